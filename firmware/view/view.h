/* SPDX-License-Identifier: MIT
 *
 * VIEW: camera and vertices -> points on the screen, rounded once. In: scene vertices (16-bit
 * units). Out: view-space points for CLIP, screen points (struct lim_point) for EDGE. Memory: a
 * small cache of projected vertices, lent by the caller.
 *
 * View space: x to the right, y down, z ahead, each row scaled by the lens so that the visible
 * part is |x| <= z, |y| <= z. Its scale, called _qv, is the frame's own: see rows.c. Of a long lens z has more bits:
 * the visible part is |x| <= z >> zoom_bits[0], |y| <= z >> zoom_bits[1]. */
#ifndef LIM_VIEW_H
#define LIM_VIEW_H

#include "camera.h"
#include "stages.h"

/* |coordinate| < 2^31. In a long scene coordinates are 2^exponent times as large, there and nowhere else. */
struct lim_view_point {
    __extension__ union { /* C++ wants names for both */
        struct {
            int32_t x_qv, y_qv, z_qv;
        };
        int32_t qv[3]; /* the same */
    };
    LIM_OPTIONAL(bool, hidden, LIM_HAS_WIREFRAME); /* the edge from here to the next point is not drawn */
    LIM_OPTIONAL(int8_t, exponent, LIM_HAS_LONG);
    /* Where the exponent is LIM_VIEW_FAR: 32 further bits of each; and which corner of its polygon it is, from 1 on. */
    LIM_OPTIONAL(uint8_t, corner, LIM_HAS_LONG);
    LIM_OPTIONAL(uint32_t, low, 3 * LIM_HAS_LONG);
};

/* Exponents of a long scene: a point of whole words, as it is clipped where others are too coarse, and the least of a
 * point that is seen without its fraction, two units or so off. */
enum {
    LIM_VIEW_FAR_LAST = -8,
    LIM_VIEW_FAR = 32 + LIM_VIEW_FAR_LAST,
    LIM_VIEW_DOT = LIM_HAS_LIMBS ? 17 : 16, /* of what transform_way() makes of a row */
    LIM_VIEW_WHOLE_UNITS = LIM_VIEW_DOT - 8
};

/* The near plane, as far as a point's exponent has it; 1 to 2^31 - 1. */
static inline int32_t lim_view_near(const struct lim_view_point *point, int32_t near_qv)
{
    if (!LIM_HAS_LONG || !*point->exponent) return near_qv;
    const int_fast8_t down = *point->exponent;
    if (down > 0) return (near_qv >> (down < 31 ? down : 31)) | 1;
    return near_qv >> (31 + (down > -31 ? down : -31)) ? INT32_MAX : near_qv * (INT32_C(1) << -down);
}

/* What z comes to beside x (axis 0) or y (1). */
static inline int32_t lim_zoomed(const struct lim_rows *rows, int32_t z_qv, uint_fast8_t axis)
{
    return LIM_HAS_TELE ? z_qv >> rows->zoom_bits[axis] : z_qv;
}

/* Whether wireframe leaves out the edge from a point to the next one. */
static inline void lim_view_hide_edge(struct lim_view_point *point, bool hidden)
{
    if (LIM_HAS_WIREFRAME) *point->hidden = hidden;
}

/* Where a vertex lies outside: bits 0..4 against what is visible, GUARD against the guard band
 * |x|, |y| <= 2z (zoomed) or the near plane: such a polygon must be clipped. */
enum lim_view_code {
    LIM_VIEW_NEAR = 1,
    LIM_VIEW_LEFT = 2,
    LIM_VIEW_RIGHT = 4,
    LIM_VIEW_TOP = 8,
    LIM_VIEW_BOTTOM = 16,
    LIM_VIEW_OUTSIDE = 31,
    LIM_VIEW_GUARD = 32
};

/* Codes, and in the upper byte those that are not among them. */
static inline uint16_t lim_view_both(uint16_t codes)
{
    return (uint16_t)(codes | (codes ^ 0xFFu) << 8);
}

/* Of a vertex that is remembered. */
static inline uint16_t lim_view_codes(const struct lim_view_cached *entry)
{
    return LIM_8_BIT ? lim_view_both(entry->codes) : entry->codes;
}

/* Of the codes of several vertices, OR'ed: whether there is a side that all are outside of. */
static inline bool lim_view_all_outside(uint_fast16_t codes)
{
    return ~codes & LIM_VIEW_OUTSIDE << 8;
}

/* Whether polygons are drawn by their samples. */
static inline bool lim_is_antialiased(const struct lim_view *view)
{
    return LIM_HAS_ANTIALIAS && *view->antialiased;
}

static inline void lim_view_set_antialiased(struct lim_view *view, bool antialiased)
{
    if (LIM_HAS_ANTIALIAS) *view->antialiased = antialiased;
}

/* Once per target: screen geometry. `cache` has LIM_VIEW_CACHE_ENTRIES entries. */
void lim_view_init(struct lim_view *view, uint16_t w_px, uint16_t h_px, struct lim_view_cached *cache);

