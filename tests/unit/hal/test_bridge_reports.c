/* SPDX-License-Identifier: MIT
 *
 * All that is said between a host and a USB-HID bridge: each report, how long its answer is waited for, and what the
 * caller is told, at every speed and mode, with every fault of the cable at every report and with every byte of every
 * answer changed. It is as in tests/unit/hal/bridge_reports.expected. The bridges' own tests say what is right; this
 * tells that a report has become another. GOLDEN_FRAMES=write writes the file anew: what changes in it is explained
 * where it is committed. */
#include "golden/golden_stage.h"
#include "hid/mcp2210.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/bridge_rig.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_B = 2000, ANSWER_HEAD_B = 26 };

static struct bridge_rig rig;
static uint8_t bytes[MOST_B];

/* What is said, with the cable in between. */
static struct {
    struct reports cable;
    bool (*answer)(void *bridge, const uint8_t *report, uint8_t *answer);
    uint32_t hash;
    bool noted; /* byte by byte */
    long answers, mangled_at;
    size_t mangled_byte;
    uint8_t mangled_by;
} talk;

static int write_report(void *ctx, const uint8_t *report)
{
    size_t used_b = talk.cable.report_b;

    (void)ctx;
    talk.hash = golden_hash(talk.hash, report, talk.cable.report_b);
    while (used_b > 1 && !report[used_b - 1])
        used_b--;
    for (size_t i = 0; i < used_b && talk.noted; i++)
        golden_put("%s%02X", i ? " " : "\n  ", report[i]);
    return talk.cable.write(talk.cable.ctx, report);
}

static int read_report(void *ctx, uint8_t *report, uint32_t timeout_ms)
{
    (void)ctx;
    talk.hash = golden_hash(talk.hash, &timeout_ms, sizeof timeout_ms);
    return talk.cable.read(talk.cable.ctx, report, timeout_ms);
}

static uint64_t now_ms(void *ctx)
{
    (void)ctx;
    return talk.cable.now_ms(talk.cable.ctx);
}

static bool answer(void *bridge, const uint8_t *report, uint8_t *to)
{
    const bool answered = talk.answer(bridge, report, to);

    if (talk.answers++ == talk.mangled_at) to[talk.mangled_byte] ^= talk.mangled_by;
    return answered;
}

static void note_result(const struct bridge_kind *kind, const void *state, int err)
{
    const char *why = kind->why(state);

    talk.hash = golden_hash(golden_hash(talk.hash, &err, sizeof err), why, strlen(why));
    if (talk.noted && !err) golden_put("\n  done");
    if (talk.noted && err) golden_put("\n  %d: %s", err, why);
}

/* From the beginning to the end, whatever goes wrong. */
static void converse(const struct bridge_kind *kind, const struct bridge_config *config)
{
    static const size_t sizes_b[] = {1, 0, 59, 60, 61, 1, 120, 121, 255, 256, 505, 506, 510, 511, 512, 1020};
    const struct reports reports = {NULL, kind->report_b, write_report, read_report, now_ms};
    void *state = calloc(1, kind->state_b);

    assert_non_null(state);
    note_result(kind, state, kind->begin(state, &reports, config));
    for (size_t i = 0; i < sizeof sizes_b / sizeof *sizes_b; i++) {
        const size_t n_b = sizes_b[i] < kind->gathered_b ? sizes_b[i] : kind->gathered_b;
        note_result(kind, state, kind->send(state, bytes, n_b));
        if (i % 3 == 0) note_result(kind, state, kind->set(state, (unsigned)i % (kind->pins + 2u), i % 2));
    }
    note_result(kind, state, kind->send(state, bytes, kind->gathered_b < MOST_B ? kind->gathered_b : MOST_B));
    free(state);
}

/* The cable anew, and what will go wrong. */
static void connect(void)
{
    emulated_bridge_init(&rig.bridge, rig.glass.port);
    talk.cable = emulated_cable_reports(&rig.bridge.cable);
    talk.answer = rig.bridge.cable.answer;
    rig.bridge.cable.answer = answer;
    talk.answers = 0;
    talk.mangled_at = -1;
}

