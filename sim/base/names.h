/* SPDX-License-Identifier: MIT
 *
 * Names that a note tells: each once, in the order of their first mention, and how often any of them was mentioned. */
#ifndef SIM_NAMES_H
#define SIM_NAMES_H

#include <stdbool.h>
#include <stddef.h>

/* Nothing, if it is all zeros. */
struct names {
    char **items;
    size_t item_count, capacity;
    size_t mentions;
};

/* Of a longer name than a line of a note holds, the end is what tells it from others. */
enum { NAME_END_B = 128 };
struct name_end {
    char text[NAME_END_B];
};
struct name_end name_end(const char *name);

/* A name of `length` bytes. Many names are counted and not kept: notes tell the first. */
void names_add(struct names *names, const char *name, size_t length);

/* Whether it is among those that are kept. */
bool names_have(const struct names *names, const char *name, size_t length);

/* "'a', 'b' and 3 more". Returns `out`. */
const char *names_list(const struct names *names, char *out, size_t out_b);
void names_free(struct names *names);

#endif
