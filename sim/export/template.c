/* SPDX-License-Identifier: MIT */
#include "export/template.h"

#include <stdbool.h>
#include <string.h>

/* The word between `text`, which is after an @, and the next one; NULL: none of the list. */
static const struct template_word *find(const char *text, const struct template_word *words, size_t count)
{
    const char *end = strchr(text, '@');
    for (size_t i = 0; end && i < count; i++) {
        const size_t length = strlen(words[i].word);
        if (length == (size_t)(end - text) && memcmp(words[i].word, text, length) == 0) return &words[i];
    }
    return NULL;
}

/* What follows a condition at the line's beginning; *is_written: whether it holds. */
static const char *after_condition(const char *line, const struct template_word *words, size_t count, bool *is_written)
{
    static const char *const conditions[] = {"@unless ", "@if "};
    for (size_t wanted = 0; wanted < 2; wanted++) {
        const size_t length = strlen(conditions[wanted]);
        if (strncmp(line, conditions[wanted], length) != 0) continue;
        const struct template_word *word = find(line + length, words, count);
        if (!word) continue;
        *is_written = (word->text[0] != '\0') == (wanted == 1);
        return line + length + strlen(word->word) + 1;
    }
    *is_written = true;
    return line;
}

static void write_line(FILE *out, const char *at, const char *end, const struct template_word *words, size_t count)
{
    while (at < end) {
        const struct template_word *word = *at == '@' ? find(at + 1, words, count) : NULL;
        if (word) {
            fputs(word->text, out);
            at += strlen(word->word) + 2;
        } else {
            fputc(*at++, out);
        }
    }
}

void template_write(FILE *out, const char *text, const struct template_word *words, size_t count)
{
    while (*text) {
        bool is_written;
        text = after_condition(text, words, count, &is_written);
        const char *end = strchr(text, '\n');
        end = end ? end + 1 : text + strlen(text);
        if (is_written) write_line(out, text, end, words, count);
        text = end;
    }
}
