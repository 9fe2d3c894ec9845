/* SPDX-License-Identifier: MIT
 *
 * Words of a text. */
#ifndef SIM_WORDS_H
#define SIM_WORDS_H

#include <stdbool.h>
#include <stddef.h>

struct word {
    const char *text;
    size_t length;
};

/* Ends of lines are newlines, carriage returns and zeros; blanks are spaces and tabs. */
bool is_line_end(char c);
bool is_blank(char c);

/* Of a line [text, end): the words up to a comment's #; how many there are, of which at most `most` are set. */
size_t words_of(const char *text, const char *end, struct word *words, size_t most);

/* In capitals or not. */
bool word_is(const struct word *word, const char *lower_case);

#endif
