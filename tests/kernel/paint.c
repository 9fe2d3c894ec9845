/* SPDX-License-Identifier: MIT
 *
 * Paints a picture over the whole of a frame buffer, as any program would: paint /dev/fb0 PICTURE.ppm [bits]
 * The picture, binary PPM of the frame buffer's size, may be made black and white first. Switches the display on, which
 * drivers of direct rendering want to be asked for. */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

struct picture {
    unsigned w_px, h_px;
    uint8_t *rgb; /* 3 bytes a pixel */
};

static bool picture_read(struct picture *picture, const char *path)
{
    FILE *file = fopen(path, "rb");
    const bool has_size = file && fscanf(file, "P6 %u %u 255", &picture->w_px, &picture->h_px) == 2;
    const size_t n_b = has_size ? (size_t)3 * picture->w_px * picture->h_px : 0;

    picture->rgb = n_b ? malloc(n_b) : NULL;
    const bool ok = picture->rgb && fgetc(file) != EOF && fread(picture->rgb, 1, n_b, file) == n_b;
    if (file) fclose(file);
    return ok;
}

/* By the brightness of ITU-R BT.601. */
static void to_bits(struct picture *picture)
{
    uint8_t *rgb = picture->rgb;

    for (size_t i = 0; i < (size_t)picture->w_px * picture->h_px; i++, rgb += 3)
        memset(rgb, 299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2] >= 128000 ? 255 : 0, 3);
}

static uint32_t to_field(uint8_t level, const struct fb_bitfield *field)
{
    return (uint32_t)level >> (8 - field->length) << field->offset;
}

/* Of 16 or 32 bits a pixel, in the machine's byte order. */
static void pack_line(void *line, const struct fb_var_screeninfo *screen, const uint8_t *rgb)
{
    for (unsigned x = 0; x < screen->xres; x++, rgb += 3) {
        const uint32_t pixel =
            to_field(rgb[0], &screen->red) | to_field(rgb[1], &screen->green) | to_field(rgb[2], &screen->blue);
        if (screen->bits_per_pixel == 16)
            ((uint16_t *)line)[x] = (uint16_t)pixel;
        else
            ((uint32_t *)line)[x] = pixel;
    }
}

/* All lines in one piece: a line that is written by itself, direct rendering of 6.1 takes for nothing new. */
static bool write_picture(int file, const struct fb_var_screeninfo *screen, size_t line_b, const uint8_t *rgb)
{
    const size_t n_b = line_b * screen->yres;
    uint8_t *lines = calloc(1, n_b);

    for (unsigned y = 0; lines && y < screen->yres; y++)
        pack_line(lines + y * line_b, screen, rgb + (size_t)3 * y * screen->xres);
    const bool ok = lines && write(file, lines, n_b) == (ssize_t)n_b;
    free(lines);
    return ok;
}

/* NULL: done; else what went wrong. */
static const char *paint(int file, const struct picture *picture)
{
    struct fb_var_screeninfo screen;
    struct fb_fix_screeninfo memory;

    if (ioctl(file, FBIOGET_VSCREENINFO, &screen) || ioctl(file, FBIOGET_FSCREENINFO, &memory)) return strerror(errno);
    if (screen.xres != picture->w_px || screen.yres != picture->h_px) return "the picture is of another size";
    if (screen.bits_per_pixel != 16 && screen.bits_per_pixel != 32) return "neither 16 nor 32 bits a pixel";
    screen.activate = FB_ACTIVATE_NOW | FB_ACTIVATE_FORCE;
    if (ioctl(file, FBIOPUT_VSCREENINFO, &screen)) return strerror(errno);
    return write_picture(file, &screen, memory.line_length, picture->rgb) ? NULL : "not all could be written";
}

int main(int argc, char **argv)
{
    struct picture picture;
    const int file = argc >= 3 ? open(argv[1], O_RDWR) : -1;

    if (file < 0 || !picture_read(&picture, argv[2])) {
        fprintf(stderr, "paint: %s: %s\n",
                argc >= 3 ? argv[file < 0 ? 1 : 2] : "a frame buffer and a picture are needed", strerror(errno));
        return EXIT_FAILURE;
    }
    if (argc > 3) to_bits(&picture);
    const char *wrong = paint(file, &picture);
    if (wrong) fprintf(stderr, "paint: %s: %s\n", argv[1], wrong);
    free(picture.rgb);
    close(file);
    return wrong ? EXIT_FAILURE : EXIT_SUCCESS;
}
