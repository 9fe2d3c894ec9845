/* SPDX-License-Identifier: MIT
 *
 * A line of text as a command line. */
#ifndef TESTS_FUZZ_WORDS_H
#define TESTS_FUZZ_WORDS_H

#include "base/arguments.h"
#include "fuzz.h"

enum { FUZZ_WORDS_MOST = 24, FUZZ_LINE_B = 1024 };

struct fuzz_words {
    char text[FUZZ_LINE_B];
    char *items[FUZZ_WORDS_MOST + 1];
};

/* Takes the first line off the text: its words, divided by spaces, up to as many as there is room for, and NULL. */
struct arguments fuzz_words(struct fuzz_bytes *text, struct fuzz_words *words);

#endif
