/* SPDX-License-Identifier: MIT
 *
 * A compiled scene: a BSP tree in const data. `limner compile` writes it as C arrays for flash and as a .lim file,
 * which a host loads in place; SCENE.md specifies the bits of both.
 *
 * Coordinates are units: 16-bit integers, one scale for the whole scene (or 32-bit ones: long.h), y up, right-handed. A
 * plane is the set of points p with n . p = d; its front is where n . p > d. */
#ifndef LIM_SCENE_H
#define LIM_SCENE_H

#include "config.h"

/* The form of a scene's NAME.c and NAME.h, which say for which one they were written. It changes whenever files that
 * were written before would compile to something wrong. */
#define LIM_SCENE_FORMAT 12

/* An index into a scene's arrays, and a word of its polygons. Wide scenes have more than 16 bits can count. */
#if LIM_HAS_WIDE
typedef uint32_t lim_index;
typedef int32_t lim_offset;
#define LIM_NO_INDEX 0xFFFFFFFFu /* "no such index", in every index field below */
#else
typedef uint16_t lim_index;
typedef int16_t lim_offset;
#define LIM_NO_INDEX 0xFFFFu
#endif

#define LIM_NONE 0xFFFFu /* the same for pools and lists, which have 16 bits in any scene */

enum { LIM_SCENE_VERSION = LIM_SCENE_FORMAT }; /* what NAME.c asserted before 0.1.0 */

struct lim_vertex {
    int16_t x, y, z; /* units */
};

/* What rounding to units took from a vertex: in profile exact it is drawn at units + fraction. */
struct lim_fraction {
    int8_t x_q8, y_q8, z_q8;
};

/* A plane that is not an axis plane. Bounds that the compiler keeps: 0 < |n[0]| + |n[1]| + |n[2]| <= 32767 and
 * |d| <= LIM_PLANE_D_MAX, so that n . p - d fits 32 bits for every p of the 16-bit cube.
 * With an exact plane (LARGE), n and d are only a filter: the exact normal times s, rounded, with s such that
 * its longest component is 8191; d = the exact d times s, rounded. */
struct lim_plane {
    int32_t n_yx;         /* n[1] in the upper half, n[0] in the lower one: two are loaded at once */
    int32_t n_z_exact;    /* n[2], and below it an index into lim_scene.exact or LIM_NO_INDEX: n and d are the plane */
    int32_t slack_less_d; /* LIM_PLANE_SLACK - d; d = n . p of the points on the plane, in n's scale times units */
#if LIM_HAS_WIDE
    lim_index exact; /* all of that index, whose lower half is above, too */
#endif
};
#if LIM_HAS_WIDE
#define LIM_PLANE(nx, ny, nz, exact, d)                                                                                \
    {                                                                                                                  \
        LIM_PLANE_HALVES(ny, nx), LIM_PLANE_HALVES(nz, exact), LIM_PLANE_SLACK - (d), exact                            \
    }
#else
#define LIM_PLANE(nx, ny, nz, exact, d)                                                                                \
    {                                                                                                                  \
        LIM_PLANE_HALVES(ny, nx), LIM_PLANE_HALVES(nz, exact), LIM_PLANE_SLACK - (d)                                   \
    }
#endif
#define LIM_PLANE_HALVES(upper, lower) LIM_CAST(int32_t, (upper)*INT32_C(65536) + LIM_CAST(uint16_t, lower))
#define LIM_PLANE_SLACK (INT32_C(1) << 16)       /* where |n . p - d| is less, eye.c does not trust it */
#define LIM_PLANE_D_MAX (INT32_C(32767) * 32767) /* enough for any plane through a point of the grid */

/* |n[i]| < 2^31, |d| < 2^48; d = d_hi * 2^32 + d_lo. */
struct lim_plane_exact {
    int32_t n[3];
    int32_t d_hi;
    uint32_t d_lo;
};

/* What lim_plane_ref.plane says of an axis plane, x, y or z = offset. Any smaller number is a place in
 * lim_scene.planes, in words of 4 bytes. */
