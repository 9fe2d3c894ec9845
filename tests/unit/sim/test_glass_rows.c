/* SPDX-License-Identifier: MIT
 *
 * The drivers, as `limner module` and `limner play` set them up for a chip and a size with nothing else told, on the
 * modules of the glass table, which were found without looking at the drivers: the viewer sees the card as it was
 * turned, and mirrored where the chip can. */
#include "displays/module_choice.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/panel_rig.h"

#include <glob.h>
#include <regex.h>
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

/* Not seen, and yet a default that can be wrong: within what others set, or twice or half of what the maker does. */
static void usual_modules_get_their_voltage_and_current(void **state)
{
    unsigned voltages = 0, currents = 0;

    (void)state;
    for (const struct glass *row = glass_rows; row->chip; row++) {
        const struct module_choice choice = choose(row);
        assert_true(panel_rig_setup_on(&rig, &choice.panel, &choice.module, row));
        assert_int_equal(panel_init(rig.display.panel), 0);
        if (row->most_mv) {
            assert_in_range(emulated_pages_supply_mv(&rig.glass.chip.pages), row->least_mv, row->most_mv);
            voltages++;
        }
        if (row->current_permille) {
            assert_in_range(emulated_solomon_current_permille(&rig.glass.chip.solomon), row->current_permille / 2u,
                            row->current_permille * 2u);
            currents++;
        }
    }
    assert_int_equal(voltages, 3);
    assert_int_equal(currents, 1);
}

/* Claims of the documents ----------------------------------------------------------------------------------------- */

/* A row of that size, or all of the chip's memory: what the table in hal/PANELS.md has. */
static bool is_known(const char *chip, unsigned w_px, unsigned h_px)
{
    const struct glass *row = glass_find(chip, 0, 0);

    if (!row) return false;
    return glass_find(chip, w_px, h_px) || (row->mem_w_px == w_px && row->mem_h_px == h_px);
}

/* A chip and, soon after it, a size: counts them, and fails on one that no row holds. */
static unsigned check_line(const regex_t *claim, const char *path, const char *line)
{
    regmatch_t at[4];
    unsigned count = 0;

    for (; regexec(claim, line, 4, at, 0) == 0; line += at[0].rm_eo, count++) {
        char chip[16] = "";
        for (regoff_t i = 0; i < at[1].rm_eo - at[1].rm_so; i++) {
            const char c = line[at[1].rm_so + i];
            chip[i] = c >= 'A' && c <= 'Z' ? (char)(c + 'a' - 'A') : c;
        }
        const unsigned w_px = (unsigned)atoi(line + at[2].rm_so), h_px = (unsigned)atoi(line + at[3].rm_so);
        if (!is_known(chip, w_px, h_px))
            fail_msg("%s speaks of %s with %ux%u pixels: no row has that", path, chip, w_px, h_px);
    }
    return count;
}

static void compile_claim(regex_t *claim)
{
    char pattern[512] = "(", name[32];

    for (const struct glass *row = glass_rows; row->chip; row++) {
        if (glass_find(row->chip, 0, 0) != row) continue;
        snprintf(name, sizeof name, "%s%s", row == glass_rows ? "" : "|", row->chip);
        strcat(pattern, name);
    }
    strcat(pattern, ")[^0-9x|]{0,24}[ |]{0,3}([0-9]+)x([0-9]+)");
    assert_int_equal(regcomp(claim, pattern, REG_EXTENDED | REG_ICASE), 0);
}

static unsigned check_document(const regex_t *claim, const char *path)
{
    static char line[1 << 16];
    FILE *file = fopen(path, "r");
    unsigned count = 0;

    if (!file) fail_msg("%s cannot be read", path);
    while (fgets(line, sizeof line, file))
        count += check_line(claim, path, line);
    fclose(file);
    return count;
}

static void documents_speak_of_no_module_without_a_row(void **state)
{
    regex_t claim;
    glob_t boards;

    (void)state;
    compile_claim(&claim);
    assert_true(is_known("st7735", 128, 128) && !is_known("st7735", 128, 129) && !is_known("sh1107", 128, 128));
    assert_int_equal(check_line(&claim, "here", "| SH1106 | 132x64 | and an ssd1306 --size 72x40, 1x1"), 2);
    assert_in_range(check_document(&claim, "hal/PANELS.md"), 16, 1000);
    check_document(&claim, "README.md");
    check_document(&claim, "hal/README.md");
    check_document(&claim, "boards/README.md");
    assert_int_equal(glob("boards/*/README.md", 0, NULL, &boards), 0);
    unsigned count = 0;
    for (size_t i = 0; i < boards.gl_pathc; i++)
        count += check_document(&claim, boards.gl_pathv[i]);
    assert_in_range(count, 5, 1000);
    globfree(&boards);
    regfree(&claim);
}

int main(void)
{
    enum { MOST_ROWS = 64 };
    static struct CMUnitTest tests[MOST_ROWS + 4];
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
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(usual_modules_get_their_voltage_and_current);
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(every_chip_has_a_row_for_what_it_is_taken_for);
    tests[count++] = (struct CMUnitTest)cmocka_unit_test(documents_speak_of_no_module_without_a_row);
    return _cmocka_run_group_tests("glass_rows", tests, count, NULL, NULL);
}
