/* SPDX-License-Identifier: MIT
 *
 * Textures and mappings of a mesh as the scene's arrays have them: only what some record shows. */
#ifndef SIM_ENCODE_TEXTURE_H
#define SIM_ENCODE_TEXTURE_H

#include "base/map.h"
#include "model/mesh.h"
#include "scene.h"
#include "scene/encoding.h"

struct texture_encoder {
    const struct mesh *mesh;
    struct texture_arrays *out;
    struct map same;           /* hash -> first mapping of the scene with these bytes */
    struct map looks;          /* texture and light -> texture of the scene */
    struct map texels;         /* texture -> its first block */
    unsigned light_bits;       /* levels of light are 2^light_bits a channel */
    const uint8_t *place_bits; /* of a mesh: lim_texture.place_bits of each of its textures; else NULL */
};

/* The plane of a polygon as the scene has it, and where. */
struct texture_plane {
    struct lim_plane_ref ref;
    double n[3], d; /* n . p = d; of an axis plane, n is LIM_MAPPING_UPRIGHT_N long, or of a long scene 2^30 */
    bool is_long;
    int32_t at[3]; /* of a long scene: the vertex by which it goes, units */
};

/* Levels of light as many as palettes have room for, 16 at most: each that a face needs takes a palette. */
void texture_encoder_init(struct texture_encoder *encoder, const struct mesh *mesh, struct texture_arrays *out);

/* The words that a record has on the polygon's texture; false: it has none. */
bool texture_encode(struct texture_encoder *encoder, const struct mesh_polygon *polygon,
                    const struct texture_plane *plane, uint16_t words[2]);

/* The light of a face, as palettes have it where there is room for all levels. */
uint32_t texture_light_of(uint32_t colour);

/* Of a mesh: the texture of a polygon, and one of a single texel for one that has none. */
uint16_t texture_encode_look(struct texture_encoder *encoder, const struct mesh_polygon *polygon);

/* Whether some of its texture's texels are clear: then it has a transparency, too. */
bool texture_is_masked(const struct mesh *mesh, const struct mesh_polygon *polygon);

/* Where the texture cannot be shown, as on what is transparent all over: its mean, lit. */
uint32_t texture_flat_colour(const struct mesh *mesh, const struct mesh_polygon *polygon);

/* When all records are encoded. */
void texture_encoder_finish(struct texture_encoder *encoder);

/* In a tree of more words than 16 bits count a mapping is of one texture, and names it: a mapping that is shown with
 * several gets copies. */
void texture_name_by_mappings(struct encoding *encoding);

/* Refuses what does not fit 16-bit indices. */
bool texture_arrays_check(const struct texture_arrays *arrays, struct error *err);
void texture_encoder_free(struct texture_encoder *encoder);

#endif
