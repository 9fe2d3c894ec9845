/* SPDX-License-Identifier: MIT
 *
 * What a model owns, and its notice. */
#include "model/model.h"

#include "base/notice.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void model_note(struct model *model, const char *format, ...)
{
    static const char more[] = "there is more to say than fits here";
    const size_t used = strlen(model->notice), left_b = sizeof model->notice - used - sizeof more - 1;
    va_list arguments;
    if (left_b > sizeof model->notice) return;
    char *at = model->notice + used;
    if (used) *at++ = '\n';
    va_start(arguments, format);
    const int length = vsnprintf(at, left_b, format, arguments);
    va_end(arguments);
    if (length >= (int)left_b) memcpy(at, more, sizeof more);
}

void model_tell(const char *path, const struct model *model)
{
    for (const char *line = model->notice; *line;) {
        const size_t length = strcspn(line, "\n");
        notice("%s: %.*s", path, (int)length, line);
        line += length + (line[length] == '\n');
    }
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
    if (model->source_motion) source_motion_free(model->source_motion);
    free(model->source_motion);
    *model = (struct model){0};
}
