/* SPDX-License-Identifier: MIT
 *
 * Lines that wait for the bus: however fast it is, they come in order, are not painted over before they have left, and
 * go out together; meanwhile something else is done. The emulated bus reads data as late as it may. */
#include "rigs/panels/dcs_rig.h"
#include "rigs/random.h"

#include <limits.h>

/* What the screen asks of the port, which sends some bytes between two looks, or takes random times. */
struct look {
    struct random random;
    bool is_random;
    size_t step_b, gone_b;  /* bytes that leave between two looks */
    long calls;             /* of the port, at the last look */
    unsigned worked, to_do; /* quanta */
};

static struct look look;

static size_t left_b(void *ctx)
{
    const struct emulated_port *port = &rig.chip.port;

    (void)ctx;
    if (port->pending_b == 0) return 0;
    if (look.is_random) return random_in(&look.random, 0, 2) ? port->pending_b : 0;
    if (rig.fault.calls != look.calls) look.gone_b = 0;
    look.calls = rig.fault.calls;
    look.gone_b += look.step_b;
    return look.gone_b < port->pending_b ? port->pending_b - look.gone_b : 0;
}

static bool work(void *ctx)
{
    assert_ptr_equal(ctx, &look);
    look.worked++;
    return look.worked < look.to_do;
}

static void start(unsigned n_lines, size_t step_b)
{
    const struct bus bus = {.left_b = left_b};

    rig_setup(module_240x240);
    rig.chip.port.deferred = true;
    rig_start(n_lines);
    look = (struct look){.random = {1}, .step_b = step_b};
    screen_set_bus(&rig.screen, &bus, NULL, NULL);
}

static void assert_frame(void)
{
    memset(rig.mem, 0xEE, sizeof rig.mem);
    assert_int_equal(draw_frame(&rig.screen), 0);
    assert_card_shown(0, false);
    assert_quiet();
}

static void a_slow_bus_gets_half_of_the_lines_at_a_time(void **state)
{
    (void)state;
    for (unsigned n_lines = 1; n_lines <= 33; n_lines++) {
        start(n_lines, 1);
        assert_frame();
        const long calls = rig.fault.calls;
        assert_frame();
        assert_int_equal(rig.chip.frame_writes, 2);
        const unsigned at_once = n_lines > 1 ? n_lines / 2 : 1;
        if (n_lines == 2 || n_lines == 16) print_message("# %u lines: %ld calls\n", n_lines, rig.fault.calls - calls);
        assert_true(rig.fault.calls - calls <= 30 + (n_lines == 1 ? 480 : 240 / at_once + 1));
    }
}

static void a_fast_bus_gets_every_line_at_once(void **state)
{
    (void)state;
    start(16, 100000);
    assert_frame();
    const long calls = rig.fault.calls;
    assert_frame();
    assert_true(rig.fault.calls - calls >= 240);
}

/* A line is painted in the time in which `step_b` bytes leave. */
static void lines_come_whole_at_any_speed(void **state)
{
    (void)state;
    for (size_t step_b = 40; step_b < 4000; step_b = step_b * 3 / 2) {
        start(8, step_b);
        assert_frame();
        assert_frame();
    }
    for (unsigned n_lines = 2; n_lines < 20; n_lines++) {
        start(n_lines, 0);
        look.is_random = true;
        assert_frame();
        assert_frame();
    }
}

/* Lines, pieces and windows of the renderer in turns. */
static void pieces_and_windows_keep_their_places(void **state)
{
    (void)state;
    start(8, 0);
    look.is_random = true;
    const struct lim_target *target = &rig.screen.target;
    for (int frame = 0; frame < 10; frame++) {
        assert_int_equal(screen_begin_frame(&rig.screen), 0);
        for (unsigned y = 0; y < 240;) {
            const unsigned n = (unsigned)random_in(&look.random, 1, 12), end = y + n < 240 ? y + n : 240;
            const struct lim_rect whole = {0, (uint16_t)y, 240, (uint16_t)end};
            const int how = (int)random_in(&look.random, 0, 3);
            if (how == 0) assert_int_equal(target->window(target->ctx, &whole), 0);
            if (how == 2)
                assert_int_equal(draw_lines(&rig.screen, (y + end) / 2, end, 240), 0); /* the wrong way round */
            assert_int_equal(draw_lines(&rig.screen, y, how == 2 ? (y + end) / 2 : end, how == 1 ? 70 : 240), 0);
            if (how == 0) assert_int_equal(target->window(target->ctx, NULL), 0);
            y = end;
        }
        assert_int_equal(screen_end_frame(&rig.screen), 0);
        assert_card_shown(0, false);
        assert_quiet();
    }
}

static void work_is_done_while_bytes_leave_and_no_longer(void **state)
{
    const struct bus bus = {.left_b = left_b};

    (void)state;
    for (unsigned n_lines = 1; n_lines <= 16; n_lines *= 2) {
        start(n_lines, 10);
        screen_set_bus(&rig.screen, &bus, work, &look);
        look.to_do = UINT_MAX;
        assert_frame();
        print_message("# %u lines: %u quanta\n", n_lines, look.worked);
        assert_true(look.worked > 5000); /* of 11520 looks, of which an eighth of what is sent comes too late */
        look.worked = 0;
        look.to_do = 100;
        assert_frame();
        assert_true(look.worked > 100 && look.worked < 600); /* each wait asks once whether there is any */
    }
}

static void lines_that_wait_are_lost_with_their_frame_only(void **state)
{
    (void)state;
    start(8, 0);
    look.is_random = true;
    for (long n = 0; n < 80; n++) {
        fault_arm(n);
        const int err = draw_frame(&rig.screen);
        assert_int_equal(err, rig.fault.failed ? rig.fault.code : 0);
        fault_arm(-1);
        assert_int_equal(draw_frame(&rig.screen), 0);
        assert_card_shown(0, false);
    }
}

static void formats_whose_lines_cannot_join_have_two(void **state)
{
    (void)state;
    rig_setup(module_135x240);
    rig_start(9);
    assert_int_equal(rig.screen.n_lines, 2);
    rig_setup(module_240x240);
    rig.config.format = PANEL_RGB444;
    rig_start(9);
    assert_int_equal(rig.screen.n_lines, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slow_bus_gets_half_of_the_lines_at_a_time),
        cmocka_unit_test(a_fast_bus_gets_every_line_at_once),
        cmocka_unit_test(lines_come_whole_at_any_speed),
        cmocka_unit_test(pieces_and_windows_keep_their_places),
        cmocka_unit_test(work_is_done_while_bytes_leave_and_no_longer),
        cmocka_unit_test(lines_that_wait_are_lost_with_their_frame_only),
        cmocka_unit_test(formats_whose_lines_cannot_join_have_two),
    };
    return cmocka_run_group_tests_name("screen_lines", tests, NULL, NULL);
}
