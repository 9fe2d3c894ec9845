/* SPDX-License-Identifier: MIT
 *
 * The port over hidapi, with a hidapi of our own that reaches emulated bridges: which bridge is taken, what is said
 * where none can be, and that plugs may be pulled at any report. */
#include "fakes/fake_hidapi.h"
#include "hid/hid_bridges.h"
#include "hid/hid_port.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/bridge_rig.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <wchar.h>

static struct bridge_rig rig;
static struct emulated_bridge others[FAKE_PLACES]; /* without a display of interest */
static struct port port;

static void assert_text(const char *part)
{
    if (!strstr(port.error, part)) fail_msg("\"%s\" does not say \"%s\"", port.error, part);
    assert_null(strchr(port.error, '\n'));
    assert_true(strlen(port.error) < PORT_ERROR_B - 1);
}

/* Time stands still but for a millisecond that every look at the clock takes, and sleep is noted. */
static struct {
    struct timespec now, asked;
    unsigned sleeps, interrupted; /* the first so many end early */
    int sleep_errno;              /* that all of them fail with; 0: none does */
} fake_time;

int clock_gettime(clockid_t clock, struct timespec *now)
{
    (void)clock; /* cmocka looks at others */
    *now = fake_time.now;
    fake_time.now.tv_nsec += 1000000;
    if (fake_time.now.tv_nsec < 1000000000) return 0;
    fake_time.now.tv_nsec -= 1000000000;
    fake_time.now.tv_sec++;
    return 0;
}

int nanosleep(const struct timespec *asked, struct timespec *left)
{
    fake_time.asked = *asked;
    if (fake_time.sleep_errno) {
        errno = fake_time.sleep_errno;
        return -1;
    }
    if (fake_time.sleeps++ >= fake_time.interrupted) return 0;
    *left = (struct timespec){asked->tv_sec / 2, asked->tv_nsec / 2};
    errno = EINTR;
    return -1;
}

/* The program is linked with --wrap for it. */
static int allocations_left = -1; /* of the port's; -1: any number */

void *__real_calloc(size_t n, size_t size_b);
void *__wrap_calloc(size_t n, size_t size_b);

void *__wrap_calloc(size_t n, size_t size_b)
{
    if (allocations_left >= 0) assert_int_equal(n, 1); /* nobody has more than one of anything */
    if (allocations_left == 0) return NULL;
    if (allocations_left > 0) allocations_left--;
    return __real_calloc(n, size_b);
}

/* The rig's bridge in the first place, with this serial number. */
static int set_up(void **state)
{
    (void)state;
    bridge_rig_setup(&rig, "st7735", 24, 9);
    fake_hidapi =
        (struct fake_hidapi){.places = {{.cable = &rig.bridge.cable, .path = "/dev/hidraw0", .serial = L"0001"}}};
    for (unsigned i = 1; i < FAKE_PLACES; i++)
        emulated_bridge_init(&others[i], rig.glass.port);
    return 0;
}

/* Nothing stays open, nothing is left of a list. */
static int tear_down(void **state)
{
    (void)state;
    port_close(&port);
    assert_int_equal(fake_hidapi.opened, fake_hidapi.closed);
    assert_int_equal(fake_hidapi.listed, fake_hidapi.freed);
    assert_false(fake_hidapi.ended_open);
    return 0;
}

static int open_port(const char *serial)
{
    const struct bridge_options options = emulated_bridge_options(&rig.bridge);

    return hid_port_open(&port, serial, &options);
}

/* The waits are the display's, which takes no time. */
static void connect_driver(void)
{
    port.clock = emulated_port_clock(rig.glass.port);
    bridge_rig_connect(&rig, &port);
}

static void plug_in(unsigned place, const char *path, const wchar_t *serial)
{
    fake_hidapi.places[place] = (struct fake_place){.cable = &others[place].cable, .path = path, .serial = serial};
}

static void frames_arrive_whole(void **state)
{
    (void)state;
    fake_hidapi.interrupted_every = 3;
    assert_int_equal(open_port(NULL), 0);
    connect_driver();
    assert_int_equal(bridge_rig_start(&rig, 0), 0);
    bridge_rig_assert_shown(&rig, 0);
    bridge_rig_assert_quiet(&rig);
}

