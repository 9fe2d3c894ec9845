/* SPDX-License-Identifier: MIT
 *
 * What lies where in a linked image, and which object file it is from: the map file of GNU ld. */
#ifndef SIM_LINK_MAP_H
#define SIM_LINK_MAP_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>

struct link_section {
    char *name;   /* of the section in its object, ".text.lim_frame" */
    char *object; /* its path */
    uint64_t start, size_b;
};

struct link_map {
    struct link_section *sections; /* of at least a byte, by their address */
    size_t count, capacity;
};

/* Only code, constants and variables; what is for debuggers has no place in memory. */
bool link_map_read(const char *path, struct link_map *out, struct error *err);

/* Whether a section's name is `prefix` or begins with it and a dot. */
bool link_section_is(const struct link_section *section, const char *prefix);

void link_map_free(struct link_map *map);

#endif
