/* SPDX-License-Identifier: MIT
 *
 * Films of RGB565 frames into libgd images and files. A GIF gets the palette of its contact
 * sheet: quantised once, over frames from the whole film. */
#include "pictures/image.h"

#include "base/binary.h"
#include "pictures/picture_size.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHEET_FRAMES_MAX = 24, SHEET_COLUMNS = 6, SHEET_CELL_MAX_PX = 240, SHEET_BORDER_PX = 2 };
enum { PALETTE_COLOURS = 256, COLOURS_565 = 65536 };
enum { PNG_MOST_B = 64 << 20 };
static const int SHEET_BORDER_COLOUR = 0x202428;

uint32_t image_rgb888_from_565(uint16_t colour)
{
    uint32_t red = colour >> 11, green = (colour >> 5) & 63, blue = colour & 31;
    red = red << 3 | red >> 2;
    green = green << 2 | green >> 4;
    blue = blue << 3 | blue >> 2;
    return red << 16 | green << 8 | blue;
}

static const uint16_t *film_frame(const struct film *film, size_t frame)
{
    return film->pixels + frame * film->w_px * film->h_px;
}

gdImagePtr image_from_frame(const struct film *film, size_t frame)
{
    gdImagePtr image = gdImageCreateTrueColor((int)film->w_px, (int)film->h_px);
    if (!image) return NULL;
    const uint16_t *pixels = film_frame(film, frame);
    for (unsigned y = 0; y < film->h_px; y++)
        for (unsigned x = 0; x < film->w_px; x++)
            image->tpixels[y][x] = (int)image_rgb888_from_565(*pixels++);
    return image;
}

bool image_write_png(gdImagePtr image, FILE *file, const char *name, struct error *err)
{
    int size_b;
    void *bytes = image ? gdImagePngPtr(image, &size_b) : NULL;
    if (!bytes) return error_set(err, "%s: out of memory", name);
    errno = 0;
    bool ok = fwrite(bytes, 1, (size_t)size_b, file) == (size_t)size_b;
    gdFree(bytes);
    return ok || error_set(err, "%s: %s", name, strerror(errno));
}

/* Contact sheet ------------------------------------------------------------------------------ */

static bool sheet_place(gdImagePtr sheet, const struct film *film, size_t frame, int x_px, int y_px, int w_px, int h_px)
{
    gdImagePtr image = image_from_frame(film, frame);
    if (!image) return false;
    gdImageCopyResampled(sheet, image, x_px, y_px, 0, 0, w_px, h_px, gdImageSX(image), gdImageSY(image));
    gdImageDestroy(image);
    return true;
}

gdImagePtr image_contact_sheet(const struct film *film)
{
    const int shown = film->count < SHEET_FRAMES_MAX ? (int)film->count : SHEET_FRAMES_MAX;
    const int columns = shown < SHEET_COLUMNS ? shown : SHEET_COLUMNS;
    const int rows = (shown + columns - 1) / columns;
    const unsigned longest_px = film->w_px > film->h_px ? film->w_px : film->h_px;
    const unsigned cell_px = longest_px < SHEET_CELL_MAX_PX ? longest_px : SHEET_CELL_MAX_PX;
    const int w_px = (int)(film->w_px * cell_px / longest_px), h_px = (int)(film->h_px * cell_px / longest_px);
    const int step_x_px = (w_px > 0 ? w_px : 1) + SHEET_BORDER_PX, step_y_px = (h_px > 0 ? h_px : 1) + SHEET_BORDER_PX;

    gdImagePtr sheet =
        gdImageCreateTrueColor(columns * step_x_px + SHEET_BORDER_PX, rows * step_y_px + SHEET_BORDER_PX);
    if (!sheet) return NULL;
    gdImageFilledRectangle(sheet, 0, 0, gdImageSX(sheet) - 1, gdImageSY(sheet) - 1, SHEET_BORDER_COLOUR);
    for (int i = 0; i < shown; i++) {
        size_t frame = (size_t)i * film->count / (size_t)shown;
        if (sheet_place(sheet, film, frame, SHEET_BORDER_PX + i % columns * step_x_px,
                        SHEET_BORDER_PX + i / columns * step_y_px, step_x_px - SHEET_BORDER_PX,
                        step_y_px - SHEET_BORDER_PX))
            continue;
        gdImageDestroy(sheet);
        return NULL;
    }
    return sheet;
}

/* GIF ---------------------------------------------------------------------------------------- */

/* The film's own colours where they are few enough, else those that suit its contact sheet best. */
static gdImagePtr film_palette(const struct film *film, const bool *is_used)
{
    int used_count = 0;
    for (int colour = 0; colour < COLOURS_565; colour++)
        used_count += is_used[colour];
    if (used_count > PALETTE_COLOURS) {
        gdImagePtr sheet = image_contact_sheet(film);
        if (sheet && !gdImageTrueColorToPalette(sheet, 0, PALETTE_COLOURS)) {
            gdImageDestroy(sheet);
            return NULL;
        }
        return sheet;
    }
    gdImagePtr palette = gdImageCreate(1, 1);
    for (int colour = 0; palette && colour < COLOURS_565; colour++) {
        if (!is_used[colour]) continue;
        int rgb = (int)image_rgb888_from_565((uint16_t)colour);
        gdImageColorAllocate(palette, gdTrueColorGetRed(rgb), gdTrueColorGetGreen(rgb), gdTrueColorGetBlue(rgb));
    }
    return palette;
}

struct gif_colours {
    bool is_used[COLOURS_565];
    uint8_t index[COLOURS_565]; /* in the palette, of those used */
};

