/* SPDX-License-Identifier: MIT
 *
 * What is to be exported, and what it takes. */
#ifndef SIM_EXPORT_PLAN_H
#define SIM_EXPORT_PLAN_H

#include "displays/module_choice.h"
#include "export/world.h"
#include "scene/scene_files.h"

/* What is inline in a header of the project has no use in every file that it is joined into. */
#define EXPORT_UNUSED "#ifdef __clang__\n#pragma clang diagnostic ignored \"-Wunused-function\"\n#endif\n"

struct export_plan {
    const struct world *world;
    const char *folder;               /* to be written */
    const struct c_name *name;        /* of the whole: its symbol names the files */
    const struct named_scene *scenes; /* named FOLDER/src/NAME or FOLDER/src/NAME_HALL */
    size_t count;
    const struct module_choice *module; /* NULL: pixels are sent by a function of the user's */
    unsigned w_px, h_px;                /* of the picture */
    double near_m;                      /* of the example's camera; 0: lens_default_near_m() */
    const char *command;                /* that asks for all this */
};

/* Whether the display has colours, as other libraries' examples draw them; so it is without a display of ours. */
bool export_is_in_colour(const struct export_plan *plan);

/* Whether the display's runs are put into its pages at once, without a line of memory. */
bool export_is_filled(const struct export_plan *plan);

/* The lens of the example; and the least stack that a renderer takes. */
enum { EXPORT_STACK_B = 640 };

/* Bytes of constant data, and of RAM without the stack: with what the scene asks for, and with the least that it takes.
 */
struct export_cost {
    size_t data_b, ram_b, least_ram_b;
    size_t least_mem_b; /* for lim_init() alone */
};
struct export_cost export_cost(const struct export_plan *plan);

/* Whether the world's smallest board has so much RAM, and a stack beside it. */
bool export_has_room(const struct export_plan *plan, size_t ram_b);

#endif
