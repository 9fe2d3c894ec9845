/* SPDX-License-Identifier: MIT
 *
 * A USB cable between struct reports and an emulated HID bridge: a queue of answers, a clock, and all that goes wrong
 * on the way: a plug pulled out, answers lost, late, cut off or somebody else's, empty packets. Each report, either
 * way, takes a millisecond. */
#ifndef SIM_EMULATED_CABLE_H
#define SIM_EMULATED_CABLE_H

#include "hid/reports.h"

enum { CABLE_REPORT_MAX_B = 512, CABLE_ANSWERS = 8, CABLE_NEVER = -1 };

/* What happens to a report or to its answer. */
enum cable_fault {
    CABLE_REFUSED,  /* the report is not sent: write fails with fault_code */
    CABLE_UNREAD,   /* the report takes effect, and the next read fails with fault_code */
    CABLE_LOST,     /* it takes effect, and there is no answer */
    CABLE_LATE,     /* the answer comes with that of the next report */
    CABLE_CUT,      /* the answer is cut off */
    CABLE_MANGLED,  /* the answer is to another command */
    CABLE_UNPLUGGED /* the plug is pulled before the report: everything fails with -ENODEV until it is back */
};
enum { CABLE_FAULTS = CABLE_UNPLUGGED + 1 };

struct emulated_cable {
    void *bridge;
    bool (*answer)(void *bridge, const uint8_t *report, uint8_t *answer); /* false: there is none */
    size_t report_b;

    /* What goes wrong. */
    long fault_at; /* index of the report; CABLE_NEVER */
    enum cable_fault fault;
    int fault_code;       /* negative errno */
    unsigned empty_every; /* each so many-th read returns nothing, at once; 0: none */

    /* To be read. */
    uint64_t now_ms;
    long reports; /* sent since fault_at was set */
    bool faulted, unplugged;

    /* Private: answers on their way, the oldest first. */
    uint8_t answers[CABLE_ANSWERS][CABLE_REPORT_MAX_B];
    size_t answers_b[CABLE_ANSWERS];
    unsigned n_answers, late, reads;
    bool read_fails;
};

void emulated_cable_init(struct emulated_cable *cable, void *bridge,
                         bool (*answer)(void *bridge, const uint8_t *report, uint8_t *answer), size_t report_b);

/* Report number fault_at from now meets the fault; whatever was before is forgotten, but for answers on their way. */
void emulated_cable_arm(struct emulated_cable *cable, long fault_at, enum cable_fault fault, int code);

/* An answer that nobody asked for waits at the host's end. */
void emulated_cable_push(struct emulated_cable *cable, const uint8_t *answer, size_t n_b);

/* Plugged in again: nothing is on its way. */
void emulated_cable_replug(struct emulated_cable *cable);

struct reports emulated_cable_reports(struct emulated_cable *cable);

#endif
