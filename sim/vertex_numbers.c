/* SPDX-License-Identifier: MIT */
#include "vertex_numbers.h"

#include "numbering.h"

#include <stdlib.h>
#include <string.h>

/* The library chooses by suffix, too. */
static bool (*format_of(const char *path))(struct numbering *)
{
    static const struct {
        const char *suffix;
        bool (*number)(struct numbering *);
    } formats[] = {{".obj", number_obj}, {".ply", number_ply}, {".stl", number_stl}, {".off", number_off}};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (path_has_suffix(path, formats[i].suffix)) return formats[i].number;
    return NULL;
}

/* Bytes in front of UTF-8 that say so. UTF-16 (-1) is left to the library. */
static int byte_order_mark(const struct whole_file *file)
{
    const unsigned char *bytes = (const unsigned char *)file->bytes;
    if (file->size_b >= 3 && bytes[0] == 0xEF && bytes[1] == 0xBB && bytes[2] == 0xBF) return 3;
    return file->size_b >= 2 && (bytes[0] ^ bytes[1]) == 1 && bytes[0] >= 0xFE ? -1 : 0;
}

bool vertex_numbers_make(const char *path, struct vertex_numbers *out, struct error *err)
{
    bool (*number)(struct numbering *) = format_of(path);
    struct whole_file file;
    *out = (struct vertex_numbers){0};
    if (!number) return true;
    if (!whole_file_read(path, &file, err)) return false;
    const int mark_b = byte_order_mark(&file);
    struct numbering work = {
        .path = path, .at = file.bytes + mark_b, .end = file.bytes + file.size_b, .line = 1, .err = err};
    const bool ok = mark_b < 0 || number(&work);
    if (ok && work.table.count) {
        numbering_write(&work, "", 1);
        *out = (struct vertex_numbers){{work.out, work.out_b - 1}, work.table, work.is_float32};
    } else {
        free(work.out);
        vertex_table_free(&work.table);
    }
    whole_file_free(&file);
    return ok;
}

void vertex_numbers_free(struct vertex_numbers *numbers)
{
    whole_file_free(&numbers->file);
    vertex_table_free(&numbers->table);
}
