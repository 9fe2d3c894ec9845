/* SPDX-License-Identifier: MIT
 *
 * A text that a reader of our own goes through, line by line and word by word. */
#ifndef SIM_TEXT_LINES_H
#define SIM_TEXT_LINES_H

#include "base/error.h"
#include "files/words.h"

struct text {
    const char *path;
    const char *at, *end;
    const char *line_end; /* of the line that `at` is in; NULL: it stands before a line */
    size_t line;          /* the line's number, from 1 */
    struct error *err;
};

/* From a file's bytes, behind a mark of UTF-8. Refuses UTF-16. */
bool text_begin(struct text *text, const char *path, const char *bytes, size_t size_b, struct error *err);

/* To the next line that has a word; a comment's # ends a line. false: there is none. */
bool text_next_line(struct text *text);

/* The next word of the line. false: there is none. */
bool text_word(struct text *text, struct word *word);
size_t text_words_left(const struct text *text);

/* What is left of the line, as a name: without blanks at its ends; a # belongs to it. */
void text_rest(const struct text *text, struct word *rest);

/* The next word of the text, on whatever line. false: there is none. */
bool text_any_word(struct text *text, struct word *word);

/* A word as a number; else an error that names the line. */
bool text_number(const struct text *text, const struct word *word, double *value);

#endif
