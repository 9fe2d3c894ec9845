/* SPDX-License-Identifier: MIT
 *
 * The rooms of the textured demo as OBJ and MTL, and a walk through them. */
#ifndef TEXTURED_ROOMS_H
#define TEXTURED_ROOMS_H

#include <stdbool.h>
#include <stdio.h>

bool textured_write_obj(FILE *file);
bool textured_write_mtl(FILE *file);
bool textured_write_cam(FILE *file);

#endif
