/* SPDX-License-Identifier: MIT
 *
 * hal/linux on a fake machine: how writes are split, what each failure says and that it leaves nothing open, and that
 * a picture through spidev and GPIO lines is the picture that was drawn. */
#include "fakes/fake_linux.h"
#include "linux/linux_port.h"
#include "linux/spidev.h"
#include "rigs/cmocka_ready.h"
#include "screen.h"
#include "test_card.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 20, H_PX = 24 };

static const struct linux_port_config all_wired = {.spi = "/dev/spidev0.0",
                                                   .dc = "GPIO5",
                                                   .reset = "pinctrl-fake:4",
                                                   .backlight = "gpiochip0:3",
                                                   .select = "/dev/gpiochip1:2",
                                                   .tearing = "GPIO6",
                                                   .led = "GPIO7",
                                                   .speed_hz = 20000000,
                                                   .mode = 3};

static struct port port;

static int set_up(void **state)
{
    (void)state;
    fake_linux_init();
    return 0;
}

static void open_port(const struct linux_port_config *config)
{
    if (linux_port_open(&port, config)) fail_msg("%s", port.error);
}

static void assert_refused(const struct linux_port_config *config, int err_no, const char *text)
{
    assert_int_equal(linux_port_open(&port, config), -err_no);
    assert_string_equal(port.error, text);
    assert_null(port.close);
    assert_true(fake_is_clean());
}

static void assert_line_refused(const char *line, int err_no, const char *text)
{
    assert_refused(&(struct linux_port_config){.spi = "/dev/spidev0.0", .dc = line, .speed_hz = 1000000}, err_no, text);
}

/* Bytes ----------------------------------------------------------------------------------------- */

static void assert_split(const char *bufsiz, size_t n_b, const size_t *parts_b, unsigned n)
{
    static const uint8_t bytes[20000];
    fake_linux_init();
    fake.bufsiz = bufsiz;
    fake.most_b = bufsiz ? strtoul(bufsiz, NULL, 10) : 4096;
    open_port(&all_wired);
    assert_int_equal(bus_write(&port.bus, bytes, n_b), 0);
    assert_int_equal(fake.message_count, n);
    for (unsigned i = 0; i < n; i++)
        assert_int_equal(fake.messages_b[i], parts_b[i]);
    port_close(&port);
}

static void writes_are_split_at_bufsiz(void **state)
{
    (void)state;
    assert_split("4096\n", 1, (size_t[]){1}, 1);
    assert_split("4096\n", 4095, (size_t[]){4095}, 1);
    assert_split("4096\n", 4096, (size_t[]){4096}, 1);
    assert_split("4096\n", 4097, (size_t[]){4096, 1}, 2);
    assert_split("4096\n", 8192, (size_t[]){4096, 4096}, 2);
    assert_split("777\n", 2000, (size_t[]){777, 777, 446}, 3);
    assert_split("000000000000777", 2000, (size_t[]){777, 777, 446}, 3); /* the longest text that is read */
    assert_split("65536\n", 20000, (size_t[]){20000}, 1);
    assert_split(NULL, 4097, (size_t[]){4096, 1}, 2); /* unreadable: the kernel's usual one */
    assert_split("4096\n", 0, NULL, 0);
    assert_split("4294967295\n", 20000, (size_t[]){20000}, 1);
    assert_split("1\n", 2, (size_t[]){1, 1}, 2);
    assert_split("9", 10, (size_t[]){9, 1}, 2);
}

/* Of what cannot be a length the kernel's usual one takes the place. */
static void a_bufsiz_that_is_no_length_does_not_count(void **state)
{
    static const char *const texts[] = {"0\n", "", "4294967296\n", "many\n"};
    static const uint8_t bytes[4097];

    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        fake_linux_init();
        fake.bufsiz = texts[i];
        open_port(&all_wired);
        assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), 0);
        assert_int_equal(fake.messages_b[0], 4096);
        assert_int_equal(fake.messages_b[1], 1);
        port_close(&port);
    }
}

/* Who is started without a standard input gets its descriptor, 0, for the first that he opens. */
static void any_descriptor_will_do(void **state)
{
    static const uint8_t bytes[100];

    (void)state;
    fake.first_fd = 0;
    fake.bufsiz = "77\n";
    open_port(&all_wired);
    assert_int_equal(fake.fds, 1);
    assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), 0);
    assert_int_equal(fake.message_count, 2);
    assert_int_equal(fake.messages_b[0], 77);
    port_close(&port);
    assert_true(fake_is_clean());
}

