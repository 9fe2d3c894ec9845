/* SPDX-License-Identifier: MIT
 *
 * A command line that several parts of a program share: each takes what it knows out of it, and the rest is whoever's
 * comes last. */
#ifndef SIM_ARGUMENTS_H
#define SIM_ARGUMENTS_H

#include "base/error.h"

#include <stdbool.h>

struct arguments {
    char **items; /* the caller's; taken ones are closed up, and NULL follows */
    int count;
};

/* Takes `--name VALUE` or `--name=VALUE`, the last if there are several. *value stays as it is if there is none. An
 * error: the value is missing or empty. */
bool arguments_value(struct arguments *arguments, const char *name, const char **value, struct error *err);

/* Takes `--name`; whether it was there. */
bool arguments_flag(struct arguments *arguments, const char *name);

/* Takes `--name`, `--name=VALUE` or, where the word that follows is such a value, `--name VALUE`; whether it was there.
 * *value stays as it is if there is none. */
bool arguments_optional(struct arguments *arguments, const char *name, bool (*is_value)(const char *word),
                        const char **value);

/* Takes both flags, of which only one makes sense; an error names them. *on stays as it is if neither is there. */
bool arguments_either(struct arguments *arguments, const char *yes, const char *no, bool *on, struct error *err);

#endif
