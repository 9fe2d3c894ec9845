/* SPDX-License-Identifier: MIT */
#include "readers/vertex_numbers.h"

#include "readers/numbering.h"

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

bool vertex_numbers_make(const char *path, struct vertex_numbers *out, struct error *err)
{
    bool (*number)(struct numbering *) = format_of(path);
    struct whole_file file;
    *out = (struct vertex_numbers){0};
    if (!number) return true;
    if (!whole_file_read(path, &file, err)) return false;
    const int mark_b = whole_file_mark_b(file.bytes, file.size_b);
    const bool is_left = mark_b == WHOLE_FILE_UTF16;
    struct numbering work = {.path = path,
                             .at = file.bytes + (is_left ? 0 : mark_b),
                             .end = file.bytes + file.size_b,
                             .line = 1,
                             .err = err};
    const bool ok = is_left || number(&work);
    if (ok && (work.table.count || work.is_mended)) {
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