/* A transfer takes as long to begin as so many bytes: a 50,000th of a second, as far as 16 bits count. */
static void what_a_message_costs_grows_with_the_speed(void **state)
{
    static const struct {
        uint32_t speed_hz, message_b;
    } cases[] = {{399999, 0}, {400000, 1}, {799999, 1}, {20000000, 50}, {400000000, 1000}, {4294967295u, 10737}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        fake_linux_init();
        struct linux_port_config config = all_wired;
        config.speed_hz = cases[i].speed_hz;
        open_port(&config);
        assert_int_equal(port.bus.message_b, cases[i].message_b);
        port_close(&port);
    }
}

static void the_device_is_set_up_as_asked(void **state)
{
    (void)state;
    struct linux_port_config config = all_wired;
    fake.word_bits = 16; /* another program's */
    open_port(&config);
    assert_int_equal(fake.mode, 3);
    assert_int_equal(fake.word_bits, 8);
    assert_int_equal(fake.speed_hz, 20000000);
    port_close(&port);
    config.no_cs = true;
    open_port(&config);
    assert_int_equal(fake.mode, 0x43);
    port_close(&port);
    config.no_cs = false;
    config.cs_high = true;
    open_port(&config);
    assert_int_equal(fake.mode, 0x07);
    port_close(&port);
}

static void what_the_kernel_finds_too_long_is_sent_in_halves(void **state)
{
    (void)state;
    static const uint8_t bytes[3000];
    open_port(&all_wired);
    fake.most_b = 800;
    assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), 0);
    assert_int_equal(fake.messages_b[0], 750);
    assert_int_equal(fake.message_count, 4);
    fake.most_b = 4;
    assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), -EMSGSIZE);
    assert_string_equal(port.error, "/dev/spidev0.0: a message of 11 bytes: Message too long; raise spidev.bufsiz");
    assert_int_equal(bus_write(&port.bus, bytes, 4), 0);
    port_close(&port);
}

/* 16 bytes are no more halved: what refuses so few refuses everything. */
static void a_message_of_sixteen_bytes_is_not_halved(void **state)
{
    static const struct {
        const char *bufsiz, *text;
    } cases[] = {
        {"32\n", "a message of 16 bytes"}, {"34\n", "a message of 8 bytes"}, {"15\n", "a message of 15 bytes"}};
    static const uint8_t bytes[40];

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        fake_linux_init();
        fake.bufsiz = cases[i].bufsiz;
        fake.most_b = 4;
        open_port(&all_wired);
        assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), -EMSGSIZE);
        assert_non_null(strstr(port.error, cases[i].text));
        port_close(&port);
    }
}

static void a_message_that_is_sent_in_part_is_an_error(void **state)
{
    static const uint8_t bytes[100];
    (void)state;
    open_port(&all_wired);
    for (fake.unsent_b = 1; fake.unsent_b <= sizeof bytes; fake.unsent_b += 33) {
        assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), -EIO);
        assert_string_equal(port.error, "/dev/spidev0.0: a message of 100 bytes: Input/output error");
    }
    fake.unsent_b = 0;
    assert_int_equal(bus_write(&port.bus, bytes, sizeof bytes), 0);
    port_close(&port);
}

static void signals_interrupt_nothing(void **state)
{
    (void)state;
    fake.interrupts = 3;
    open_port(&all_wired);
    fake.interrupts = 5;
    assert_int_equal(bus_write(&port.bus, (const uint8_t *)"x", 1), 0);
    assert_int_equal(fake.message_count, 1);
    fake.interrupts = 5;
    const uint64_t before_ns = fake.now_ns;
    assert_int_equal(clock_delay(&port.clock, 1500), 0);
    assert_int_equal(fake.now_ns - before_ns, 1500000);
    fake.interrupts = 2;
    assert_int_equal(edge_wait(&port.tearing, 1000), 0);
    port_close(&port);
    assert_true(fake_is_clean());
}

/* What is said ---------------------------------------------------------------------------------- */

