/* SPDX-License-Identifier: MIT */
#include "export/export_plan.h"

#include "displays/idle_port.h"
#include "limner.h"
#include "pixels.h"
#include "scene/mcu_mem.h"
#include "scene/moving.h"
#include "scene/needs.h"
#include "screen.h"

/* Of the renderer, the screen and the display's driver, on an 8-bit processor. */
enum { STRUCTS_B = 400, DELTA_STRUCT_B = 200 };

bool export_is_in_colour(const struct export_plan *plan)
{
    return !plan->module || plan->module->panel.format == PANEL_RGB565 || plan->module->panel.format == PANEL_RGB666;
}

bool export_is_filled(const struct export_plan *plan)
{
    struct display display;
    struct error err;
    const struct needs needs = c_header_needs(plan->scenes, plan->count);
    if (!plan->module || !idle_display_setup(&display, plan->module, &err)) return false;
    return display.panel->step_y_px > 1 && needs.convex && !needs.nearest && !needs.scanline && !needs.painter &&
           !needs.depth && !needs.newell && !needs.mesh && !needs.mesh_depth && !needs.textures && !needs.delta;
}

static size_t movers_ram_b(const struct named_scene *scene)
{
    return scene->moving ? mcu_movers_mem_b(scene->scene, scene->moving) : 0;
}

/* Of pixels, as the display's source, or NAME_MEMORY(), declares them. */
static size_t lines_b(const struct export_plan *plan, const struct compiled *scene)
{
    const bool all = scene->report.draws == LIM_PAINTER || scene->report.framebuffer;
    struct display display;
    struct error err;
    if (!plan->module || !idle_display_setup(&display, plan->module, &err))
        return (size_t)LIM_LINE_B(plan->w_px) * (all ? plan->h_px : 1u);
    const struct panel *panel = display.panel;
    const size_t count = export_is_filled(plan) ? 0u : all ? panel->h_px : plan->world->line_count;
    if (panel->step_x_px > 1 || panel->step_y_px > 1) return SCREEN_PAGES_MEM_B(panel->w_px, count);
    return pixels_head_b(panel->format, 1) ? SCREEN_WIDE_MEM_B(panel->w_px, count) : SCREEN_MEM_B(panel->w_px, count);
}

/* What options ask for: changes alone, smooth edges, the whole picture. */
static size_t extras_b(const struct export_plan *plan, const struct compiled *scene, const struct needs *needs)
{
    size_t all_b = 0;
    if (needs->delta)
        all_b += DELTA_STRUCT_B + 4u * ((size_t)plan->w_px + scene->report.delta_runs) + 2u * ((size_t)plan->h_px + 1);
    if (needs->antialias) all_b += LIM_ANTIALIAS_MEM_B(plan->w_px);
    if (needs->fill && needs->nearest && plan->module) all_b += SCREEN_FRAME_MEM_B(plan->w_px, plan->h_px);
    return all_b;
}

static size_t greater(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* One scene is in memory at a time, beside lines of pixels, and what drivers keep. */
struct export_cost export_cost(const struct export_plan *plan)
{
    struct export_cost cost = {0};
    const struct needs needs = c_header_needs(plan->scenes, plan->count);
    for (size_t i = 0; i < plan->count; i++) {
        const struct compiled *scene = plan->scenes[i].scene;
        const struct moving *moving = plan->scenes[i].moving;
        const size_t fixed_b =
            STRUCTS_B + lines_b(plan, scene) + extras_b(plan, scene, &needs) + movers_ram_b(&plan->scenes[i]);
        cost.data_b += scene->report.flash_b;
        for (size_t k = 0; moving && k < moving->count; k++)
            cost.data_b += moving->objects[k].scene.report.flash_b;
        cost.ram_b = greater(cost.ram_b, fixed_b + mcu_mem_b(scene));
        cost.least_ram_b = greater(cost.least_ram_b, fixed_b + mcu_mem_min_b(scene));
        cost.least_mem_b = greater(cost.least_mem_b, mcu_mem_min_b(scene));
    }
    return cost;
}

bool export_has_room(const struct export_plan *plan, size_t ram_b)
{
    return !plan->world->smallest || ram_b + EXPORT_STACK_B <= plan->world->ram_b;
}
