/* SPDX-License-Identifier: MIT
 *
 * Levels of wires -> bytes and changes, as a chip takes them: in each mode of SPI, with what changes in one sample with
 * an edge, while others are selected, and with levels that nobody knows. */
#include "glass/spi_wires.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <string.h>

static struct spi_wires wires;
static struct wire_levels levels;
static uint64_t now_ns;
static char heard[400];
static struct error err;

static bool on_byte(void *ctx, uint64_t at_ns, uint8_t byte, struct error *error)
{
    (void)ctx, (void)at_ns, (void)error;
    snprintf(heard + strlen(heard), sizeof heard - strlen(heard), "%02X ", byte);
    return true;
}

static bool on_level(void *ctx, uint64_t at_ns, enum capture_wire wire, bool high, struct error *error)
{
    (void)ctx, (void)at_ns, (void)error;
    snprintf(heard + strlen(heard), sizeof heard - strlen(heard), "%s%d ", capture_wire_names[wire], high);
    return true;
}

static void put(enum capture_wire wire, char value)
{
    const uint8_t bit = (uint8_t)(1u << wire);
    levels.high = (uint8_t)(value == '1' ? levels.high | bit : levels.high & ~bit);
    levels.unknown = (uint8_t)(value == 'x' ? levels.unknown | bit : levels.unknown & ~bit);
}

static bool sample(void)
{
    now_ns += 100;
    err.text[0] = '\0';
    return spi_wires_take(&wires, now_ns, levels, &err);
}

/* D/C, clock, data, CS and LED. */
static void begin(unsigned mode)
{
    wires = (struct spi_wires){.events = {NULL, on_byte, on_level},
                               .wired = 1u << CAPTURE_DC | 1u << CAPTURE_SCK | 1u << CAPTURE_MOSI | 1u << CAPTURE_CS |
                                        1u << CAPTURE_LED,
                               .takes_falling = mode == 1 || mode == 2,
                               .rests_high = mode >= 2};
    levels = (struct wire_levels){0, 0};
    put(CAPTURE_SCK, mode >= 2 ? '1' : '0');
    assert_true(sample());
    heard[0] = '\0';
}

static bool step(enum capture_wire wire, char value)
{
    put(wire, value);
    return sample();
}

/* So many bits from the highest on; the data change with the edge before the one that takes them. */
static void send(unsigned mode, uint8_t byte, unsigned n_bits)
{
    for (unsigned i = 0; i < n_bits; i++) {
        const bool is_late = mode == 1 || mode == 3;
        if (is_late) put(CAPTURE_SCK, mode == 3 ? '0' : '1');
        put(CAPTURE_MOSI, byte >> (7 - i) & 1 ? '1' : '0');
        assert_true(sample());
        assert_true(step(CAPTURE_SCK, mode == 0 || mode == 3 ? '1' : '0'));
        if (!is_late) assert_true(step(CAPTURE_SCK, mode == 2 ? '1' : '0'));
    }
}

static void each_mode_has_its_bytes(void **state)
{
    (void)state;
    for (unsigned mode = 0; mode < 4; mode++) {
        begin(mode);
        send(mode, 0xA5, 8);
        send(mode, 0x01, 8);
        assert_true(step(CAPTURE_DC, '1'));
        send(mode, 0x80, 8);
        assert_string_equal(heard, "A5 01 dc1 80 ");
    }
}

static void what_changes_with_the_last_edge_of_a_byte_came_behind_it(void **state)
{
    (void)state;
    const enum capture_wire both[] = {CAPTURE_DC, CAPTURE_CS};
    static const char *const as_heard[] = {"A5 dc1 ", "A5 cs1 "};
    for (int i = 0; i < 2; i++) {
        begin(0);
        send(0, 0xA4, 7);
        put(CAPTURE_MOSI, '1');
        put(CAPTURE_SCK, '1');
        assert_true(step(both[i], '1'));
        assert_string_equal(heard, as_heard[i]);
    }
}

static void what_changes_with_the_first_one_came_before_it(void **state)
{
    (void)state;
    begin(0);
    send(0, 0x11, 8);
    put(CAPTURE_MOSI, '1');
    put(CAPTURE_DC, '1');
    assert_true(step(CAPTURE_SCK, '1'));
    assert_true(step(CAPTURE_SCK, '0'));
    send(0, 0x02, 7);
    assert_string_equal(heard, "11 dc1 81 ");
}