static gdImagePtr gif_colours_choose(struct gif_colours *colours, const struct film *film)
{
    for (size_t i = 0; i < film->count * film->w_px * film->h_px; i++)
        colours->is_used[film->pixels[i]] = true;
    gdImagePtr palette = film_palette(film, colours->is_used);
    for (int colour = 0; palette && colour < COLOURS_565; colour++) {
        if (!colours->is_used[colour]) continue;
        int rgb = (int)image_rgb888_from_565((uint16_t)colour);
        colours->index[colour] = (uint8_t)gdImageColorClosest(palette, gdTrueColorGetRed(rgb), gdTrueColorGetGreen(rgb),
                                                              gdTrueColorGetBlue(rgb));
    }
    return palette;
}

static gdImagePtr gif_frame(const struct film *film, size_t frame, gdImagePtr palette, const uint8_t *index)
{
    gdImagePtr image = gdImageCreate((int)film->w_px, (int)film->h_px);
    if (!image) return NULL;
    gdImagePaletteCopy(image, palette);
    const uint16_t *pixels = film_frame(film, frame);
    for (unsigned y = 0; y < film->h_px; y++)
        for (unsigned x = 0; x < film->w_px; x++)
            image->pixels[y][x] = index[*pixels++];
    return image;
}

static int gif_time_cs(size_t frame, double frames_per_s)
{
    return (int)floor((double)frame * 100 / frames_per_s);
}

/* Each frame but the first holds only the rectangle that differs from the one before. Delays are
 * hundredths of a second: uneven ones keep the mean rate. */
static bool gif_frames(const struct film *film, double frames_per_s, gdImagePtr palette, const uint8_t *index,
                       FILE *file)
{
    gdImagePtr before = NULL;
    bool ok = true;
    for (size_t frame = 0; ok && frame < film->count; frame++) {
        gdImagePtr image = gif_frame(film, frame, palette, index);
        const int delay_cs = gif_time_cs(frame + 1, frames_per_s) - gif_time_cs(frame, frames_per_s);
        ok = image != NULL;
        if (ok && frame == 0) gdImageGifAnimBegin(image, file, 1, 0);
        /* libgd cannot write a rectangle of no pixels: a frame like the one before is written whole. */
        bool is_same = ok && before && !(gdImageCompare(before, image) & GD_CMP_IMAGE);
        if (ok) gdImageGifAnimAdd(image, file, 0, 0, 0, delay_cs, gdDisposalNone, is_same ? NULL : before);
        if (before) gdImageDestroy(before);
        before = image;
    }
    if (before) gdImageDestroy(before);
    if (ok) gdImageGifAnimEnd(file);
    return ok;
}

bool image_write_gif(const struct film *film, double frames_per_s, FILE *file, const char *name, struct error *err)
{
    struct gif_colours *colours = calloc(1, sizeof *colours);
    gdImagePtr palette = colours ? gif_colours_choose(colours, film) : NULL;
    errno = 0;
    bool ok = palette && gif_frames(film, frames_per_s, palette, colours->index, file);
    if (palette) gdImageDestroy(palette);
    free(colours);
    if (!ok) return error_set(err, "%s: out of memory", name);
    return !ferror(file) || error_set(err, "%s: %s", name, strerror(errno));
}

/* Check -------------------------------------------------------------------------------------- */

static void ignore_gd_message(int priority, const char *format, va_list arguments)
{
    (void)priority;
    (void)format;
    (void)arguments;
}

static gdImagePtr decode_png(const struct binary *file, char *reason, size_t reason_b)
{
    snprintf(reason, reason_b, "not a readable PNG file");
    if (file->size_b < 8 || memcmp(file->bytes, "\x89PNG", 4) != 0) return NULL;
    if (!picture_size_check(file->bytes, file->size_b, reason, reason_b)) return NULL;
    snprintf(reason, reason_b, "not a readable PNG file");
    gdSetErrorMethod(ignore_gd_message); /* libgd would print lines of its own */
    gdImagePtr image = gdImageCreateFromPngPtr((int)file->size_b, file->bytes);
    gdClearErrorMethod();
    return image;
}

gdImagePtr image_read_png(const char *path, struct error *err)
{
    struct binary file;
    char reason[80];
    if (!binary_read(path, PNG_MOST_B, &file, err)) return NULL;
    gdImagePtr image = decode_png(&file, reason, sizeof reason);
    free(file.bytes);
    if (!image) error_set(err, "%s: %s", path, reason);
    return image;
}

static bool same_pixels(const struct film *frame, gdImagePtr image, const char *path, struct error *err)
{
    if (gdImageSX(image) != (int)frame->w_px || gdImageSY(image) != (int)frame->h_px)
        return error_set(err, "%s: %dx%d pixels, the frame has %ux%u", path, gdImageSX(image), gdImageSY(image),
                         frame->w_px, frame->h_px);
    size_t different = 0, first = 0;
    for (size_t i = 0; i < (size_t)frame->w_px * frame->h_px; i++) {
        int x = (int)(i % frame->w_px), y = (int)(i / frame->w_px);
        uint32_t rgb = (uint32_t)gdImageGetTrueColorPixel(image, x, y) & 0xFFFFFF;
        if (rgb == image_rgb888_from_565(frame->pixels[i])) continue;
        if (different++ == 0) first = i;
    }
    if (different == 0) return true;
    return error_set(err, "%s: %zu of %zu pixels differ, the first at (%zu, %zu)", path, different,
                     (size_t)frame->w_px * frame->h_px, first % frame->w_px, first / frame->w_px);
}

bool image_check_png(const struct film *frame, const char *path, struct error *err)
{
    gdImagePtr image = image_read_png(path, err);
    if (!image) return false;
    bool ok = same_pixels(frame, image, path, err);
    gdImageDestroy(image);
    return ok;
}
