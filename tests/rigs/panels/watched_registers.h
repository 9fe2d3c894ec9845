/* SPDX-License-Identifier: MIT
 *
 * Memory in the place of registers that notices each access, reads among them, and may change in between as a
 * peripheral would: a page that may not be touched, so that every instruction which does is seen, helped and noted. An
 * instruction that reads and writes counts as a write. Needs a processor that can stop after one instruction and tell
 * what it did: x86-64. */
#ifndef TESTS_WATCHED_REGISTERS_H
#define TESTS_WATCHED_REGISTERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { WATCHED_B = 4096, WATCHED_LOG_MAX = 256 };

struct watched_write {
    uint16_t at_b;
    uint32_t value; /* of the 32 bits from there on, afterwards */
};

struct watched_registers {
    void (*before_read)(size_t at_b); /* may change what is at hand; NULL: nothing moves */
    void (*after_write)(size_t at_b);
    uint32_t reads[WATCHED_B], writes[WATCHED_B]; /* by offset */
    struct watched_write log[WATCHED_LOG_MAX];
    unsigned n_log;
};

extern struct watched_registers watched;

/* False: not on this processor. */
bool watched_is_possible(void);

/* The page, all zeros, open to everybody until it is watched. *watched begins anew, without hooks. */
void *watched_begin(void);

/* From now on accesses are noted; hooks, which are called within a signal, may touch the page freely. */
void watched_start(void);
void watched_stop(void);

/* Times that a value was written to an offset. */
unsigned watched_times(size_t at_b, uint32_t value);

#endif