#define LIM_PLANE_X (LIM_NO_INDEX - 3u) /* x, y and z in the last two bits */
#define LIM_PLANE_Y (LIM_NO_INDEX - 2u)
#define LIM_PLANE_Z (LIM_NO_INDEX - 1u)
enum { LIM_PLANE_WORDS = sizeof(struct lim_plane) / 4 };

/* Where to find a plane. */
struct lim_plane_ref {
    lim_index plane;   /* above; LIM_NO_INDEX: there is none */
    lim_offset offset; /* of an axis plane, units; else 0 */
};

/* A run is a sequence of polygon records in lim_scene.polygons:
 * word 0: bits 0..7 number of vertices, bits 8..14 flags, bit 15 set in the run's last record;
 * word 1: colour, RGB565 as a number (red in bits 11..15);
 * then one vertex index a word, counter-clockwise seen from the side that the polygon faces;
 * then what the flags announce, in their order.
 * The records of a node's run share its plane and a facing. Those of a leaf have planes of their own, but in a mesh
 * leaf, whose order is by distance: there a record faces the side from which its corners run counter-clockwise. */
#define LIM_POLYGON_COUNT 0x00FFu
#define LIM_POLYGON_PLANE 0x0100u   /* its plane, a struct lim_plane_ref: two words */
#define LIM_POLYGON_BACK 0x0200u    /* it faces the back of that plane */
#define LIM_POLYGON_ALPHA 0x0400u   /* its alpha, a word: 1..254, of 255; textured: how much of it is not clear */
#define LIM_POLYGON_EDGES 0x0800u   /* an edge a bit, (n + 15) / 16 words: bit k set, and wireframe leaves edge k out */
#define LIM_POLYGON_TEXTURE 0x1000u /* indices of its texture and of its mapping: two words, the last ones */
#define LIM_POLYGON_MESH 0x2000u    /* the first of a mesh leaf: four words (LIM_MESH_LEAF_...), before the texture's */
#define LIM_POLYGON_LAST 0x8000u
enum { LIM_POLYGON_HEAD_WORDS = 2, LIM_POLYGON_TEXTURE_WORDS = 2, LIM_POLYGON_MESH_WORDS = 4 };

/* What the first record of a mesh leaf says of all of it. Its corners are among vertices first .. first + count - 1, 1
 * or more, which no record outside of the leaf has to leave alone; the box holds them. */
enum { LIM_MESH_LEAF_FIRST, LIM_MESH_LEAF_COUNT, LIM_MESH_LEAF_POLYGONS, LIM_MESH_LEAF_BOX };

/* A scene of no nodes is a mesh: for LIM_MESH and LIM_MESH_DEPTH alone, as those draw no others. Its records are
 * triangles of LIM_TRIANGLE_WORDS words: three vertex indices, counter-clockwise seen from the side that it faces, and
 * its colour, RGB565 as a number; or, where the scene has textures, the index of its texture: of one of a single texel
 * where it is of one colour. boxes[0] holds all of it, and there are no planes and no mappings.
 *
 * Where there are LIM_TRIANGLE_TEXTURES or fewer, the next 7 bits tell from how far away on texels advance evenly over
 * the triangle (mesh_texture.h): 4 e + m of them, from (7 - m) 2^(29 - e) units on. 0: nobody has found out. */
enum { LIM_TRIANGLE_WORDS = 4, LIM_TRIANGLE_TEXTURES = 512, LIM_TRIANGLE_TEXTURE_BITS = 9 };

/* A leaf has no plane and no children; its front_run comes in an order that is right from everywhere, nearest
 * first (sets without a tree, and mesh leaves: in any order), and is never LIM_NO_INDEX. */
struct lim_node {
    struct lim_plane_ref split;
    lim_index front, back; /* child nodes on either side of the plane, or LIM_NO_INDEX */
    lim_index front_run;   /* word offset of the polygons that face the front, or LIM_NO_INDEX */
    lim_index back_run;    /* the same for those that face the back */
    lim_index box;         /* bounds of the whole subtree, or LIM_NO_INDEX: too small to be worth it */
};

