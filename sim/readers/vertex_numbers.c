/* SPDX-License-Identifier: MIT */
#include "readers/vertex_numbers.h"

#include "files/utf16.h"
#include "readers/numbering.h"
#include "readers/obj_library.h"
#include "readers/obj_survey.h"

#include <stdlib.h>

static bool make(const char *path, const struct whole_file *file, struct vertex_numbers *out, struct error *err)
{
    struct numbering work = {.path = path, .obj = &out->obj, .err = err};
    bool ok = obj_survey(&out->obj, path, file->bytes, file->size_b, err);
    ok = ok && number_obj(&work, file->bytes, file->size_b);
    if (ok && work.table.count) {
        numbering_write(&work, "", 1);
        out->file = (struct whole_file){work.out, work.out_b - 1};
        out->table = work.table;
        out->materials = obj_materials_text(&out->obj);
    } else {
        free(work.out);
        vertex_table_free(&work.table);
    }
    return ok;
}

bool vertex_numbers_make(const char *path, struct vertex_numbers *out, struct error *err)
{
    struct whole_file file;
    *out = (struct vertex_numbers){0};
    if (!path_has_suffix(path, ".obj")) return true; /* the library chooses by suffix, too */
    if (!whole_file_read(path, &file, err)) return false;
    utf8_from_utf16(&file);
    const bool ok = make(path, &file, out, err);
    whole_file_free(&file);
    if (!ok) vertex_numbers_free(out);
    return ok;
}

void vertex_numbers_free(struct vertex_numbers *numbers)
{
    whole_file_free(&numbers->file);
    whole_file_free(&numbers->materials);
    vertex_table_free(&numbers->table);
    obj_free(&numbers->obj);
}