static void devices_that_cannot_be_opened_are_explained(void **state)
{
    (void)state;
    struct linux_port_config config = all_wired;
    config.spi = "/dev/spidev1.0";
    assert_refused(&config, ENOENT, "/dev/spidev1.0: no such device; there are /dev/spidev0.0");
    fake.spi_path = NULL;
    assert_refused(&config, ENOENT,
                   "/dev/spidev1.0: no such device, nor any other; load spidev and the controller's driver (Raspberry "
                   "Pi: dtparam=spi=on)");
    fake_linux_init();
    fake.spi_err_no = EACCES;
    assert_refused(
        &all_wired, EACCES,
        "/dev/spidev0.0: Permission denied; join group spi (`ls -l` shows whose it is), or add the udev rule "
        "of hal/linux/README.md");
    fake.spi_err_no = EPERM;
    assert_refused(
        &all_wired, EPERM,
        "/dev/spidev0.0: Operation not permitted; join group spi (`ls -l` shows whose it is), or add the udev rule "
        "of hal/linux/README.md");
    fake.spi_err_no = ENODEV;
    assert_refused(&all_wired, ENODEV, "/dev/spidev0.0: no such device; there are /dev/spidev0.0");
    fake.spi_err_no = ENXIO;
    assert_refused(&all_wired, ENXIO, "/dev/spidev0.0: no such device; there are /dev/spidev0.0");
    fake.spi_err_no = EBUSY;
    assert_refused(&all_wired, EBUSY, "/dev/spidev0.0: in use by another program; `fuser /dev/spidev0.0` names it");
    fake.spi_err_no = EIO;
    assert_refused(&all_wired, EIO, "/dev/spidev0.0: Input/output error");
}

/* As many as the message has room for. */
static void of_many_devices_the_first_are_named(void **state)
{
    static const char each[] = "/dev/spidev0.0";
    struct linux_port_config config = all_wired;

    (void)state;
    config.spi = "/dev/spidev1.0";
    for (fake.spi_count = 2; fake.spi_count < 60; fake.spi_count++) {
        unsigned named = 0;
        assert_int_equal(linux_port_open(&port, &config), -ENOENT);
        assert_true(fake_is_clean());
        const char *at = strstr(port.error, "; there are ");
        assert_non_null(at);
        for (at = strstr(at, each); at; at = strstr(at + 1, each))
            named++;
        assert_true(named == fake.spi_count || (named >= 6 && named < 20));
        assert_true(strlen(port.error) < PORT_ERROR_B);
    }
}

static void a_lack_of_memory_is_told(void **state)
{
    (void)state;
    memset(&port, 0x5A, sizeof port);
    fake.no_memory = true;
    const int err = linux_port_open(&port, &all_wired);
    fake.no_memory = false;
    assert_int_equal(err, -ENOMEM);
    assert_string_equal(port.error, "/dev/spidev0.0: out of memory");
    assert_null(port.close);
    assert_true(fake_is_clean());
}

static void a_device_that_cannot_be_set_up_is_closed(void **state)
{
    (void)state;
    for (long n = 2; n < 5; n++) { /* after the opens and the read: mode, bits a word, rate */
        struct spidev spidev;
        fake_linux_init();
        fake_fail_at(n + 1, EINVAL);
        assert_int_equal(spidev_open(&spidev, "/dev/spidev0.0", 0, 0, 1000000, &port), -EINVAL);
        assert_int_equal(spidev.fd, -1);
        assert_true(fake_is_clean());
        spidev_close(&spidev);
        assert_true(fake_is_clean());
    }
}

static void what_a_device_cannot_do_is_explained(void **state)
{
    (void)state;
    fake.bufsiz = NULL;
    fake_fail_at(2, ENOTTY); /* after the two opens */
    assert_refused(&all_wired, ENOTTY, "/dev/spidev0.0: not an SPI device");
    fake_fail_at(2, EINVAL);
    assert_refused(&all_wired, EINVAL, "/dev/spidev0.0: mode 3: Invalid argument; the controller cannot do that");
    fake_fail_at(3, EINVAL);
    assert_refused(&all_wired, EINVAL,
                   "/dev/spidev0.0: bits a word 8: Invalid argument; the controller cannot do that");
    fake_fail_at(4, EINVAL);
    assert_refused(&all_wired, EINVAL, "/dev/spidev0.0: Hz 20000000: Invalid argument; the controller cannot do that");
}

