/* SPDX-License-Identifier: MIT
 *
 * Frame hashes and their text files. */
#include "pictures/hashes.h"

#include "base/grow.h"
#include "base/input_file.h"

#include <inttypes.h>
#include <stdlib.h>
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

struct hashes {
    uint64_t *items;
    size_t count, capacity;
};

static bool read_lines(struct hashes *hashes, struct input_lines *lines, struct error *err)
{
    while (input_line(lines, err)) {
        const char *line = lines->line;
        size_t number;
        uint64_t hash;
        int end = 0;
        if (sscanf(line, "%zu %16" SCNx64 " %n", &number, &hash, &end) != 2 || line[end] || number != hashes->count)
            return error_set(err, "%s:%zu: not a frame's number and hash", lines->path, lines->number);
        hashes->items = grow(hashes->items, hashes->count, &hashes->capacity, sizeof hash);
        hashes->items[hashes->count++] = hash;
    }
    return !err->text[0];
}

static bool read_file(struct hashes *hashes, const char *path, struct error *err)
{
    struct input_lines lines = {.path = path, .line_most_b = LINE_MOST_B};
    err->text[0] = '\0';
    lines.file = input_open(path, FILE_MOST_B, NULL, err);
    if (!lines.file) return false;
    const bool ok = read_lines(hashes, &lines, err);
    input_lines_free(&lines);
    fclose(lines.file);
    return ok;
}

/* How many frames are as they should be if the first one is the file's frame `from`, and the file goes round. */
static size_t count_same(const struct hashes *wanted, size_t from, const uint64_t *hashes, size_t count)
{
    size_t same = 0;
    while (same < count && hashes[same] == wanted->items[(from + same) % wanted->count])
        same++;
    return same;
}

static bool refuse(size_t frame, const uint64_t *hashes, uint64_t expected, const char *path, struct error *err)
{
    return error_set(err, "%s: frame %zu differs: hash %016" PRIx64 ", expected %016" PRIx64, path, frame,
                     hashes[frame], expected);
}

static bool compare(const struct hashes *wanted, const uint64_t *hashes, size_t count, const char *path,
                    struct error *err)
{
    const size_t both = wanted->count < count ? wanted->count : count;
    const size_t same = both ? count_same(wanted, 0, hashes, both) : 0;
    if (same < both) return refuse(same, hashes, wanted->items[same], path, err);
    return wanted->count == count ||
           error_set(err, "%s: has %zu frames, %zu were rendered", path, wanted->count, count);
}

/* From where on most are the same. */
static bool compare_loop(const struct hashes *wanted, const uint64_t *hashes, size_t count, const char *path,
                         struct error *err)
{
    size_t most = 0, from = 0;
    for (size_t i = 0; i < wanted->count && most < count; i++) {
        const size_t same = count_same(wanted, i, hashes, count);
        if (same > most) from = i;
        if (same > most) most = same;
    }
    if (most == count && count) return true;
    if (most == 0) return error_set(err, "%s: the first frame is none of its %zu", path, wanted->count);
    return refuse(most, hashes, wanted->items[(from + most) % wanted->count], path, err);
}

bool hashes_check(const uint64_t *hashes, size_t count, const char *path, struct error *err)
{
    struct hashes wanted = {.items = NULL};
    const bool ok = read_file(&wanted, path, err) && compare(&wanted, hashes, count, path, err);
    free(wanted.items);
    return ok;
}

bool hashes_check_loop(const uint64_t *hashes, size_t count, const char *path, struct error *err)
{
    struct hashes wanted = {.items = NULL};
    const bool ok = read_file(&wanted, path, err) && compare_loop(&wanted, hashes, count, path, err);
    free(wanted.items);
    return ok;
}
