/* SPDX-License-Identifier: MIT
 *
 * What a page is written with. Whatever comes from a model or a command line goes through html_text(). */
#ifndef SIM_HTML_H
#define SIM_HTML_H

#include "base/error.h"

#include <gd.h>
#include <stddef.h>
#include <stdio.h>

/* As text or in quotes: what means something in HTML is escaped, control characters become spaces, and bytes that are
 * no UTF-8 become U+FFFD. */
void html_text(FILE *file, const char *text);

/* 1234567 as 1 234 567, with so many decimals. NaN is a dash. */
void html_number(FILE *file, double number, int decimals);

/* An <img> with the picture in itself, shown as wide as it is; its pixels stay squares. */
bool html_picture(FILE *file, gdImagePtr image, const char *alt, struct error *err);

/* A row of a table whose first cell is a word; a bar is of 0 to 1. */
void html_row_begin(FILE *file, const char *name);
void html_cell(FILE *file, double number, int decimals);
void html_bar(FILE *file, double bar);
void html_row_end(FILE *file);

/* A section with a heading and an anchor. */
void html_section(FILE *file, const char *id, const char *title);
void html_section_end(FILE *file);

#endif
