/* SPDX-License-Identifier: MIT
 *
 * Words that users choose from lists: large and small letters are one, and who errs is told the word that is nearest.
 */
#ifndef SIM_CHOICE_H
#define SIM_CHOICE_H

#include "base/error.h"

#include <stddef.h>

/* The index-th word; NULL: there are no more. */
typedef const char *choice_word(const void *list, size_t index);

struct choice {
    const char *option, *kind; /* "--tree", "tree": for errors */
    choice_word *word;
    const void *list;
};

/* A list of words that ends with NULL, as choice.word takes it. */
choice_word choice_in_array;

/* Whether two words are one. */
bool choice_is(const char *text, size_t length, const char *word);

/* Sets *index. An error names the option, the nearest word and all of them. */
bool choice_find(const struct choice *choice, const char *text, size_t *index, struct error *err);

/* The same for `length` characters of the text; `also`: what else the option takes, for the error; or NULL. */
bool choice_find_part(const struct choice *choice, const char *text, size_t length, const char *also, size_t *index,
                      struct error *err);

/* The word that differs least, by letters that are left out, put in, exchanged or others: one of three, three at most.
 * NULL: none does by so little. */
const char *choice_nearest(choice_word *word, const void *list, const char *text, size_t length);

#endif
