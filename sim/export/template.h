/* SPDX-License-Identifier: MIT
 *
 * Texts with words to be replaced: @name@. A word that the list has not is left as it is. A line that begins with
 * @if name@ is written, without that, if the word stands for something, and one with @unless name@ if for nothing. */
#ifndef SIM_TEMPLATE_H
#define SIM_TEMPLATE_H

#include <stddef.h>
#include <stdio.h>

struct template_word {
    const char *word; /* without @ */
    const char *text;
};

void template_write(FILE *out, const char *text, const struct template_word *words, size_t count);

#endif
