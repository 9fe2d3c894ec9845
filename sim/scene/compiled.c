/* SPDX-License-Identifier: MIT
 *
 * What a compiled scene owns. */
#include "scene/compiled.h"

#include "model/original.h"
#include "scene/moving.h"

#include <stdlib.h>

void compiled_free(struct compiled *scene)
{
    if (scene->moving) moving_free(scene->moving);
    free(scene->moving);
    original_free(scene->original);
    free(scene->groups);
    free(scene->image);
    free(scene->of_32_bits);
    free(scene->report.notes);
    *scene = (struct compiled){0};
}
