/* SPDX-License-Identifier: MIT */
#include "export/export_plan.h"

#include "displays/idle_port.h"
#include "scene/mcu_mem.h"
#include "scene/moving.h"
#include "scene/needs.h"

/* Of the renderer, the screen and the display's driver, on an 8-bit processor. */
enum { STRUCTS_B = 400 };

bool export_is_filled(const struct export_plan *plan)
{
    struct display display;
    struct error err;
    const struct needs needs = c_header_needs(plan->scenes, plan->count);
    if (!plan->module || !idle_display_setup(&display, plan->module, &err)) return false;
    return display.panel->step_y_px > 1 && needs.convex && !needs.nearest && !needs.scanline && !needs.painter &&
           !needs.depth && !needs.newell && !needs.textures && !needs.delta;
}

static size_t movers_ram_b(const struct named_scene *scene)
{
    return scene->moving ? mcu_movers_mem_b(scene->scene, scene->moving) : 0;
}

static size_t greater(size_t a, size_t b)
{
    return a > b ? a : b;
}

/* One scene is in memory at a time, beside lines of pixels, or two pages of a display, and what drivers keep. */
struct export_cost export_cost(const struct export_plan *plan)
{
    struct export_cost cost = {0};
    const size_t lines_b = (export_is_filled(plan) ? 1u : 2u * plan->world->line_count) * plan->w_px;
    for (size_t i = 0; i < plan->count; i++) {
        const struct compiled *scene = plan->scenes[i].scene;
        const struct moving *moving = plan->scenes[i].moving;
        const size_t fixed_b = STRUCTS_B + lines_b + movers_ram_b(&plan->scenes[i]);
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
