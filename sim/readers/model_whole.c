/* SPDX-License-Identifier: MIT */
#include "readers/model_whole.h"

#include "base/binary.h"
#include "files/whole_file.h"

#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE_B = 1 << 20 };

bool model_text_fits(const char *path, const char *text, size_t size_b, struct error *err)
{
    size_t line_b = 0, longest_b = 0;
    for (size_t i = 0; i < size_b; i++) {
        line_b = text[i] == '\n' || text[i] == '\r' ? 0 : line_b + 1;
        if (line_b > longest_b) longest_b = line_b;
    }
    if (whole_file_mark_b(text, size_b) != WHOLE_FILE_UTF16 && memchr(text, 0, size_b))
        return error_set(err, "%s: a NUL byte in a text", path);
    return longest_b <= LONGEST_LINE_B || error_set(err, "%s: a line is longer than %d bytes", path, LONGEST_LINE_B);
}

/* Corners may end with the / behind which numbers are missing, if all do. */
static bool ends_as_first_word(const char *line)
{
    const char *first = line + strcspn(line, " \t");
    first += strspn(first, " \t");
    const size_t length = strcspn(first, " \t");
    return length && first[length - 1] == line[strlen(line) - 1];
}

/* Words of a line after its first; 0 if the last of them cannot be whole. */
static size_t words_after(const char *line)
{
    size_t count = 0;
    const char end = line[strlen(line) - 1];
    for (const char *at = line + strcspn(line, " \t"); at[strspn(at, " \t")]; count++) {
        at += strspn(at, " \t");
        at += strcspn(at, " \t");
    }
    return strchr("+-.eE", end) || (end == '/' && !ends_as_first_word(line)) ? 0 : count;
}

/* The last line alone can show it: if it has no end, and fewer numbers than a vertex or a face needs. */
static bool obj_is_whole(const char *path, const struct binary *file, struct error *err)
{
    char line[256];
    size_t length = 0;
    if (!model_text_fits(path, (const char *)file->bytes, file->size_b, err)) return false;
    while (length < file->size_b && file->bytes[file->size_b - 1 - length] != '\n' &&
           file->bytes[file->size_b - 1 - length] != '\r')
        length++;
    if (length < 2 || length >= sizeof line) return true;
    memcpy(line, file->bytes + file->size_b - length, length);
    line[length] = '\0';
    const bool is_vertex = strncmp(line, "v ", 2) == 0, is_face = strncmp(line, "f ", 2) == 0;
    if ((!is_vertex && !is_face) || words_after(line) >= 3) return true;
    return error_set(err, "%s: truncated: its last line is '%.40s'", path, line);
}

bool model_is_whole(const char *path, struct error *err)
{
    struct binary file;
    if (!path_has_suffix(path, ".obj")) return true;
    if (!binary_read(path, MODEL_FILE_MOST_B, &file, err)) return false;
    const bool ok = obj_is_whole(path, &file, err);
    free(file.bytes);
    return ok;
}
