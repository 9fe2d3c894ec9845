/* SPDX-License-Identifier: MIT
 *
 * The arrays are freed once a .lim image has a copy of them. */
#include "scene/encoding.h"

#include <stdlib.h>

enum { COUNT_MAX = 0xFFFF };

void texture_arrays_free(struct texture_arrays *arrays)
{
    free(arrays->mappings);
    free(arrays->long_mappings);
    free(arrays->textures);
    free(arrays->palettes);
    free(arrays->texels);
}

void encoding_free(struct encoding *encoding)
{
    free(encoding->long_vertices);
    free(encoding->long_planes);
    free(encoding->long_boxes);
    free(encoding->vertices);
    free(encoding->fractions);
    free(encoding->uvs);
    free(encoding->nodes);
    free(encoding->planes);
    free(encoding->exact);
    free(encoding->boxes);
    free(encoding->words);
    free(encoding->faces);
    texture_arrays_free(&encoding->textures);
    *encoding = (struct encoding){0};
}

bool encoding_check_count(size_t count, const char *what, struct error *err)
{
    return count <= COUNT_MAX || error_set(err, "scene too large: %zu %s, %d are the most (%zu too many)", count, what,
                                           COUNT_MAX, count - COUNT_MAX);
}
