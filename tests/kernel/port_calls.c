/* SPDX-License-Identifier: MIT
 *
 * The Linux port against the kernel's own drivers: what a call of it does to the wires, as the tap recorded it. Runs in
 * the tests' kernel alone. TEARING_LINE names an input whose level is TEARING_PULL's, a file that takes pull-up and
 * pull-down. */
#include "linux/linux_port.h"
#include "rigs/cmocka_ready.h"
#include "wire_tap.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { LONG_B = 10000, EVENTS_MAX = 256, RECORD_MAX_B = 65536, SPEED_HZ = 12000000 };

static struct rig {
    struct port port;
    int tap_fd;
    uint8_t record[RECORD_MAX_B];
    struct wire_tap_event events[EVENTS_MAX];
    const uint8_t *data[EVENTS_MAX]; /* of each event */
    size_t count;
} rig;

/* All that has been recorded since it was read last. */
static void read_tap(void)
{
    size_t record_b = 0;
    ssize_t n_b;

    while ((n_b = read(rig.tap_fd, rig.record + record_b, sizeof rig.record - record_b)) > 0)
        record_b += (size_t)n_b;
    assert_int_equal(n_b, 0);
    rig.count = 0;
    for (size_t at_b = 0; at_b < record_b; rig.count++) {
        struct wire_tap_event *event = &rig.events[rig.count];
        assert_true(rig.count < EVENTS_MAX);
        memcpy(event, rig.record + at_b, sizeof *event);
        rig.data[rig.count] = rig.record + at_b + sizeof *event;
        at_b += sizeof *event + event->n_b;
    }
}

static void open_as(struct linux_port_config config)
{
    if (!config.spi) config.spi = "/dev/spidev0.0";
    if (!config.speed_hz) config.speed_hz = SPEED_HZ;
    if (linux_port_open(&rig.port, &config) != 0) fail_msg("%s", rig.port.error);
    read_tap();
}

static void assert_event(size_t index, enum wire_tap_kind kind, unsigned which, uint32_t value)
{
    assert_true(index < rig.count);
    assert_int_equal(rig.events[index].kind, kind);
    assert_int_equal(rig.events[index].which, which);
    assert_int_equal(rig.events[index].value, value);
}

/* SPI ---------------------------------------------------------------------------------------- */

static uint8_t pattern(size_t i)
{
    return (uint8_t)(i * 31 + i / 256);
}

static int write_pattern(size_t n_b)
{
    uint8_t *bytes = malloc(n_b);

    assert_non_null(bytes);
    for (size_t i = 0; i < n_b; i++)
        bytes[i] = pattern(i);
    const int err = bus_write(&rig.port.bus, bytes, n_b);
    free(bytes);
    return err;
}

/* How many transfers it took; none is longer than most_b. */
static unsigned assert_pattern_sent(size_t n_b, size_t most_b)
{
    unsigned transfers = 0;
    size_t sent_b = 0;

    read_tap();
    for (size_t i = 0; i < rig.count; i++) {
        if (rig.events[i].kind != WIRE_TAP_BYTES) continue;
        assert_true(rig.events[i].n_b <= most_b);
        for (size_t k = 0; k < rig.events[i].n_b; k++)
            assert_int_equal(rig.data[i][k], pattern(sent_b++));
        transfers++;
    }
    assert_int_equal(sent_b, n_b);
    return transfers;
}

static size_t bufsiz_b(void)
{
    char text[16] = "";
    FILE *file = fopen("/sys/module/spidev/parameters/bufsiz", "r");

    assert_non_null(file);
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    return strtoul(text, NULL, 10);
}

static void a_long_write_is_split_where_spidev_wants_it(void **state)
{
    const size_t most_b = bufsiz_b();

    (void)state;
    open_as((struct linux_port_config){0});
    assert_int_equal(write_pattern(LONG_B), 0);
    assert_int_equal(assert_pattern_sent(LONG_B, most_b), (LONG_B + most_b - 1) / most_b);
}

static void what_a_controller_refuses_for_its_length_goes_in_parts(void **state)
{
    enum { CONTROLLER_MOST_B = 1000 };

    (void)state;
    open_as((struct linux_port_config){.spi = "/dev/spidev0.1"});
    assert_int_equal(write_pattern(LONG_B), 0);
    assert_true(assert_pattern_sent(LONG_B, CONTROLLER_MOST_B) <= 2 * (LONG_B / CONTROLLER_MOST_B + 1));
}

static void the_controllers_error_comes_through(void **state)
{
    (void)state;
    open_as((struct linux_port_config){.spi = "/dev/spidev0.2"});
    assert_int_equal(write_pattern(10), -EIO);
    assert_non_null(strstr(rig.port.error, "/dev/spidev0.2"));
    assert_non_null(strstr(rig.port.error, "Input/output error"));
}

static void mode_and_speed_are_as_asked(void **state)
{
    enum { MODE_BITS = 3 | 1 << 2 | 1 << 6 }; /* clock polarity and phase, chip select high, none */

    (void)state;
    for (uint8_t mode = 0; mode < 4; mode++) {
        open_as((struct linux_port_config){.mode = mode, .cs_high = mode & 1, .speed_hz = SPEED_HZ + mode});
        assert_int_equal(write_pattern(1), 0);
        read_tap();
        assert_event(0, WIRE_TAP_SELECT, 0, mode & 1);
        assert_event(1, WIRE_TAP_BYTES, 0, SPEED_HZ + mode);
        assert_event(2, WIRE_TAP_SELECT, 0, !(mode & 1));
        assert_int_equal(rig.events[1].mode & MODE_BITS, mode | (mode & 1) << 2);
        port_close(&rig.port);
    }
}

/* Lines -------------------------------------------------------------------------------------- */

