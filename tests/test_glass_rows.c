/* SPDX-License-Identifier: MIT
 *
 * The drivers, as `limner module` and `limner play` set them up for a chip and a size with nothing else told, on the
 * modules of the glass table, which were found without looking at the drivers: the viewer sees the card as it was
 * turned, and mirrored where the chip can. */
#include "cmocka_ready.h"
#include "module_choice.h"
#include "panel_rig.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct panel_rig rig;

/* As the command line has it. */
static struct module_choice choose(const struct glass *row)
{
    char name[32], size[32];
    snprintf(name, sizeof name, "--panel=%s", row->chip);
    snprintf(size, sizeof size, "--size=%ux%u", row->w_px, row->h_px);
    char *items[] = {"", name, size, NULL};
    struct arguments arguments = {items, 3};
    struct module_choice choice;
    struct error err;

    if (!module_choice_parse(&choice, &arguments, &err)) fail_msg("%s", err.text);
    return choice;
}

static void check_row(const struct glass *row, enum panel_rotation rotation, bool mirror)
{
    struct module_choice choice = choose(row);

    choice.module.rotation = rotation;
    choice.module.mirror = mirror;
    if (!panel_rig_setup_on(&rig, &choice.panel, &choice.module, row)) {
        assert_true(mirror); /* the chip cannot */
        return;
    }
    rig.seed = rotation + 4u * mirror;
    assert_int_equal(panel_init(rig.display.panel), 0);
    assert_int_equal(panel_rig_draw(&rig, row->w_px + row->h_px), 0);
    panel_rig_assert_seen(&rig, false);
    panel_rig_assert_quiet(&rig, 0);
}

static void usual_modules_show_the_card_as_it_was_turned(void **state)
{
    const struct glass *row = *state;

    for (unsigned turn = 0; turn < 4; turn++)
        for (unsigned mirror = 0; mirror < 2; mirror++)
            check_row(row, (enum panel_rotation)turn, mirror);
}

/* Repositories differ: two files of one are one source. */
static unsigned independent(const struct glass *row)
{
    unsigned count = 0;

    for (unsigned i = 0; i < GLASS_SOURCES && row->sources[i]; i++) {
        const char *const path = strchr(row->sources[i], ' ');
        bool is_new = true;
        assert_non_null(path);
        assert_non_null(memchr(row->sources[i], '/', (size_t)(path - row->sources[i])));
        for (unsigned k = 0; k < i; k++)
            if (strncmp(row->sources[i], row->sources[k], (size_t)(path - row->sources[i] + 1)) == 0) is_new = false;
        count += is_new;
    }
    return count;
}

static void every_row_has_two_sources_and_lies_within_its_chip(void **state)
{
    (void)state;
    for (const struct glass *row = glass_rows; row->chip; row++) {
        if (independent(row) < 2) fail_msg("%s %ux%u: fewer than two sources", row->chip, row->w_px, row->h_px);
        assert_true(glass_fits(row));
        const unsigned last = row->lines_back ? row->line - (row->h_px - 1u) : row->line + row->h_px - 1u;
        if (last >= row->mem_h_px) fail_msg("%s %ux%u: lines run over", row->chip, row->w_px, row->h_px);
        for (const struct glass *other = row + 1; other->chip; other++)
            if (strcmp(other->chip, row->chip) == 0 && other->w_px == row->w_px && other->h_px == row->h_px)
                fail_msg("%s %ux%u: two rows", row->chip, row->w_px, row->h_px);
    }
}

static void every_chip_has_a_row_for_what_it_is_taken_for(void **state)
{
    struct panel_choice panel;

    (void)state;
    for (size_t i = 0; panel_choice_at(i, &panel); i++) {
        const struct glass *row = glass_find(panel.name, 0, 0);
        if (!row) fail_msg("%s has no row", panel.name);
        char name[32];
        snprintf(name, sizeof name, "--panel=%s", panel.name);
        char *items[] = {"", name, NULL};
        struct arguments arguments = {items, 2};
        struct module_choice choice;
        struct error err;
        assert_true(module_choice_parse(&choice, &arguments, &err));
        assert_int_equal(choice.module.w_px, row->w_px);
        assert_int_equal(choice.module.h_px, row->h_px);
    }
}

int main(void)
{
    enum { MOST_ROWS = 64 };
    static struct CMUnitTest tests[MOST_ROWS + 2];
    static char names[MOST_ROWS][64];
    size_t count = 0;

    for (const struct glass *row = glass_rows; row->chip && count < MOST_ROWS; row++, count++) {
        snprintf(names[count], sizeof names[count], "%s %ux%u shows the card as it was turned", row->chip, row->w_px,
                 row->h_px);
        tests[count] = (struct CMUnitTest){.name = names[count],
                                           .test_func = usual_modules_show_the_card_as_it_was_turned,
                                           .initial_state = (void *)(uintptr_t)row};
    }
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(every_row_has_two_sources_and_lies_within_its_chip);
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(every_chip_has_a_row_for_what_it_is_taken_for);
    return _cmocka_run_group_tests("glass_rows", tests, count, NULL, NULL);
}
