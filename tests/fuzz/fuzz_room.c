/* SPDX-License-Identifier: MIT
 *
 * The seed is chosen for a room with few polygons and a solid. */
#include "fuzz_room.h"

#include "compiler/compile_mesh.h"
#include "rigs/closed_scene.h"

#include <stdio.h>
#include <stdlib.h>

static void compile_room(struct compiled *room)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .keep_faces = true, .w_px = 8, .h_px = 8};
    struct random random = {272};
    struct closed_scene closed;
    struct mesh mesh;
    struct error err;

    closed_scene_make(&closed, &random);
    if (!mesh_clean(&closed.model, &mesh, &err) || !mesh_insert_t_vertices(&mesh, &err) ||
        !compile_mesh(&mesh, &options, room, &err)) {
        fprintf(stderr, "the room does not compile: %s\n", err.text);
        abort();
    }
    mesh_free(&mesh);
    closed_scene_free(&closed);
}

const struct compiled *fuzz_room(void)
{
    static struct compiled room;

    if (!room.image) compile_room(&room);
    return &room;
}
