/* SPDX-License-Identifier: MIT
 *
 * The bridges' protocols against a script that answers report by report, on a clock of its own: how long answers are
 * waited for, what is passed over, that the transport's codes come back unchanged, and which settings are refused. */
#include "hid/mcp2210.h"
#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum { PATIENCE_MS = 1000, QUIET_MS = 20, STALE_MOST = 64, REPORTS_MAX = 32, NEVER = -1 };

static struct {
    const struct bridge_kind *kind;
    uint64_t now_ms;
    unsigned look_ms; /* that a look at the clock takes */
    /* What is to happen. */
    int fail_write_at, fail_read_at, code;
    unsigned stale;                      /* reports that are there before anybody asks */
    unsigned silent_from;                /* reports from this one on get no answer; 0: all do */
    unsigned early_ms;                   /* reads end after so long, with nothing, at first; 0: they do not */
    int other_b;                         /* length of an answer that comes before the right one; 0: none comes */
    bool other_is_ours;                  /* it has the command that was sent */
    uint8_t status, engine_full, engine; /* engine_full: after a report that is full */
    /* What happened. */
    int writes, reads;
    unsigned quiet_reads;
    uint32_t timeouts_ms[8];
    unsigned n_timeouts;
    uint8_t reports[REPORTS_MAX][MCP2210_REPORT_B];
} script;

static union {
    uint64_t aligned;
    uint8_t state[4096];
} bridge;

static uint8_t *last(void)
{
    return script.reports[(script.writes - 1) % REPORTS_MAX];
}

static int write(void *ctx, const uint8_t *report)
{
    (void)ctx;
    if (script.writes == script.fail_write_at) {
        script.fail_write_at = NEVER;
        return script.code;
    }
    script.writes++;
    memcpy(last(), report, script.kind->report_b);
    script.n_timeouts = 0;
    return 0;
}

static void answer_mcp2210(uint8_t *to)
{
    memset(to, 0, MCP2210_REPORT_B);
    to[0] = last()[0];
    to[1] = script.status;
    if (to[0] == 0x42) to[3] = last()[1] == 60 ? script.engine_full : script.engine;
}

static int read(void *ctx, uint8_t *to, uint32_t timeout_ms)
{
    (void)ctx;
    if (script.reads++ == script.fail_read_at) {
        script.fail_read_at = NEVER;
        return script.code;
    }
    if (script.n_timeouts < 8) script.timeouts_ms[script.n_timeouts++] = timeout_ms;
    if (timeout_ms == QUIET_MS) {
        script.quiet_reads++;
        if (!script.stale) return 0;
        script.stale--;
        memset(to, 0x42, script.kind->report_b);
        return (int)script.kind->report_b;
    }
    if (script.silent_from && script.writes >= (int)script.silent_from) {
        script.now_ms += script.early_ms ? script.early_ms : timeout_ms;
        script.early_ms = 0;
        return 0;
    }
    answer_mcp2210(to);
    const int other_b = script.other_b;
    script.other_b = 0;
    if (other_b && !script.other_is_ours) to[0] ^= 1;
    return other_b ? other_b : (int)script.kind->report_b;
}

static uint64_t now_ms(void *ctx)
{
    (void)ctx;
    script.now_ms += script.look_ms;
    return script.now_ms;
}

static struct bridge_config usual(void)
{
    return (struct bridge_config){.bit_rate_hz = 3000000, .mode = 3, .outputs = 0x1F, .levels = 2, .selects = 0x20};
}

static void reset(const struct bridge_kind *kind)
{
    memset(&script, 0, sizeof script);
    memset(&bridge, 0, sizeof bridge);
    script.kind = kind;
    script.fail_write_at = script.fail_read_at = NEVER;
    script.engine = 0x10;
    script.engine_full = 0x20;
    script.now_ms = 5000;
    assert_true(kind->state_b <= sizeof bridge);
}

static int begin_with(const struct bridge_config *config)
{
    const struct reports reports = {NULL, script.kind->report_b, write, read, now_ms};
    return script.kind->begin(bridge.state, &reports, config);
}

static int begin(void)
{
    const struct bridge_config config = usual();
    return begin_with(&config);
}

static int send_some(void)
{
    static const uint8_t bytes[70] = {1, 2, 3};
    return script.kind->send(bridge.state, bytes, sizeof bytes);
}

static int set_pin(void)
{
    return script.kind->set(bridge.state, 3, true);
}

static int (*const calls[])(void) = {begin, send_some, set_pin};

/* As begun, with a script from here on. */
static void begun(const struct bridge_kind *kind)
{
    reset(kind);
    assert_int_equal(begin(), 0);
    script.writes = script.reads = 0;
    script.quiet_reads = 0;
}

static void assert_why(const char *text)
{
    const char *why = script.kind->why(bridge.state);
    if (!strstr(why, text)) fail_msg("\"%s\" does not say \"%s\"", why, text);
}

