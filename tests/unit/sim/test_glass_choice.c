/* SPDX-License-Identifier: MIT
 *
 * Modules that somebody says are not the usual ones: the glass that is chosen for them shows the card of a driver that
 * was told so, and of one that was not told it does not. On each row of the table, with each way to differ.
 * And of sizes that no row has. */
#include "displays/module_choice.h"
#include "glass/glass_choice.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/panel_rig.h"

#include <stdio.h>

static struct panel_rig rig;

/* false: the chip has no glass of that size. */
static bool choose_size(struct module_choice *choice, const char *chip, unsigned w_px, unsigned h_px, struct error *err)
{
    char name[32], size[32];
    snprintf(name, sizeof name, "--panel=%s", chip);
    snprintf(size, sizeof size, "--size=%ux%u", w_px, h_px);
    char *items[] = {"", name, size, NULL};
    struct arguments arguments = {items, 3};

    return module_choice_parse(choice, &arguments, err);
}

static struct module_choice usual_of(const struct glass *row)
{
    struct module_choice choice;
    struct error err;

    if (!choose_size(&choice, row->chip, row->w_px, row->h_px, &err)) fail_msg("%s", err.text);
    return choice;
}

/* The ways to differ: false if the chip has no such thing. */
static bool is_sharp(const struct panel_choice *panel)
{
    return panel->family == &display_sharp;
}

static bool flip_columns(const struct panel_choice *panel, struct display_module *module)
{
    module->flip_columns = !module->flip_columns;
    return panel->flips;
}

static bool flip_rows(const struct panel_choice *panel, struct display_module *module)
{
    module->flip_rows = !module->flip_rows;
    return panel->flips && !module->shift; /* a maker's shift is for one direction */
}

static bool exchange_colours(const struct panel_choice *panel, struct display_module *module)
{
    module->bgr = !module->bgr;
    return panel->format != PANEL_GREY4 && panel->format != PANEL_MONO_PAGES && !is_sharp(panel);
}

static bool invert(const struct panel_choice *panel, struct display_module *module)
{
    module->invert = !module->invert;
    return !is_sharp(panel);
}

/* To where memory has room, by steps of two pixels as greys want. */
static bool shift_columns(const struct panel_choice *panel, struct display_module *module)
{
    const unsigned mem_w_px = module->mem_w_px ? module->mem_w_px : panel->mem_w_px;
    if (module->ox_px + module->w_px + 2u <= mem_w_px)
        module->ox_px = (uint16_t)(module->ox_px + 2);
    else if (module->ox_px >= 2)
        module->ox_px = (uint16_t)(module->ox_px - 2);
    else
        return false;
    return true;
}

static bool shift_rows(const struct panel_choice *panel, struct display_module *module)
{
    const unsigned mem_h_px = module->mem_h_px ? module->mem_h_px : panel->mem_h_px;
    if (!panel->family->has_rows || module->oy_px + module->h_px >= mem_h_px) return false;
    module->oy_px++;
    return true;
}

static bool take_all_memory(const struct panel_choice *panel, struct display_module *module)
{
    const bool had_less = module->mem_w_px;
    module->mem_w_px = panel->mem_w_px;
    module->mem_h_px = panel->mem_h_px;
    return panel->has_mode_pins && had_less;
}

static bool rewire(const struct panel_choice *panel, struct display_module *module)
{
    const struct glass *row = glass_find(panel->name, module->w_px, module->h_px);
    module->wiring = row->wiring == GLASS_IN_ORDER ? PAGES_WIRING_ALTERNATIVE : PAGES_WIRING_SEQUENTIAL;
    return panel->has_wiring;
}

/* Only where all outputs are in use is there another first line. */
static bool start_elsewhere(const struct panel_choice *panel, struct display_module *module)
{
    module->start_line = 5;
    return panel->start_lines && module->h_px == panel->mem_h_px;
}

static const struct way {
    const char *name;
    bool (*apply)(const struct panel_choice *panel, struct display_module *module);
} WAYS[] = {{"columns mirrored", flip_columns},      {"rows mirrored", flip_rows},
            {"colours exchanged", exchange_colours}, {"negative", invert},
            {"two columns on", shift_columns},       {"a row on", shift_rows},
            {"all memory", take_all_memory},         {"wired otherwise", rewire},
            {"another line", start_elsewhere}};

