/* SPDX-License-Identifier: MIT */
#include "files/words.h"

#include <string.h>
#include <strings.h>

bool is_line_end(char c)
{
    return c == '\n' || c == '\r' || c == '\0';
}

bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

size_t words_of(const char *text, const char *end, struct word *words, size_t most)
{
    size_t count = 0;
    for (;;) {
        while (text < end && (is_blank(*text) || is_line_end(*text)))
            text++;
        if (text == end || *text == '#') return count;
        const char *first = text;
        while (text < end && !is_blank(*text) && !is_line_end(*text))
            text++;
        if (count < most) words[count] = (struct word){first, (size_t)(text - first)};
        count++;
    }
}

bool word_is(const struct word *word, const char *lower_case)
{
    return word->length == strlen(lower_case) && strncasecmp(word->text, lower_case, word->length) == 0;
}
