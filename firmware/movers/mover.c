/* SPDX-License-Identifier: MIT
 *
 * POSE: each instance's view and eye in its object's own coordinates, in which its vertices are exact and its tree is
 * walked by the same exact tests. What is rounded is where the eye is, to 1/256 of the object's unit.
 *
 * Ranges. A centre and all around it lie within 2^16 units, 2^28 in Q12; an eye within 2^20 units, of the static scene
 * and of the object's own. */
#include "movers/mover.h"

#include "eye.h"
#include "math/orientation.h"
#include "movers/deform.h"
#include "movers/mover_long.h"
#include "pixels/texture.h"
#include "view/pass.h"
#include "view/rows.h"
#include "view/view.h"

#if LIM_HAS_MOVERS

#define WORLD_END_Q12 (INT32_C(1) << 28)
#define AT_END_Q8 (INT32_C(1) << 24)
enum { FINER_BITS_MAX = 3 };

/* A point of the object, `bits` fraction bits to its own unit. |v| < 2^16 units, so sums stay below 2^28 once they are
 * in Q12. */
static inline void place_fine(const struct lim_instance *instance, const int32_t v[3], uint8_t bits, int32_t at_q12[3])
{
    const int64_t half = INT64_C(1) << (30 - 12 + bits + instance->finer_bits - 1);

    for (uint_fast8_t i = 0; i < 3; i++) {
        int64_t sum = half;
        for (uint_fast8_t j = 0; j < 3; j++)
            sum += (int64_t)instance->axes_q30[3 * j + i] * v[j];
        at_q12[i] = instance->at_q8[i] * 16 + ((int32_t)(sum >> (30 - 12 + bits)) >> instance->finer_bits);
    }
}

#if LIM_LONG_MULTIPLY
static void movers_place(const struct lim_instance *instance, const int32_t v[3], int32_t at_q12[3])
{
    place_fine(instance, v, 0, at_q12);
}
#else
/* The same of whole units, |v| <= 2^15: axes in limbs of 15 bits, each product in 32. As the axes' components of one
 * coordinate are a unit vector, the sum of the high ones stays below sqrt(3) 2^30, of the low ones below 3 * 2^29. */
static void movers_place(const struct lim_instance *instance, const int32_t v[3], int32_t at_q12[3])
{
    const uint8_t shift = (uint8_t)(30 - 12 - 15 + instance->finer_bits);

    if (LIM_HAS_LONG && instance->finer_bits > 8) {
        place_fine(instance, v, 0, at_q12);
        return;
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        int32_t high = 0, low = 0;
        for (uint_fast8_t j = 0; j < 3; j++) {
            const int32_t axis_q15 = (instance->axes_q30[3 * j + i] + (INT32_C(1) << 14)) >> 15;
            high += axis_q15 * v[j];
            low += (instance->axes_q30[3 * j + i] - axis_q15 * (INT32_C(1) << 15)) * v[j];
        }
        const int32_t rest = (high & ((INT32_C(1) << shift) - 1)) * (INT32_C(1) << 15);
        const int32_t half = INT32_C(1) << (14 + shift);
        at_q12[i] = instance->at_q8[i] * 16 + (high >> shift) + ((low + rest + half) >> (15 + shift));
    }
}
#endif

static void mover_place(const struct lim_movers *movers, uint16_t mover, lim_index vertex, int32_t at_q12[3])
{
    const struct lim_instance *instance = &movers->instances[mover];
    int32_t v[3];

    lim_corner_load(v, instance->object, vertex);
    if (LIM_HAS_FRACTIONS)
        place_fine(instance, v, 8, at_q12);
    else
        movers_place(instance, v, at_q12);
}

void lim_mover_forget_corners(struct lim_movers *movers)
{
    for (uint_fast8_t i = 0; i < LIM_PLACED_CORNERS; i++)
        movers->placed[i].mover = LIM_NONE;
}

/* The same few corners are asked for again and again: for each plane that a polygon may meet. */
const int32_t *lim_mover_corner(struct lim_movers *movers, uint16_t mover, lim_index vertex)
{
    struct lim_placed *placed = &movers->placed[(vertex + 8u * mover) % LIM_PLACED_CORNERS];

    if (placed->mover != mover || placed->vertex != vertex) {
        placed->mover = mover;
        placed->vertex = vertex;
        mover_place(movers, mover, vertex, placed->at_q12);
    }
    return placed->at_q12;
}

