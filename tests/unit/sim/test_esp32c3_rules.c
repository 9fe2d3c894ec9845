/* SPDX-License-Identifier: MIT
 *
 * The rules that the emulated ESP32-C3 holds programs to: a program that keeps them all is not told on, and each way to
 * break one is, by the name of that rule and no other. Addresses are those of espressif/esp-idf. */
#include "emulators/esp32c3_chip.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

#define SYSTEM UINT32_C(0x600C0000)
#define RTC UINT32_C(0x60008000)
#define TIMER_GROUP UINT32_C(0x6001F000)
#define GPIO UINT32_C(0x60004000)
#define MUX UINT32_C(0x60009004)
#define TIMER UINT32_C(0x60023000)
#define SPI UINT32_C(0x60024000)
#define KEY UINT32_C(0x50D83AA1)
#define SUPER_KEY UINT32_C(0x8F1D312A)
#define UPDATE UINT32_C(0x00800000)
#define USR UINT32_C(0x01000000)
#define EMPTY UINT32_C(0x40000000)
#define DATA_ALONE UINT32_C(0x08000000)
#define UNDIVIDED UINT32_C(0x80000000)
enum { DC = 5, SCK = 6, MOSI = 7, PANEL_HZ = 40000000 };

static struct {
    struct c3 chip;
    unsigned told[C3_RULES], ever[C3_RULES];
    uint8_t sent[256];
    unsigned n_sent, levels;
} rig;

static void on_complaint(void *ctx, enum c3_rule rule, const char *what)
{
    (void)ctx, (void)what;
    rig.told[rule]++;
    rig.ever[rule]++;
}

static void on_byte(void *ctx, uint8_t byte)
{
    (void)ctx;
    assert_true(rig.n_sent < sizeof rig.sent);
    rig.sent[rig.n_sent++] = byte;
}

static void on_level(void *ctx, unsigned pin, bool high)
{
    (void)ctx, (void)pin, (void)high;
    rig.levels++;
}

static void put(uint32_t address, uint32_t value)
{
    c3_write(&rig.chip, address, value, 4);
    c3_run(&rig.chip, 2);
}

static uint32_t get(uint32_t address)
{
    c3_run(&rig.chip, 2);
    return c3_read(&rig.chip, address, 4);
}

static void set(uint32_t address, uint32_t bits)
{
    put(address, get(address) | bits);
}

static void stop_watchdogs(void)
{
    put(RTC + 0xA8, KEY);
    put(RTC + 0x90, get(RTC + 0x90) & UINT32_C(0x7FFFEFFF));
    put(RTC + 0xB0, SUPER_KEY);
    set(RTC + 0xAC, UINT32_C(0x80000000));
    put(TIMER_GROUP + 0x64, KEY);
    put(TIMER_GROUP + 0x48, (get(TIMER_GROUP + 0x48) & UINT32_C(0x7FFFBFFF)) | UINT32_C(0x00400000));
}

static void make_output(unsigned pin)
{
    put(GPIO + 0x554 + 4 * pin, 128 + 512);
    put(MUX + 4 * pin, 0x1800);
    put(GPIO + 0x24, UINT32_C(1) << pin);
}

static void start_spi(uint32_t clock)
{
    set(SYSTEM + 0x10, 1 << 6 | 1 << 29);
    put(SPI + 0xE8, 3);
    put(SPI + 0xC, clock);
    put(SPI + 0x10, DATA_ALONE);
    put(MUX + 4 * SCK, 0x2800);
    put(MUX + 4 * MOSI, 0x2800);
    make_output(DC);
}

static void power_up(void)
{
    const struct c3_world world = {NULL, on_complaint, on_byte, on_level};
    const struct c3_setting setting = {.panel_hz = PANEL_HZ, .wired = 1 << DC};

    memset(rig.told, 0, sizeof rig.told);
    rig.n_sent = rig.levels = 0;
    c3_init(&rig.chip, &setting, &world);
}

static void begin(void)
{
    power_up();
    stop_watchdogs();
    put(SYSTEM + 0x58, 0);
    start_spi(UNDIVIDED);
}

static void prepare(unsigned n_b)
{
    put(SPI + 0x30, EMPTY);
    put(SPI + 0x30, 0);
    put(SPI + 0x1C, 8 * n_b - 1);
    put(SPI + 0x98, 0x44332211);
    put(SPI + 0x9C, 0x88776655);
}

static void update(void)
{
    put(SPI, UPDATE);
    while (get(SPI) & UPDATE)
        ;
}

