/* SPDX-License-Identifier: MIT
 *
 * A folder that holds all it takes to draw a scene in some world: the renderer, cut to what the scene requires and
 * joined into limner.c and limner.h; the scene; a display's driver; a manifest, an example, a page and the licence. */
#ifndef SIM_EXPORT_H
#define SIM_EXPORT_H

#include "export/export_plan.h"
#include "outputs/outputs.h"

bool export_put(const struct export_plan *plan, struct outputs *outputs, struct error *err);

/* What the scenes take, and whether that is more than the world's smallest board has. */
void export_report(const struct export_plan *plan);

#endif