static bool shows(const struct module_choice *choice, const struct display_module *module, const struct glass *glass,
                  enum panel_rotation rotation)
{
    struct display_module told = *module;

    told.rotation = rotation;
    assert_true(panel_rig_setup_on(&rig, &choice->panel, &told, glass));
    assert_int_equal(panel_init(rig.display.panel), 0);
    assert_int_equal(panel_rig_draw(&rig, 1000), 0);
    return panel_rig_sees(&rig);
}

/* All memory is no other address upright, but turned it is. */
static bool is_missed(const struct module_choice *usual, const struct glass *glass)
{
    for (unsigned turn = 0; turn < 4; turn++)
        if (!shows(usual, &usual->module, glass, (enum panel_rotation)turn)) return true;
    return false;
}

static void what_differs_is_seen_unless_it_was_said(void **state)
{
    const struct way *way = *state;
    unsigned tried = 0;

    for (const struct glass *row = glass_rows; row->chip; row++) {
        const struct module_choice usual = usual_of(row);
        struct display_module module = usual.module;
        if (!way->apply(&usual.panel, &module)) continue;
        const struct glass glass = glass_choose(&usual.panel, &module);
        for (unsigned turn = 0; turn < 4; turn++)
            if (!shows(&usual, &module, &glass, (enum panel_rotation)turn))
                fail_msg("%s %ux%u, turned %u: not seen", row->chip, row->w_px, row->h_px, turn);
        if (!is_missed(&usual, &glass)) fail_msg("%s %ux%u: seen untold", row->chip, row->w_px, row->h_px);
        tried++;
    }
    assert_true(tried > 0);
}

static void what_is_not_said_is_as_the_table_has_it(void **state)
{
    (void)state;
    for (const struct glass *row = glass_rows; row->chip; row++) {
        const struct module_choice usual = usual_of(row);
        const struct glass glass = glass_choose(&usual.panel, &usual.module);
        assert_memory_equal(&glass, row, sizeof glass);
    }
}

/* Every multiple of eight pixels up to 132x64, as small OLEDs come in; every fifth of larger memory. */
static unsigned show_sizes(const struct glass *row)
{
    const unsigned step_w_px = row->mem_w_px <= 132 && row->mem_h_px <= 64 ? 8 : row->mem_w_px / 40 * 8u;
    const unsigned step_h_px = row->mem_h_px <= 64 ? 8 : row->mem_h_px / 40 * 8u;
    unsigned shown = 0;

    for (unsigned w_px = step_w_px; w_px <= row->mem_w_px; w_px += step_w_px)
        for (unsigned h_px = step_h_px; h_px <= row->mem_h_px; h_px += step_h_px) {
            struct module_choice choice;
            struct error err;
            if (glass_find(row->chip, w_px, h_px) || !choose_size(&choice, row->chip, w_px, h_px, &err)) continue;
            const struct glass glass = glass_choose(&choice.panel, &choice.module);
            for (unsigned turn = 0; turn < 4; turn += 2) {
                if (!shows(&choice, &choice.module, &glass, (enum panel_rotation)turn))
                    fail_msg("%s %ux%u, turned %u: not seen", row->chip, w_px, h_px, turn);
                panel_rig_assert_quiet(&rig, 0);
            }
            shown++;
        }
    return shown;
}

static void sizes_that_no_row_has_are_shown_too(void **state)
{
    unsigned shown = 0;

    (void)state;
    for (const struct glass *row = glass_rows; row->chip; row++)
        if (glass_find(row->chip, 0, 0) == row) shown += show_sizes(row);
    assert_in_range(shown, 400, 10000);
}

int main(void)
{
    enum { COUNT = sizeof WAYS / sizeof WAYS[0] };
    static struct CMUnitTest tests[COUNT + 2];

    for (size_t i = 0; i < COUNT; i++)
        tests[i] = (struct CMUnitTest){.name = WAYS[i].name,
                                       .test_func = what_differs_is_seen_unless_it_was_said,
                                       .initial_state = (void *)(uintptr_t)&WAYS[i]};
    tests[COUNT] = (struct CMUnitTest)cmocka_unit_test(what_is_not_said_is_as_the_table_has_it);
    tests[COUNT + 1] = (struct CMUnitTest)cmocka_unit_test(sizes_that_no_row_has_are_shown_too);
    return _cmocka_run_group_tests("glass_choice", tests, COUNT + 2, NULL, NULL);
}
