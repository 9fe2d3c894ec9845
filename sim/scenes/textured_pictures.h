/* SPDX-License-Identifier: MIT
 *
 * The pictures of the textured demo: PNG but for one JPEG, one with sides that are no powers of two. */
#ifndef TEXTURED_PICTURES_H
#define TEXTURED_PICTURES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct textured_picture {
    const char *name;
    bool (*write)(FILE *file);
};

extern const struct textured_picture textured_pictures[];
extern const size_t textured_picture_count;

#endif
