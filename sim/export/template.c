/* SPDX-License-Identifier: MIT */
#include "export/template.h"

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

void template_write(FILE *out, const char *text, const struct template_word *words, size_t count)
{
    while (*text) {
        const struct template_word *word = *text == '@' ? find(text + 1, words, count) : NULL;
        if (word) {
            fputs(word->text, out);
            text += strlen(word->word) + 2;
        } else {
            fputc(*text++, out);
        }
    }
}
