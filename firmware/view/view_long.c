/* SPDX-License-Identifier: MIT
 *
 * Vertices of a long scene: the way from the eye, whose numbers have one exponent, through the three rows. x / z does
 * not mind the exponent, and what is compared with anything but another coordinate is the near plane alone.
 *
 * A way d of 31 bits keeps an edge between two far corners where it is, even where it passes close to the eye. A row of
 * 16 bits takes it as floor(n d / 2^16), component by component; n d = 2^16 n high + n low with 0 <= low < 2^16, so 32
 * bits do for each. A row is 32767 long at most, so the sum is below 2^30 sqrt(3). Rows with limbs, 2^30 long at most,
 * are multiplied in 64 bits: |n . d| < 2^61 sqrt(3). */
#include "view/view.h"

#include "math/relative.h"
#include "view/perspective.h"
#include "view/place.h"
#include "view/transform.h"

#if LIM_HAS_LONG

/* More than what a coordinate is off by: 3 for three products, and a unit and a half where fractions do not count. Of
 * what is so far to the side, or so far before the near plane, the clipping decides. */
enum { CODE_SLACK = 256 };

/* Of an object that moves in it, whose vertices have 16 bits. */
static LIM_IF_CALLED void way_to_object(struct lim_relative *way, const struct lim_rows *rows,
                                        const struct lim_scene *object, lim_index vertex)
{
    const struct lim_vertex at = object->vertices[vertex];
    const struct lim_long_vertex far_at = {{at.x, at.y, at.z}};
    const bool has_fraction = LIM_HAS_FRACTIONS && object->fractions;

    lim_relative_set(way, rows->eye, (const LIM_FLASH struct lim_long_vertex *)&far_at,
                     has_fraction ? &object->fractions[vertex] : NULL);
    way->exponent = (int8_t)(way->exponent + rows->eye->unit);
}

static inline void way_to_vertex(struct lim_relative *way, const struct lim_rows *rows, lim_index vertex)
{
    const struct lim_long *all = rows->eye->all;

    lim_relative_set(way, rows->eye, &all->vertices[vertex], all->fractions ? &all->fractions[vertex] : NULL);
}

static inline void long_transform(const struct lim_rows *rows, const struct lim_scene *scene, lim_index vertex,
                                  struct lim_view_point *out)
{
    struct lim_relative way;

    if (LIM_HAS_MOVERS && !rows->eye->all->vertices)
        way_to_object(&way, rows, scene, vertex);
    else
        way_to_vertex(&way, rows, vertex);
    LIM_UNROLLED(3)
    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = transform_way(&rows->row[i], way.d);
    out->z_qv += rows->row[2].shift_qv;
    transform_settle(rows, out->qv);
    *out->exponent = (int8_t)(way.exponent + LIM_VIEW_DOT);
}

void lim_view_transform_long(const struct lim_view *view, lim_index vertex, struct lim_view_point *out)
{
    long_transform(&view->rows, NULL, vertex, out);
}

void lim_view_transform_moved(const struct lim_view *view, const struct lim_scene *object, lim_index vertex,
                              struct lim_view_point *out)
{
    long_transform(&view->rows, object, vertex, out);
}

static inline void long_project(const struct lim_view *view, const struct lim_view_point *point, struct lim_point *out)
{
    const struct lim_depth depth = perspective_depth(point->z_qv);

    out->x = project_x(view, point->x_qv, depth);
    out->y = project_y(view, point->y_qv, depth);
}

/* A cut may have few bits left, or a bit more than limbs leave room for: where z was made the near plane's. */
void lim_view_project_long(const struct lim_view *view, const struct lim_view_point *point, struct lim_point *out)
{
    struct lim_view_point scaled = *point;
    const uint32_t size = abs_s32(point->x_qv) | abs_s32(point->y_qv) | (uint32_t)point->z_qv;
    const uint8_t zeros = clz_u32(size | 1), up = (uint8_t)(zeros > 2 ? zeros - 2 : 0);

    for (uint_fast8_t i = 0; i < 3; i++)
        scaled.qv[i] = (int32_t)((uint32_t)point->qv[i] << up) >> (LIM_HAS_LIMBS && zeros < 2);
    long_project(view, &scaled, out);
}

/* As codes_outside() of view.c has them, but for those of which it is not sure. */
static LIM_RARE uint8_t long_codes(const struct lim_rows *rows, const struct lim_view_point *point)
{
    const int32_t x_qv = (int32_t)abs_s32(point->x_qv), y_qv = (int32_t)abs_s32(point->y_qv);
    const int32_t width_qv = lim_zoomed(rows, point->z_qv, 0), height_qv = lim_zoomed(rows, point->z_qv, 1);
    const int32_t near_qv = lim_view_near(point, rows->near_qv);
    uint8_t codes = 0;

    if (point->z_qv < near_qv) codes = LIM_VIEW_GUARD;
    if (point->z_qv < near_qv - CODE_SLACK) codes |= LIM_VIEW_NEAR;
    if (x_qv - margin_of(width_qv) - CODE_SLACK > width_qv)
        codes = (uint8_t)(codes | (point->x_qv < 0 ? LIM_VIEW_LEFT : LIM_VIEW_RIGHT));
    if (y_qv - margin_of(height_qv) - CODE_SLACK > height_qv)
        codes = (uint8_t)(codes | (point->y_qv < 0 ? LIM_VIEW_TOP : LIM_VIEW_BOTTOM));
    if (x_qv >> 1 > width_qv - CODE_SLACK || y_qv >> 1 > height_qv - CODE_SLACK) codes |= LIM_VIEW_GUARD;
    return codes;
}

static inline bool is_long_seen(const struct lim_rows *rows, const struct lim_view_point *point)
{
    return (int32_t)abs_s32(point->x_qv) <= lim_zoomed(rows, point->z_qv, 0) &&
           (int32_t)abs_s32(point->y_qv) <= lim_zoomed(rows, point->z_qv, 1) &&
           point->z_qv >= lim_view_near(point, rows->near_qv);
}

void lim_view_remember_long(struct lim_view *view, const struct lim_scene *scene, lim_index vertex,
                            struct lim_view_cached *entry)
{
    struct lim_view_point point;

    long_transform(&view->rows, scene, vertex, &point);
    const uint8_t codes = is_long_seen(&view->rows, &point) ? 0 : long_codes(&view->rows, &point);
    entry->vertex = vertex;
    entry->codes = (lim_view_code_bits)(LIM_8_BIT ? codes : lim_view_both(codes));
    if (!(codes & LIM_VIEW_GUARD)) long_project(view, &point, &entry->at);
    if (LIM_HAS_STATS) view->vertices++;
}

#endif
