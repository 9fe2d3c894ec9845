/* SPDX-License-Identifier: MIT */
#include "files/text_lines.h"

#include "files/decimal.h"
#include "files/whole_file.h"

#include <string.h>

bool text_begin(struct text *text, const char *path, const char *bytes, size_t size_b, struct error *err)
{
    const int mark_b = whole_file_mark_b(bytes, size_b);
    if (mark_b == WHOLE_FILE_UTF16)
        return error_set(err, "%s: a text in UTF-16; save it as UTF-8, or in plain letters", path);
    *text = (struct text){path, bytes + mark_b, bytes + size_b, NULL, 0, err};
    return true;
}

/* The first place of the line's rest that is no blank. */
static const char *next_place(const struct text *text)
{
    const char *at = text->at;
    while (at < text->line_end && is_blank(*at))
        at++;
    return at;
}

/* Past the rest of this line, and to the end of the next one. */
static bool begin_line(struct text *text)
{
    while (text->line_end && text->at < text->end && !is_line_end(*text->at))
        text->at++;
    if (text->line_end && text->at < text->end) text->at += text->at[0] == '\r' && text->at[1] == '\n' ? 2 : 1;
    text->line++;
    text->line_end = text->at;
    if (text->at >= text->end) return false;
    while (text->line_end < text->end && !is_line_end(*text->line_end) && *text->line_end != '#')
        text->line_end++;
    return true;
}

bool text_next_line(struct text *text)
{
    while (begin_line(text))
        if (next_place(text) < text->line_end) return true;
    return false;
}

bool text_word(struct text *text, struct word *word)
{
    text->at = next_place(text);
    const char *first = text->at;
    while (text->at < text->line_end && !is_blank(*text->at))
        text->at++;
    *word = (struct word){first, (size_t)(text->at - first)};
    return word->length > 0;
}

size_t text_words_left(const struct text *text)
{
    struct text rest = *text;
    struct word word;
    size_t count = 0;
    while (text_word(&rest, &word))
        count++;
    return count;
}

void text_rest(const struct text *text, struct word *rest)
{
    const char *first = next_place(text), *end = text->line_end;
    while (end < text->end && !is_line_end(*end))
        end++;
    while (end > first && is_blank(end[-1]))
        end--;
    *rest = (struct word){first, (size_t)(end - first)};
}

bool text_any_word(struct text *text, struct word *word)
{
    while (!text_word(text, word))
        if (!text_next_line(text)) return false;
    return true;
}

bool text_number(const struct text *text, const struct word *word, double *value)
{
    enum { SHOWN = 40 };
    if (decimal_parse(word->text, word->length, value)) return true;
    return error_set(text->err, "%s:%zu: '%.*s' is not a decimal number up to 3.4e38", text->path, text->line,
                     word->length < SHOWN ? (int)word->length : SHOWN, word->text);
}