/* What is remembered: its memory has served for something else. */
void lim_view_forget(struct lim_view *view);

/* Once per frame, when its rows are set; false: they are not. */
static inline bool lim_view_begin_rows(struct lim_view *view, bool has_rows)
{
    if (!has_rows) return false;
    if (LIM_HAS_PLANES && (!LIM_HAS_MESHES || view->cache)) lim_view_forget(view); /* a mesh remembers all vertices */
    if (LIM_HAS_STATS) view->vertices = 0;
    return true;
}

/* The same, and its rows. false: the camera is out of range (limner.h). */
bool lim_view_begin(struct lim_view *view, const struct lim_scene *scene, const struct lim_camera *camera);

/* `vertex` is one of the scene's. */
void lim_view_transform(const struct lim_view *view, const struct lim_scene *scene,
                        const LIM_FLASH struct lim_vertex *vertex, struct lim_view_point *out);

/* Takes from z what it has more of a long lens: then |x|, |y| <= z is visible. */
static inline void lim_view_even(const struct lim_rows *rows, struct lim_view_point *point)
{
    const uint8_t x_bits = rows->zoom_bits[0], y_bits = rows->zoom_bits[1], bits = x_bits > y_bits ? x_bits : y_bits;

    point->x_qv >>= bits - x_bits;
    point->y_qv >>= bits - y_bits;
    point->z_qv >>= bits;
}

/* Needs near <= z and |x|, |y| <= 2z, zoomed. */
void lim_view_project(const struct lim_view *view, const struct lim_view_point *point, struct lim_point *out);

/* These of a vertex of a long scene; and the last three of one of an object that moves in it, too. */
void lim_view_transform_long(const struct lim_view *view, lim_index vertex, struct lim_view_point *out);
void lim_view_transform_moved(const struct lim_view *view, const struct lim_scene *object, lim_index vertex,
                              struct lim_view_point *out);
void lim_view_project_long(const struct lim_view *view, const struct lim_view_point *point, struct lim_point *out);
void lim_view_remember_long(struct lim_view *view, const struct lim_scene *scene, lim_index vertex,
                            struct lim_view_cached *entry);

/* Takes a vertex in, in the place of what the entry held. */
void lim_view_remember(struct lim_view *view, const struct lim_scene *scene, lim_index vertex,
                       struct lim_view_cached *entry);

/* Vertices that are projected at once: those of a mesh, or of a mesh leaf. */
#define LIM_VIEWS_ALL (LIM_HAS_MESHES || LIM_HAS_MESH_LEAVES)
struct lim_view_part {
    lim_index first, count;
    lim_index box; /* of the scene's boxes: it holds them */
};

/* How they lie on the screen. */
enum lim_view_extent {
    LIM_VIEW_INSIDE, /* all of it on the screen */
    LIM_VIEW_WHOLE,  /* none of it needs to be clipped */
    LIM_VIEW_CLIPPED /* some of it may have to be */
};

/* All vertices of a part: where each is on the screen, and its nearness, 1 / z as perspective_nearness() has it; 0 for
 * one before the near plane or beyond the guard band, whose point's x is instead its code, without LIM_VIEW_GUARD. */
enum lim_view_extent lim_view_all(struct lim_view *view, const struct lim_scene *scene,
                                  const struct lim_view_part *part, struct lim_point *points, uint16_t *nearness,
                                  uint8_t *near_shift);

/* Of the screen, what holds a box's pixels: a pixel more on each side than its corners. false: it meets the near plane,
 * or reaches far beyond the screen. */
bool lim_view_box_rect(const struct lim_view *view, const LIM_FLASH struct lim_box *box, struct lim_rect *rect);

/* A coordinate's pixel, up to the next border; a pixel more on each side covers whatever rounding does. */
static inline uint16_t lim_view_pixel_within(int32_t at, int32_t more, int32_t side_px)
{
    const int32_t px = (at >> LIM_SUB_BITS) + LIM_ORIGIN_PX + more;

    return (uint16_t)(px < 0 ? 0 : px > side_px ? side_px : px);
}

/* Nearness anew, finer by the bits that what is seen does not use: `seen` is that of all that is, OR'ed. The eye may be
 * as near as the near plane to some vertex, and what is seen seldom is. What is nearer, or has none, keeps what it has.
 */
void lim_view_refine(struct lim_view *view, const struct lim_scene *scene, const struct lim_view_part *part,
                     uint16_t seen, uint16_t *nearness, uint8_t *near_shift);

/* The nearness of another point of it, which near <= z holds for; `near_shift` as those have set it. */
uint16_t lim_view_nearness(const struct lim_view_point *point, uint8_t near_shift);

/* A vertex on the screen, and where it lies outside: valid until another one is asked for. */
static inline const struct lim_view_cached *lim_view_vertex(struct lim_view *view, const struct lim_scene *scene,
                                                            lim_index vertex)
{
    struct lim_view_cached *entry = &view->cache[vertex % LIM_VIEW_CACHE_ENTRIES];

    if (LIM_UNLIKELY(entry->vertex != vertex)) lim_view_remember(view, scene, vertex, entry);
    return entry;
}

#endif