static void lines_that_cannot_be_had_are_explained(void **state)
{
    (void)state;
    assert_line_refused("GPIO77", ENOENT,
                        "GPIO77: no line of that name on gpiochip0 (pinctrl-fake), gpiochip1 (expander); `limner "
                        "devices` lists them");
    assert_line_refused("gpiochip7:1", ENOENT,
                        "gpiochip7:1: no chip of that name on gpiochip0 (pinctrl-fake), gpiochip1 (expander); `limner "
                        "devices` lists them");
    assert_line_refused("expander:4", EINVAL, "expander:4: gpiochip1 (expander) has lines 0 to 3");
    fake.chips[0].lines[2].is_used = true;
    assert_line_refused("GPIO2", EBUSY, "GPIO2: gpiochip0:2 cannot be had: Device or resource busy");
    fake.chips[0].lines[2].consumer = "lcd-reset";
    assert_line_refused(
        "GPIO2", EBUSY,
        "GPIO2: gpiochip0:2 is in use by \"lcd-reset\"; end that program, take the overlay away that says so, or take "
        "another line");
    fake.chips[1].lines[1].name = "GPIO3";
    assert_line_refused("GPIO3", ENOTUNIQ, "GPIO3: more than one is called so; give gpiochip0:3 or gpiochip1:1");
    fake.chips[0].lines[7].name = "GPIO1";
    assert_line_refused("GPIO1", ENOTUNIQ, "GPIO1: more than one is called so; give gpiochip0:1 or gpiochip0:7");
    fake.chips[1].label = "pinctrl-fake";
    assert_line_refused("pinctrl-fake:3", ENOTUNIQ,
                        "pinctrl-fake:3: more than one is called so; give gpiochip0:3 or gpiochip1:3");
}

static void chips_that_cannot_be_opened_are_explained(void **state)
{
    (void)state;
    fake.chips[0].open_err_no = EACCES;
    assert_line_refused("GPIO2", EACCES,
                        "/dev/gpiochip0: Permission denied; join group gpio (`ls -l` shows whose it is), or add the "
                        "udev rule of hal/linux/README.md");
    fake.chips[0].open_err_no = EPERM;
    assert_line_refused("GPIO2", EPERM,
                        "/dev/gpiochip0: Operation not permitted; join group gpio (`ls -l` shows whose it is), or add "
                        "the udev rule of hal/linux/README.md");
    fake.chips[0].open_err_no = EIO;
    assert_line_refused("GPIO2", EIO, "/dev/gpiochip0: Input/output error");
    fake.chip_count = 0;
    assert_line_refused("GPIO2", ENOENT, "GPIO2: there is no GPIO chip, no /dev/gpiochip*; load its driver");
}

static void a_chip_that_is_not_needed_may_be_closed_to_us(void **state)
{
    (void)state;
    fake.chips[1].open_err_no = EACCES;
    open_port(&(struct linux_port_config){.spi = "/dev/spidev0.0", .dc = "GPIO2", .speed_hz = 1000000});
    assert_true(fake.chips[0].lines[2].held);
    port_close(&port);
}

/* As on machines whose chips are numbered anew: a link keeps the old name. */
static void a_link_to_a_chip_is_no_second_chip(void **state)
{
    (void)state;
    fake.chips[2] =
        (struct fake_chip){"/dev/gpiochip4", "gpiochip0", "pinctrl-fake", FAKE_NAMED_LINES, 0, {{.name = "GPIO2"}}};
    fake.chip_count = 3;
    open_port(&(struct linux_port_config){.spi = "/dev/spidev0.0", .dc = "GPIO2", .speed_hz = 1000000});
    assert_true(fake.chips[0].lines[2].held);
    port_close(&port);
}

static void a_line_may_be_named_as_a_chip_and_number(void **state)
{
    (void)state;
    fake.chips[0].lines[0].name = "header:pin";
    open_port(&(struct linux_port_config){.spi = "/dev/spidev0.0", .dc = "header:pin", .speed_hz = 1000000});
    assert_true(fake.chips[0].lines[0].held);
    port_close(&port);
}

static void assert_taken(const char *name, unsigned chip, unsigned number)
{
    open_port(&(struct linux_port_config){.spi = "/dev/spidev0.0", .dc = name, .speed_hz = 1000000});
    assert_true(fake.chips[chip].lines[number].held);
    assert_int_equal(fake.lines_held, 1);
    port_close(&port);
    assert_true(fake_is_clean());
}