/* Holds every polygon of a subtree: |p[i] - centre[i]| <= half[i]. */
struct lim_box {
    int16_t centre[3]; /* units */
    uint16_t half[3];  /* units, 0..32768 */
};

/* Where a textured polygon shows which texel. The polygon lies in a plane, across that of two axes j and k, the two
 * after its normal's longest component; i = 0 is u, to the right, i = 1 v, down: uv[i] . (p_j, p_k) / 2^bits, plus a
 * constant, in widths of the picture. The components of either uv add up to 32767 at most, without their signs. */
struct lim_mapping {
    int16_t uv[2][2] LIM_WORD_ALIGNED;
    uint16_t at_zero_q16[2]; /* the place at p = 0, modulo the width */
    lim_index plane;         /* as lim_plane_ref.plane; of an axis plane its offset, as of lim_plane_ref */
    int8_t level_q3;         /* log2 of texels a unit, the mean of both directions, and half of log2(|n| / 2^14) */
    uint8_t scale;           /* bits, 0..31; LIM_MAPPING_UPRIGHT: an axis plane; the axis of the longest component */
#if LIM_HAS_WIDE
    uint16_t texture; /* lim_mappings_name_textures(): the one that is shown, of lim_scene.textures; else 0 */
#endif
};
enum { LIM_MAPPING_BITS = 31, LIM_MAPPING_UPRIGHT = 32, LIM_MAPPING_AXIS_SHIFT = 6 };
#if LIM_HAS_WIDE
#define LIM_MAPPING_TEXTURE(mapping) ((mapping)->texture)
#define LIM_MAPPING(u_j, u_k, v_j, v_k, u, v, plane, level_q3, scale, texture)                                         \
    {                                                                                                                  \
        {{u_j, u_k}, {v_j, v_k}}, {u, v}, plane, level_q3, scale, texture                                              \
    }
#else
#define LIM_MAPPING_TEXTURE(mapping) ((void)(mapping), 0u)
#define LIM_MAPPING(u_j, u_k, v_j, v_k, u, v, plane, level_q3, scale, texture)                                         \
    {                                                                                                                  \
        {{u_j, u_k}, {v_j, v_k}}, {u, v}, plane, level_q3, scale                                                       \
    }
#endif
#define LIM_MAPPING_UPRIGHT_N 16384 /* how long the normal of an axis plane is taken to be */

/* Where a vertex of a mesh with textures lies in the picture, u to the right, v down, each in 2^-place_bits of the
 * width of its triangles' texture, counted from any whole number of widths. */
struct lim_uv {
    int16_t u LIM_WORD_ALIGNED;
    int16_t v;
};

/* A picture of 2^w_bits x 2^h_bits texels, an index of the palette each, a row after the other from the top; then the
 * same in half the size, and so on. Sizes are 0..10 bits, and none is higher than wide. */
struct lim_texture {
    uint16_t texels LIM_WORD_ALIGNED; /* where it begins in lim_scene.texels, in blocks */
    uint16_t palette;                 /* where its colours begin in lim_scene.palettes */
    uint8_t w_bits, h_bits;
    uint8_t levels;     /* 1..h_bits + 1 */
    uint8_t place_bits; /* of a mesh: of struct lim_uv, 0..15; else 0, LIM_TEXTURE_MASKED or LIM_TEXTURE_SKY */
};
enum { LIM_TEXEL_BLOCK = 16 };

/* Texels 0 are clear. Records with an alpha have such textures, and no others. */
#define LIM_TEXTURE_MASKED 0x80u

/* It is seen on a cylinder around the eye, wherever its polygons are. Of a record's mapping are asked how often it goes
 * round, uv[0][0], 1..16, and at_zero_q16[1], how far from its top the horizon is, in 2^-15 of its width. Colours 0 and
 * 1 of its palette are what is seen above and below it. */
#define LIM_TEXTURE_SKY 0x40u

static inline bool lim_texture_is_masked(const LIM_FLASH struct lim_texture *texture)
{
    return LIM_HAS_MASKED && texture->place_bits & LIM_TEXTURE_MASKED;
}

