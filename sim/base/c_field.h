/* SPDX-License-Identifier: MIT
 *
 * Fields of a struct's initialiser, written as C: a line each, `.name = value,`. What is zero is left out, as in C. */
#ifndef SIM_C_FIELD_H
#define SIM_C_FIELD_H

#include "pages.h"

#include <stdio.h>

/* A value as its type is written. */
#define C_FIELD(file, name, value)                                                                                     \
    _Generic((value), bool                                                                                             \
             : c_field_flag, uint8_t                                                                                   \
             : c_field_number, uint16_t                                                                                \
             : c_field_number, enum pages_wiring                                                                       \
             : c_field_wiring, enum panel_rotation                                                                     \
             : c_field_rotation, enum panel_format                                                                     \
             : c_field_format)(file, name, value)

void c_field_flag(FILE *file, const char *name, bool on);
void c_field_number(FILE *file, const char *name, uint16_t number);
void c_field_wiring(FILE *file, const char *name, enum pages_wiring wiring);
void c_field_rotation(FILE *file, const char *name, enum panel_rotation rotation);
void c_field_format(FILE *file, const char *name, enum panel_format format);

/* What the board has under a name. */
void c_field_of_board(FILE *file, const char *name, const char *of_board);

/* Names of constants. */
const char *c_field_rotation_name(enum panel_rotation rotation);
const char *c_field_format_name(enum panel_format format);

#endif