/* Whatever report it was, and whatever the code; then everything is put in order again. */
static void codes_of_the_transport_come_back(void **state)
{
    static const int codes[] = {-1, -2, -EIO, -7000};

    (void)state;
    for (size_t i = 0; i < 3; i++) {
        begun(&mcp2210);
        assert_int_equal(calls[i](), 0);
        const int writes = script.writes, reads = script.reads;
        assert_true(writes > 0 && reads > 0);
        for (int n = 0; n < writes + reads; n++) {
            begun(&mcp2210);
            script.code = codes[n % 4];
            *(n < writes ? &script.fail_write_at : &script.fail_read_at) = n < writes ? n : n - writes;
            assert_int_equal(calls[i](), script.code);
            assert_string_equal(script.kind->why(bridge.state), "");
            script.quiet_reads = 0;
            assert_int_equal(send_some(), 0);
            assert_int_equal(script.quiet_reads, 1);
            assert_int_equal(send_some(), 0);
            assert_int_equal(script.quiet_reads, 1);
        }
    }
}

static void what_is_on_its_way_is_passed_over_up_to_64_reports(void **state)
{
    static const unsigned stale[] = {0, 1, 5, 62, 63, 64, 65, 1000};

    (void)state;
    for (size_t i = 0; i < sizeof stale / sizeof *stale; i++) {
        reset(&mcp2210);
        script.stale = stale[i];
        assert_int_equal(begin(), 0);
        assert_int_equal(script.quiet_reads, stale[i] < STALE_MOST ? stale[i] + 1 : STALE_MOST);
    }
}

static void an_answer_is_waited_for_a_second(void **state)
{
    (void)state;
    for (size_t i = 1; i < 3; i++) {
        begun(&mcp2210);
        script.silent_from = 1;
        const uint64_t began_ms = script.now_ms;
        assert_int_equal(calls[i](), -ETIMEDOUT);
        assert_why("in 1000 ms; unplug it and plug it in again");
        assert_int_equal(script.now_ms - began_ms, PATIENCE_MS);
        assert_int_equal(script.n_timeouts, 1);
        assert_int_equal(script.timeouts_ms[0], PATIENCE_MS);

        begun(&mcp2210);
        script.silent_from = 1;
        script.early_ms = 400;
        script.look_ms = 1;
        assert_int_equal(calls[i](), -ETIMEDOUT);
        assert_int_equal(script.n_timeouts, 2);
        assert_int_equal(script.timeouts_ms[0], PATIENCE_MS - 1);
        assert_int_equal(script.timeouts_ms[1], PATIENCE_MS - 402);
    }
}

static void of_another_s_answers_and_parts_none_counts(void **state)
{
    static const struct {
        int other_b;
        bool is_ours;
        int reads;
    } cases[] = {{64, false, 2}, {63, true, 2}, {64, true, 1}, {1, true, 2}, {6, true, 2}, {5, true, 2}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        begun(&mcp2210);
        script.other_b = cases[i].other_b;
        script.other_is_ours = cases[i].is_ours;
        assert_int_equal(set_pin(), 0);
        assert_int_equal(script.reads, cases[i].reads);
        assert_int_equal(script.writes, 1);
    }
}

static void an_mcp2210_may_be_busy_for_a_second(void **state)
{
    (void)state;
    begun(&mcp2210);
    script.status = 0xF8;
    script.look_ms = 1;
    const uint64_t began_ms = script.now_ms;
    assert_int_equal(set_pin(), -ETIMEDOUT);
    assert_why("busy for 1000 ms (status 0xf8)");
    assert_in_range(script.now_ms - began_ms, PATIENCE_MS + 1, PATIENCE_MS + 3);
    begun(&mcp2210);
    script.status = 0xF7;
    assert_int_equal(set_pin(), -EBUSY);
    assert_int_equal(script.writes, 1);
    begun(&mcp2210);
    script.status = 0xF9;
    assert_int_equal(set_pin(), -EPROTO);
    assert_why("status 0xf9 to command 0x30");
}

static void an_mcp2210_s_transfer_may_take_a_second(void **state)
{
    static const uint8_t unknown[] = {0x00, 0x0F, 0x11, 0x1F, 0x21, 0x2F, 0x31, 0xFF};

    (void)state;
    for (uint8_t engine = 0x20; engine <= 0x30; engine += 0x10) {
        begun(&mcp2210);
        script.engine = engine;
        script.look_ms = 1;
        const uint64_t began_ms = script.now_ms;
        assert_int_equal(send_some(), -ETIMEDOUT);
        assert_why("a transfer does not end in 1000 ms");
        assert_in_range(script.now_ms - began_ms, PATIENCE_MS, PATIENCE_MS + 20);
        assert_int_equal(last()[1], 0); /* it only asks */
    }
    for (size_t i = 0; i < sizeof unknown; i++) {
        begun(&mcp2210);
        script.engine = script.engine_full = unknown[i];
        assert_int_equal(send_some(), -EPROTO);
        assert_why("unknown state 0x");
    }
    begun(&mcp2210);
    script.engine_full = 0x10;
    assert_int_equal(script.kind->send(bridge.state, bridge.state, 121), -EPROTO);
    assert_why("a transfer ended 61 bytes early");
}