static inline bool lim_texture_is_sky(const LIM_FLASH struct lim_texture *texture)
{
    return LIM_HAS_SKY && texture->place_bits & LIM_TEXTURE_SKY;
}

/* From which cell on a visible set holds. A cell is where the tree ends: twice the number of the node whose child is
 * missing, and 1 more behind its plane. Places come in their cells' order. Scenes of over 32767 nodes have none.
 *
 * A visible set is a bit a box, whether anything of its subtree may be seen, lowest first; a byte of zeros is followed
 * by how many of them there are, 1..255. */
struct lim_place {
    uint16_t cell;
    uint16_t pvs; /* where it begins in lim_scene.visible sets, or LIM_NONE: nothing is known, everything is walked */
};

/* What memory a frame needs; the compiler measures all but the first two on sampled cameras. A frame that needs more
 * falls back to bands; without room for pieces, polygons go by their farthest points (LIM_NEWELL). */
struct lim_limits {
    uint16_t depth;    /* nodes on the longest path from the root: least stack of the walk */
    uint16_t vertices; /* most vertices of any polygon */
    /* What the next three take together is one memory, which they share; LIM_CONVEX and meshes take the last alone. */
    uint16_t retained_cells; /* points and heads of the polygons retained between SPAN and PAINT */
    uint16_t gaps;           /* gaps beyond the first of each line, all lines together */
    uint16_t active;         /* polygons that cross one line, beyond those that find room elsewhere */
    uint16_t pieces;         /* LIM_NEWELL: how often polygons are split */
    uint16_t layers;         /* pieces of transparent polygons on one line; 0: there are no such polygons */
    uint16_t leaf_vertices;  /* most vertices of any mesh leaf; 0: there is none */
    uint16_t leaf_polygons;  /* of a mesh leaf that are sorted at once, measured likewise: 1 or more if there is one */
};

LIM_OPTIONAL_BEGIN
struct lim_long;
struct lim_long_vertex;
struct lim_scene {
    const LIM_FLASH struct lim_vertex *vertices;
    const LIM_FLASH struct lim_node *nodes; /* the root is nodes[0]; children come after parents */
    const LIM_FLASH struct lim_plane *planes;
    const LIM_FLASH struct lim_plane_exact *exact;
    const LIM_FLASH struct lim_box *boxes;
    const LIM_FLASH lim_index *polygons;
    const LIM_FLASH struct lim_fraction *fractions; /* vertex_count of them, or NULL */
    lim_index vertex_count, node_count, plane_count, exact_count, box_count;
    lim_index polygon_words; /* length of `polygons` */
    lim_index polygon_count; /* records in it */
    uint16_t background;     /* colour where no polygon is seen, RGB565 as a number */
    struct lim_limits limits;
#if LIM_HAS_TEXTURE
    const LIM_FLASH struct lim_mapping *mappings;
    const LIM_FLASH struct lim_texture *textures;
    const LIM_FLASH uint16_t *palettes; /* colours as they lie in memory: fill.h */
    const LIM_FLASH uint8_t *texels;    /* indices of colours */
    uint16_t mapping_count, texture_count, palette_colours, texel_blocks;
    LIM_OPTIONAL(const LIM_FLASH struct lim_uv *, uvs, LIM_HAS_MESHES); /* of a mesh: vertex_count of them */
#endif
#if LIM_HAS_PORTALS
    const LIM_FLASH struct lim_place *places;
    const LIM_FLASH uint8_t *pvs;
    uint16_t place_count, pvs_bytes;
#endif
    /* Of a mesh: for LIM_MESH_DEPTH triangles from this one on have depth at each pixel; where the eye is so near that
     * triangles may be clipped, those from near_deep_from on, which is no more. */
    LIM_OPTIONAL(lim_index, deep_from, LIM_HAS_MESH_DEPTH);
    LIM_OPTIONAL(lim_index, near_deep_from, LIM_HAS_MESH_DEPTH);
    LIM_OPTIONAL(const struct lim_long *, of_32_bits, LIM_HAS_LONG); /* NULL: it is none of many scales (long.h) */
};

