/* SPDX-License-Identifier: MIT
 *
 * Every panel of the lists through hal/linux on a fake machine: the card is right, and whichever call of the kernel
 * fails, while a panel is set up or a frame is sent, its error comes through, and what follows is right. */
#include "fakes/fake_linux.h"
#include "linux/linux_port.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/panels/panel_rig.h"

#include <errno.h>

enum { W_PX = 9, H_PX = 8, WHOLE_PX = 480 };

static struct panel_rig rig; /* too large for a stack */
static struct port port;

/* In the emulated port's place: the machine's SPI and lines, which lead to the same glass. */
static void wire(struct panel_rig *to, struct port *whole)
{
    const bool selects = to->choice.family == &display_sharp;
    const struct linux_port_config config = {.spi = "/dev/spidev0.0",
                                             .dc = selects ? NULL : "GPIO5",
                                             .reset = selects ? NULL : "GPIO4",
                                             .backlight = "GPIO3",
                                             .select = selects ? "GPIO2" : NULL,
                                             .speed_hz = 1000000,
                                             .no_cs = selects};
    struct fake_line *lines = fake.chips[0].lines;

    fake.display = to->glass.port;
    lines[5].wire = whole->dc;
    lines[4].wire = whole->reset;
    lines[3].wire = whole->backlight;
    lines[2].wire = whole->select;
    assert_int_equal(linux_port_open(&port, &config), 0);
    *whole = port;
}

static void start(const struct panel_choice *choice)
{
    const struct display_module module = panel_rig_module(choice, W_PX, H_PX);

    fake_linux_init();
    assert_true(panel_rig_setup(&rig, choice, &module, wire));
    rig.fault.fail_at = -1;
    assert_int_equal(panel_init(rig.display.panel), 0);
    assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
    panel_rig_assert_seen(&rig, false);
    panel_rig_assert_quiet(&rig, 0);
}

static void finish(void)
{
    port_close(&port);
    assert_true(fake_is_clean());
}

/* With little effort every twentieth call fails, from another one on for each panel. */
static long step(void)
{
    return 20 / effort(20);
}

/* Returns how many calls of the kernel setting up takes, or a few more. */
static long sweep_init(long first)
{
    for (long n = first;; n += step()) {
        fake_fail_at(n, EREMOTEIO);
        const int err = panel_init(rig.display.panel);
        if (!fake.failed) return n;
        assert_int_equal(err, -EREMOTEIO);
        fake_fail_at(-1, 0);
        assert_int_equal(panel_init(rig.display.panel), 0);
        rig.seed++;
        assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
        panel_rig_assert_seen(&rig, false);
    }
}

/* A panel that was powered all the time needs no setting up again. */
static long sweep_frame(long first)
{
    for (long n = first;; n += step()) {
        fake_fail_at(n, EREMOTEIO);
        rig.seed++;
        const int err = panel_rig_draw(&rig, WHOLE_PX);
        if (!fake.failed) return n;
        assert_int_equal(err, -EREMOTEIO);
        fake_fail_at(-1, 0);
        rig.seed++;
        assert_int_equal(panel_rig_draw(&rig, WHOLE_PX), 0);
        panel_rig_assert_seen(&rig, false);
    }
}

static void every_call_of_the_kernel_may_fail_on_every_panel(void **state)
{
    struct panel_choice choice;
    unsigned panels = 0;
    long calls = 0;

    (void)state;
    for (; panel_choice_at(panels, &choice); panels++) {
        start(&choice);
        const long first = panels % step(), of_init = sweep_init(first), of_frame = sweep_frame(first);
        assert_true(of_init > 2 && of_frame > 2);
        calls += of_init + of_frame;
        finish();
    }
    print_message("# linux: %u panels, %ld calls of the kernel\n", panels, calls);
    assert_true(panels >= 15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_call_of_the_kernel_may_fail_on_every_panel)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
