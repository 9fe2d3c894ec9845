/* SPDX-License-Identifier: MIT
 *
 * Two arrays that grow: the polygons, and all their corners one after the other. */
#include "model/polygon_list.h"

#include "base/grow.h"

#include <stdlib.h>

enum { MOST_CORNERS = 1 << 28 };

void polygon_list_add(struct polygon_list *list, const uint32_t *corners, size_t count, const struct mesh_polygon *like)
{
    struct mesh_polygon polygon = *like;
    if (list->corner_count + count > MOST_CORNERS) list->full = true;
    if (list->full) return;
    polygon.first = (uint32_t)list->corner_count;
    polygon.count = (uint32_t)count;
    for (size_t i = 0; i < count; i++) {
        list->corners = grow(list->corners, list->corner_count, &list->corner_capacity, sizeof *list->corners);
        list->corners[list->corner_count++] = corners[i];
    }
    list->polygons = grow(list->polygons, list->polygon_count, &list->polygon_capacity, sizeof *list->polygons);
    list->polygons[list->polygon_count++] = polygon;
}

bool polygon_list_move(struct polygon_list *list, struct mesh *mesh, struct error *err)
{
    const struct polygon_list moved = *list;
    *list = (struct polygon_list){0};
    free(moved.full ? moved.corners : mesh->corners);
    free(moved.full ? moved.polygons : mesh->polygons);
    if (moved.full) return error_set(err, "the mesh has more than %d corners", MOST_CORNERS);
    mesh->corners = moved.corners;
    mesh->corner_count = moved.corner_count;
    mesh->polygons = moved.polygons;
    mesh->polygon_count = moved.polygon_count;
    return true;
}
