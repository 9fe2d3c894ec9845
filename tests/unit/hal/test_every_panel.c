/* SPDX-License-Identifier: MIT
 *
 * What holds for every panel of the lists, which is how a new one is found: the card is what the viewer sees, in all
 * formats, rotations and mirrors, in one piece and in many; whatever goes wrong with any call of the port comes through
 * unchanged, and the next frame is right; hal/PANELS.md says what it is. */
#include "rigs/cmocka_ready.h"
#include "rigs/panels/panel_rig.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { SMALL_W_PX = 17, SMALL_H_PX = 16, SWEEP_W_PX = 9, SWEEP_H_PX = 8, WHOLE_PX = 480 };

static struct panel_rig rig; /* too large for a stack; every test sets it up afresh */

static bool takes(const struct panel_choice *choice, int format)
{
    return choice->formats >> format & 1;
}

static void start(const struct panel_choice *choice, const struct display_module *module)
{
    assert_true(panel_rig_setup(&rig, choice, module, NULL));
    assert_int_equal(panel_init(rig.display.panel), 0);
}

/* Pictures ------------------------------------------------------------------------------------- */

static void check_card(const struct panel_choice *choice, struct display_module module, unsigned piece_px)
{
    start(choice, &module);
    for (rig.seed = 1; rig.seed <= 2; rig.seed++) {
        assert_int_equal(panel_rig_draw(&rig, piece_px), 0);
        panel_rig_assert_seen(&rig, false);
    }
    panel_rig_assert_quiet(&rig, 0);
}

static unsigned check_format(const struct panel_choice *choice)
{
    struct display_module module = panel_rig_module(choice, SMALL_W_PX, SMALL_H_PX);

    for (unsigned turns = 0; turns < 4; turns++) {
        module.rotation = (enum panel_rotation)turns;
        check_card(choice, module, WHOLE_PX);
        check_card(choice, module, 5);
    }
    check_card(choice, panel_rig_module(choice, WHOLE_PX, WHOLE_PX), WHOLE_PX);
    return 9;
}

static void the_card_is_right_on_every_panel_in_every_format_and_rotation(void **state)
{
    struct panel_choice choice;
    unsigned panels = 0, cards = 0;

    (void)state;
    for (; panel_choice_at(panels, &choice); panels++)
        for (int format = 0; format < PANEL_FORMATS; format++) {
            choice.format = (enum panel_format)format;
            if (takes(&choice, format)) cards += check_format(&choice);
        }
    print_message("# every panel: %u panels, %u cards\n", panels, cards);
    assert_true(panels >= 15);
}

/* Where the camera turns a picture the mirror is the glass's. */
static void a_mirrored_picture_is_right_where_a_chip_can(void **state)
{
    struct panel_choice choice;
    unsigned cannot = 0;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++) {
        struct display_module module = panel_rig_module(&choice, SMALL_W_PX, SMALL_H_PX);
        module.mirror = true;
        if (!panel_rig_setup(&rig, &choice, &module, NULL)) {
            cannot++;
            continue;
        }
        for (unsigned turns = 0; turns < 4; turns++) {
            module.rotation = (enum panel_rotation)turns;
            assert_true(panel_rig_setup(&rig, &choice, &module, NULL));
            if (rig.display.camera_turn == PANEL_UPRIGHT) check_card(&choice, module, WHOLE_PX);
        }
    }
    assert_int_equal(cannot, 3); /* pcd8544, and the memory LCDs */
}

/* Unsupported is an answer; a picture that is wrong afterwards is not. */
static void every_setting_does_what_it_says_or_is_refused(void **state)
{
    struct panel_choice choice;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++) {
        const struct display_module module = panel_rig_module(&choice, SMALL_W_PX, SMALL_H_PX);
        const uint8_t dark = choice.family == &display_sharp ? 255 : 0; /* glass without light is white */
        struct panel *panel;
        start(&choice, &module);
        panel = rig.display.panel;
        assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
        assert_int_equal(panel_blank(panel, true), 0);
        panel_rig_assert_blank(&rig, dark);
        assert_int_equal(panel_blank(panel, false), 0);
        panel_rig_assert_seen(&rig, false);
        int err = panel_set_inverted(panel, true);
        assert_true(err == 0 || err == PANEL_ERR_UNSUPPORTED);
        panel_rig_assert_seen(&rig, err == 0);
        if (!err) assert_int_equal(panel_set_inverted(panel, false), 0);
        err = panel_sleep(panel, true);
        assert_true(err == 0 || err == PANEL_ERR_UNSUPPORTED);
        if (!err) {
            panel_rig_assert_blank(&rig, dark);
            assert_int_equal(panel_sleep(panel, false), 0);
        }
        assert_int_equal(panel_keep(panel), 0);
        panel_rig_assert_seen(&rig, false);
        panel_rig_assert_quiet(&rig, 0);
    }
}