/* Names and labels may be of one letter, begin like a path, and be as long as the kernel's, 31 letters. */
static void chips_may_have_any_name(void **state)
{
    static const char longest[] = "a-label-of-thirty-one-letters..";

    (void)state;
    fake.chips[1].n_lines = 13;
    assert_taken("expander:0", 1, 0);
    assert_taken("expander:9", 1, 9);
    assert_taken("expander:12", 1, 12);
    assert_taken("/dev/gpiochip1:10", 1, 10);
    fake.chips[1].label = "x";
    assert_taken("x:11", 1, 11);
    assert_line_refused("x:13", EINVAL, "x:13: gpiochip1 (x) has lines 0 to 12");
    assert_line_refused("y:1", ENOENT,
                        "y:1: no chip of that name on gpiochip0 (pinctrl-fake), gpiochip1 (x); `limner devices` lists "
                        "them");
    fake.chips[1].label = "/devices";
    assert_taken("/devices:2", 1, 2);
    assert_int_equal(strlen(longest), 31);
    fake.chips[1].label = longest;
    assert_taken("a-label-of-thirty-one-letters..:3", 1, 3);
    fake.chips[1].lines[5].name = ":5";
    assert_taken(":5", 1, 5);
    fake.chips[1].lines[6].name = "n";
    assert_taken("n", 1, 6);
    assert_line_refused("expander:0x1", ENOENT,
                        "expander:0x1: no line of that name on gpiochip0 (pinctrl-fake), gpiochip1 "
                        "(a-label-of-thirty-one-letters..); `limner devices` lists them");
}

/* Half of the message is theirs. */
static void of_many_chips_the_first_are_named(void **state)
{
    static const char *const names[] = {"gpiochip-of-thirty-one-letters0", "gpiochip-of-thirty-one-letters1",
                                        "gpiochip-of-thirty-one-letters2"};
    static const char *const paths[] = {"/dev/gpiochip-of-thirty-one-letters0", "/dev/gpiochip-of-thirty-one-letters1",
                                        "/dev/gpiochip-of-thirty-one-letters2"};
    static const char before[] = "GPIO77: no line of that name on ", behind[] = "; `limner devices` lists them";
    char wanted[PORT_ERROR_B];

    (void)state;
    fake.chip_count = 3;
    for (unsigned i = 0; i < 3; i++)
        fake.chips[i] = (struct fake_chip){paths[i], names[i], names[i], 4, 0, {{0}}};
    snprintf(wanted, sizeof wanted, "%s (%s), %s (%s), %s (%s)", names[0], names[0], names[1], names[1], names[2],
             names[2]);
    assert_true(strlen(wanted) > PORT_ERROR_B / 2);
    snprintf(wanted + PORT_ERROR_B / 2 - 1, PORT_ERROR_B / 2 + 1, "%s", behind);
    const struct linux_port_config config = {.spi = "/dev/spidev0.0", .dc = "GPIO77", .speed_hz = 1000000};
    assert_int_equal(linux_port_open(&port, &config), -ENOENT);
    assert_memory_equal(port.error, before, sizeof before - 1);
    assert_string_equal(port.error + sizeof before - 1, wanted);
    assert_true(fake_is_clean());
}

static void both_places_of_a_name_are_told_whole(void **state)
{
    (void)state;
    fake.chips[1].path = "/dev/gpiochip-of-thirty-one-letters.";
    fake.chips[1].name = "gpiochip-of-thirty-one-letters.";
    fake.chips[1].n_lines = 13;
    fake.chips[1].lines[12].name = "GPIO3";
    assert_line_refused("GPIO3", ENOTUNIQ,
                        "GPIO3: more than one is called so; give gpiochip0:3 or gpiochip-of-thirty-one-letters.:12");
    fake.chips[0].lines[2].is_used = true;
    fake.chips[0].lines[2].consumer = "x";
    assert_line_refused(
        "GPIO2", EBUSY,
        "GPIO2: gpiochip0:2 is in use by \"x\"; end that program, take the overlay away that says so, or take "
        "another line");
}

/* Lines ----------------------------------------------------------------------------------------- */

static void lines_are_taken_by_any_name_at_their_quiet_level(void **state)
{
    (void)state;
    open_port(&all_wired);
    const struct fake_line *lines = fake.chips[0].lines;
    assert_true(lines[5].held && lines[5].is_output && !lines[5].level);
    assert_true(lines[4].held && lines[4].is_output && lines[4].level);
    assert_true(lines[3].held && lines[3].is_output && !lines[3].level);
    assert_true(fake.chips[1].lines[2].held && !fake.chips[1].lines[2].level);
    assert_true(lines[6].held && !lines[6].is_output);
    assert_true(lines[7].held && lines[7].is_output && !lines[7].level);
    assert_int_equal(fake.lines_held, 6);
    port_close(&port);
    port_close(&port); /* a second time does nothing */
    assert_true(fake_is_clean());
}

