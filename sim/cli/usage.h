/* SPDX-License-Identifier: MIT
 *
 * The help: all of it, or that of one command; and the table that it is made of, for whatever else is made of it: the
 * manual page, completion. */
#ifndef SIM_CLI_USAGE_H
#define SIM_CLI_USAGE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

void usage_print(FILE *out);

/* What the command does, its options, or those that most people want unless `all` are, and an example. False: there is
 * no such command, and nothing was printed. */
bool usage_print_command(const char *name, bool all, FILE *out);

struct usage_command {
    const char *name, *arguments, *what, *example;
};

/* Lines: an option, two blanks at least and what it is, which goes on in lines that begin with more than two blanks; or
 * a heading, which is not indented. */
struct usage_entry {
    uint32_t commands; /* bit i: command i takes it; 0: a heading */
    const char *text;
};

/* NULL: there are no more. */
const struct usage_command *usage_command_at(size_t index);
const struct usage_entry *usage_entry_at(size_t index);

/* The nearest command; NULL: none is near. */
const char *usage_nearest_command(const char *name);

/* An option among the arguments that the command does not have while it has one that is nearly called so: err asks for
 * that. Others are the command's affair. */
bool usage_check_options(const char *command, char *const *arguments, struct error *err);

/* Not in the help of all commands together: a heading says it there. */
bool usage_is_alone(const struct usage_entry *entry);

#endif
