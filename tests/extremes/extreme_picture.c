/* SPDX-License-Identifier: MIT
 *
 * Hues are steps of the golden ratio round the circle, so that neighbouring numbers look different. */
#include "extreme_picture.h"

#include "base/grow.h"
#include "pictures/image.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_PX = 160, BACKGROUND = 0x202428, WRONG = 0xFF0000 };

bool extreme_picture_is_wanted(void)
{
    return getenv("EXTREMES_PICTURES") != NULL;
}

static int compare_faces(const void *left, const void *right)
{
    const uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
    return (a > b) - (a < b);
}

static size_t count_distinct(const uint32_t *faces, size_t pixels)
{
    uint32_t *sorted = grow_zeroed(pixels, sizeof *sorted);
    size_t count = 1;

    memcpy(sorted, faces, pixels * sizeof *sorted);
    qsort(sorted, pixels, sizeof *sorted, compare_faces);
    for (size_t i = 1; i < pixels; i++)
        count += sorted[i] != sorted[i - 1];
    free(sorted);
    return count;
}

/* Of a hue from 0 to 1, pale; `light` is 0 to 1. */
static unsigned pale_rgb888(double hue, double light)
{
    unsigned rgb = 0;

    for (int channel = 0; channel < 3; channel++) {
        const double wave = cos(6.283185307179586 * (hue - channel / 3.0));
        rgb = rgb << 8 | (unsigned)lround(255 * light * (0.72 + 0.28 * wave));
    }
    return rgb;
}

static unsigned face_rgb888(uint32_t face, double light)
{
    return face ? pale_rgb888(fmod(face * 0.6180339887498949, 1), light) : BACKGROUND;
}

/* The deepest face seen is a third as bright as the nearest. */
static double light_of(double depth_m, double near_m, double far_m)
{
    return far_m > near_m ? 1 - 0.65 * (depth_m - near_m) / (far_m - near_m) : 1;
}

static void find_range(const double *depths_m, size_t pixels, double *near_m, double *far_m)
{
    *near_m = INFINITY;
    *far_m = 0;
    for (size_t i = 0; i < pixels; i++) {
        if (!isfinite(depths_m[i])) continue;
        *near_m = fmin(*near_m, depths_m[i]);
        *far_m = fmax(*far_m, depths_m[i]);
    }
}

void extreme_picture_consider(struct extreme_best *best, const uint32_t *faces, const double *depths_m,
                              const uint32_t *truth, unsigned w_px, unsigned h_px)
{
    const size_t pixels = (size_t)w_px * h_px, distinct = count_distinct(faces, pixels);
    double near_m = 0, far_m = 0;

    if (distinct <= best->distinct) return;
    best->distinct = distinct;
    if (!best->rgb888) best->rgb888 = grow_zeroed(pixels, sizeof *best->rgb888);
    if (depths_m) find_range(depths_m, pixels, &near_m, &far_m);
    for (size_t i = 0; i < pixels; i++) {
        const double light = depths_m && isfinite(depths_m[i]) ? light_of(depths_m[i], near_m, far_m) : 1;
        best->rgb888[i] = truth && truth[i] != faces[i] ? WRONG : face_rgb888(faces[i], light);
    }
}

/* At least one pixel, however thin the picture is. */
static unsigned shown_px(unsigned side_px, unsigned longer_px)
{
    if (longer_px <= SHOWN_PX) return side_px * (SHOWN_PX / longer_px);
    return side_px * SHOWN_PX < longer_px ? 1 : side_px * SHOWN_PX / longer_px;
}

/* Whole pixels where there are fewer than are shown, means where there are more. */
static gdImagePtr picture_of(const struct extreme_best *best, unsigned w_px, unsigned h_px)
{
    const unsigned longer_px = w_px > h_px ? w_px : h_px;
    const unsigned shown_w_px = shown_px(w_px, longer_px), shown_h_px = shown_px(h_px, longer_px);
    gdImagePtr whole = gdImageCreateTrueColor((int)w_px, (int)h_px);
    gdImagePtr shown = gdImageCreateTrueColor((int)shown_w_px, (int)shown_h_px);

    assert_non_null(whole);
    assert_non_null(shown);
    for (unsigned y = 0; y < h_px; y++)
        for (unsigned x = 0; x < w_px; x++)
            whole->tpixels[y][x] = (int)best->rgb888[y * w_px + x];
    if (longer_px > SHOWN_PX)
        gdImageCopyResampled(shown, whole, 0, 0, 0, 0, (int)shown_w_px, (int)shown_h_px, (int)w_px, (int)h_px);
    else
        gdImageCopyResized(shown, whole, 0, 0, 0, 0, (int)shown_w_px, (int)shown_h_px, (int)w_px, (int)h_px);
    gdImageDestroy(whole);
    return shown;
}

void extreme_picture_write(const struct extreme_best *best, const char *name, unsigned w_px, unsigned h_px)
{
    char path[512];
    struct error err;

    if (!best->rgb888) return;
    int length = snprintf(path, sizeof path, "%s/", getenv("EXTREMES_PICTURES"));
    for (; *name && length < (int)sizeof path - 8; name++)
        if (*name != '/') path[length++] = *name;
    memcpy(path + length, ".png", sizeof ".png");
    gdImagePtr picture = picture_of(best, w_px, h_px);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(image_write_png(picture, file, path, &err));
    assert_int_equal(fclose(file), 0);
    gdImageDestroy(picture);
}

void extreme_picture_free(struct extreme_best *best)
{
    free(best->rgb888);
    *best = (struct extreme_best){0};
}
