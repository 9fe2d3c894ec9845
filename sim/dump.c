/* SPDX-License-Identifier: MIT
 *
 * LIMNER_DUMP and LIMNER_CHECK; with both set the frame is written first, so that a failed check
 * leaves a picture to look at. */
#include "dump.h"

#include "outputs.h"

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

bool dump_last_frame(const struct film *frame, struct error *err)
{
    const char *dump = getenv("LIMNER_DUMP"), *check = getenv("LIMNER_CHECK");
    if (dump && *dump && !dump_png(frame, dump, err)) return false;
    return !check || !*check || image_check_png(frame, check, err);
}