/* Faults --------------------------------------------------------------------------------------- */

static void wire_everything(struct panel_rig *on, struct port *port)
{
    port->tearing = emulated_port_tearing(on->glass.port);
}

static void wire_no_reset(struct panel_rig *on, struct port *port)
{
    port->tearing = emulated_port_tearing(on->glass.port);
    port->reset = (struct pin){0};
}

/* The driver's next calls, of which one goes wrong. Whether it came to that one. */
static bool run_with_fault(enum fault fault, long fail_at, bool with_init)
{
    fault_port_arm(&rig.fault, fail_at);
    rig.fault.fault = fault;
    rig.seed++;
    int err = with_init ? panel_init(rig.display.panel) : 0;
    if (!err) err = panel_rig_draw(&rig, WHOLE_PX);
    assert_int_equal(err, rig.fault.failed ? rig.fault.code : 0);
    assert_int_equal(rig.fault.calls_late, 0);
    if (!err) panel_rig_assert_seen(&rig, false);
    const bool failed = rig.fault.failed;
    fault_port_arm(&rig.fault, -1);
    return failed;
}

/* What a fault cut short may be complained about until the chip is told anew. */
static void assert_next_frame_is_right(bool with_init)
{
    unsigned complaints = panel_rig_complaints(&rig);

    rig.seed++;
    if (with_init) {
        assert_int_equal(panel_init(rig.display.panel), 0);
        complaints = panel_rig_complaints(&rig);
    }
    assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
    panel_rig_assert_seen(&rig, false);
    if (with_init) panel_rig_assert_quiet(&rig, complaints);
}

static long sweep(const struct panel_choice *choice, enum fault fault, bool with_init,
                  void (*wire)(struct panel_rig *, struct port *))
{
    const struct display_module module = panel_rig_module(choice, SWEEP_W_PX, SWEEP_H_PX);
    long n = 0;

    assert_true(panel_rig_setup(&rig, choice, &module, wire));
    rig.drawn_px = SWEEP_H_PX;
    if (!with_init) assert_int_equal(panel_init(rig.display.panel), 0);
    for (; run_with_fault(fault, n, with_init); n++)
        if (fault != FAULT_SLOW) assert_next_frame_is_right(with_init);
    if (fault == FAULT_SLOW) panel_rig_assert_quiet(&rig, 0);
    return n;
}

/* In the format that a chip usually gets, or in the one in which a piece can end within a byte. */
static void sweep_all(bool with_init, void (*wire)(struct panel_rig *, struct port *))
{
    struct panel_choice choice;
    long calls = 0;

    for (size_t i = 0; panel_choice_at(i, &choice); i++)
        for (int fault = 0; fault < FAULTS; fault++) {
            if (takes(&choice, PANEL_RGB444)) choice.format = PANEL_RGB444;
            const long n = sweep(&choice, (enum fault)fault, with_init, wire);
            assert_true(n > 5);
            calls += n;
        }
    print_message("# every panel: %ld faults\n", calls);
}

static void whatever_goes_wrong_comes_through_and_the_next_start_is_right(void **state)
{
    (void)state;
    sweep_all(true, wire_everything);
    sweep_all(true, wire_no_reset);
}

static void whatever_goes_wrong_in_a_frame_the_next_one_is_right_without_a_start(void **state)
{
    (void)state;
    sweep_all(false, wire_everything);
}

