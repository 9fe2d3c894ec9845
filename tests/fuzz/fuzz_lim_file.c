/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a .lim file: refused in one line that begins with the file's name; or read, and then
 * safe to draw. */
#include "fuzz_frame.h"
#include "scene/compiled.h"
#include "scene/lim_image.h"
#include "scene/scene_files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 6 };

/* From inside or from far away; the checksum throws the dice. */
static const char *draw(const struct lim_scene *scene, uint32_t crc32)
{
    static const struct lim_camera cameras[] = {{.eye_q8 = {1000, 2000, -3000},
                                                 .yaw = 0x12345678,
                                                 .pitch = 0x0FEDCBA9,
                                                 .tan_x_q28 = 1u << 28,
                                                 .tan_y_q28 = 1u << 28,
                                                 .near_q8 = 256},
                                                {.eye_q8 = {100000 * 256, 50000 * 256, 100000 * 256},
                                                 .yaw = 0x20000000,
                                                 .pitch = 0xF0000000,
                                                 .roll = 0x40000000,
                                                 .tan_x_q28 = 1u << 28,
                                                 .tan_y_q28 = 1u << 27,
                                                 .near_q8 = 256}};
    const struct fuzz_frame frame = {
        .scene = scene, .camera = cameras[crc32 >> 8 & 1], .w_px = SIDE_PX, .h_px = SIDE_PX};

    return fuzz_draw(&frame, (uint8_t)crc32);
}

/* What a big-endian host does to the bytes before it writes them, it undoes after it has read them. */
static const char *check_swaps(const struct compiled *read)
{
    const struct lim_file_header *header = read->image;
    unsigned char *bytes = malloc(read->image_b);

    memcpy(bytes, read->image, read->image_b);
    lim_image_swap_sections(bytes, header);
    lim_image_swap_header(bytes);
    lim_image_swap_header(bytes);
    lim_image_swap_sections(bytes, header);
    const bool same = memcmp(bytes, read->image, read->image_b) == 0;
    free(bytes);
    return same ? NULL : "bytes that were swapped twice are others";
}

/* A scene that was read is written as it was. */
static const char *check_write(const struct compiled *read)
{
    const char *path = fuzz_as_named_file("written.lim", NULL, 0);
    struct error err;

    if (!lim_file_write(read, path, &err)) return "a scene cannot be written";
    unsigned char *bytes = malloc(read->image_b + 1);
    FILE *file = fopen(path, "rb");
    const bool same = file && fread(bytes, 1, read->image_b + 1, file) == read->image_b &&
                      memcmp(bytes, read->image, read->image_b) == 0;
    if (file) fclose(file);
    free(bytes);
    return same ? NULL : "a scene was written otherwise than it was read";
}

static const char *check_read(const struct compiled *read, size_t size_b)
{
    const struct lim_file_header *header = read->image;

    if (read->image_b != size_b) return "a file was read that is longer or shorter than it says";
    if (!(isfinite(read->grid.units_per_m) && read->grid.units_per_m > 0)) return "a grid without a scale";
    const char *broken = check_swaps(read);
    if (!broken) broken = check_write(read);
    return broken ? broken : draw(&read->scene, header->crc32);
}

static const char *run(const uint8_t *bytes, size_t size_b)
{
    const char *path = fuzz_as_file(bytes, size_b);
    struct compiled read;
    struct error err;

    if (!lim_file_read(path, &read, &err)) {
        if (read.image) return "a refused file left something behind";
        return fuzz_check_refusal(err.text, path);
    }
    const char *broken = check_read(&read, size_b);
    compiled_free(&read);
    return broken;
}

/* Signature, version, sizes and checksum, as the counts in the header want them; on little-endian hosts. */
static size_t mend(uint8_t *bytes, size_t size_b, size_t max_b)
{
    struct lim_file_header header;

    if (max_b < sizeof header) return size_b;
    if (size_b < sizeof header) memset(bytes + size_b, 0, sizeof header - size_b);
    memcpy(&header, bytes, sizeof header);
    memcpy(header.magic, lim_file_magic, sizeof header.magic);
    header.version = LIM_FILE_VERSION;
    header.header_b = sizeof header;
    const size_t file_b = lim_image_section_b(&header, SECTION_COUNT);
    if (file_b > max_b) return size_b;
    if (size_b < file_b) memset(bytes + size_b, 0, file_b - size_b);
    header.file_b = (uint32_t)file_b;
    memcpy(bytes, &header, sizeof header);
    header.crc32 = lim_image_crc32(bytes, file_b);
    memcpy(bytes, &header, sizeof header);
    return file_b;
}

const struct fuzz_target fuzz_lim_file = {"lim_file", run, mend};
