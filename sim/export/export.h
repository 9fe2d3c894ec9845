/* SPDX-License-Identifier: MIT
 *
 * A folder that holds all it takes to draw a scene in some world: the renderer, cut to what the scene requires and
 * joined into limner.c and limner.h; the scene; a display's driver; a manifest, an example, a page and the licence. */
#ifndef SIM_EXPORT_H
#define SIM_EXPORT_H

#include "base/c_name.h"
#include "base/outputs.h"
#include "displays/module_choice.h"
#include "export/world.h"
#include "scene/scene_files.h"

struct export
{
    const struct world *world;
    const char *folder;               /* to be written */
    const struct c_name *name;        /* of the whole: its symbol names the files */
    const struct named_scene *scenes; /* named FOLDER/src/NAME or FOLDER/src/NAME_HALL */
    size_t count;
    const struct module_choice *module; /* NULL: pixels are sent by a function of the user's */
    unsigned w_px, h_px;                /* of the picture */
    const char *command;                /* that asks for all this */
};

bool export_put(const struct export *export, struct outputs *outputs, struct error *err);

/* The lens of the example. */
enum { EXPORT_FOV_DEG = 60 };

/* Bytes of constant data, and of RAM without the stack: with what the scene asks for, and with the least that it takes.
 */
struct export_cost {
    size_t data_b, ram_b, least_ram_b;
    size_t least_mem_b; /* for lim_init() alone */
};
struct export_cost export_cost(const struct export *export);

/* Whether the world's smallest board has so much RAM, and a stack beside it. */
bool export_has_room(const struct export *export, size_t ram_b);

/* What the scenes take, and whether that is more than the world's smallest board has. */
void export_report(const struct export *export);

#endif