static void the_light_changes_behind_the_byte(void **state)
{
    (void)state;
    begin(0);
    send(0, 0x3C, 7);
    put(CAPTURE_SCK, '1');
    put(CAPTURE_MOSI, '0');
    assert_true(step(CAPTURE_LED, '1'));
    assert_string_equal(heard, "3C led1 ");
}

static void bytes_for_others_are_none(void **state)
{
    (void)state;
    begin(0);
    assert_true(step(CAPTURE_CS, '1'));
    send(0, 0xFF, 8);
    send(0, 0xFF, 3);
    assert_true(step(CAPTURE_CS, '0'));
    send(0, 0x42, 8);
    assert_string_equal(heard, "cs1 cs0 42 ");
    assert_int_equal(wires.other_edges, 11);
}

static void a_byte_that_is_cut_is_refused(void **state)
{
    (void)state;
    begin(0);
    send(0, 0x42, 8);
    send(0, 0xFF, 5);
    assert_false(step(CAPTURE_CS, '1'));
    assert_non_null(strstr(err.text, "cs changes after 5 bits of a byte"));
    assert_non_null(strstr(err.text, " 100 ns"));
}

/* Then no level of the clock has had a beginning and an end. */
static void no_length_is_told_of_a_clock_with_one_edge(void **state)
{
    (void)state;
    begin(0);
    assert_true(step(CAPTURE_CS, '1'));
    assert_true(step(CAPTURE_CS, '0'));
    assert_true(step(CAPTURE_SCK, '1'));
    assert_false(step(CAPTURE_CS, '1'));
    assert_non_null(strstr(err.text, "cs changes after 1 bit of a byte"));
    assert_non_null(strstr(err.text, "; it has had one edge so far"));
    assert_null(strstr(err.text, " ns"));
}

static void bits_before_the_first_boundary_may_be_the_clocks_way_to_its_level(void **state)
{
    (void)state;
    begin(0);
    send(0, 0xFF, 1);
    assert_true(step(CAPTURE_DC, '1'));
    send(0, 0x42, 8);
    assert_string_equal(heard, "dc1 42 ");
}

static void unknown_levels_matter_when_they_are_taken(void **state)
{
    (void)state;
    begin(0);
    assert_true(step(CAPTURE_MOSI, 'x'));
    assert_true(step(CAPTURE_DC, 'x'));
    assert_true(step(CAPTURE_DC, '0'));
    send(0, 0x42, 8);
    assert_true(step(CAPTURE_MOSI, 'x'));
    assert_false(step(CAPTURE_SCK, '1'));
    assert_non_null(strstr(err.text, "mosi is unknown"));

    begin(0);
    send(0, 0x42, 3);
    assert_false(step(CAPTURE_SCK, 'x'));
    assert_non_null(strstr(err.text, "sck is unknown"));

    begin(0);
    assert_true(step(CAPTURE_DC, 'x'));
    send(0, 0x42, 7);
    assert_false(step(CAPTURE_SCK, '1'));
    assert_non_null(strstr(err.text, "dc is unknown"));
}

/* As a simulator has it, which knows no level before somebody drives the wire. */
static void an_unknown_clock_is_where_it_rests(void **state)
{
    (void)state;
    for (unsigned mode = 0; mode < 4; mode += 3) {
        begin(mode);
        assert_true(step(CAPTURE_SCK, 'x'));
        send(mode, 0x96, 8);
        assert_string_equal(heard, "96 ");
    }
}

static void a_running_display_is_heard_from_a_command_on(void **state)
{
    (void)state;
    begin(0);
    wires.is_running = true;
    send(0, 0x11, 8);
    send(0, 0x11, 3);
    assert_true(step(CAPTURE_DC, '1'));
    send(0, 0x22, 8);
    assert_true(step(CAPTURE_DC, '0'));
    send(0, 0x33, 8);
    assert_string_equal(heard, "dc1 dc0 33 ");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_mode_has_its_bytes),
        cmocka_unit_test(what_changes_with_the_last_edge_of_a_byte_came_behind_it),
        cmocka_unit_test(what_changes_with_the_first_one_came_before_it),
        cmocka_unit_test(the_light_changes_behind_the_byte),
        cmocka_unit_test(bytes_for_others_are_none),
        cmocka_unit_test(a_byte_that_is_cut_is_refused),
        cmocka_unit_test(no_length_is_told_of_a_clock_with_one_edge),
        cmocka_unit_test(bits_before_the_first_boundary_may_be_the_clocks_way_to_its_level),
        cmocka_unit_test(unknown_levels_matter_when_they_are_taken),
        cmocka_unit_test(an_unknown_clock_is_where_it_rests),
        cmocka_unit_test(a_running_display_is_heard_from_a_command_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
