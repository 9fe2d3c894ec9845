/* SPDX-License-Identifier: MIT
 *
 * Writing and reading .lim files. The whole file is in memory at once. */
#include "base/grow.h"
#include "base/input_file.h"
#include "scene/lim_check.h"
#include "scene/lim_image.h"
#include "scene/scene_files.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

enum { FILE_MOST_B = 1 << 30 };
static const bool HOST_IS_BIG_ENDIAN = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

/* Writing ------------------------------------------------------------------------------------ */

/* The image as the file has it: checksummed, little-endian. */
static unsigned char *file_bytes(const struct compiled *scene)
{
    unsigned char *bytes = grow_zeroed(scene->image_b, 1);
    memcpy(bytes, scene->image, scene->image_b);
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_sections(bytes, scene->image);
    struct lim_file_header header;
    memcpy(&header, bytes, sizeof header);
    if (scene->report.w_px) header.drawn_by = 1 + (uint32_t)scene->report.draws; /* it was compiled, not read */
    memcpy(bytes, &header, sizeof header);
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_header(bytes);
    header.crc32 = lim_image_crc32(bytes, scene->image_b);
    memcpy(bytes, &header, sizeof header);
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_header(bytes);
    return bytes;
}

bool lim_file_put(const struct compiled *scene, const char *path, struct outputs *outputs, struct error *err)
{
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    unsigned char *bytes = file_bytes(scene);
    fwrite(bytes, 1, scene->image_b, file); /* outputs_close() reports what failed */
    free(bytes);
    return outputs_close(file, path, err);
}

bool lim_file_write(const struct compiled *scene, const char *path, struct error *err)
{
    struct outputs outputs = {0};
    return scene_files_finish(&outputs, lim_file_put(scene, path, &outputs, err), err);
}

/* Reading ------------------------------------------------------------------------------------ */

/* Reads the header's bytes and says what they are, if they are no whole header. */
static bool read_header(FILE *file, struct lim_file_header *header, const char *path, struct error *err)
{
    size_t got_b = fread(header, 1, sizeof *header, file);
    if (ferror(file)) return error_set(err, "%s: %s", path, strerror(errno));
    if (got_b == 0) return error_set(err, "%s: empty file", path);
    size_t magic_b = got_b < sizeof header->magic ? got_b : sizeof header->magic;
    if (memcmp(header->magic, lim_file_magic, magic_b) != 0) return error_set(err, "%s: not a Limner scene", path);
    if (got_b < sizeof *header) return error_set(err, "%s: truncated: %zu bytes, less than a header", path, got_b);
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_header(header);
    return true;
}

static bool check_header(const struct lim_file_header *header, const char *path, struct error *err)
{
    if (header->version != LIM_FILE_VERSION)
        return error_set(err, "%s: version %lu; this program reads version %d, compile the model again", path,
                         (unsigned long)header->version, LIM_FILE_VERSION);
    const uint32_t fractions = header->counts[SECTION_FRACTIONS], uvs = header->counts[SECTION_UVS];
    const bool is_long = header->coordinate_bits == 32;
    if (header->coordinate_bits != 16 && header->coordinate_bits != 32)
        return error_set(err, "%s: damaged: coordinates of %lu bits", path, (unsigned long)header->coordinate_bits);
    if (header->drawn_by > METHOD_DRAWS)
        return error_set(err, "%s: drawn by a method that this program does not know", path);
    if (header->header_b != sizeof *header || header->file_b != lim_image_section_b(header, SECTION_COUNT) ||
        (fractions && fractions != header->counts[SECTION_VERTICES]) ||
        ((uvs || is_long) && uvs != header->counts[is_long ? SECTION_MAPPINGS : SECTION_VERTICES]))
        return error_set(err, "%s: damaged: the header contradicts itself", path);
    for (enum lim_section i = SECTION_MAPPINGS; i < SECTION_COUNT; i++)
        if (header->counts[i] > UINT16_MAX)
            return error_set(err, "%s: damaged: %lu elements in section %d, 65535 are the most", path,
                             (unsigned long)header->counts[i], (int)i);
    return true;
}