static struct bridge_config usual(void)
{
    return (struct bridge_config){.outputs = 0x29, .levels = 0x21, .selects = 0x10, .bit_rate_hz = 8000000};
}

static void put_conversation(const struct bridge_kind *kind)
{
    const struct bridge_config config = usual();

    bridge_rig_setup(&rig, "st7735", 24, 9);
    connect();
    talk.noted = true;
    golden_put("%s, %zu B at once, %u B a report:", kind->name, kind->gathered_b, kind->transfer_b);
    converse(kind, &config);
    talk.noted = false;
    golden_put("\n");
}

static void put_settings(const struct bridge_kind *kind)
{
    static const uint32_t rates_hz[] = {0,        1,        1463,     1464,      1465,      468749,
                                        468750,   468751,   937500,   1874999,   1875000,   3750000,
                                        7500000,  11999999, 12000000, 12000001,  15000000,  29999999,
                                        30000000, 59999999, 60000000, 100000000, UINT32_MAX};
    const struct bridge_config start = usual();

    golden_put("%s, settings:", kind->name);
    talk.hash = GOLDEN_HASH;
    for (size_t i = 0; i < sizeof rates_hz / sizeof *rates_hz; i++)
        for (uint8_t mode = 0; mode < 5; mode++) {
            struct bridge_config config = start;
            config.bit_rate_hz = rates_hz[i];
            config.mode = mode;
            connect();
            converse(kind, &config);
        }
    golden_put(" %08x, pins:", talk.hash);
    talk.hash = GOLDEN_HASH;
    for (unsigned pin = 0; pin < 16; pin++)
        for (unsigned how = 0; how < 4; how++) {
            struct bridge_config config = start;
            config.outputs = (uint16_t)(how & 1 ? 1u << pin : 0);
            config.levels = (uint16_t)(how == 3 ? 1u << pin : 0);
            config.selects = (uint16_t)(how & 2 ? 1u << (pin + 1) % 16 : 1u << pin);
            connect();
            converse(kind, &config);
        }
    golden_put(" %08x\n", talk.hash);
}

static void put_faults(const struct bridge_kind *kind)
{
    const struct bridge_config config = usual();

    golden_put("%s, faults:", kind->name);
    for (int fault = 0; fault < CABLE_FAULTS; fault++) {
        long n = 0;
        talk.hash = GOLDEN_HASH;
        do {
            connect();
            emulated_cable_arm(&rig.bridge.cable, n++, (enum cable_fault)fault, -EIO);
            converse(kind, &config);
        } while (rig.bridge.cable.faulted);
        golden_put(" %08x", talk.hash);
    }
    golden_put("\n");
}

static void put_answers(const struct bridge_kind *kind)
{
    static const uint8_t by[] = {0x01, 0x02, 0x10, 0x80, 0xFF};
    const struct bridge_config config = usual();

    golden_put("%s, answers:", kind->name);
    for (size_t byte = 0; byte < ANSWER_HEAD_B; byte++) {
        talk.hash = GOLDEN_HASH;
        for (size_t i = 0; i < sizeof by; i++)
            for (long n = 0; n < 12; n++) {
                connect();
                talk.mangled_at = n;
                talk.mangled_byte = byte;
                talk.mangled_by = by[i];
                converse(kind, &config);
            }
        golden_put(" %08x", talk.hash);
    }
    golden_put("\n");
}

static void all_is_said_as_it_was(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i * 37 + i / 256);
    put_conversation(&mcp2210);
    put_settings(&mcp2210);
    put_faults(&mcp2210);
    put_answers(&mcp2210);
    golden_compare("tests/unit/hal/bridge_reports.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_is_said_as_it_was)};

    return cmocka_run_group_tests_name("bridge_reports", tests, NULL, NULL);
}