static void each_pin_sets_its_own_line(void **state)
{
    (void)state;
    open_port(&all_wired);
    const struct fake_line *lines = fake.chips[0].lines;
    assert_int_equal(pin_set(&port.dc, true), 0);
    assert_true(lines[5].level && lines[4].level && !lines[3].level && !fake.chips[1].lines[2].level);
    assert_int_equal(pin_set(&port.reset, false), 0);
    assert_true(lines[5].level && !lines[4].level && !lines[3].level && !fake.chips[1].lines[2].level);
    assert_int_equal(pin_set(&port.select, true), 0);
    assert_int_equal(pin_set(&port.backlight, true), 0);
    assert_true(lines[5].level && !lines[4].level && lines[3].level && fake.chips[1].lines[2].level);
    assert_false(lines[7].level);
    assert_int_equal(pin_set(&port.led, true), 0);
    assert_true(lines[7].level);
    port_close(&port);
}

static void pins_that_were_not_asked_for_are_not_wired(void **state)
{
    (void)state;
    open_port(&(struct linux_port_config){.spi = "/dev/spidev0.0", .speed_hz = 1000000});
    assert_false(pin_is_wired(&port.dc) || pin_is_wired(&port.reset) || pin_is_wired(&port.backlight));
    assert_false(pin_is_wired(&port.select) || pin_is_wired(&port.led) || edge_is_wired(&port.tearing));
    port_close(&port);
    assert_refused(&(struct linux_port_config){.spi = "/dev/spidev0.0"}, EINVAL,
                   "a port needs an SPI device, a clock rate and a mode of 0 to 3");
}

static void a_rise_is_waited_for_and_not_remembered(void **state)
{
    (void)state;
    open_port(&all_wired);
    struct fake_line *tearing = &fake.chips[0].lines[6];
    tearing->rises = 5; /* before anybody waited */
    const uint64_t before_ns = fake.now_ns;
    port.error[0] = '\0';
    assert_int_equal(edge_wait(&port.tearing, 20000), 0);
    assert_string_equal(port.error, "");
    assert_int_equal(fake.now_ns - before_ns, 20000000);
    fake.rise_after_waits = 2; /* the first wait sees that nothing is remembered */
    assert_int_equal(edge_wait(&port.tearing, 20000), 1);
    port_close(&port);
}

/* Signals do not make a wait longer, nor end it early. */
static void a_wait_for_a_rise_ends_in_time_however_often_it_is_interrupted(void **state)
{
    static const struct {
        uint64_t interrupt_ns, all_ns;
    } cases[] = {{0, 1000000},      {1, 1000000},      {499999, 1000000},
                 {500000, 1000000}, {500001, 1000002}, {3000000000u, 6000000000u},
                 {999999, 1999998}, {333333, 1000000}};

    (void)state;
    open_port(&all_wired);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        fake.now_ns = 1999999998;
        const uint64_t before_ns = fake.now_ns;
        fake.interrupts = 2; /* the first is that of what rose earlier */
        fake.interrupt_ns = cases[i].interrupt_ns;
        assert_int_equal(edge_wait(&port.tearing, 1000), 0);
        assert_int_equal(fake.interrupts, 0);
        assert_int_equal(fake.now_ns - before_ns, cases[i].all_ns);
    }
    fake.interrupts = 1;
    fake.interrupt_ns = 999999; /* a nanosecond is left */
    const uint64_t before_ns = fake.now_ns;
    assert_int_equal(edge_wait(&port.tearing, 1000), 0);
    assert_int_equal(fake.now_ns - before_ns, 1000000);
    port_close(&port);
}

/* Frames ---------------------------------------------------------------------------------------- */

static struct {
    struct emulated_display glass; /* large */
    struct display display;
    struct screen screen;
    uint32_t lines[SCREEN_MEM_B(W_PX, 2) / 4];
    uint8_t rgb[3 * W_PX * H_PX];
} rig;

static const struct display_module module = {
    .w_px = W_PX, .h_px = H_PX, .ox_px = 7, .oy_px = 9, .rotation = PANEL_TURNED_180, .invert = true};

