/* SPDX-License-Identifier: MIT */
#include "readers/vertex_numbers.h"

#include "readers/numbering.h"

#include <stdlib.h>
#include <string.h>

bool vertex_numbers_make(const char *path, struct vertex_numbers *out, struct error *err)
{
    struct whole_file file;
    *out = (struct vertex_numbers){0};
    if (!path_has_suffix(path, ".obj")) return true; /* the library chooses by suffix, too */
    if (!whole_file_read(path, &file, err)) return false;
    const int mark_b = whole_file_mark_b(file.bytes, file.size_b);
    const bool is_left = mark_b == WHOLE_FILE_UTF16;
    struct numbering work = {.path = path,
                             .at = file.bytes + (is_left ? 0 : mark_b),
                             .end = file.bytes + file.size_b,
                             .line = 1,
                             .err = err};
    const bool ok = is_left || number_obj(&work);
    if (ok && work.table.count) {
        numbering_write(&work, "", 1);
        *out = (struct vertex_numbers){{work.out, work.out_b - 1}, work.table};
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
