/* SPDX-License-Identifier: MIT
 *
 * An OBJ text, line by line. */
#ifndef SIM_OBJ_LINES_H
#define SIM_OBJ_LINES_H

#include "files/text_lines.h"

struct obj_lines {
    const char *at, *end;  /* of the text that is left */
    size_t number, next;   /* of this line in the file, from 1, and of the next */
    struct word statement; /* its first word */
    const char *rest;      /* behind that, with a 0 at its end */
    char *line;            /* owned */
    size_t capacity;
};

void obj_lines_begin(struct obj_lines *lines, const char *bytes, size_t size_b);

/* To the next line that has a word, with those that it is continued on by a backslash. false: there is none. */
bool obj_lines_next(struct obj_lines *lines);
void obj_lines_free(struct obj_lines *lines);

/* The words behind the statement, up to a comment's #: how many there are, of which at most `most` are set. */
size_t obj_lines_words(const struct obj_lines *lines, struct word *words, size_t most);

/* All behind the statement as one name, without blanks at its ends. */
struct word obj_lines_name(const struct obj_lines *lines);

#endif