static void waits_take_their_time(void **state)
{
    (void)state;
    assert_int_equal(open_port(NULL), 0);
    fake_time.sleeps = 0;
    assert_int_equal(clock_delay(&port.clock, 10), 0);
    assert_int_equal(fake_time.asked.tv_sec, 0);
    assert_int_equal(fake_time.asked.tv_nsec, 10000);
    assert_int_equal(clock_delay(&port.clock, 3999999), 0);
    assert_int_equal(fake_time.asked.tv_sec, 3);
    assert_int_equal(fake_time.asked.tv_nsec, 999999000);
    assert_int_equal(clock_delay(&port.clock, 4000000), 0);
    assert_int_equal(fake_time.asked.tv_sec, 4);
    assert_int_equal(fake_time.asked.tv_nsec, 0);
    assert_int_equal(fake_time.sleeps, 3);
    fake_time.interrupted = 5;
    assert_int_equal(clock_delay(&port.clock, 4000000), 0);
    fake_time.interrupted = 0;
    assert_int_equal(fake_time.sleeps, 6);
    assert_int_equal(fake_time.asked.tv_sec, 1); /* half of 4 s, twice: the last is the rest of the rest */
    errno = EIO;                                 /* another's, which a sleep that ends well leaves as it is */
    assert_int_equal(clock_delay(&port.clock, 4), 0);
    assert_int_equal(fake_time.sleeps, 7);
    fake_time.sleep_errno = EINVAL;
    assert_int_equal(clock_delay(&port.clock, 4), -EINVAL);
    fake_time.sleep_errno = 0;
}

/* A look at the clock takes a millisecond, of the second that an answer is waited for, wherever the second begins. */
static void answers_are_waited_for_a_second(void **state)
{
    (void)state;
    for (long begin_ns = 1; begin_ns < 1000000000; begin_ns += begin_ns < 900000000 ? 49999999 : 1000000) {
        fake_time.now = (struct timespec){7, begin_ns};
        fake_hidapi.longest_ms = 0;
        fake_hidapi.shortest_ms = BRIDGE_PATIENCE_MS;
        assert_int_equal(open_port(NULL), 0);
        assert_int_equal(fake_hidapi.longest_ms, BRIDGE_PATIENCE_MS - 1);
        assert_int_equal(fake_hidapi.shortest_ms, BRIDGE_PATIENCE_MS - 1);
        port_close(&port);
    }
}

static void of_a_closed_port_nothing_is_wired(void **state)
{
    (void)state;
    assert_int_equal(open_port(NULL), 0);
    assert_true(pin_is_wired(&port.dc) && pin_is_wired(&port.reset));
    port_close(&port);
    assert_false(pin_is_wired(&port.dc) || pin_is_wired(&port.reset) || pin_is_wired(&port.backlight));
    assert_true(!port.bus.write && !port.clock.delay && !port.ctx && !port.close);
}

static void serial_numbers_are_cut_and_paths_are_not(void **state)
{
    static const size_t lengths[] = {0, 1, 62, 63, 64, 65, 127, 128, 129};
    static wchar_t serial[130];
    static char path[130];
    struct hid_bridge found[HID_BRIDGES_MAX];

    (void)state;
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        const size_t length = lengths[i];
        wmemset(serial, L'7', length);
        memset(path, '/', length);
        serial[length] = L'\0';
        path[length] = '\0';
        fake_hidapi.places[0].serial = serial;
        fake_hidapi.places[0].path = path;
        assert_int_equal(hid_bridges_find(found), length < 128);
        if (length >= 128) continue;
        assert_string_equal(found[0].path, path);
        assert_int_equal(strlen(found[0].serial), length < 64 ? length : 63);
    }
}

static void of_a_serial_number_what_is_not_ascii_is_no_digit(void **state)
{
    static const wchar_t serial[] = {L'A', L' ', L'!', L'~', 127, 128, 0xE9, 31, L'z', L'\0'};
    struct hid_bridge found[HID_BRIDGES_MAX];

    (void)state;
    fake_hidapi.places[0].serial = serial;
    assert_int_equal(hid_bridges_find(found), 1);
    assert_string_equal(found[0].serial, "A?!~????z");
}