/* What a panel does beside frames: a call, and with which argument. */
struct deed {
    int (*call)(struct panel *panel, int argument);
    int argument;
    bool goes_on; /* after an error, with what is left of it */
};

static int do_blank(struct panel *panel, int argument)
{
    return panel_blank(panel, argument);
}

static int do_sleep(struct panel *panel, int argument)
{
    return panel_sleep(panel, argument);
}

static int do_darken(struct panel *panel, int argument)
{
    (void)argument;
    return panel_darken(panel);
}

static int do_turn(struct panel *panel, int argument)
{
    return panel_set_rotation(panel, (enum panel_rotation)argument);
}

static int do_invert(struct panel *panel, int argument)
{
    return panel_set_inverted(panel, argument);
}

static int do_light(struct panel *panel, int argument)
{
    return panel_set_backlight(panel, argument);
}

static int do_keep(struct panel *panel, int argument)
{
    (void)argument;
    return panel_keep(panel);
}

static int do_begin(struct panel *panel, int argument)
{
    (void)argument;
    return panel_begin_frame(panel);
}

static int do_window(struct panel *panel, int argument)
{
    (void)argument;
    return panel_window(panel, 0, 0, panel->w_px, panel->step_y_px);
}

static const struct deed deeds[] = {
    {do_blank, 1, false}, {do_blank, 0, false}, {do_sleep, 1, false}, {do_sleep, 0, false},  {do_darken, 0, true},
    {do_turn, 1, false},  {do_turn, 2, false},  {do_turn, 0, false},  {do_invert, 1, false}, {do_invert, 0, false},
    {do_light, 0, false}, {do_light, 1, false}, {do_keep, 0, false},  {do_begin, 0, false},  {do_window, 0, false}};

/* Fails the deed's n-th call; a setting that did not come through is none, so the next start is as the first was.
 * Whether it came to that call. */
static bool fail_deed(const struct deed *deed, enum fault fault, long n)
{
    struct panel *panel = rig.display.panel;
    const uint16_t w_px = panel->w_px, h_px = panel->h_px;

    assert_int_equal(panel_init(panel), 0);
    assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
    fault_port_arm(&rig.fault, n);
    rig.fault.fault = fault;
    const int err = deed->call(panel, deed->argument);
    const bool failed = rig.fault.failed;
    if (!failed) {
        assert_true(err == 0 || err == PANEL_ERR_UNSUPPORTED);
        return false;
    }
    assert_int_equal(err, rig.fault.code);
    if (!deed->goes_on) assert_int_equal(rig.fault.calls_late, 0);
    fault_port_arm(&rig.fault, -1);
    assert_int_equal(panel->w_px, w_px);
    assert_int_equal(panel->h_px, h_px);
    assert_next_frame_is_right(true);
    return true;
}

static void whatever_goes_wrong_in_any_other_call_comes_through_and_changes_no_setting(void **state)
{
    struct panel_choice choice;
    long calls = 0;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++)
        for (size_t k = 0; k < sizeof deeds / sizeof *deeds; k++)
            for (int fault = FAULT_AT_ONCE; fault <= FAULT_LATE; fault++) {
                const struct display_module module = panel_rig_module(&choice, SWEEP_W_PX, SWEEP_H_PX);
                assert_true(panel_rig_setup(&rig, &choice, &module, wire_everything));
                long n = 0;
                while (fail_deed(&deeds[k], (enum fault)fault, n))
                    n++;
                calls += n;
            }
    print_message("# every panel: %ld faults beside frames\n", calls);
    assert_true(calls > 500);
}

/* Of the window that was open before a start no pixel is taken any more, whether the start comes through or not. */
static void a_start_closes_the_window(void **state)
{
    static const uint8_t zeros[3 * WHOLE_PX];
    struct panel_choice choice;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++) {
        const struct display_module module = panel_rig_module(&choice, SWEEP_W_PX, SWEEP_H_PX);
        start(&choice, &module);
        struct panel *panel = rig.display.panel;
        bool failed = true;
        for (long n = 0; failed; n++) {
            const size_t piece_px = (size_t)panel->step_x_px * panel->step_y_px;
            assert_int_equal(panel_window(panel, 0, 0, panel->w_px, panel->h_px), 0);
            assert_int_equal(panel_pixels(panel, zeros, piece_px), 0);
            fault_port_arm(&rig.fault, n);
            const int err = panel_init(panel);
            failed = rig.fault.failed;
            assert_int_equal(err, failed ? rig.fault.code : 0);
            fault_port_arm(&rig.fault, -1);
            assert_int_equal(panel_pixels(panel, zeros, piece_px), PANEL_ERR_WINDOW);
            assert_int_equal(panel_init(panel), 0);
        }
    }
}

