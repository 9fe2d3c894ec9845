/* SPDX-License-Identifier: MIT
 *
 * LIMNER_DUMP and LIMNER_CHECK; with both set the frame is written first, so that a failed check
 * leaves a picture to look at. */
#include "pictures/dump.h"

#include "outputs/outputs.h"

#include <stdlib.h>

static bool dump_png(const struct film *frame, const char *path, struct error *err)
{
    struct outputs outputs = {0};
    FILE *file = outputs_open(&outputs, path, err);
    gdImagePtr image = file ? image_from_frame(frame, 0) : NULL;
    bool ok = file && image_write_png(image, file, path, err);
    if (image) gdImageDestroy(image);
    if (file) ok = outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
    if (ok) return outputs_keep(&outputs, err);
    outputs_discard(&outputs);
    return false;
}

static bool is_set(const char *variable)
{
    const char *value = getenv(variable);
    return value && *value;
}

bool dump_is_asked(void)
{
    return is_set("LIMNER_DUMP") || is_set("LIMNER_CHECK");
}

bool dump_last_frame(const struct film *frame, struct error *err)
{
    if (is_set("LIMNER_DUMP") && !dump_png(frame, getenv("LIMNER_DUMP"), err)) return false;
    return !is_set("LIMNER_CHECK") || image_check_png(frame, getenv("LIMNER_CHECK"), err);
}