LIM_OPTIONAL_END

static inline bool lim_scene_is_mesh(const struct lim_scene *scene)
{
    return LIM_HAS_MESHES && (!LIM_HAS_PLANES || (!scene->node_count && scene->polygon_count));
}

/* Of a mesh with textures: which bits of a triangle's last word are its texture's. */
static inline lim_index lim_triangle_texture_mask(uint16_t texture_count)
{
    return LIM_CAST(lim_index, texture_count > LIM_TRIANGLE_TEXTURES ? UINT16_MAX : LIM_TRIANGLE_TEXTURES - 1);
}

/* Where 16 bits do not tell at which word a record names its texture, its mapping does: no two textures share one. */
static inline bool lim_mappings_name_textures(const struct lim_scene *scene)
{
    return LIM_HAS_WIDE && LIM_CAST(uint32_t, scene->polygon_words) >> 16 != 0;
}

/* Textures of a scene; what its lim_screen_polygon.texture is less than; whether an object's are those of its scene. */
#if LIM_HAS_TEXTURE
static inline uint16_t lim_texture_count(const struct lim_scene *scene)
{
    return scene->texture_count;
}
static inline lim_index lim_texture_numbers(const struct lim_scene *scene)
{
    return lim_mappings_name_textures(scene) ? scene->mapping_count : scene->polygon_words;
}
static inline bool lim_scene_shares_textures(const struct lim_scene *scene, const struct lim_scene *object)
{
    return scene->texture_count && object->texture_count && object->textures == scene->textures;
}
#else
static inline uint16_t lim_texture_count(const struct lim_scene *scene)
{
    (void)scene;
    return 0;
}
static inline lim_index lim_texture_numbers(const struct lim_scene *scene)
{
    return scene->polygon_words;
}
static inline bool lim_scene_shares_textures(const struct lim_scene *scene, const struct lim_scene *object)
{
    (void)scene, (void)object;
    return false;
}
#endif

/* Whatever a plane's record packs. */
/*@ requires \valid_read(plane);
    assigns \nothing;
    ensures \result == (int16_t)plane->n_yx; */
static inline int16_t lim_plane_x(const LIM_FLASH struct lim_plane *plane)
{
    return LIM_CAST(int16_t, plane->n_yx);
}

/*@ requires \valid_read(plane);
    assigns \nothing;
    ensures \result == plane->n_yx >> 16; */
static inline int16_t lim_plane_y(const LIM_FLASH struct lim_plane *plane)
{
    return LIM_CAST(int16_t, plane->n_yx >> 16);
}

/*@ requires \valid_read(plane);
    assigns \nothing;
    ensures \result == plane->n_z_exact >> 16; */
static inline int16_t lim_plane_z(const LIM_FLASH struct lim_plane *plane)
{
    return LIM_CAST(int16_t, plane->n_z_exact >> 16);
}

static inline lim_index lim_plane_exact(const LIM_FLASH struct lim_plane *plane)
{
#if LIM_HAS_WIDE
    return plane->exact;
#else
    return LIM_CAST(uint16_t, plane->n_z_exact);
#endif
}

/*@ requires \valid_read(plane) && -1073676289 <= plane->slack_less_d - 65536 <= 1073676289;
    assigns \nothing;
    ensures \result == 65536 - plane->slack_less_d; */
static inline int32_t lim_plane_d(const LIM_FLASH struct lim_plane *plane)
{
    return LIM_PLANE_SLACK - plane->slack_less_d;
}