/* The normal N = R n has as many bits as leave room, 29; its d follows from N . p = n . v for p = R v / 2^finer + at.
 */
void lim_mover_turn(const struct lim_movers *movers, uint16_t mover, struct lim_plane_unpacked *plane)
{
    const struct lim_instance *instance = &movers->instances[mover];
    const int32_t n[3] = {plane->n[0], plane->n[1], plane->n[2]};
    const uint8_t spare = clz_u32(abs_s32(n[0]) | abs_s32(n[1]) | abs_s32(n[2])); /* n < 2^(32 - spare) */
    int64_t offset_q8 = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        int64_t sum = 0;
        for (uint_fast8_t j = 0; j < 3; j++)
            sum += (int64_t)instance->axes_q30[3 * j + i] * n[j];
        plane->n[i] =
            (int32_t)shift_round_s64(sum, (uint8_t)(34 - spare)); /* times 2^(spare - 4), below 2^28 sqrt(3) */
        offset_q8 += (int64_t)plane->n[i] * instance->at_q8[i];
    }
    const int64_t own = spare >= 4 ? plane->d * (INT64_C(1) << (spare - 4)) : plane->d >> (4 - spare);
    plane->d = (own >> instance->finer_bits) + (offset_q8 >> 8);
    plane->slack = (int64_t)abs_s32(plane->n[0]) + abs_s32(plane->n[1]) + abs_s32(plane->n[2]);
    plane->narrow = false;
    plane->axis = LIM_NO_AXIS;
    if (LIM_HAS_LONG) *plane->along = LIM_NO_AXIS;
}

int32_t lim_mover_depth(const struct lim_movers *movers, const int32_t at_q12[3])
{
    int64_t sum_q40 = -movers->eye_ahead_q40;

    for (uint_fast8_t i = 0; i < 3; i++)
        sum_q40 += (int64_t)movers->ahead_q28[i] * at_q12[i];
    return (int32_t)(sum_q40 >> 31);
}

/* Of a view's rows that are not set yet: no others have this. */
enum { NOT_SET_QV = 0 };

/* What is asked of a camera here is asked already, of the scene's, and of where its eye is. */
static void turn_rows(struct lim_view *view, const struct lim_scene *scene, const struct lim_camera *camera,
                      const int32_t axes_q30[9])
{
    const bool is_set = lim_rows_set_turned(&view->rows, scene, camera, axes_q30);

    LIM_DEBUG_ASSERT(is_set);
    (void)is_set;
}

/* Textures are the scene's: an object with others shows the colours of its records, and so does one that deforms, whose
 * mappings are those of other planes, or that is lit. */
static LIM_IF_CALLED void turn_textures(const struct lim_movers *movers, uint16_t mover, const struct lim_camera *own,
                                        const int32_t own_axes_q30[9])
{
    const struct lim_instance *instance = &movers->instances[mover];
    struct lim_mover *self = &movers->movers[mover];
    struct lim_texturing *const frame = *movers->texturing;

    *self->texturing->first_texture = LIM_NONE;
    if (!frame || !lim_scene_shares_textures(frame->scene, instance->object) || lim_deforms(instance) ||
        (LIM_HAS_LIGHT && movers->light->on) || (LIM_HAS_FAR_MOVERS && lim_mover_is_remote(self)))
        return;
    if (lim_texture_add_moved(frame, self->texturing, lim_texture_numbers(frame->scene),
                              lim_texture_numbers(instance->object)))
        lim_texture_begin(self->texturing, instance->object, &self->view, own, own_axes_q30);
}

