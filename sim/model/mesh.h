/* SPDX-License-Identifier: MIT
 *
 * A mesh ready for the tree: welded vertices, convex planar polygons, each knowing its face in the
 * model file. model -> mesh_clean -> (mesh_merge) -> mesh_insert_t_vertices -> tree. */
#ifndef SIM_MESH_H
#define SIM_MESH_H

#include "base/error.h"
#include "base/map.h"
#include "model/model.h"

/* The scene's integer grid: unit = (metre - origin) * units_per_m, rounded to nearest. */
struct grid {
    double origin_m[3];
    double units_per_m;
    bool is_long;       /* coordinates have 32 bits: firmware/long.h */
    bool has_fractions; /* these do not do for the smallest faces: vertices have fractions in any profile */
};

struct mesh_polygon {
    uint32_t first, count; /* corners[first .. first + count) */
    uint32_t face;         /* 1-based number in the model file; the first one, if merged */
    uint32_t colour;       /* 0xRRGGBB */
    uint8_t transparency;  /* 0 is opaque, up to 254 */
    bool two_sided;
    uint32_t mapping; /* of mesh.mappings; 0: it has no texture */
};

/* Which part of a texture a polygon shows: gradient[i] . (p - centre) + uv[i] at p on the plane through the centre, in
 * pictures, i = 0 across and 1 down. */
struct mapping {
    uint32_t texture;              /* of mesh.textures */
    double centre_m[3], normal[3]; /* of length 1 */
    double gradient[2][3], uv[2];  /* gradients lie in the plane; pictures a metre */
};

/* One line of text on what could not be taken as it was. */
struct note {
    char text[512];
    bool is_detail; /* for the report alone */
    bool is_loss;   /* something of the file is not drawn as it says */
};

/* Why a face does not show its texture. */
enum unmapped { UNMAPPED_MISSING, UNMAPPED_INFINITE, UNMAPPED_FAR, UNMAPPED_FINE, UNMAPPED_KINDS };

/* What became of the input; the report prints it. */
struct mesh_counts {
    size_t faces;                    /* in the model file */
    size_t clamped;                  /* faces whose opacity was below 0 or above 1 */
    size_t invisible;                /* faces dropped: of opacity 0 */
    size_t zero_area;                /* faces dropped: all corners on one line */
    size_t too_small;                /* faces dropped: they have an area, but corners that the grid cannot tell apart */
    size_t non_planar;               /* faces triangulated because a corner leaves the plane */
    size_t concave;                  /* faces triangulated because they are not convex */
    size_t bent;                     /* faces triangulated because their texture is bent */
    size_t unmapped[UNMAPPED_KINDS]; /* polygons without their texture */
    size_t merged;                   /* polygons that vanished into a coplanar neighbour */
    size_t t_vertices;               /* vertices inserted into edges of other polygons */
};

struct original;

/* A piece of a face that was cut and merged: it is in another polygon than the face's first piece. */
struct mesh_piece {
    uint32_t face, into; /* face numbers, as of merged_into */
};

struct mesh {
    double (*points)[3]; /* metres, no two nearer than grid_weld_m(); some may be unused */
    size_t point_count;
    uint32_t *corners;
    size_t corner_count;
    struct mesh_polygon *polygons;
    size_t polygon_count;
    struct grid grid;
    bool is_interior; /* model.is_interior */
    struct mesh_counts counts;
    struct map inner;         /* edges that no face has: inner.h */
    struct texture *textures; /* of the model's pictures, one to one; no texels: it could not be read, or is not used */
    size_t texture_count;
    struct note *notes; /* on textures, for people */
    size_t note_count, note_capacity;
    struct mapping *mappings; /* the first one is none */
    size_t mapping_count, mapping_capacity;
    struct original *original; /* the model's faces, unrounded, owned; NULL: not known */
    uint32_t *merged_into;     /* counts.faces + 1 entries: merged_into[face] = face number of the polygon
                                  that holds it (its first piece, if it was cut), itself if unmerged, 0
                                  if dropped */
    struct mesh_piece *pieces; /* of faces that were cut, by face: where merged_into does not have them */
    size_t piece_count, piece_capacity;
};

/* Welds, drops faces of no area or opacity, triangulates what is not flat or not convex. Chooses the grid: the
 * largest scale at which every coordinate fits -32767..32767, the origin in the middle of the bounds.
 * Corners in the middle of a straight side are kept. Refuses a model of which nothing is left, or one
 * whose outlier squeezes the rest into a few units; the text does not name the file. What is too small for the grid is
 * dropped and counted: whether that does harm is asked once the scene is there (faithful.h). The caller owns *mesh. */
bool mesh_clean(const struct model *model, struct mesh *mesh, struct error *err);

/* The same on a grid that is given: a mover's is its scene's, or finer by a power of two. Corners must fit it. */
bool mesh_clean_on(const struct model *model, const struct grid *grid, struct mesh *mesh, struct error *err);

/* The model for the reference, on a grid 256 times as fine: what the scene's own grid welds, drops or takes for flat is
 * there as the file has it. `grid`: the scene's; NULL: the one that mesh_clean() chooses. Not for compiling. */
bool mesh_clean_fine(const struct model *model, const struct grid *grid, struct mesh *mesh, struct error *err);

/* As long as a side of any of the model's textures may get, so that all of them fit a scene: 2^bits. */
uint8_t mesh_texture_bits(const struct model *model);

/* Makes the model's pictures textures: those that a face shows. Together they get no larger than a scene can hold: if
 * need be, the largest are made smaller. What became of each goes to mesh->notes. */
bool mesh_textures_make(const struct model *model, struct mesh *mesh, struct error *err);

/* Makes them anew, as large as their pictures: together perhaps larger than a scene can hold. */
bool mesh_textures_enlarge(const struct model *model, struct mesh *mesh, struct error *err);

/* Joins coplanar neighbours of one colour, opacity and texture wherever the union is convex, and drops corners in the
 * middle of straight sides; mesh_insert_t_vertices() brings back those that others need. Polygons
 * stay in the order of their first faces. */
bool mesh_merge(struct mesh *mesh, struct error *err);

/* Adds to each polygon the corners of others that lie inside its edges, in order. Afterwards two
 * polygons that touch along an edge share both its ends, so no crack can open between them. */
bool mesh_insert_t_vertices(struct mesh *mesh, struct error *err);

void mesh_free(struct mesh *mesh);

#endif
