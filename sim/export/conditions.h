/* SPDX-License-Identifier: MIT
 *
 * What the preprocessor would decide, as far as it is known before a compiler runs: a scene's settings are, a
 * processor's are not. So an exported renderer is left with the conditions that a compiler has to decide, and without
 * the code that its scene never asks for.
 *
 * Macros are known from their definitions. Not defined is what begins as `settled` says, or ends in _H, and was not
 * met: include guards, and what the export alone decides. LIM_EITHER() and LIM_BOTH() are understood
 * (firmware/config.h), other macros with arguments are not known. Numbers are whole. Operators are `defined`, !, - with
 * one side and with two, +, < <= > >= == != once in a row, && and ||, and brackets; with others a value is not known.
 */
#ifndef SIM_CONDITIONS_H
#define SIM_CONDITIONS_H

#include <stdbool.h>
#include <stddef.h>

struct condition_macro;

struct conditions {
    struct condition_macro *macros;
    size_t count, capacity;
    const char *const *settled; /* beginnings of names that nobody else defines; ends with NULL, or is it */
};

/* A directive's answer. */
enum known { KNOWN_FALSE, KNOWN_TRUE, KNOWN_NOT };

/* NAME and its text, of a #define that is certainly read. */
void conditions_define(struct conditions *conditions, const char *name, const char *text);

/* NAME is certainly not defined: of an #undef that is certainly read. */
void conditions_undefine(struct conditions *conditions, const char *name);

/* NAME may be one or the other from now on. */
void conditions_forget(struct conditions *conditions, const char *name);

/* Of the words after #if. */
enum known conditions_ask(const struct conditions *conditions, const char *expression);

/* Of #ifdef NAME. */
enum known conditions_is_defined(const struct conditions *conditions, const char *name);

void conditions_free(struct conditions *conditions);

#endif
