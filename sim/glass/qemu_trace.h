/* SPDX-License-Identifier: MIT
 *
 * What firmware in QEMU wrote to registers, as `-trace memory_region_ops_write` tells it, becomes what went over a
 * display's wires, by a map of the board's registers, a line each:
 *
 *     spi ADDRESS                 data register of the SPI; addresses are hexadecimal
 *     pin NAME IDIOM ADDRESS BIT  a wire, as wire_log.h names them, and the bit of a register that sets it:
 *         bsrr    the lower half's ones set, the upper half's reset (STM32)
 *         clear   ones reset (BRR of STM32F1)
 *         masked  bits 9..2 of the address say which bits change; ADDRESS is that of no bits (PL061)
 *         output  all bits are levels (output_val of FE310)
 *     # ...                       nothing; neither do empty lines
 *
 * QEMU tells no time. */
#ifndef SIM_QEMU_TRACE_H
#define SIM_QEMU_TRACE_H

#include "glass/listener.h"

enum { QEMU_TRACE_REGISTERS = 32 };

enum qemu_idiom { QEMU_SPI, QEMU_BSRR, QEMU_CLEAR, QEMU_MASKED, QEMU_OUTPUT };

struct qemu_register {
    enum qemu_idiom idiom;
    uint64_t address;
    enum listener_pin pin; /* not of the SPI */
    uint8_t bit;
};

struct qemu_map {
    struct qemu_register registers[QEMU_TRACE_REGISTERS];
    size_t count;
};

/* An error names the file and the line. */
bool qemu_map_read(struct qemu_map *map, const char *path, struct error *err);

/* Whether a line is of a trace; else it is something that QEMU or the firmware says. */
bool qemu_trace_is(const char *line);

/* A line of a trace. An error says what is wrong with it. */
bool qemu_trace_take(const struct qemu_map *map, struct listener *listener, const char *line, struct error *err);

#endif