/* The camera, as the object sees it. */
static LIM_ALONE void turn_view(const struct lim_movers *movers, uint16_t mover)
{
    const struct lim_instance *instance = &movers->instances[mover];
    struct lim_mover *self = &movers->movers[mover];
    struct lim_camera own = movers->camera;
    int32_t own_axes_q30[9];

    for (uint_fast8_t j = 0; j < 3; j++) {
        own.eye_q8[j] = self->eye.at_q8[j];
        for (uint_fast8_t i = 0; i < 3; i++)
            own_axes_q30[3 * i + j] =
                (int32_t)shift_round_s64(lim_along_axis(instance, j, &movers->axes_q30[3 * i]), 30);
    }
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) {
        turn_rows(&self->view, (*movers->far)->scene, &own, own_axes_q30);
        lim_mover_set_far_view(self);
    } else {
        const int32_t near_end_q8 = LIM_NEAR_MAX_Q8 >> instance->finer_bits;
        own.near_q8 = own.near_q8 < near_end_q8 ? own.near_q8 << instance->finer_bits : LIM_NEAR_MAX_Q8;
        turn_rows(&self->view, lim_deforms(instance) ? NULL : instance->object, &own, own_axes_q30);
    }
    if (LIM_HAS_TEXTURE) turn_textures(movers, mover, &own, own_axes_q30);
}

struct lim_view *lim_mover_view(struct lim_movers *movers, uint16_t mover)
{
    struct lim_view *view = &movers->movers[mover].view;

    if (movers->cached != mover) {
        lim_index filled = LIM_VIEW_CACHE_ENTRIES; /* the entry of a vertex is its number, modulo that */
        if (movers->cached != LIM_NONE && movers->instances[movers->cached].object->vertex_count < filled)
            filled = movers->instances[movers->cached].object->vertex_count;
        while (filled)
            movers->cache[--filled].vertex = LIM_NO_INDEX;
        movers->cached = mover;
        if (view->rows.near_qv == NOT_SET_QV) turn_view(movers, mover);
    }
    return view;
}

/* What holds the object: its root's box, or what holds its vertices where it is too small to have one, or deforms. */
static struct lim_box movers_box_of(const struct lim_instance *instance)
{
    const struct lim_scene *object = instance->object;
    const lim_index root = lim_deforms(instance) ? (lim_index)LIM_NO_INDEX : object->nodes[0].box;
    int32_t low[3], high[3];
    struct lim_box box = {.half = {0}};

    if (root != LIM_NO_INDEX) return object->boxes[root];
    for (uint_fast8_t i = 0; i < 3; i++)
        low[i] = high[i] = 0;
    for (lim_index k = 0; k < object->vertex_count; k++) {
        const struct lim_vertex vertex = object->vertices[k];
        const int32_t at[3] = {vertex.x, vertex.y, vertex.z};
        for (uint_fast8_t i = 0; i < 3; i++) {
            if (!k || at[i] < low[i]) low[i] = at[i];
            if (!k || at[i] > high[i]) high[i] = at[i];
        }
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        box.centre[i] = (int16_t)((low[i] + high[i]) >> 1);
        box.half[i] = (uint16_t)(((high[i] - low[i]) >> 1) + 1);
    }
    return box;
}

/* Of a box that is turned, along an axis of the scene; 2^-12 more for each rounding of a corner that it holds. */
static int32_t half_along(const struct lim_instance *instance, const uint16_t half[3], uint_fast8_t i)
{
    int64_t sum_q30 = 0;

    for (uint_fast8_t j = 0; j < 3; j++)
        sum_q30 += (int64_t)abs_s32(instance->axes_q30[3 * j + i]) * half[j];
    return (int32_t)(sum_q30 >> (30 - 12 + instance->finer_bits)) + 2 +
           (LIM_HAS_FRACTIONS ? (int32_t)LIM_CORNER_ONE_Q12 >> instance->finer_bits : 0);
}

/* sqrt(x), rounded up, or one more; x < 2^30. */
static uint32_t root_above(uint32_t x)
{
    uint32_t root = 0;

    for (uint32_t bit = UINT32_C(1) << 14; bit; bit >>= 1)
        if ((root + bit) * (root + bit) <= x) root += bit;
    return root + 1;
}

/* Of the ball around a point that holds all vertices, none of which is farther along an axis than `most`. What is
 * rounded down is short by less than one along each axis, so by less than two in all. Vertices of no polygon may be
 * farther away: their squares are anything, and the ball is too large at worst. */