/* Datasheet, 3.2.2: rate at 4, selects when idle at 8, when active at 10, delays from 12 on, length at 18, mode at 20.
 */
static void an_mcp2210_s_settings_are_as_its_datasheet_has_them(void **state)
{
    static const uint32_t rates_hz[] = {1500, 1501, 3000000, 11999999, 12000000, 12000001, UINT32_MAX};

    (void)state;
    for (size_t i = 0; i < sizeof rates_hz / sizeof *rates_hz; i++) {
        reset(&mcp2210);
        struct bridge_config config = usual();
        config.bit_rate_hz = rates_hz[i];
        assert_int_equal(begin_with(&config), 0);
        script.writes = 0;
        const uint8_t byte = 0x5A;
        assert_int_equal(script.kind->send(bridge.state, &byte, 1), 0);
        const uint32_t sent_hz = rates_hz[i] < 12000000 ? rates_hz[i] : 12000000;
        const uint8_t wanted[MCP2210_REPORT_B] = {[0] = 0x40,
                                                  [4] = (uint8_t)sent_hz,
                                                  (uint8_t)(sent_hz >> 8),
                                                  (uint8_t)(sent_hz >> 16),
                                                  (uint8_t)(sent_hz >> 24),
                                                  0xFF,
                                                  0x01,
                                                  0xDF,
                                                  0x01,
                                                  [18] = 1,
                                                  [20] = 3};
        assert_memory_equal(script.reports[0], wanted, sizeof wanted);
        const uint8_t transfer[MCP2210_REPORT_B] = {0x42, 1, 0, 0, 0x5A};
        assert_int_equal(script.writes, 2);
        assert_memory_equal(script.reports[1], transfer, sizeof transfer);
    }
}

static void settings_that_a_bridge_does_not_have_are_refused(void **state)
{
    static const struct {
        const struct bridge_kind *kind;
        struct bridge_config config;
        int err;
    } cases[] = {{&mcp2210, {1499, 0, 1, 0, 2}, -EINVAL},     {&mcp2210, {1500, 0, 1, 0, 2}, 0},
                 {&mcp2210, {0, 0, 1, 0, 2}, -EINVAL},        {&mcp2210, {1500, 4, 1, 0, 2}, -EINVAL},
                 {&mcp2210, {1500, 3, 0x1FE, 0, 1}, 0},       {&mcp2210, {1500, 3, 0x200, 0, 1}, -EINVAL},
                 {&mcp2210, {1500, 3, 1, 0, 0x200}, -EINVAL}, {&mcp2210, {1500, 3, 1, 0, 0x100}, 0},
                 {&mcp2210, {1500, 3, 3, 0, 2}, -EINVAL}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        reset(cases[i].kind);
        if (begin_with(&cases[i].config) != cases[i].err) fail_msg("case %zu: %d is wrong", i, cases[i].err);
        assert_int_equal(script.writes > 0, cases[i].err == 0);
        if (cases[i].err) assert_why("it has SPI modes 0 to 3 from ");
    }
}

static void pins_that_are_no_outputs_are_not_set(void **state)
{
    (void)state;
    for (unsigned pin = 0; pin < 20; pin++) {
        reset(&mcp2210);
        const struct bridge_config config = usual();
        assert_int_equal(begin_with(&config), 0);
        script.writes = 0;
        const bool is_output = config.outputs >> pin & 1;
        assert_int_equal(script.kind->set(bridge.state, pin, true), is_output ? 0 : -EINVAL);
        assert_int_equal(script.writes, is_output);
        char text[40] = "";
        if (!is_output) snprintf(text, sizeof text, "GP%u is not set up as an output", pin);
        assert_string_equal(script.kind->why(bridge.state), text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(codes_of_the_transport_come_back),
        cmocka_unit_test(what_is_on_its_way_is_passed_over_up_to_64_reports),
        cmocka_unit_test(an_answer_is_waited_for_a_second),
        cmocka_unit_test(of_another_s_answers_and_parts_none_counts),
        cmocka_unit_test(an_mcp2210_may_be_busy_for_a_second),
        cmocka_unit_test(an_mcp2210_s_transfer_may_take_a_second),
        cmocka_unit_test(an_mcp2210_s_settings_are_as_its_datasheet_has_them),
        cmocka_unit_test(settings_that_a_bridge_does_not_have_are_refused),
        cmocka_unit_test(pins_that_are_no_outputs_are_not_set),
    };
    return cmocka_run_group_tests_name("bridge_waits", tests, NULL, NULL);
}