static void of_many_bridges_the_first_are_found(void **state)
{
    static const wchar_t *const serials[] = {L"00", L"01", L"02", L"03", L"04", L"05", L"06", L"07", L"08", L"09",
                                             L"10", L"11", L"12", L"13", L"14", L"15", L"16", L"17", L"18", L"19"};
    struct hid_bridge found[HID_BRIDGES_MAX + 4]; /* untouched behind the last */

    (void)state;
    for (unsigned n = 1; n <= FAKE_PLACES; n++) {
        char last[3];
        if (n > 1) plug_in(n - 1, "/dev/hidraw7", serials[n - 1]);
        memset(found, 0x5A, sizeof found);
        const size_t listed = hid_bridges_find(found);
        assert_int_equal(listed, n < 16 ? n : 16);
        snprintf(last, sizeof last, "%02u", (unsigned)listed - 1);
        if (n > 1) assert_string_equal(found[listed - 1].serial, last);
        assert_int_equal(found[listed].serial[0], 0x5A);
    }
}

static void the_right_bridge_is_taken(void **state)
{
    (void)state;
    plug_in(1, "/dev/hidraw1", L"0002");
    plug_in(2, "/dev/hidraw2", NULL);
    assert_int_equal(open_port("0002"), 0);
    assert_true(others[1].cable.reports > 0);
    assert_int_equal(rig.bridge.cable.reports + others[2].cable.reports, 0);
}

static void of_several_none_is_taken_unasked(void **state)
{
    (void)state;
    plug_in(1, "/dev/hidraw1", L"0002");
    plug_in(2, "/dev/hidraw2", NULL);
    assert_int_equal(open_port(NULL), -EEXIST);
    assert_string_equal(
        port.error,
        "USB-HID bridge: there are several; choose by serial number: 0001, 0002, one without a readable serial number");
    assert_int_equal(open_port(""), -EEXIST);
    assert_int_equal(fake_hidapi.opened, 0);
}

/* Half of what a reason may have is theirs, 112 bytes with the end of the text. */
static void of_many_serial_numbers_the_first_are_named(void **state)
{
    static const char before[] = "USB-HID bridge: there are several; choose by serial number: 0001, ";

    (void)state;
    for (unsigned i = 1; i < FAKE_PLACES; i++)
        plug_in(i, "/dev/hidraw1", L"0123456789");
    assert_int_equal(open_port(NULL), -EEXIST);
    assert_memory_equal(port.error, before, sizeof before - 1);
    assert_int_equal(strlen(port.error), sizeof before - 1 - 6 + 111);
}

static void a_bridge_that_is_not_there_is_told(void **state)
{
    (void)state;
    assert_int_equal(open_port("0007"), -ENODEV);
    assert_string_equal(port.error, "USB-HID bridge 0007: none has that serial number; there is 0001");
    plug_in(1, "/dev/hidraw1", L"0002");
    assert_int_equal(open_port("0002"), 0);
    port_close(&port);
    fake_hidapi.places[1].cable = NULL; /* and is no longer found, whatever memory holds of it */
    assert_int_equal(open_port("0002"), -ENODEV);
    assert_string_equal(port.error, "USB-HID bridge 0002: none has that serial number; there is 0001");
    fake_hidapi.places[0].cable = NULL;
    assert_int_equal(open_port(NULL), -ENODEV);
    assert_text("USB-HID bridge: none is plugged in (an MCP2210 is USB 04d8:00de)");
    assert_null(port.close);
}

static void the_longest_serial_number_is_named_whole(void **state)
{
    static const char longest[] = "012345678901234567890123456789012345678901234567890123456789012";

    (void)state;
    assert_int_equal(strlen(longest), HID_SERIAL_B - 1);
    assert_int_equal(open_port(longest), -ENODEV);
    assert_memory_equal(port.error, "USB-HID bridge ", 15);
    assert_memory_equal(port.error + 15, longest, sizeof longest - 1);
    assert_string_equal(port.error + 15 + sizeof longest - 1, ": none has that serial number; there is 0001");
}

/* As by libusb, whatever errno was before. */
static void an_error_without_a_number_may_be_one_of_permissions(void **state)
{
    (void)state;
    fake_hidapi.places[0].open_untold = true;
    for (int before = 0; before < 20; before++) {
        errno = before;
        assert_int_equal(open_port(NULL), -EIO);
        assert_text("MCP2210: cannot be opened, mostly for want of permission; put ATTRS{idVendor}==\"04d8\"");
    }
}