/* Nor after pixels or a flush that failed, nor after another window that was refused. */
static void an_error_closes_the_window(void **state)
{
    static const uint8_t zeros[3 * WHOLE_PX];
    struct panel_choice choice;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++) {
        const struct display_module module = panel_rig_module(&choice, SWEEP_W_PX, SWEEP_H_PX);
        start(&choice, &module);
        struct panel *panel = rig.display.panel;
        const size_t piece_px = (size_t)panel->step_x_px * panel->step_y_px;
        bool failed = true;
        assert_int_equal(panel_window(panel, 0, 0, panel->w_px, panel->h_px), 0);
        assert_int_equal(panel_window(panel, 0, panel->h_px, panel->w_px, panel->h_px), PANEL_ERR_WINDOW);
        assert_int_equal(panel_pixels(panel, zeros, piece_px), PANEL_ERR_WINDOW);
        for (long n = 0; failed; n++) {
            assert_int_equal(panel_window(panel, 0, 0, panel->w_px, panel->h_px), 0);
            fault_port_arm(&rig.fault, n);
            int err = panel_pixels(panel, zeros, piece_px);
            if (!err) err = panel_flush(panel);
            failed = rig.fault.failed;
            assert_int_equal(err, failed ? rig.fault.code : 0);
            fault_port_arm(&rig.fault, -1);
            if (failed) assert_int_equal(panel_pixels(panel, zeros, piece_px), PANEL_ERR_WINDOW);
            assert_int_equal(panel_init(panel), 0);
        }
    }
}

static void wire_messages(struct panel_rig *on, struct port *port)
{
    wire_everything(on, port);
    port->bus.message_b = 60;
}

/* A window fails at its n-th call, and what comes next at its m-th. Whether it came to that one. */
static bool fail_twice(const struct deed *deed, enum fault fault, long n, long m)
{
    struct panel *panel = rig.display.panel;

    fault_port_arm(&rig.fault, n);
    rig.fault.fault = fault;
    const int first = do_window(panel, 0);
    assert_int_equal(first, rig.fault.failed ? rig.fault.code : 0);
    fault_port_arm(&rig.fault, m);
    rig.fault.fault = fault;
    const int err = deed->call(panel, deed->argument);
    const bool failed = rig.fault.failed;
    assert_true(failed ? err == rig.fault.code : err == 0 || err == PANEL_ERR_UNSUPPORTED);
    assert_int_equal(rig.fault.calls_late, 0);
    fault_port_arm(&rig.fault, -1);
    assert_int_equal(panel_init(panel), 0);
    return failed;
}

/* After an error chips are told more than else, so that what it cut short comes to an end: this may fail as well. */
static void errors_come_through_one_after_another(void **state)
{
    static const struct deed seconds[] = {{do_window, 0, false}, {do_invert, 1, false}, {do_blank, 1, false}};
    enum { WINDOW_CALLS = 16 };
    struct panel_choice choice;
    long calls = 0;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++)
        for (unsigned k = 0; k < 2 * sizeof seconds / sizeof *seconds; k++) {
            const struct display_module module = panel_rig_module(&choice, SWEEP_W_PX, SWEEP_H_PX);
            assert_true(panel_rig_setup(&rig, &choice, &module, k % 2 ? wire_messages : wire_everything));
            assert_int_equal(panel_init(rig.display.panel), 0);
            for (long n = 0; n < WINDOW_CALLS; n++)
                for (long m = 0; fail_twice(&seconds[k / 2], n % 2 ? FAULT_SHORT : FAULT_LATE, n, m); m++)
                    calls++;
        }
    print_message("# every panel: %ld faults after another\n", calls);
    assert_true(calls > 2000);
}