static uint32_t reach_of_vertices(const struct lim_scene *object, const int32_t centre[3], uint32_t most)
{
    const uint8_t zeros = clz_u32(most | 1),
                  shift = (uint8_t)(zeros < 18 ? 18 - zeros : 0); /* to 14 bits: squares below 2^30 */
    uint32_t square = 0;

    for (lim_index k = 0; k < object->vertex_count; k++) {
        const struct lim_vertex at = object->vertices[k];
        const uint32_t x = (uint32_t)((at.x - centre[0]) >> shift), y = (uint32_t)((at.y - centre[1]) >> shift);
        const uint32_t z = (uint32_t)((at.z - centre[2]) >> shift), sum = x * x + y * y + z * z;
        if (sum > square) square = sum;
    }
    return ((root_above(square) + (shift ? 2 : 0)) << shift) + (LIM_HAS_FRACTIONS ? 2 : 0);
}

/* As in rows.c, a length is at most that of its longest component and 107/256 of the others. */
static void set_ball(struct lim_mover *mover, const struct lim_instance *instance)
{
    const struct lim_box box = movers_box_of(instance);
    int32_t centre[3];
    uint32_t longest = 0, sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        centre[i] = box.centre[i];
        sum += box.half[i];
        if (box.half[i] > longest) longest = box.half[i];
    }
    movers_place(instance, centre, mover->centre_q12);
    for (uint_fast8_t i = 0; i < 3; i++) {
        mover->own_half_q12[i] = (int32_t)(((uint32_t)box.half[i] << 12 >> instance->finer_bits) + LIM_CORNER_ONE_Q12);
        mover->half_q12[i] = half_along(instance, box.half, i);
    }
    const uint32_t to_corners = longest + (sum - longest) * 107 / 256 + 1; /* below 2^16 */
    const uint32_t to_vertices = reach_of_vertices(instance->object, centre, longest + 1);
    const uint32_t radius = to_vertices < to_corners ? to_vertices : to_corners;
    mover->radius_q12 = (int32_t)((radius << 12 >> instance->finer_bits) + LIM_CORNER_ONE_Q12);
    for (uint_fast8_t i = 0; i < 3; i++)
        if (mover->half_q12[i] > mover->radius_q12) mover->half_q12[i] = mover->radius_q12;
}

static bool is_within(const struct lim_mover *mover)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        if ((int64_t)abs_s32(mover->centre_q12[i]) + mover->radius_q12 >= WORLD_END_Q12) return false;
    return true;
}

/* Whether there is room for its mesh leaves. One that deforms has none: its polygons are sorted one by one. */
static bool has_room_for_leaves(const struct lim_movers *movers, const struct lim_instance *instance)
{
    const struct lim_limits *limits = &instance->object->limits;

    if (!limits->leaf_polygons || lim_deforms(instance)) return true;
    return LIM_HAS_MESH_LEAVES && limits->leaf_vertices <= *movers->leaf_vertices && *movers->leaf_polygons;
}

static bool is_usable(const struct lim_movers *movers, const struct lim_instance *instance)
{
    const struct lim_scene *object = instance->object;

    const bool is_far = LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers); /* then these are asked by its POSE */

    LIM_ASSERT(!object || !lim_scene_long(object)); /* what moves has 16 bits, in any scene */
    if (!object || !object->node_count || !object->polygon_count || (!is_far && instance->finer_bits > FINER_BITS_MAX))
        return false;
    for (uint_fast8_t i = 0; i < 3 && !is_far; i++)
        if (abs_s32(instance->at_q8[i]) >= (uint32_t)AT_END_Q8) return false;
    return object->limits.vertices <= movers->most_corners && object->limits.depth <= movers->object_depth &&
           has_room_for_leaves(movers, instance) && (LIM_HAS_SLANTED || !object->plane_count) &&
           (LIM_HAS_LARGE || !object->exact_count);
}

