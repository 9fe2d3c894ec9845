/* SPDX-License-Identifier: MIT
 *
 * What a model owns, and its notice. */
#include "model/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void model_note(struct model *model, const char *text)
{
    const size_t used = strlen(model->notice);
    snprintf(model->notice + used, sizeof model->notice - used, "%s%s", used ? "; " : "", text);
}

void model_free(struct model *model)
{
    free(model->points);
    free(model->source_points);
    free(model->corners);
    free(model->faces);
    free(model->uvs);
    for (size_t i = 0; i < model->picture_count; i++) {
        free(model->pictures[i].pixels);
        free(model->pictures[i].alpha);
    }
    free(model->pictures);
    free(model->movers);
    free(model->keys);
    *model = (struct model){0};
}