static void a_lack_of_memory_is_told(void **state)
{
    int enough = 0;

    (void)state;
    for (int err = -ENOMEM; err; enough++) {
        memset(&port, 0x5A, sizeof port);
        allocations_left = enough;
        err = open_port(NULL);
        allocations_left = -1;
        if (!err) break;
        assert_int_equal(err, -ENOMEM);
        assert_text("out of memory");
        assert_non_null(strstr(port.error, enough < 2 ? "USB-HID bridge: " : "MCP2210 0001: "));
        assert_null(port.close);
        assert_int_equal(fake_hidapi.opened, fake_hidapi.closed);
    }
    assert_int_equal(enough, 3); /* the link, the port and the bridge's state */
}

static void a_lack_of_permission_names_the_rule(void **state)
{
    (void)state;
    fake_hidapi.places[0].open_errno = EACCES;
    assert_int_equal(open_port(NULL), -EACCES);
    assert_text("MCP2210: no permission; put ATTRS{idVendor}==\"04d8\", ATTRS{idProduct}==\"00de\", MODE=\"0666\" into "
                "/etc/udev/rules.d/70-mcp2210.rules and plug it in again");
    fake_hidapi.places[0].open_errno = EPERM;
    assert_int_equal(open_port(NULL), -EACCES);
    fake_hidapi.places[0].open_errno = EBUSY;
    assert_int_equal(open_port(NULL), -EBUSY);
    assert_text("MCP2210: /dev/hidraw0 cannot be opened: ");
}

static void an_error_that_is_no_unplugging_is_told_as_hidapi_does(void **state)
{
    (void)state;
    for (int fault = CABLE_REFUSED; fault <= CABLE_UNREAD; fault++) {
        set_up(NULL);
        assert_int_equal(open_port(NULL), 0);
        connect_driver();
        assert_int_equal(bridge_rig_start(&rig, 0), 0);
        emulated_cable_arm(&rig.bridge.cable, 10, (enum cable_fault)fault, -EIO);
        assert_int_equal(bridge_rig_draw(&rig, 1), -EIO);
        assert_text("MCP2210 0001: hidapi: a made-up error");
        assert_int_equal(bridge_rig_draw(&rig, 2), 0);
        assert_int_equal(fake_hidapi.opened, 2);
        bridge_rig_forgive(&rig);
        bridge_rig_assert_shown(&rig, 2);
        tear_down(NULL);
    }
}

static void a_bridge_that_does_not_begin_again_is_closed(void **state)
{
    (void)state;
    assert_int_equal(open_port(NULL), 0);
    emulated_cable_arm(&rig.bridge.cable, 0, CABLE_REFUSED, -EIO);
    assert_int_equal(pin_set(&port.dc, true), -EIO);
    assert_int_equal(fake_hidapi.opened, fake_hidapi.closed);
    emulated_cable_arm(&rig.bridge.cable, 0, CABLE_LOST, 0);
    assert_int_equal(pin_set(&port.dc, true), -ETIMEDOUT);
    assert_int_equal(fake_hidapi.opened, 2);
    assert_int_equal(fake_hidapi.closed, 2);
    assert_int_equal(pin_set(&port.dc, true), 0);
}

/* What the bridge itself complained about is forgotten when the next error is the cable's. */
static void each_error_has_its_own_reason(void **state)
{
    (void)state;
    assert_int_equal(open_port(NULL), 0);
    for (unsigned i = 0; i < 3; i++) {
        emulated_cable_arm(&rig.bridge.cable, 0, CABLE_LOST, 0);
        assert_int_equal(pin_set(&port.dc, true), -ETIMEDOUT);
        assert_text("MCP2210 0001: no answer");
        assert_int_equal(fake_hidapi.closed, i);
        emulated_cable_arm(&rig.bridge.cable, 0, CABLE_REFUSED, -EIO);
        assert_int_equal(pin_set(&port.dc, true), -EIO);
        assert_text("MCP2210 0001: hidapi: a made-up error");
        assert_int_equal(fake_hidapi.closed, i + 1);
        assert_int_equal(pin_set(&port.dc, true), 0);
    }
}

static void a_report_cut_short_is_an_error(void **state)
{
    (void)state;
    fake_hidapi.writes_short = true;
    assert_int_equal(open_port(NULL), -EIO);
    assert_text("hidapi");
}