/* Of a request for several lines together, libgpiod 1 would change more than the one that is set. */
static void a_line_that_is_set_moves_no_other(void **state)
{
    (void)state;
    open_as((struct linux_port_config){.dc = "DC", .reset = "RESET", .backlight = "BACKLIGHT", .select = "SELECT"});
    const struct pin pins[] = {rig.port.backlight, rig.port.dc, rig.port.reset, rig.port.select};
    static const unsigned lines[] = {WIRE_BACKLIGHT, WIRE_DC, WIRE_RESET, WIRE_SELECT};
    for (unsigned i = 0; i < 8; i++) {
        assert_int_equal(pin_set(&pins[i % 4], i < 4), 0);
        read_tap();
        assert_int_equal(rig.count, 1);
        assert_event(0, WIRE_TAP_LEVEL, lines[i % 4], i < 4);
    }
}

static void lines_begin_as_a_panel_that_is_dark_wants_them(void **state)
{
    (void)state;
    open_as((struct linux_port_config){.dc = "DC", .reset = "RESET", .backlight = "BACKLIGHT"});
    const size_t first = rig.count - 3; /* the bus was set up before them */
    assert_event(first, WIRE_TAP_LEVEL, WIRE_DC, false);
    assert_event(first + 1, WIRE_TAP_LEVEL, WIRE_RESET, true);
    assert_event(first + 2, WIRE_TAP_LEVEL, WIRE_BACKLIGHT, false);
}

static void lines_are_given_back(void **state)
{
    (void)state;
    open_as((struct linux_port_config){.dc = "DC", .reset = "RESET"});
    port_close(&rig.port);
    read_tap();
    assert_int_equal(rig.count, 2);
    assert_event(0, WIRE_TAP_RELEASED, WIRE_DC, 0);
    assert_event(1, WIRE_TAP_RELEASED, WIRE_RESET, 0);
    open_as((struct linux_port_config){.dc = "DC", .reset = "RESET"});
}

static void a_line_is_found_by_its_chips_label_and_number(void **state)
{
    (void)state;
    open_as((struct linux_port_config){.dc = "wire-tap:2"});
    assert_int_equal(pin_set(&rig.port.dc, true), 0);
    read_tap();
    assert_event(0, WIRE_TAP_LEVEL, 2, true);
}

/* Time --------------------------------------------------------------------------------------- */

static uint64_t now_us(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000 + (uint64_t)now.tv_nsec / 1000;
}

static void a_delay_is_not_too_short(void **state)
{
    static const uint32_t delays_us[] = {1, 10, 5000, 120000, 3000000};

    (void)state;
    open_as((struct linux_port_config){0});
    for (unsigned i = 0; i < sizeof delays_us / sizeof *delays_us; i++) {
        const uint64_t before_us = now_us();
        assert_int_equal(clock_delay(&rig.port.clock, delays_us[i]), 0);
        assert_true(now_us() - before_us >= delays_us[i]);
    }
}

static void pull(const char *way)
{
    FILE *file = fopen(getenv("TEARING_PULL"), "w");

    assert_non_null(file);
    assert_true(fputs(way, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

/* A pulse from another process, a while later. */
static pid_t pulse_after(uint32_t delay_us)
{
    const pid_t child = fork();

    assert_true(child >= 0);
    if (child > 0) return child;
    nanosleep(&(struct timespec){.tv_nsec = (long)delay_us * 1000}, NULL);
    pull("pull-up");
    _exit(0);
}

static void a_rise_is_waited_for_and_one_of_the_past_is_not_taken_for_it(void **state)
{
    enum { TIMEOUT_US = 100000, PULSE_US = 20000, SETTLE_US = 20000 }; /* simulated lines tell of a rise a tick later */

    (void)state;
    pull("pull-down");
    open_as((struct linux_port_config){.tearing = getenv("TEARING_LINE")});
    pull("pull-up");
    pull("pull-down");
    assert_int_equal(clock_delay(&rig.port.clock, SETTLE_US), 0);
    uint64_t before_us = now_us();
    assert_int_equal(edge_wait(&rig.port.tearing, TIMEOUT_US), 0);
    assert_true(now_us() - before_us >= TIMEOUT_US);
    const pid_t child = pulse_after(PULSE_US);
    before_us = now_us();
    assert_int_equal(edge_wait(&rig.port.tearing, TIMEOUT_US), 1);
    assert_true(now_us() - before_us < TIMEOUT_US);
    assert_int_equal(waitpid(child, NULL, 0), child);
}

static int open_tap(void **state)
{
    (void)state;
    rig.tap_fd = open("/dev/wire_tap", O_RDONLY | O_NONBLOCK);
    if (rig.tap_fd < 0) return -1;
    read_tap();
    return 0;
}

static int close_all(void **state)
{
    (void)state;
    port_close(&rig.port);
    return close(rig.tap_fd);
}

#define WITH_TAP(test) cmocka_unit_test_setup_teardown(test, open_tap, close_all)

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_TAP(a_long_write_is_split_where_spidev_wants_it),
        WITH_TAP(what_a_controller_refuses_for_its_length_goes_in_parts),
        WITH_TAP(the_controllers_error_comes_through),
        WITH_TAP(mode_and_speed_are_as_asked),
        WITH_TAP(a_line_that_is_set_moves_no_other),
        WITH_TAP(lines_begin_as_a_panel_that_is_dark_wants_them),
        WITH_TAP(lines_are_given_back),
        WITH_TAP(a_line_is_found_by_its_chips_label_and_number),
        WITH_TAP(a_delay_is_not_too_short),
        WITH_TAP(a_rise_is_waited_for_and_one_of_the_past_is_not_taken_for_it),
    };
    return cmocka_run_group_tests_name("port calls", tests, NULL, NULL);
}