static void finish(void)
{
    while (get(SPI) & USR)
        ;
}

static void send(unsigned n_b)
{
    prepare(n_b);
    update();
    put(SPI, USR);
    finish();
}

static void assert_told(enum c3_rule rule)
{
    for (int i = 0; i < C3_RULES; i++)
        if ((rig.told[i] != 0) != (i == (int)rule)) fail_msg("rule %d: told %u times", i, rig.told[i]);
}

static void assert_quiet(void)
{
    assert_told(C3_RULES);
}

static void who_keeps_all_rules_is_not_told_on(void **state)
{
    (void)state;
    begin();
    send(6);
    put(GPIO + 8, 1 << DC);
    send(1);
    put(TIMER, UINT32_C(0xC0000000));
    put(TIMER + 4, UINT32_C(0x40000000));
    while (!(get(TIMER + 4) & UINT32_C(0x20000000)))
        ;
    (void)get(TIMER + 0x44);
    c3_run(&rig.chip, 40000000);
    assert_quiet();
    assert_int_equal(rig.n_sent, 7);
    assert_memory_equal(rig.sent, ((const uint8_t[]){0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x11}), 7);
    assert_int_equal(rig.levels, 2);
}

static void bytes_take_their_time_and_timers_count_theirs(void **state)
{
    (void)state;
    begin();
    put(SPI + 0xC, 3 << 12 | 1 << 6 | 3 | 1 << 18);
    prepare(8);
    update();
    assert_int_equal(c3_spi_hz(&rig.chip), 5000000);
    const uint64_t from_ps = rig.chip.now_ps;
    put(SPI, USR);
    finish();
    assert_in_range(rig.chip.now_ps - from_ps, UINT64_C(64) * 200000, UINT64_C(66) * 200000);
    put(TIMER, UINT32_C(0xC0000000));
    put(TIMER + 4, UINT32_C(0x40000000));
    c3_run(&rig.chip, 10);
    assert_int_equal(get(TIMER + 0x44), (rig.chip.systimer_valid_ps) / 62500);
    assert_quiet();
}

static void watchdogs_bite_who_leaves_them(void **state)
{
    (void)state;
    for (unsigned left = 0; left < 5; left++) {
        begin();
        if (left == 1) put(RTC + 0x90, 1 << 12);
        if (left == 2) put(RTC + 0xAC, 0);
        if (left == 3) put(TIMER_GROUP + 0x48, 1 << 22 | 1 << 14);
        if (left == 4) rig.chip.timer_group.taken = 1 << 14, put(TIMER_GROUP + 0x48, 0); /* written, and not taken */
        c3_run(&rig.chip, 20000000);
        assert_told(left ? C3_WATCHDOG_BITES : C3_RULES);
    }
    power_up();
    put(RTC + 0x90, 0);
    assert_told(C3_WATCHDOG_KEY);
    power_up();
    put(RTC + 0xB0, KEY);
    put(RTC + 0xAC, UINT32_C(0x80000000));
    assert_told(C3_WATCHDOG_KEY);
    power_up();
    put(TIMER_GROUP + 0x48, 0);
    assert_told(C3_WATCHDOG_KEY);
}

static void what_has_no_clock_or_is_not_there_is_told(void **state)
{
    (void)state;
    power_up();
    put(SPI + 0xC, UNDIVIDED);
    assert_told(C3_CLOCK_ON);
    begin();
    set(SYSTEM + 0x18, 1 << 29);
    put(TIMER, 0);
    assert_told(C3_CLOCK_ON);
    static const uint32_t unknown[] = {SYSTEM + 0x14, SYSTEM + 8,   RTC,        RTC + 0x94, TIMER_GROUP + 0x4C,
                                       GPIO + 4,      GPIO + 0xFFC, MUX - 4,    TIMER + 8,  SPI + 4,
                                       SPI + 0x14,    SPI + 0x34,   0x60000000, 0x60025000};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
        begin();
        put(unknown[i], 0);
        assert_told(C3_MODELLED);
    }
    begin();
    c3_write(&rig.chip, GPIO + 8, 0, 2);
    assert_told(C3_WORDS);
    begin();
    (void)c3_read(&rig.chip, SPI + 1, 1);
    assert_told(C3_WORDS);
}