/* Plugged in again it has another path. Returns whether the plug was pulled at all. */
static bool survives_unplugging(long n)
{
    set_up(NULL);
    assert_int_equal(open_port(NULL), 0);
    connect_driver();
    emulated_cable_arm(&rig.bridge.cable, n, CABLE_UNPLUGGED, 0);
    const int err = bridge_rig_start(&rig, 0);
    const bool pulled = rig.bridge.cable.unplugged;
    assert_int_equal(err, pulled ? -ENODEV : 0);
    if (pulled) {
        assert_text("MCP2210 0001: unplugged; plug it in again");
        assert_int_equal(bridge_rig_start(&rig, 1), -ENODEV);
        assert_text("MCP2210 0001: none is plugged in");
        plug_in(1, "/dev/hidraw0", L"0002"); /* another one comes first */
        assert_int_equal(bridge_rig_start(&rig, 1), -ENODEV);
        assert_text("MCP2210 0001: none has that serial number; there is 0002");
        emulated_bridge_replug(&rig.bridge);
        fake_hidapi.places[0].path = "/dev/hidraw1";
        assert_int_equal(bus_flush(&port.bus), 0);
        bridge_rig_forgive(&rig);
        assert_int_equal(bridge_rig_start(&rig, 1), 0);
        bridge_rig_assert_shown(&rig, 1);
        bridge_rig_assert_quiet(&rig);
        assert_int_equal(others[1].cable.reports, 0);
    }
    tear_down(NULL);
    return pulled;
}

static void plugs_may_be_pulled_at_any_report(void **state)
{
    long n = 0;

    (void)state;
    while (survives_unplugging(n))
        n++;
    print_message("# hid port: unplugged at %ld reports\n", n);
    assert_true(n > 60);
}

/* As many as are looked at, and ours no more among them. */
static void one_of_many_may_be_unplugged(void **state)
{
    (void)state;
    for (unsigned i = 1; i < FAKE_PLACES; i++)
        plug_in(i, "/dev/hidraw7", L"0002");
    assert_int_equal(open_port("0001"), 0);
    rig.bridge.cable.unplugged = true;
    assert_int_equal(pin_set(&port.dc, true), -ENODEV);
    assert_string_equal(port.error, "MCP2210 0001: unplugged; plug it in again");
}

static void a_bridge_without_a_serial_number_comes_back_as_the_only_one(void **state)
{
    (void)state;
    fake_hidapi.places[0].serial = NULL;
    assert_int_equal(open_port(NULL), 0);
    connect_driver();
    assert_int_equal(bridge_rig_start(&rig, 0), 0);
    rig.bridge.cable.unplugged = true;
    assert_int_equal(bridge_rig_draw(&rig, 1), -ENODEV);
    assert_text("MCP2210: unplugged");
    emulated_bridge_replug(&rig.bridge);
    assert_int_equal(bridge_rig_start(&rig, 1), 0);
    bridge_rig_forgive(&rig);
    bridge_rig_assert_shown(&rig, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(frames_arrive_whole, set_up, tear_down),
        cmocka_unit_test_setup_teardown(waits_take_their_time, set_up, tear_down),
        cmocka_unit_test_setup_teardown(answers_are_waited_for_a_second, set_up, tear_down),
        cmocka_unit_test_setup_teardown(of_a_closed_port_nothing_is_wired, set_up, tear_down),
        cmocka_unit_test_setup_teardown(serial_numbers_are_cut_and_paths_are_not, set_up, tear_down),
        cmocka_unit_test_setup_teardown(of_a_serial_number_what_is_not_ascii_is_no_digit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(of_many_bridges_the_first_are_found, set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_right_bridge_is_taken, set_up, tear_down),
        cmocka_unit_test_setup_teardown(of_several_none_is_taken_unasked, set_up, tear_down),
        cmocka_unit_test_setup_teardown(of_many_serial_numbers_the_first_are_named, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_bridge_that_is_not_there_is_told, set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_longest_serial_number_is_named_whole, set_up, tear_down),
        cmocka_unit_test_setup_teardown(an_error_without_a_number_may_be_one_of_permissions, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_lack_of_memory_is_told, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_lack_of_permission_names_the_rule, set_up, tear_down),
        cmocka_unit_test_setup_teardown(an_error_that_is_no_unplugging_is_told_as_hidapi_does, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_bridge_that_does_not_begin_again_is_closed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(each_error_has_its_own_reason, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_report_cut_short_is_an_error, set_up, tear_down),
        cmocka_unit_test_setup_teardown(plugs_may_be_pulled_at_any_report, set_up, tear_down),
        cmocka_unit_test_setup_teardown(one_of_many_may_be_unplugged, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_bridge_without_a_serial_number_comes_back_as_the_only_one, set_up, tear_down),
    };
    return cmocka_run_group_tests_name("hid_port", tests, NULL, NULL);
}