/* The eye, as the object sees it. false: it is too far away. */
static bool turn_eye(int32_t own_q8[3], const int32_t eye_q8[3], const struct lim_instance *instance)
{
    int32_t away_q8[3];

    for (uint_fast8_t i = 0; i < 3; i++)
        away_q8[i] = eye_q8[i] - instance->at_q8[i];
    for (uint_fast8_t j = 0; j < 3; j++) {
        const int64_t at_q8 =
            shift_round_s64(lim_along_axis(instance, j, away_q8), (uint8_t)(30 - instance->finer_bits));
        if (at_q8 >= LIM_EYE_MAX_Q8 || at_q8 <= -LIM_EYE_MAX_Q8) return false;
        own_q8[j] = (int32_t)at_q8;
    }
    return true;
}

static void turn_light(struct lim_mover *mover, const struct lim_instance *instance, const struct lim_light *light)
{
    const int32_t to_q14[3] = {light->to_q14[0], light->to_q14[1], light->to_q14[2]};

    for (uint_fast8_t k = 0; k < 3; k++)
        mover->to_q14[k] = (int16_t)shift_round_s64(lim_along_axis(instance, k, to_q14), 30);
}

/* All but the rows. */
static LIM_RARE void set_view(struct lim_view *to, const struct lim_view *from, struct lim_view_cached *cache)
{
    to->width = from->width;
    to->height = from->height;
    to->cache = cache;
    to->vertices = 0;
    to->rows.near_qv = NOT_SET_QV;
    if (LIM_HAS_ANTIALIAS) lim_view_set_antialiased(to, lim_is_antialiased(from));
}

/* In a long scene the mover's own; else what is asked for. */
static LIM_IF_CALLED bool set_any_eye(struct lim_movers *movers, uint16_t i, int32_t own_q8[3])
{
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) return lim_mover_approach(movers, i);
    return turn_eye(own_q8, movers->camera.eye_q8, &movers->instances[i]);
}

static bool pose(struct lim_movers *movers, const struct lim_view *view, uint16_t i)
{
    const struct lim_instance *instance = &movers->instances[i];
    struct lim_mover *mover = &movers->movers[i];
    int32_t eye_q8[3];

    mover->radius_q12 = -1;
    if (!is_usable(movers, instance) ||
        !(LIM_HAS_FAR_MOVERS ? set_any_eye(movers, i, eye_q8) : turn_eye(eye_q8, movers->camera.eye_q8, instance)))
        return false;
    set_view(&mover->view, view, movers->cache);
    if (!LIM_HAS_FAR_MOVERS || !lim_movers_are_far(movers)) lim_eye_set(&mover->eye, instance->object, eye_q8);
    if (LIM_HAS_LIGHT) turn_light(mover, instance, movers->light);
    set_ball(mover, instance);
    if (is_within(mover)) return true;
    mover->radius_q12 = -1;
    return false;
}

void lim_movers_set_antialiased(struct lim_movers *movers, bool antialiased)
{
    for (uint16_t i = 0; i < movers->count; i++)
        lim_view_set_antialiased(&movers->movers[i].view, antialiased);
}

void lim_movers_pose(struct lim_movers *movers, struct lim_pass *pass, const struct lim_camera *camera)
{
    uint32_t drawn = 0;

    movers->cached = LIM_NONE;
    lim_mover_forget_corners(movers);
    if (!movers->given) return;
    movers->camera = *camera;
    if (LIM_HAS_FAR_MOVERS) {
        *movers->far = lim_scene_long(pass->scene) ? lim_eye_of(pass) : NULL;
        if (*movers->far) lim_movers_copy(movers);
    }
    if (LIM_HAS_TEXTURE) {
        *movers->texturing = lim_texture_count(pass->scene) ? pass->texturing : NULL;
        lim_texture_forget_moved(pass->texturing);
    }
    lim_orientation_set(movers->axes_q30, camera);
    movers->eye_ahead_q40 = 0;
    for (uint_fast8_t i = 0; i < 3; i++) {
        movers->ahead_q28[i] = movers->axes_q30[6 + i] >> 2;
        movers->eye_ahead_q40 += movers->ahead_q28[i] * ((int64_t)camera->eye_q8[i] * 16);
    }
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) movers->eye_ahead_q40 = 0; /* all of it is seen from there */
    for (uint16_t i = 0; i < movers->count; i++)
        drawn += pose(movers, &pass->view, i);
    if (LIM_HAS_STATS) lim_stats_of(pass)->movers.left_out = movers->given - drawn;
}

#endif