static void a_transfer_is_as_it_should_be(void **state)
{
    static const struct {
        uint32_t reg, value;
        enum c3_rule rule;
    } cases[] = {
        {SPI + 0x10, UINT32_C(0x88000000), C3_SPI_PHASES},
        {SPI + 0x10, 0, C3_SPI_PHASES},
        {SPI + 0x10, UINT32_C(0x08000001), C3_SPI_PHASES},
        {SPI + 8, UINT32_C(0x04000000), C3_SPI_PHASES},
        {SPI + 0x1C, 12, C3_SPI_LENGTH},
        {SPI + 0x1C, 519, C3_SPI_LENGTH},
        {SPI + 0xC, 3 << 12 | 2 << 6 | 3, C3_SPI_CLOCK},
        {SPI + 0xC, 3 << 12 | 1 << 6 | 2, C3_SPI_CLOCK},
        {SPI + 0xE8, 7, C3_SPI_RATE},
        {SPI + 0xE8, 1, C3_CLOCK_ON},
        {MUX + 4 * SCK, 0x1800, C3_SPI_PINS},
        {MUX + 4 * MOSI, 0x1800, C3_SPI_PINS},
    };

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        begin();
        prepare(8);
        put(cases[i].reg, cases[i].value);
        update();
        put(SPI, USR);
        assert_told(cases[i].rule);
    }
}

static void what_is_written_is_updated_and_left_alone(void **state)
{
    (void)state;
    begin();
    prepare(8);
    put(SPI, USR);
    assert_told(C3_SPI_UPDATED);
    begin();
    prepare(8);
    c3_write(&rig.chip, SPI, UPDATE, 4);
    c3_write(&rig.chip, SPI, USR, 4);
    assert_told(C3_SPI_UPDATED);
    begin();
    send(4);
    put(SPI + 0x1C, 7);
    update();
    put(SPI, USR);
    assert_told(C3_SPI_EMPTIED);
    begin();
    prepare(8);
    update();
    put(SPI, USR);
    put(SPI + 0x9C, 0);
    assert_told(C3_SPI_BUSY);
    finish();
    assert_int_equal(rig.sent[7], 0); /* as late as can be */
}

static void pins_are_outputs_and_stand_still(void **state)
{
    (void)state;
    begin();
    prepare(8);
    update();
    put(SPI, USR);
    put(GPIO + 8, 1 << DC);
    assert_told(C3_PIN_IDLE);
    begin();
    put(MUX + 4 * DC, 0);
    put(GPIO + 8, 1 << DC);
    assert_told(C3_PIN_DRIVEN);
    begin();
    put(TIMER, UINT32_C(0xC0000000));
    (void)get(TIMER + 0x44);
    assert_told(C3_TIMER_ASKED);
    begin();
    put(TIMER, UINT32_C(0xC0000000));
    put(TIMER + 4, UINT32_C(0x40000000));
    rig.chip.systimer_valid_ps = rig.chip.now_ps + 1;
    (void)c3_read(&rig.chip, TIMER + 0x44, 4);
    assert_told(C3_TIMER_ASKED);
}

static void a_stopped_spi_is_mended_by_resets(void **state)
{
    (void)state;
    begin();
    rig.chip.setting.stop_after = 8;
    rig.chip.setting.stop_for = 1;
    send(8);
    for (unsigned resets = 0; resets < 3; resets++) {
        start_spi(UNDIVIDED);
        prepare(8);
        update();
        put(SPI, USR);
        c3_run(&rig.chip, 1000);
        assert_int_equal(rig.n_sent, resets < 2 ? 8 : 16);
        set(SYSTEM + 0x18, 1 << 6);
        put(SYSTEM + 0x18, get(SYSTEM + 0x18) & ~UINT32_C(0x40));
    }
    assert_quiet();
}

static void each_rule_was_broken(void **state)
{
    (void)state;
    for (int i = 0; i < C3_RULES; i++) {
        if (!rig.ever[i]) fail_msg("rule %d was never broken", i);
        assert_non_null(c3_rules[i].text);
        assert_non_null(c3_rules[i].source);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_keeps_all_rules_is_not_told_on),
        cmocka_unit_test(bytes_take_their_time_and_timers_count_theirs),
        cmocka_unit_test(watchdogs_bite_who_leaves_them),
        cmocka_unit_test(what_has_no_clock_or_is_not_there_is_told),
        cmocka_unit_test(a_transfer_is_as_it_should_be),
        cmocka_unit_test(what_is_written_is_updated_and_left_alone),
        cmocka_unit_test(pins_are_outputs_and_stand_still),
        cmocka_unit_test(a_stopped_spi_is_mended_by_resets),
        cmocka_unit_test(each_rule_was_broken),
    };
    return cmocka_run_group_tests_name("rules of the ESP32-C3", tests, NULL, NULL);
}