/* Words of a record that begins with `head`. */
static inline uint16_t lim_record_words(lim_index head)
{
    uint16_t words = LIM_CAST(uint16_t, LIM_POLYGON_HEAD_WORDS + (head & LIM_POLYGON_COUNT));

    if (LIM_HAS_LEAVES && head & LIM_POLYGON_PLANE) words += sizeof(struct lim_plane_ref) / sizeof(lim_index);
    if (LIM_HAS_TRANSPARENT && head & LIM_POLYGON_ALPHA) words++;
    if (LIM_HAS_WIREFRAME && head & LIM_POLYGON_EDGES)
        words = LIM_CAST(uint16_t, words + ((head & LIM_POLYGON_COUNT) + 15) / 16);
    if (LIM_HAS_MESH_LEAVES && head & LIM_POLYGON_MESH) words += LIM_POLYGON_MESH_WORDS;
    if (LIM_HAS_TEXTURE && head & LIM_POLYGON_TEXTURE) words += LIM_POLYGON_TEXTURE_WORDS;
    return words;
}

/* The plane of a record of a leaf. */
static inline const LIM_FLASH struct lim_plane_ref *lim_record_plane(const LIM_FLASH lim_index *record)
{
    return LIM_FLASH_AS(struct lim_plane_ref, record + LIM_POLYGON_HEAD_WORDS + (record[0] & LIM_POLYGON_COUNT));
}

/* Where the alpha of a record with LIM_POLYGON_ALPHA is, in words. */
static inline uint16_t lim_record_alpha_at(lim_index head)
{
    return lim_record_words(head & (LIM_POLYGON_COUNT | LIM_POLYGON_PLANE));
}

/* Where the flags of the edges of a record with LIM_POLYGON_EDGES are, in words. */
static inline uint16_t lim_record_edges_at(lim_index head)
{
    return lim_record_words(head & (LIM_POLYGON_COUNT | LIM_POLYGON_PLANE | LIM_POLYGON_ALPHA));
}

/* The mapping that a record with LIM_POLYGON_TEXTURE names in its last word. */
static inline uint16_t lim_record_mapping(const LIM_FLASH lim_index *record)
{
    return LIM_CAST(uint16_t, record[lim_record_words(record[0]) - 1]);
}

static inline bool lim_node_is_leaf(const LIM_FLASH struct lim_node *node)
{
    return LIM_HAS_LEAVES && node->split.plane == LIM_NO_INDEX;
}

/* Whether a run that begins with this record is a mesh leaf's. */
static inline bool lim_is_mesh_leaf(const LIM_FLASH lim_index *record)
{
    return LIM_HAS_MESH_LEAVES && record[0] & LIM_POLYGON_MESH;
}

/* What it says of the leaf: LIM_MESH_LEAF_... */
static inline const LIM_FLASH lim_index *lim_mesh_leaf_words(const LIM_FLASH lim_index *record)
{
    return record + lim_record_words(LIM_CAST(lim_index, record[0] & ~(LIM_POLYGON_MESH | LIM_POLYGON_TEXTURE)));
}

/* The plane that lim_plane_ref.plane names, if not an axis plane. */
static inline const LIM_FLASH struct lim_plane *lim_plane_at(const LIM_FLASH struct lim_plane *planes, lim_index words)
{
    return LIM_FLASH_AS(struct lim_plane, LIM_FLASH_AS(uint32_t, planes) + words);
}

/* What moves ------------------------------------------------------------------------------------------------------ */

/* Moving objects: meshes with compiled scenes of their own, placed anew in each frame.
 *
 *     struct lim_instance instances[2] = {{.object = &ball_scene}, {.object = &door_scene}};
 *     err = lim_movers_init(&lim, mover_mem, sizeof mover_mem, &(struct lim_movers_limits){2, 12, 0, 0});
 *     lim_instance_turn(&instances[1], yaw, 0, 0);
 *     err = lim_movers_frame(&lim, &camera, instances, 2);
 *
 * They are drawn by LIM_NEAREST_FIRST and LIM_SCANLINE; by other methods all are left out. The array is the caller's
 * and is read while a frame is drawn; nothing of it is kept. */

LIM_C_BEGIN
LIM_OPTIONAL_BEGIN

