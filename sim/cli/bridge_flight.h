/* SPDX-License-Identifier: MIT
 *
 * What a flight through a scene costs over a USB-HID bridge if only what changes is sent: frames are rendered, and go
 * through the real port to an emulated MCP2210 (bridge_cost.h). */
#ifndef SIM_BRIDGE_FLIGHT_H
#define SIM_BRIDGE_FLIGHT_H

#include "cli/bridge_cost.h"

/* *out: of a frame, on average of all but the first, which is whole. */
bool bridge_flight_cost(const struct panel_choice *choice, const struct display_module *module, const char *scene_path,
                        const char *camera_path, struct bridge_cost *out, struct error *err);

#endif