static void start_display(const char *bufsiz)
{
    struct panel_choice choice;
    struct error err;
    struct linux_port_config config = all_wired;
    config.select = NULL; /* the bus selects an ST7789 */
    fake_linux_init();
    fake.bufsiz = bufsiz;
    assert_true(panel_choice_parse("st7789", NULL, &choice, &err));
    emulated_display_choose(&rig.glass, &choice, &module);
    fake.display = rig.glass.port;
    fake.chips[0].lines[5].wire = emulated_port_dc(fake.display);
    fake.chips[0].lines[4].wire = emulated_port_reset(fake.display);
    fake.chips[0].lines[3].wire = emulated_port_backlight(fake.display);
    open_port(&config);
    assert_true(display_setup(&rig.display, &choice, &module, &port, &err));
    assert_int_equal(panel_init(rig.display.panel), 0);
    assert_int_equal(screen_init(&rig.screen, rig.display.panel, LIM_NEAREST_FIRST, rig.lines, sizeof rig.lines), 0);
}

static int draw_card(void)
{
    const struct lim_target *target = &rig.screen.target;
    int err = screen_begin_frame(&rig.screen);
    for (uint16_t y = 0; y < H_PX && !err; y++) {
        uint8_t *line = target->lend(target->ctx, y);
        for (unsigned x = 0; x < W_PX; x++) {
            line[2 * x] = (uint8_t)(test_card_px(x, y, W_PX, H_PX) >> 8);
            line[2 * x + 1] = (uint8_t)test_card_px(x, y, W_PX, H_PX);
        }
        err = target->done(target->ctx, y, 0, W_PX);
    }
    return err ? err : screen_end_frame(&rig.screen);
}

static void assert_card_shown(void)
{
    emulated_display_show(&rig.glass, rig.rgb);
    for (unsigned y = 0; y < H_PX; y++)
        for (unsigned x = 0; x < W_PX; x++) {
            const uint8_t *seen = &rig.rgb[3 * ((H_PX - 1 - y) * W_PX + W_PX - 1 - x)]; /* turned by half a turn */
            const unsigned px = (unsigned)(seen[0] >> 3 << 11 | seen[1] >> 2 << 5 | seen[2] >> 3);
            if (px != test_card_px(x, y, W_PX, H_PX)) fail_msg("pixel %u,%u is %04x", x, y, px);
        }
}

static void assert_quiet(void)
{
    struct error err;
    if (!emulated_display_is_quiet(&rig.glass, &err)) fail_msg("%s", err.text);
}

static void a_frame_arrives_whole_however_it_is_split(void **state)
{
    (void)state;
    static const char *const bufsizes[] = {"4096\n", "40\n", "17\n", "1\n"};
    for (size_t i = 0; i < sizeof bufsizes / sizeof bufsizes[0]; i++) {
        start_display(bufsizes[i]);
        assert_int_equal(draw_card(), 0);
        assert_card_shown();
        assert_quiet();
        port_close(&port);
        assert_true(fake_is_clean());
    }
}

/* Faults ---------------------------------------------------------------------------------------- */

/* A failure that need not be one: the usual bufsiz does, and so do the other chips. */
static bool is_survived(void)
{
    return fake.failed && (strstr(fake.failed, "bufsiz") || strcmp(fake.failed, "chip_open") == 0 ||
                           strcmp(fake.failed, "get_info") == 0);
}

static void opening_that_fails_anywhere_leaves_nothing_open(void **state)
{
    (void)state;
    long n = 0;
    unsigned refused = 0;
    do {
        fake_linux_init();
        fake_fail_at(n++, EREMOTEIO);
        const int err = linux_port_open(&port, &all_wired);
        if (err) {
            assert_true(err == -EREMOTEIO || err == -ENOMEM);
            assert_non_null(fake.failed);
            assert_true(strlen(port.error) > 10);
            assert_non_null(strstr(port.error, err == -ENOMEM ? "out of memory" : "Remote I/O error"));
            refused++;
        } else {
            assert_true(fake.failed == NULL || is_survived());
            port_close(&port);
        }
        assert_true(fake_is_clean());
    } while (fake.failed);
    assert_true(refused > 20);
}

static void a_frame_that_fails_anywhere_is_told_and_the_next_is_whole(void **state)
{
    (void)state;
    start_display("17\n");
    long n = 0;
    for (;; n++) {
        port.error[0] = '\0';
        fake_fail_at(n, EREMOTEIO);
        const int err = draw_card();
        if (!fake.failed) break;
        assert_int_equal(err, -EREMOTEIO);
        assert_non_null(strstr(port.error, "Remote I/O error"));
        memset(rig.glass.chip.dcs.memory, 0, sizeof rig.glass.chip.dcs.memory);
        fake_fail_at(-1, 0);
        assert_int_equal(draw_card(), 0);
        assert_card_shown();
    }
    assert_true(n > 80); /* as many calls a frame */
    port_close(&port);
    assert_true(fake_is_clean());
}

