/* SPDX-License-Identifier: MIT */
#include "glass/emulated_cable.h"

#include <errno.h>
#include <string.h>

enum { CUT_B = 3 };

void emulated_cable_init(struct emulated_cable *cable, void *bridge,
                         bool (*answer)(void *bridge, const uint8_t *report, uint8_t *answer), size_t report_b)
{
    *cable = (struct emulated_cable){.bridge = bridge, .answer = answer, .report_b = report_b, .fault_at = CABLE_NEVER};
}

void emulated_cable_arm(struct emulated_cable *cable, long fault_at, enum cable_fault fault, int code)
{
    cable->fault_at = fault_at;
    cable->fault = fault;
    cable->fault_code = code;
    cable->reports = 0;
    cable->faulted = cable->read_fails = false;
}

void emulated_cable_push(struct emulated_cable *cable, const uint8_t *answer, size_t n_b)
{
    if (cable->n_answers == CABLE_ANSWERS) return; /* as a kernel's queue does */
    memcpy(cable->answers[cable->n_answers], answer, n_b);
    cable->answers_b[cable->n_answers++] = n_b;
}

void emulated_cable_replug(struct emulated_cable *cable)
{
    cable->unplugged = cable->read_fails = false;
    cable->n_answers = cable->late = 0;
}

/* The answers that are late are not seen before the next report. */
static void deliver(struct emulated_cable *cable, const uint8_t *report, bool faulty)
{
    uint8_t answer[CABLE_REPORT_MAX_B];

    cable->late = 0;
    const bool answered = cable->answer(cable->bridge, report, answer);
    if (!faulty && answered) emulated_cable_push(cable, answer, cable->report_b);
    if (!faulty) return;
    cable->read_fails = cable->fault == CABLE_UNREAD;
    if (!answered || cable->fault == CABLE_LOST || cable->fault == CABLE_UNREAD) return;
    if (cable->fault == CABLE_MANGLED) answer[0] ^= 0x80;
    emulated_cable_push(cable, answer, cable->fault == CABLE_CUT ? CUT_B : cable->report_b);
    if (cable->fault == CABLE_LATE) cable->late = cable->n_answers;
}

static int write_report(void *ctx, const uint8_t *report)
{
    struct emulated_cable *cable = ctx;
    const bool faulty = cable->reports++ == cable->fault_at;

    cable->now_ms++;
    if (faulty) {
        cable->faulted = true;
        if (cable->fault == CABLE_UNPLUGGED) cable->unplugged = true;
        if (cable->fault == CABLE_REFUSED) return cable->fault_code;
    }
    if (cable->unplugged) return -ENODEV;
    deliver(cable, report, faulty);
    return 0;
}

static int read_report(void *ctx, uint8_t *report, uint32_t timeout_ms)
{
    struct emulated_cable *cable = ctx;

    cable->now_ms++;
    if (cable->unplugged) return -ENODEV;
    if (cable->read_fails) {
        cable->read_fails = false;
        return cable->fault_code;
    }
    if (cable->empty_every && ++cable->reads % cable->empty_every == 0) return 0;
    if (cable->n_answers == cable->late) {
        cable->now_ms += timeout_ms;
        return 0;
    }
    const size_t n_b = cable->answers_b[0];
    memcpy(report, cable->answers[0], n_b);
    cable->n_answers--;
    memmove(cable->answers[0], cable->answers[1], sizeof *cable->answers * cable->n_answers);
    memmove(cable->answers_b, &cable->answers_b[1], sizeof *cable->answers_b * cable->n_answers);
    return (int)n_b;
}

static uint64_t now_ms(void *ctx)
{
    return ((const struct emulated_cable *)ctx)->now_ms;
}

struct reports emulated_cable_reports(struct emulated_cable *cable)
{
    return (struct reports){
        .ctx = cable, .report_b = cable->report_b, .write = write_report, .read = read_report, .now_ms = now_ms};
}
