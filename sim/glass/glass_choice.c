/* SPDX-License-Identifier: MIT
 *
 * The driver's usual module is looked at to see what was said, and for nothing else: only differences count. */
#include "glass/glass_choice.h"

#include "displays/module_choice.h"

#include <assert.h>
#include <stdio.h>

/* The module of that size as it is taken without being told more. */
static struct display_module usual_module(const struct panel_choice *panel, const struct display_module *module)
{
    char name[32], size[32];
    snprintf(name, sizeof name, "--panel=%s", panel->name);
    snprintf(size, sizeof size, "--size=%ux%u", module->w_px, module->h_px);
    char *items[] = {"", name, size, NULL};
    struct arguments arguments = {items, 3};
    struct module_choice choice;
    struct error err;
    const bool is_usual = module_choice_parse(&choice, &arguments, &err);
    assert(is_usual);
    (void)is_usual;
    return choice.module;
}

/* From the one end of memory to the other, or to where the upright picture begins by other addresses. */
static void move_columns(struct glass *glass, int by, unsigned mem_w_px)
{
    const int grown = (int)mem_w_px - glass->mem_w_px;
    glass->column = (uint16_t)(glass->columns_back ? glass->column + grown - by : glass->column + by);
    glass->mem_w_px = (uint16_t)mem_w_px;
}

static void move_rows(struct glass *glass, int by, unsigned mem_h_px)
{
    const int grown = (int)mem_h_px - glass->mem_h_px;
    glass->line = (uint16_t)(glass->lines_back ? glass->line + grown - by : glass->line + by);
    glass->mem_h_px = (uint16_t)mem_h_px;
}

/* Addresses of an upright picture stay; of chips that are told how many lines to scan the outputs do. */
static void mirror_columns(struct glass *glass)
{
    glass->column = (uint16_t)(glass->mem_w_px - 1 - glass->column);
    glass->columns_back = !glass->columns_back;
}

static void mirror_lines(struct glass *glass)
{
    glass->line =
        (uint16_t)(glass->told_lines ? glass_line(glass, glass->h_px - 1u) : glass->mem_h_px - 1u - glass->line);
    glass->lines_back = !glass->lines_back;
}

/* Another line of memory is the first that is seen, by a start line or by a shift: the glass begins as many outputs
 * earlier. */
static void start_at(struct glass *glass, int by)
{
    const int outputs = glass->mem_h_px;
    glass->line = (uint16_t)((glass->line + outputs + (glass->lines_back ? by : -by)) % outputs);
}

/* Memory that is left, if somebody said another than is usual; 0 is all that the chip has. */
static unsigned memory(uint16_t said, uint16_t usual, uint16_t glass, uint16_t chip)
{
    if (said == usual) return glass;
    return said ? said : chip;
}

static void place(struct glass *glass, const struct panel_choice *panel, const struct display_module *module,
                  const struct display_module *usual)
{
    move_columns(glass, module->ox_px - usual->ox_px,
                 memory(module->mem_w_px, usual->mem_w_px, glass->mem_w_px, panel->mem_w_px));
    if (panel->family->has_rows)
        move_rows(glass, module->oy_px - usual->oy_px,
                  memory(module->mem_h_px, usual->mem_h_px, glass->mem_h_px, panel->mem_h_px));
    if (module->flip_columns != usual->flip_columns) mirror_columns(glass);
    if (module->flip_rows != usual->flip_rows) mirror_lines(glass);
    start_at(glass, module->start_line - usual->start_line);
    start_at(glass, module->shift - usual->shift);
}

struct glass glass_choose(const struct panel_choice *panel, const struct display_module *module)
{
    const struct display_module usual = usual_module(panel, module);
    const struct glass *row = glass_find(panel->name, module->w_px, module->h_px);
    struct glass glass = row ? *row
                             : glass_like(panel->name, module->w_px, module->h_px, usual.ox_px,
                                          panel->family->has_rows ? usual.oy_px : 0);

    place(&glass, panel, module, &usual);
    glass.blue_first = glass.blue_first != (module->bgr != usual.bgr);
    glass.negative = glass.negative != (module->invert != usual.invert);
    glass.needs_reference = glass.needs_reference != (module->internal_reference != usual.internal_reference);
    if (module->wiring != usual.wiring)
        glass.wiring = module->wiring == PAGES_WIRING_SEQUENTIAL ? GLASS_IN_ORDER : GLASS_ALTERNATING;
    return glass;
}
