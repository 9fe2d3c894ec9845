/* SPDX-License-Identifier: MIT
 *
 * Texts in UTF-16, as some editors save them. */
#ifndef SIM_UTF16_H
#define SIM_UTF16_H

#include "files/whole_file.h"

/* A text whose mark says UTF-16 becomes UTF-8; halves of letters become '?'. Others stay. */
void utf8_from_utf16(struct whole_file *file);

#endif
