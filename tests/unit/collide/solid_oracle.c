/* SPDX-License-Identifier: MIT */
#include "unit/collide/solid_oracle.h"

#include "scene/plane.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>

/* That of the first three corners, of a record of a mesh leaf. */
static void plane_of_corners(const struct lim_scene *scene, const lim_index *corners, int64_t n[3], int64_t *d)
{
    int64_t at[3][3];

    for (int k = 0; k < 3; k++) {
        const struct lim_vertex *v = &scene->vertices[corners[k]];
        at[k][0] = v->x;
        at[k][1] = v->y;
        at[k][2] = v->z;
    }
    *d = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (at[1][j] - at[0][j]) * (at[2][k] - at[0][k]) - (at[1][k] - at[0][k]) * (at[2][j] - at[0][j]);
        if (llabs(n[i]) >= INT64_C(1) << 29) abort(); /* the renderer has 29 bits for one */
        *d += n[i] * at[0][i];
    }
}

static void add_run(struct solid_list *list, lim_index run, bool back, const struct lim_plane_ref *plane)
{
    const struct lim_scene *scene = list->scene;
    bool last = run == LIM_NO_INDEX;

    for (const lim_index *at = scene->polygons + run; !last; at += lim_record_words(at[0])) {
        struct solid_polygon *const to = &list->polygons[list->count++];
        const struct lim_plane_ref *own = at[0] & LIM_POLYGON_PLANE ? lim_record_plane(at) : plane;
        *to = (struct solid_polygon){.back = at[0] & LIM_POLYGON_PLANE ? (at[0] & LIM_POLYGON_BACK) != 0 : back,
                                     .record = (lim_index)(at - scene->polygons),
                                     .corners = at + LIM_POLYGON_HEAD_WORDS,
                                     .count = at[0] & LIM_POLYGON_COUNT,
                                     .low = {INT16_MAX, INT16_MAX, INT16_MAX},
                                     .high = {INT16_MIN, INT16_MIN, INT16_MIN}};
        if (own->plane == LIM_NO_INDEX)
            plane_of_corners(scene, to->corners, to->n, &to->d);
        else
            plane_exact(scene, own, to->n, &to->d);
        for (size_t k = 0; k < to->count; k++) {
            const struct lim_vertex *v = &scene->vertices[to->corners[k]];
            const int16_t xyz[3] = {v->x, v->y, v->z};
            for (int i = 0; i < 3; i++) {
                if (xyz[i] < to->low[i]) to->low[i] = xyz[i];
                if (xyz[i] > to->high[i]) to->high[i] = xyz[i];
            }
        }
        last = at[0] & LIM_POLYGON_LAST;
    }
}

void solid_list_init(struct solid_list *list, const struct lim_scene *scene)
{
    *list = (struct solid_list){scene, calloc(scene->polygon_count + 1u, sizeof *list->polygons), 0};
    if (!list->polygons) abort();
    for (lim_index k = 0; k < scene->node_count; k++) {
        const struct lim_node *node = &scene->nodes[k];
        add_run(list, node->front_run, false, &node->split);
        add_run(list, node->back_run, true, &node->split);
    }
}

void solid_list_free(struct solid_list *list)
{
    free(list->polygons);
}

__int128 solid_value(const struct solid_polygon *polygon, const int32_t at_q8[3])
{
    __int128 sum = -(__int128)polygon->d * 256;

    for (int i = 0; i < 3; i++)
        sum += (__int128)polygon->n[i] * at_q8[i];
    return sum;
}

/* The first of the longest components. */
static int main_axis(const struct solid_polygon *polygon)
{
    int axis = 0;

    for (int i = 1; i < 3; i++)
        if (llabs(polygon->n[i]) > llabs(polygon->n[axis])) axis = i;
    return axis;
}