static void setting_up_that_fails_anywhere_can_be_repeated(void **state)
{
    (void)state;
    start_display("4096\n");
    for (long n = 0;; n++) {
        fake_fail_at(n, EREMOTEIO);
        const int err = panel_init(rig.display.panel);
        if (!fake.failed) break;
        assert_int_equal(err, -EREMOTEIO);
        fake_fail_at(-1, 0);
        assert_int_equal(panel_init(rig.display.panel), 0);
        assert_int_equal(draw_card(), 0);
        assert_card_shown();
    }
    port_close(&port);
    assert_true(fake_is_clean());
}

static void waiting_that_fails_is_told(void **state)
{
    (void)state;
    open_port(&all_wired);
    for (long n = 0; n < 2; n++) {
        fake_fail_at(n, EREMOTEIO);
        assert_int_equal(edge_wait(&port.tearing, 1000), -EREMOTEIO);
        assert_string_equal(port.error, "GPIO6: cannot be waited for: Remote I/O error");
    }
    fake_fail_at(0, EINVAL);
    assert_int_equal(clock_delay(&port.clock, 7), -EINVAL);
    assert_string_equal(port.error, "waiting 7 us: Invalid argument");
    fake_fail_at(0, ENODEV);
    assert_int_equal(pin_set(&port.dc, true), -ENODEV);
    assert_string_equal(port.error, "GPIO5: cannot be set: No such device");
    port_close(&port);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(writes_are_split_at_bufsiz, set_up),
        cmocka_unit_test_setup(a_bufsiz_that_is_no_length_does_not_count, set_up),
        cmocka_unit_test_setup(any_descriptor_will_do, set_up),
        cmocka_unit_test_setup(what_a_message_costs_grows_with_the_speed, set_up),
        cmocka_unit_test_setup(the_device_is_set_up_as_asked, set_up),
        cmocka_unit_test_setup(what_the_kernel_finds_too_long_is_sent_in_halves, set_up),
        cmocka_unit_test_setup(a_message_of_sixteen_bytes_is_not_halved, set_up),
        cmocka_unit_test_setup(a_message_that_is_sent_in_part_is_an_error, set_up),
        cmocka_unit_test_setup(signals_interrupt_nothing, set_up),
        cmocka_unit_test_setup(devices_that_cannot_be_opened_are_explained, set_up),
        cmocka_unit_test_setup(of_many_devices_the_first_are_named, set_up),
        cmocka_unit_test_setup(a_lack_of_memory_is_told, set_up),
        cmocka_unit_test_setup(a_device_that_cannot_be_set_up_is_closed, set_up),
        cmocka_unit_test_setup(what_a_device_cannot_do_is_explained, set_up),
        cmocka_unit_test_setup(lines_that_cannot_be_had_are_explained, set_up),
        cmocka_unit_test_setup(chips_that_cannot_be_opened_are_explained, set_up),
        cmocka_unit_test_setup(a_chip_that_is_not_needed_may_be_closed_to_us, set_up),
        cmocka_unit_test_setup(a_link_to_a_chip_is_no_second_chip, set_up),
        cmocka_unit_test_setup(a_line_may_be_named_as_a_chip_and_number, set_up),
        cmocka_unit_test_setup(chips_may_have_any_name, set_up),
        cmocka_unit_test_setup(of_many_chips_the_first_are_named, set_up),
        cmocka_unit_test_setup(both_places_of_a_name_are_told_whole, set_up),
        cmocka_unit_test_setup(lines_are_taken_by_any_name_at_their_quiet_level, set_up),
        cmocka_unit_test_setup(each_pin_sets_its_own_line, set_up),
        cmocka_unit_test_setup(pins_that_were_not_asked_for_are_not_wired, set_up),
        cmocka_unit_test_setup(a_rise_is_waited_for_and_not_remembered, set_up),
        cmocka_unit_test_setup(a_wait_for_a_rise_ends_in_time_however_often_it_is_interrupted, set_up),
        cmocka_unit_test_setup(a_frame_arrives_whole_however_it_is_split, set_up),
        cmocka_unit_test_setup(opening_that_fails_anywhere_leaves_nothing_open, set_up),
        cmocka_unit_test_setup(a_frame_that_fails_anywhere_is_told_and_the_next_is_whole, set_up),
        cmocka_unit_test_setup(setting_up_that_fails_anywhere_can_be_repeated, set_up),
        cmocka_unit_test_setup(waiting_that_fails_is_told, set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
