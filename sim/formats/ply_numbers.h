/* SPDX-License-Identifier: MIT
 *
 * The numbers of a PLY file's body, one after the other: words of a line for each element's instance, or bytes. */
#ifndef SIM_PLY_NUMBERS_H
#define SIM_PLY_NUMBERS_H

#include "files/text_lines.h"
#include "formats/ply_header.h"

struct ply_numbers {
    struct text text; /* its path, err, and end are those of bytes, too */
    enum ply_coding coding;
};

/* Begins an instance. false: the file ends. */
bool ply_numbers_begin(struct ply_numbers *numbers);

/* The next number. false: the line, or the file, ends before it. What is no number, or beyond float32, is NaN. */
bool ply_number(struct ply_numbers *numbers, enum ply_type type, double *value);

/* The same, passed over. */
bool ply_numbers_skip(struct ply_numbers *numbers, enum ply_type type, double count);

/* The word that was read last, for errors; bytes have none. */
struct word ply_number_word(const struct ply_numbers *numbers);

#endif