static bool check_grid(const struct grid *grid, struct error *err)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(grid->origin_m[i])) return error_set(err, "the origin is not finite");
    return (isfinite(grid->units_per_m) && grid->units_per_m > 0.0) ||
           error_set(err, "the units per metre are not a positive number");
}

/* Before there is memory for all that the header promises: a file of known length may be shorter. */
static bool check_length(FILE *file, const struct lim_file_header *header, const char *path, struct error *err)
{
    struct stat about;
    if (fstat(fileno(file), &about) != 0 || !S_ISREG(about.st_mode) || about.st_size >= (off_t)header->file_b)
        return true;
    return error_set(err, "%s: truncated: %lld of %lu bytes", path, (long long)about.st_size,
                     (unsigned long)header->file_b);
}

/* Reads what follows the header. The checksum covers the file's own bytes: no swapping before. */
static bool read_rest(FILE *file, const struct lim_file_header *header, unsigned char *image, const char *path,
                      struct error *err)
{
    size_t rest_b = header->file_b - sizeof *header;
    size_t got_b = fread(image + sizeof *header, 1, rest_b, file);
    if (ferror(file)) return error_set(err, "%s: %s", path, strerror(errno));
    if (got_b < rest_b)
        return error_set(err, "%s: truncated: %zu of %lu bytes", path, sizeof *header + got_b,
                         (unsigned long)header->file_b);
    if (fgetc(file) != EOF)
        return error_set(err, "%s: damaged: goes on behind its %lu bytes", path, (unsigned long)header->file_b);
    memcpy(image, header, sizeof *header);
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_header(image);
    bool intact = lim_image_crc32(image, header->file_b) == header->crc32;
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_header(image);
    if (HOST_IS_BIG_ENDIAN) lim_image_swap_sections(image, header);
    return intact || error_set(err, "%s: damaged: the checksum is wrong", path);
}

/* What lies between sections. */
static bool check_gaps(const unsigned char *image, const struct lim_file_header *header, struct error *err)
{
    for (enum lim_section i = 0; i < SECTION_COUNT; i++)
        for (uint64_t at_b = lim_image_section_end_b(header, i); at_b < lim_image_section_b(header, i + 1); at_b++)
            if (image[at_b])
                return error_set(err, "byte %llu: not zero, between two sections", (unsigned long long)at_b);
    return true;
}

static bool check_faces(const struct compiled *scene, struct error *err)
{
    for (size_t i = 0; i < scene->scene.polygon_count; i++)
        if (!scene->faces[i]) return error_set(err, "polygon %zu: of face 0; they are counted from 1", i);
    return true;
}

static bool read_scene(FILE *file, const char *path, struct compiled *out, struct error *err)
{
    struct lim_file_header header;
    if (!read_header(file, &header, path, err) || !check_header(&header, path, err)) return false;
    if (!check_length(file, &header, path, err)) return false;
    void *image = grow_zeroed(header.file_b, 1);
    bool ok = read_rest(file, &header, image, path, err);
    if (ok) {
        lim_image_bind(image, out);
        out->report.draws = header.drawn_by ? (enum lim_method)(header.drawn_by - 1) : method_of_scene(&out->scene);
        ok = (check_gaps(image, &header, err) && check_grid(&out->grid, err) && lim_check(&out->scene, err) &&
              check_faces(out, err)) ||
             error_prefix(err, path);
    }
    if (!ok) free(image);
    if (!ok) free(out->of_32_bits);
    return ok;
}

bool lim_file_is_named(const char *path)
{
    const char *suffix = strrchr(path, '.');
    return suffix && strcasecmp(suffix, ".lim") == 0;
}

bool lim_file_read(const char *path, struct compiled *out, struct error *err)
{
    *out = (struct compiled){0};
    FILE *file = input_open(path, FILE_MOST_B, NULL, err);
    if (!file) return false;
    bool ok = read_scene(file, path, out, err);
    fclose(file);
    if (!ok) *out = (struct compiled){0};
    return ok;
}
