/* SPDX-License-Identifier: MIT
 *
 * Where the vertices of a mesh lie in its textures: struct lim_uv, and the bits of each texture. */
#ifndef SIM_ENCODE_UV_H
#define SIM_ENCODE_UV_H

#include "compiler/encode_vertex.h"
#include "model/mesh.h"

/* How places in a texture are written. */
struct uv_scale {
    double low[2], high[2]; /* of all corners that show it; low > high: none does */
    double whole[2];        /* what places are counted from, whole pictures */
    bool by_polygon;        /* they are counted from another one in each polygon: it repeats too often for one */
    uint8_t bits;
};

struct uv_encoder {
    const struct mesh *mesh;
    struct vertex_encoder *vertices;
    struct uv_scale *scales; /* of the mesh's textures */
    uint8_t *place_bits;     /* the same bits, for the texture encoder */
    uint32_t *next;          /* of each vertex, the next one at the same point; or none */
    bool *is_set;            /* of each vertex: it has a place */
    size_t next_count, next_capacity, set_capacity;
};

/* Refuses textures that repeat more often across a polygon than 16 bits can tell. The caller frees it either way. */
bool uv_encoder_init(struct uv_encoder *encoder, const struct mesh *mesh, struct vertex_encoder *vertices,
                     struct error *err);

/* The vertex of a polygon's corner that is rounded to `point`: one that is there already, if it has this place, too. */
uint32_t uv_encode(struct uv_encoder *encoder, const struct mesh_polygon *polygon, uint32_t corner,
                   struct grid_point point);

/* Places of all vertices, also of those that no texture is shown at. */
void uv_encoder_finish(struct uv_encoder *encoder);

void uv_encoder_free(struct uv_encoder *encoder);

#endif