/* A setting that came through is kept by the next start. */
static void a_start_keeps_what_was_set(void **state)
{
    struct panel_choice choice;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &choice); i++) {
        const struct display_module module = panel_rig_module(&choice, SMALL_W_PX, SMALL_H_PX);
        start(&choice, &module);
        const bool inverts = panel_set_inverted(rig.display.panel, true) == 0;
        assert_int_equal(panel_init(rig.display.panel), 0);
        assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
        panel_rig_assert_seen(&rig, inverts);
        assert_int_equal(panel_set_inverted(rig.display.panel, false), inverts ? 0 : PANEL_ERR_UNSUPPORTED);
        panel_rig_assert_seen(&rig, false);
    }
}

/* hal/PANELS.md -------------------------------------------------------------------------------------- */

static void put_format(char *to, size_t to_b, enum panel_format format)
{
    static const char *const names[PANEL_FORMATS] = {
        [PANEL_RGB565] = "RGB565",
        [PANEL_RGB444] = "RGB444",
        [PANEL_RGB666] = "RGB666",
        [PANEL_RGB666_LOW] = "RGB666",
        [PANEL_GREY4] = "16 greys",
        [PANEL_MONO_PAGES] = "black and white, pages",
        [PANEL_MONO_LINES] = "black and white, lines",
    };
    const size_t used = strlen(to);

    snprintf(to + used, to_b - used, "%s%s", used ? ", " : "", names[format]);
}

/* `| NAME, what it is | WxH | formats, the usual one first |` */
static bool is_row_of(const char *line, const struct panel_choice *choice)
{
    char name[32] = "", formats[96] = "", memory[160];

    for (size_t i = 0; choice->name[i] && i < sizeof name - 1; i++)
        name[i] = (char)toupper((unsigned char)choice->name[i]);
    put_format(formats, sizeof formats, choice->format);
    for (int format = 0; format < PANEL_FORMATS; format++)
        if (takes(choice, format) && format != (int)choice->format)
            put_format(formats, sizeof formats, (enum panel_format)format);
    snprintf(memory, sizeof memory, " | %ux%u | %s | ", choice->mem_w_px, choice->mem_h_px, formats);
    return strncmp(line, "| ", 2) == 0 && strncmp(line + 2, name, strlen(name)) == 0 &&
           strchr(", ", line[2 + strlen(name)]) && strstr(line, memory);
}

/* Run from the project's folder, as `make test` does. */
static void panels_page_has_a_row_for_each_panel_and_no_other(void **state)
{
    char line[512];
    struct panel_choice choice;
    unsigned panels = 0, rows = 0, in_table = 0;
    FILE *page = fopen("hal/PANELS.md", "r");

    (void)state;
    assert_non_null(page);
    while (fgets(line, sizeof line, page)) {
        if (line[0] != '|') continue;
        unsigned found = 0;
        for (panels = 0; panel_choice_at(panels, &choice); panels++)
            found += is_row_of(line, &choice);
        rows += found;
        if (in_table++ > 1 && found != 1)
            fail_msg("hal/PANELS.md: no panel of the lists is as this row says: %s", line);
    }
    fclose(page);
    assert_int_equal(rows, panels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_card_is_right_on_every_panel_in_every_format_and_rotation),
        cmocka_unit_test(a_mirrored_picture_is_right_where_a_chip_can),
        cmocka_unit_test(every_setting_does_what_it_says_or_is_refused),
        cmocka_unit_test(whatever_goes_wrong_comes_through_and_the_next_start_is_right),
        cmocka_unit_test(whatever_goes_wrong_in_a_frame_the_next_one_is_right_without_a_start),
        cmocka_unit_test(whatever_goes_wrong_in_any_other_call_comes_through_and_changes_no_setting),
        cmocka_unit_test(a_start_closes_the_window),
        cmocka_unit_test(an_error_closes_the_window),
        cmocka_unit_test(errors_come_through_one_after_another),
        cmocka_unit_test(a_start_keeps_what_was_set),
        cmocka_unit_test(panels_page_has_a_row_for_each_panel_and_no_other),
    };
    return cmocka_run_group_tests_name("every_panel", tests, NULL, NULL);
}
