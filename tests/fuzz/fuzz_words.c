/* SPDX-License-Identifier: MIT */
#include "fuzz_words.h"

#include <string.h>

struct arguments fuzz_words(struct fuzz_bytes *text, struct fuzz_words *words)
{
    const struct fuzz_bytes line = fuzz_part(text, '\n');
    const size_t length = line.left_b < FUZZ_LINE_B ? line.left_b : FUZZ_LINE_B - 1;
    struct arguments arguments = {words->items, 0};
    char *rest = NULL;

    if (length) memcpy(words->text, line.at, length);
    words->text[length] = '\0';
    for (char *word = strtok_r(words->text, " ", &rest); word && arguments.count < FUZZ_WORDS_MOST;
         word = strtok_r(NULL, " ", &rest))
        words->items[arguments.count++] = word;
    words->items[arguments.count] = NULL;
    return arguments;
}
