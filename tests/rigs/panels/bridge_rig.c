/* SPDX-License-Identifier: MIT */
#include "rigs/panels/bridge_rig.h"

#include "rigs/cmocka_ready.h"

#include <string.h>

enum { PICTURES = 3 };

static uint16_t noise(unsigned x, unsigned y, unsigned picture)
{
    return (uint16_t)((x * 211u + y * 3001u + picture * 911u) * 2654435761u >> 16);
}

int bridge_rig_draw(struct bridge_rig *rig, unsigned picture)
{
    const struct lim_target *target = &rig->screen.target;

    int err = screen_begin_frame(&rig->screen);
    if (err) return err;
    for (uint16_t y = 0; y < target->h_px; y++) {
        uint8_t *line = target->lend(target->ctx, y);
        for (unsigned x = 0; x < target->w_px; x++) {
            line[2 * x] = (uint8_t)(noise(x, y, picture) >> 8);
            line[2 * x + 1] = (uint8_t)noise(x, y, picture);
        }
        err = target->done(target->ctx, y, 0, target->w_px);
        if (err) return err;
    }
    return screen_end_frame(&rig->screen);
}

int bridge_rig_start(struct bridge_rig *rig, unsigned picture)
{
    const int err = panel_init(rig->display.panel);
    return err ? err : bridge_rig_draw(rig, picture);
}

void bridge_rig_connect(struct bridge_rig *rig, const struct port *port)
{
    struct error err;

    if (!display_setup(&rig->display, &rig->choice, &rig->module, port, &err)) fail_msg("%s", err.text);
    assert_int_equal(screen_init(&rig->screen, rig->display.panel, LIM_NEAREST_FIRST, rig->mem, sizeof rig->mem), 0);
}

static void draw_golden(struct bridge_rig *rig)
{
    emulated_display_choose(&rig->glass, &rig->choice, &rig->module);
    const struct port port = emulated_port_whole(rig->glass.port);
    bridge_rig_connect(rig, &port);
    assert_int_equal(panel_init(rig->display.panel), 0);
    for (unsigned picture = 0; picture < PICTURES; picture++) {
        assert_int_equal(bridge_rig_draw(rig, picture), 0);
        emulated_display_show(&rig->glass, rig->golden[picture]);
    }
}

/* Which the families have by different names: complaints so far, and memory. */
struct inside {
    unsigned *complaints;
    void *memory;
    size_t memory_b;
};

static struct inside look_inside(struct emulated_display *glass, const struct display_family *family)
{
    if (family == &display_dcs)
        return (struct inside){&glass->chip.dcs.complaints, glass->chip.dcs.memory, sizeof glass->chip.dcs.memory};
    if (family == &display_pages)
        return (struct inside){&glass->chip.pages.complaints, glass->chip.pages.memory,
                               sizeof glass->chip.pages.memory};
    if (family == &display_solomon)
        return (struct inside){&glass->chip.solomon.complaints, glass->chip.solomon.memory,
                               sizeof glass->chip.solomon.memory};
    assert_ptr_equal(family, &display_sharp);
    return (struct inside){&glass->chip.sharp.complaints, glass->chip.sharp.memory, sizeof glass->chip.sharp.memory};
}

void bridge_rig_forgive(struct bridge_rig *rig)
{
    *look_inside(&rig->glass, rig->choice.family).complaints = 0;
}

/* Cheaper than a power-up, and as good: the driver's reset is one. */
static void scribble(struct bridge_rig *rig)
{
    const struct inside inside = look_inside(&rig->glass, rig->choice.family);
    memset(inside.memory, 0x55, inside.memory_b);
    bridge_rig_forgive(rig);
}

static bool has_golden(const struct bridge_rig *rig, const struct panel_choice *choice, uint16_t w_px, uint16_t h_px)
{
    return rig->choice.chip == choice->chip && rig->choice.format == choice->format && rig->module.w_px == w_px &&
           rig->module.h_px == h_px;
}

void bridge_rig_setup(struct bridge_rig *rig, const char *panel, uint16_t w_px, uint16_t h_px)
{
    struct panel_choice choice;
    struct error err;

    if (!panel_choice_parse(panel, NULL, &choice, &err)) fail_msg("%s", err.text);
    const bool again = has_golden(rig, &choice, w_px, h_px);
    rig->choice = choice;
    rig->module = (struct display_module){.w_px = w_px, .h_px = h_px};
    if (!again) {
        draw_golden(rig);
        emulated_display_choose(&rig->glass, &rig->choice, &rig->module);
    }
    scribble(rig);
    emulated_bridge_init(&rig->bridge, rig->glass.port);
}

void bridge_rig_assert_shown(const struct bridge_rig *rig, unsigned picture)
{
    static uint8_t seen[BRIDGE_RIG_MOST_PX * 3];
    struct error err;

    if (!emulated_display_is_quiet(&rig->glass, &err)) fail_msg("%s", err.text);
    emulated_display_show(&rig->glass, seen);
    assert_memory_equal(seen, rig->golden[picture], (size_t)rig->module.w_px * rig->module.h_px * 3);
}

void bridge_rig_assert_quiet(const struct bridge_rig *rig)
{
    const char *complaint = emulated_bridge_complaint(&rig->bridge);

    if (complaint) fail_msg("bridge: %s", complaint);
}