static int16_t coordinate_of(const struct solid_list *list, lim_index corner, int axis)
{
    const struct lim_vertex *v = &list->scene->vertices[corner];

    return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

/* 128 bits into GMP. */
static void set_wide(mpz_t out, __int128 value)
{
    const bool negative = value < 0;
    const unsigned __int128 size = negative ? -(unsigned __int128)value : (unsigned __int128)value;

    mpz_set_ui(out, (unsigned long)(size >> 64));
    mpz_mul_2exp(out, out, 64);
    mpz_add_ui(out, out, (unsigned long)size);
    if (negative) mpz_neg(out, out);
}

struct crossing_point {
    mpq_t h[2], low, high, p[2], q[2], u, u_low, u_high, span;
};

static void crossing_init(struct crossing_point *c)
{
    mpq_inits(c->h[0], c->h[1], c->low, c->high, c->p[0], c->p[1], c->q[0], c->q[1], c->u, c->u_low, c->u_high, c->span,
              NULL);
}

static void crossing_clear(struct crossing_point *c)
{
    mpq_clears(c->h[0], c->h[1], c->low, c->high, c->p[0], c->p[1], c->q[0], c->q[1], c->u, c->u_low, c->u_high,
               c->span, NULL);
}

/* h along an axis, units. */
static void set_crossing(mpq_t h, int32_t from_q8, int32_t to_q8, __int128 num, __int128 den)
{
    mpq_t part;

    mpq_init(part);
    set_wide(mpq_numref(h), num);
    set_wide(mpq_denref(h), den);
    mpq_canonicalize(h);
    mpq_set_si(part, (long)to_q8 - from_q8, 256);
    mpq_canonicalize(part);
    mpq_mul(h, h, part);
    mpq_set_si(part, from_q8, 256);
    mpq_canonicalize(part);
    mpq_add(h, h, part);
    mpq_clear(part);
}

/* Whether the edge enters the closed square around h, of half a unit: what of it is within, axis by axis. */
static bool edge_enters_square(struct crossing_point *c)
{
    mpq_set_ui(c->u_low, 0, 1);
    mpq_set_ui(c->u_high, 1, 1);
    for (int i = 0; i < 2; i++) {
        mpq_set_ui(c->u, 1, 2);
        mpq_sub(c->low, c->h[i], c->u);
        mpq_add(c->high, c->h[i], c->u);
        mpq_sub(c->span, c->q[i], c->p[i]);
        const int way = mpq_sgn(c->span);
        if (!way && (mpq_cmp(c->p[i], c->low) < 0 || mpq_cmp(c->p[i], c->high) > 0)) return false;
        if (!way) continue;
        mpq_sub(c->u, way > 0 ? c->low : c->high, c->p[i]);
        mpq_div(c->u, c->u, c->span);
        if (mpq_cmp(c->u, c->u_low) > 0) mpq_set(c->u_low, c->u);
        mpq_sub(c->u, way > 0 ? c->high : c->low, c->p[i]);
        mpq_div(c->u, c->u, c->span);
        if (mpq_cmp(c->u, c->u_high) < 0) mpq_set(c->u_high, c->u);
    }
    return mpq_cmp(c->u_low, c->u_high) <= 0;
}

/* Whether the edge crosses the line from h along the first axis upwards. */
static bool edge_is_beyond(struct crossing_point *c)
{
    const bool p_above = mpq_cmp(c->p[1], c->h[1]) > 0, q_above = mpq_cmp(c->q[1], c->h[1]) > 0;

    if (p_above == q_above) return false;
    mpq_sub(c->u, c->h[1], c->p[1]);
    mpq_sub(c->span, c->q[1], c->p[1]);
    mpq_div(c->u, c->u, c->span);
    mpq_sub(c->span, c->q[0], c->p[0]);
    mpq_mul(c->u, c->u, c->span);
    mpq_add(c->u, c->u, c->p[0]);
    return mpq_cmp(c->u, c->h[0]) > 0;
}

static bool holds(const struct solid_list *list, const struct solid_polygon *polygon, struct crossing_point *c,
                  const int axes[2])
{
    bool inside = false;

    for (size_t k = 0; k < polygon->count; k++) {
        for (int i = 0; i < 2; i++) {
            mpq_set_si(c->p[i], coordinate_of(list, polygon->corners[k], axes[i]), 1);
            mpq_set_si(c->q[i], coordinate_of(list, polygon->corners[(k + 1) % polygon->count], axes[i]), 1);
        }
        if (edge_enters_square(c)) return true;
        if (edge_is_beyond(c)) inside = !inside;
    }
    return inside;
}

/* num / den of the way to the polygon, if the segment meets it. */
static bool meets(const struct solid_list *list, const struct solid_polygon *polygon, const int32_t from_q8[3],
                  const int32_t to_q8[3], bool backs, __int128 *num, __int128 *den)
{
    const int sign = polygon->back ? -1 : 1;
    __int128 from = sign * solid_value(polygon, from_q8), to = sign * solid_value(polygon, to_q8);
    const int axis = main_axis(polygon), axes[2] = {(axis + 1) % 3, (axis + 2) % 3};
    struct crossing_point c;

    if (from < 0 && backs) {
        from = -from;
        to = -to;
    }
    if (from < 0 || to > 0 || from == to) return false;
    *num = from;
    *den = from - to;
    const double part = (double)*num / (double)*den;
    for (int i = 0; i < 2; i++) { /* what is far beside it needs no exactness */
        const double at = (from_q8[axes[i]] + part * ((double)to_q8[axes[i]] - from_q8[axes[i]])) / 256.0;
        if (at < polygon->low[axes[i]] - 1.0 || at > polygon->high[axes[i]] + 1.0) return false;
    }
    crossing_init(&c);
    for (int i = 0; i < 2; i++)
        set_crossing(c.h[i], from_q8[axes[i]], to_q8[axes[i]], *num, *den);
    const bool held = holds(list, polygon, &c, axes);
    crossing_clear(&c);
    return held;
}

static int compare_parts(__int128 num, __int128 den, __int128 other_num, __int128 other_den)
{
    mpz_t a, b, c;

    mpz_inits(a, b, c, NULL);
    set_wide(a, num);
    set_wide(c, other_den);
    mpz_mul(a, a, c);
    set_wide(b, other_num);
    set_wide(c, den);
    mpz_mul(b, b, c);
    const int order = mpz_cmp(a, b);
    mpz_clears(a, b, c, NULL);
    return order;
}

struct solid_ray solid_trace(const struct solid_list *list, const int32_t from_q8[3], const int32_t to_q8[3],
                             bool backs)
{
    struct solid_ray first = {.hit = false};

    for (size_t k = 0; k < list->count; k++) {
        __int128 num, den;
        if (!meets(list, &list->polygons[k], from_q8, to_q8, backs, &num, &den)) continue;
        first.crossed++;
        if (first.hit && compare_parts(num, den, first.num, first.den) >= 0) continue;
        first.hit = true;
        first.num = num;
        first.den = den;
    }
    return first;
}

bool solid_meets_at(const struct solid_list *list, lim_index record, const int32_t from_q8[3], const int32_t to_q8[3],
                    bool backs, const struct solid_ray *ray)
{
    for (size_t k = 0; k < list->count; k++) {
        __int128 num, den;
        if (list->polygons[k].record != record) continue;
        return meets(list, &list->polygons[k], from_q8, to_q8, backs, &num, &den) &&
               compare_parts(num, den, ray->num, ray->den) == 0;
    }
    return false;
}

/* What is left of a triangle in a box: at most 9 corners, in 2^-8 units. */
struct clipped {
    mpq_t at[12][3];
    size_t count;
};

/* Keeps what lies on one side of a face of the box: sign (at - face) >= 0. */
static void clip_to(const struct clipped *from, struct clipped *to, int axis, int sign, long face_q8)
{
    mpq_t a, b, part;

    mpq_inits(a, b, part, NULL);
    to->count = 0;
    for (size_t k = 0; k < from->count; k++) {
        const mpq_t *p = from->at[k], *q = from->at[(k + 1) % from->count];
        mpq_set_si(part, face_q8, 1);
        mpq_sub(a, p[axis], part);
        mpq_sub(b, q[axis], part);
        const int of_p = sign * mpq_sgn(a), of_q = sign * mpq_sgn(b);
        if (of_p >= 0) {
            for (int i = 0; i < 3; i++)
                mpq_set(to->at[to->count][i], p[i]);
            to->count++;
        }
        if (of_p * of_q >= 0) continue;
        mpq_sub(b, a, b);
        mpq_div(part, a, b);
        for (int i = 0; i < 3; i++) {
            mpq_sub(a, q[i], p[i]);
            mpq_mul(a, a, part);
            mpq_add(to->at[to->count][i], p[i], a);
        }
        to->count++;
    }
    mpq_clears(a, b, part, NULL);
}

/* Whether the middle of all corners, which is an inner point of what they span, is in the box's inside. */
static bool middle_is_inside(const struct clipped *part, const int32_t at_q8[3], const int32_t half_q8[3])
{
    bool inside = part->count > 0;
    mpq_t sum, bound;

    mpq_inits(sum, bound, NULL);
    for (int i = 0; i < 3 && inside; i++) {
        mpq_set_ui(sum, 0, 1);
        for (size_t k = 0; k < part->count; k++)
            mpq_add(sum, sum, part->at[k][i]);
        mpq_set_si(bound, ((long)at_q8[i] - half_q8[i]) * (long)part->count, 1);
        inside = mpq_cmp(sum, bound) > 0;
        mpq_set_si(bound, ((long)at_q8[i] + half_q8[i]) * (long)part->count, 1);
        inside = inside && mpq_cmp(sum, bound) < 0;
    }
    mpq_clears(sum, bound, NULL);
    return inside;
}

static bool triangle_overlaps(const struct solid_list *list, const lim_index corners[3], const int32_t at_q8[3],
                              const int32_t half_q8[3])
{
    struct clipped parts[2];

    for (int p = 0; p < 2; p++)
        for (int k = 0; k < 12; k++)
            for (int i = 0; i < 3; i++)
                mpq_init(parts[p].at[k][i]);
    parts[0].count = 3;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            mpq_set_si(parts[0].at[k][i], coordinate_of(list, corners[k], i) * 256L, 1);
    for (int i = 0; i < 3; i++) {
        clip_to(&parts[0], &parts[1], i, 1, (long)at_q8[i] - half_q8[i]);
        clip_to(&parts[1], &parts[0], i, -1, (long)at_q8[i] + half_q8[i]);
    }
    const bool overlaps = middle_is_inside(&parts[0], at_q8, half_q8);
    for (int p = 0; p < 2; p++)
        for (int k = 0; k < 12; k++)
            for (int i = 0; i < 3; i++)
                mpq_clear(parts[p].at[k][i]);
    return overlaps;
}

bool solid_overlaps(const struct solid_list *list, const struct solid_polygon *polygon, const int32_t at_q8[3],
                    const int32_t half_q8[3])
{
    for (int i = 0; i < 3; i++)
        if (polygon->low[i] * 256 >= at_q8[i] + half_q8[i] || polygon->high[i] * 256 <= at_q8[i] - half_q8[i])
            return false;
    for (size_t k = 2; k < polygon->count; k++) {
        const lim_index corners[3] = {polygon->corners[0], polygon->corners[k - 1], polygon->corners[k]};
        if (triangle_overlaps(list, corners, at_q8, half_q8)) return true;
    }
    return false;
}
