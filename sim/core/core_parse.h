/* SPDX-License-Identifier: MIT
 *
 * Options on how the renderer draws. Each refusal names the option. */
#ifndef SIM_CORE_PARSE_H
#define SIM_CORE_PARSE_H

#include "base/error.h"
#include "core/core.h"

/* --precision NAME */
bool parse_precision(const char *text, const struct core **core, struct error *err);

/* --wireframe[=RRGGBB,RRGGBB]: the line's colour and the background's; NULL: the polygons' and the scene's own. */
bool parse_wireframe(const char *text, struct lim_wireframe *out, struct error *err);

/* --background RRGGBB, as RGB565. */
bool parse_background(const char *text, uint16_t *out, struct error *err);

#endif
