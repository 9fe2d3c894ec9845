/* SPDX-License-Identifier: MIT */
#include "base/elf_segments.h"

#include <string.h>

enum {
    HEADER_B = 52,
    MACHINE_AT = 18,
    ENTRY_AT = 24,
    TABLE_AT = 28,
    ROW_SIZE_AT = 42,
    ROWS_AT = 44,
    ROW_B = 32,
    TYPE_LOAD = 1
};

static uint32_t half_at(const uint8_t *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8;
}

static uint32_t word_at(const uint8_t *at)
{
    return half_at(at) | half_at(at + 2) << 16;
}

static bool holds(const struct binary *file, uint32_t from_b, uint32_t n_b)
{
    return from_b <= file->size_b && n_b <= file->size_b - from_b;
}

static bool check_header(const struct binary *file, unsigned machine, struct error *err)
{
    static const uint8_t ident[] = {0x7F, 'E', 'L', 'F', 1 /* 32 bits */, 1 /* little-endian */, 1};

    if (file->size_b < HEADER_B || memcmp(file->bytes, ident, sizeof ident) != 0)
        return error_set(err, "is no ELF file of 32 bits, little-endian");
    const uint32_t found = half_at(file->bytes + MACHINE_AT);
    if (found != machine) return error_set(err, "is for processor %u of ELF's list, not %u", (unsigned)found, machine);
    if (half_at(file->bytes + ROW_SIZE_AT) != ROW_B) return error_set(err, "has no table of segments");
    return true;
}

static bool take_segment(const struct binary *file, const uint8_t *row, struct elf_program *out, struct error *err)
{
    const uint32_t from_b = word_at(row + 4), size_b = word_at(row + 16);

    if (word_at(row) != TYPE_LOAD || !size_b) return true;
    if (!holds(file, from_b, size_b)) return error_set(err, "is cut off: a segment lies behind its end");
    if (out->count == ELF_SEGMENTS_MAX) return error_set(err, "has more than %d segments", ELF_SEGMENTS_MAX);
    out->segments[out->count++] = (struct elf_segment){word_at(row + 8), file->bytes + from_b, size_b};
    return true;
}

bool elf_program_read(const struct binary *file, unsigned machine, struct elf_program *out, struct error *err)
{
    if (!check_header(file, machine, err)) return false;
    const uint32_t table_b = word_at(file->bytes + TABLE_AT), rows = half_at(file->bytes + ROWS_AT);
    *out = (struct elf_program){.entry = word_at(file->bytes + ENTRY_AT)};
    if (!holds(file, table_b, rows * ROW_B)) return error_set(err, "is cut off: its table of segments is not there");
    for (uint32_t i = 0; i < rows; i++)
        if (!take_segment(file, file->bytes + table_b + i * ROW_B, out, err)) return false;
    return out->count || error_set(err, "has no segment that is loaded");
}
