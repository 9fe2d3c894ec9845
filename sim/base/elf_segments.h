/* SPDX-License-Identifier: MIT
 *
 * What of a linked program is loaded, and where: the segments of an ELF file of 32 bits, little-endian (Tool Interface
 * Standard, Executable and Linking Format, version 1.2). */
#ifndef SIM_ELF_SEGMENTS_H
#define SIM_ELF_SEGMENTS_H

#include "base/binary.h"

enum { ELF_RISCV = 243, ELF_SEGMENTS_MAX = 16 };

struct elf_segment {
    uint32_t address;
    const uint8_t *bytes; /* of the file */
    uint32_t size_b;      /* in the file, not 0 */
};

struct elf_program {
    uint32_t entry;
    struct elf_segment segments[ELF_SEGMENTS_MAX];
    unsigned count;
};

/* Refused: what is no such file or cut off, of another processor than `machine`, or has no segments or too many. */
bool elf_program_read(const struct binary *file, unsigned machine, struct elf_program *out, struct error *err);

#endif
