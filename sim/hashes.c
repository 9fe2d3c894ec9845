/* SPDX-License-Identifier: MIT
 *
 * Frame hashes and their text files. */
#include "hashes.h"

#include "input_file.h"

#include <inttypes.h>
#include <string.h>

enum { LINE_MOST_B = 63, FILE_MOST_B = 64 << 20 };

uint64_t hash_pixels(const uint16_t *pixels, size_t count)
{
    const uint64_t prime = 0x100000001b3;
    uint64_t hash = 0xcbf29ce484222325;
    for (size_t i = 0; i < count; i++) {
        hash = (hash ^ (pixels[i] >> 8)) * prime;
        hash = (hash ^ (pixels[i] & 0xFF)) * prime;
    }
    return hash;
}

bool hashes_write(const uint64_t *hashes, size_t count, FILE *file)
{
    for (size_t frame = 0; frame < count; frame++)
        if (fprintf(file, "%zu %016" PRIx64 "\n", frame, hashes[frame]) < 0) return false;
    return true;
}

static bool check_lines(const uint64_t *hashes, size_t count, struct input_lines *lines, struct error *err)
{
    const char *path = lines->path;
    size_t frame = 0;
    for (; input_line(lines, err); frame++) {
        const char *line = lines->line;
        size_t number;
        uint64_t expected;
        int end = 0;
        if (sscanf(line, "%zu %16" SCNx64 " %n", &number, &expected, &end) != 2 || line[end] || number != frame)
            return error_set(err, "%s:%zu: not a frame's number and hash", path, frame + 1);
        if (frame < count && expected != hashes[frame])
            return error_set(err, "%s: frame %zu differs: hash %016" PRIx64 ", expected %016" PRIx64, path, frame,
                             hashes[frame], expected);
    }
    if (err->text[0]) return false;
    if (frame != count) return error_set(err, "%s: has %zu frames, %zu were rendered", path, frame, count);
    return true;
}

bool hashes_check(const uint64_t *hashes, size_t count, const char *path, struct error *err)
{
    struct input_lines lines = {.path = path, .line_most_b = LINE_MOST_B};
    err->text[0] = '\0';
    lines.file = input_open(path, FILE_MOST_B, NULL, err);
    if (!lines.file) return false;
    const bool ok = check_lines(hashes, count, &lines, err);
    input_lines_free(&lines);
    fclose(lines.file);
    return ok;
}
