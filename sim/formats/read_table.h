/* SPDX-License-Identifier: MIT
 *
 * What is read of each format, feature by feature, for people: `limner formats`. The readers do it; this list says so,
 * and tests/formats/what_is_read.sh holds every cell of it. Words that a reader says are those of model/note_words.h.
 */
#ifndef SIM_READ_TABLE_H
#define SIM_READ_TABLE_H

#include <stddef.h>

enum read_format {
    READ_OBJ,
    READ_GLTF,
    READ_PLY,
    READ_STL,
    READ_OFF,
    READ_3MF,
    READ_FBX,
    READ_COLLADA,
    READ_WAD, /* maps of Doom */
    READ_FORMATS
};

enum read_fate {
    READ_NONE,     /* the format has none of it */
    READ_DRAWN,    /* as the file says */
    READ_INSTEAD,  /* something else is drawn; `words` are those of the note */
    READ_LEFT_OUT, /* `words` likewise; NULL: nothing is said */
    READ_REFUSED   /* the file is; `words` are those of the error */
};

struct read_row {
    const char *feature;
    struct read_cell {
        enum read_fate fate;
        const char *words;
    } cells[READ_FORMATS];
};

const char *read_format_name(enum read_format format);
const char *read_fate_name(enum read_fate fate);

/* NULL: there are no more. */
const struct read_row *read_row_at(size_t index);

#endif