/* An object in its place. In a scene of many scales long.h has the bounds. */
struct lim_instance {
    const struct lim_scene *object; /* of 16 bits; NULL, or without polygons: it is left out, and counted */
    int32_t at_q8[3];               /* its origin, units of the scene that it moves in, |at_q8| < 2^24 */
    /* Its x, y and z axis in that scene's axes, one after the other: of length 1, at right angles. */
    int32_t axes_q30[9];
    uint8_t finer_bits; /* a unit of its own is 2^-finer_bits of that scene's, 0..3 */
    /* The corners of the object are its owner's, who changes them: *object is a copy whose `vertices` are in RAM (not
     * on AVR, whose flash is elsewhere). Tree, planes and boxes mean nothing then: each polygon's plane is that of its
     * first three corners, so triangles are best, and all are sorted anew. */
    bool deforms;
    LIM_OPTIONAL(uint8_t, coarser_bits, LIM_HAS_LONG); /* or its unit is 2^coarser_bits of that scene's */
    LIM_OPTIONAL(int32_t, origin, 3 * LIM_HAS_LONG);   /* where at_q8 counts from, units */
};

/* What the movers of a frame may take. All of an object has to lie within 2^16 units of the scene's origin, and the
 * eye within 2^20 of the object's own units of it. Instances that do not, and those beyond the declared number, are
 * left out, and counted in struct lim_mover_stats. */
struct lim_movers_limits {
    uint16_t instances;     /* the most, 0..LIM_INSTANCES_MAX */
    uint16_t depth;         /* the greatest limits.depth of any object */
    uint16_t leaf_vertices; /* the greatest of any object's limits; 0: no object has a mesh leaf */
    uint16_t leaf_polygons; /* likewise */
};
#define LIM_INSTANCES_MAX 1024

/* Sets the axes from angles, as a camera takes them: at 0, 0, 0 they are the scene's. */
void lim_instance_turn(struct lim_instance *instance, uint32_t yaw, uint32_t pitch, uint32_t roll);

/* Keyframed rigid motion: a table in flash, written by `limner compile` from a model's animations. Between two keys a
 * position moves along a straight line, an orientation turns about one axis, both evenly. */
struct lim_motion_key {
    uint32_t time_ms;    /* ascending */
    int32_t at_q8[3];    /* units of the static scene */
    int16_t turn_q15[4]; /* a quaternion x, y, z, w of length 1, within rounding */
    uint16_t arc;        /* half the angle to the next key's orientation; a full turn is 2^16, this below 2^14 */
};

struct lim_motion {
    const LIM_FLASH struct lim_motion_key *keys;
    uint16_t count; /* at least 1 */
    bool repeats;   /* after the last key comes the first; else the last one stays */
    LIM_OPTIONAL(const LIM_FLASH struct lim_long_vertex *, origins, LIM_HAS_LONG); /* one a key (long.h), or NULL */
};

/* An object of a compiled model, and how its animation moves it. */
struct lim_moved {
    const struct lim_scene *object;
    struct lim_motion motion;
    uint8_t finer_bits;                                /* lim_instance.finer_bits */
    LIM_OPTIONAL(uint8_t, coarser_bits, LIM_HAS_LONG); /* lim_instance.coarser_bits */
};
LIM_OPTIONAL_END

/* Sets an instance for each of `count` objects as they are at a time. */
void lim_moved_at(const struct lim_moved *moved, uint16_t count, uint32_t time_ms, struct lim_instance *instances);

/* Sets where the instance is, and its axes: within 2^-14 of a unit vector, no component beyond -1..1. Before its first
 * key a motion is there already. Keys that break the bounds above give other places and axes that are no rotation, and
 * still nothing overflows. */
/*@ requires \valid_read(motion) && motion->count >= 1 && \valid_read(motion->keys + (0 .. motion->count - 1));
    requires \valid(instance) && \separated(instance, motion);
    requires \separated(instance, motion->keys + (0 .. motion->count - 1));
    assigns instance->at_q8[0 .. 2], instance->axes_q30[0 .. 8], instance->origin[0 .. 2];
    ensures \forall integer i; 0 <= i < 9 ==> -1073741824 <= instance->axes_q30[i] <= 1073741824; */
void lim_motion_at(const struct lim_motion *motion, uint32_t time_ms, struct lim_instance *instance);

LIM_C_END

#endif
