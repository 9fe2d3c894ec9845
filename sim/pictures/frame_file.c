/* SPDX-License-Identifier: MIT
 *
 * Of two failures the first is told: what cannot be written cannot be closed either. */
#include "pictures/frame_file.h"

enum { PATH_SIZE = 4096 };

bool frame_file_put(const struct film *frame, const char *path, struct outputs *outputs, struct error *err)
{
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    gdImagePtr image = image_from_frame(frame, 0);
    bool ok = image_write_png(image, file, path, err);
    if (image) gdImageDestroy(image);
    return outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
}

bool frame_file_write(const struct film *frame, const char *pattern, size_t number, struct outputs *outputs,
                      struct error *err)
{
    char path[PATH_SIZE];
    return output_pattern_path(pattern, number, path, sizeof path, err) && frame_file_put(frame, path, outputs, err);
}
