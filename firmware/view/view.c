/* SPDX-License-Identifier: MIT
 *
 * Vertices through the three rows and the perspective, each once as long as the cache remembers it. */
#include "view/view.h"

#include "camera.h"
#include "long.h"
#include "view/packed.h"
#include "view/perspective.h"
#include "view/place.h"
#include "view/rows.h"
#include "view/transform.h"

void lim_view_init(struct lim_view *view, uint16_t w_px, uint16_t h_px, struct lim_view_cached *cache)
{
    perspective_set(&view->width, w_px);
    perspective_set(&view->height, h_px);
    view->cache = cache;
    lim_view_set_antialiased(view, false);
}

void lim_view_forget(struct lim_view *view)
{
    for (uint_fast16_t i = 0; i < LIM_VIEW_CACHE_ENTRIES; i++)
        view->cache[i].vertex = LIM_NO_INDEX;
}

bool lim_view_begin(struct lim_view *view, const struct lim_scene *scene, const struct lim_camera *camera)
{
    return lim_view_begin_rows(view, lim_rows_set(&view->rows, scene, camera));
}

/* Inlined into the function that remembers vertices; where flash is short there is one of each. */
#if LIM_8_BIT || !LIM_HOT
#define VIEW_SHARED LIM_ALONE
#else
#define VIEW_SHARED LIM_HOT_INLINE
#endif

/* A point of whole units, in RAM. */
static inline void transform_units(const struct lim_view *view, const struct lim_vertex *at, struct lim_view_point *out)
{
    LIM_HOT_UNROLLED(3)
    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = transform_row(&view->rows.row[i], at);
    transform_settle(&view->rows, out->qv);
    if (LIM_HAS_LONG) *out->exponent = 0;
}

static VIEW_SHARED void transform(const struct lim_view *view, const struct lim_scene *scene,
                                  const LIM_FLASH struct lim_vertex *vertex, struct lim_view_point *out)
{
#if LIM_DUAL_MULTIPLY
    const struct lim_vertex *const at = vertex;
#else
    /* Read member by member: copied, its six bytes would be a call of memcpy() on a Cortex-M0+. */
    const struct lim_vertex copy = {vertex->x, vertex->y, vertex->z}, *const at = &copy;
#endif

    transform_units(view, at, out);
    if (LIM_HAS_FRACTIONS && scene->fractions) {
        const struct lim_fraction fraction = scene->fractions[vertex - scene->vertices];
        LIM_UNROLLED(3)
        for (uint_fast8_t i = 0; i < 3; i++)
            out->qv[i] += transform_fraction(&view->rows.row[i], &fraction);
    }
}

static VIEW_SHARED void project(const struct lim_view *view, const struct lim_view_point *point, struct lim_point *out)
{
    const struct lim_depth depth = perspective_depth(point->z_qv);

    out->x = project_x(view, point->x_qv, depth);
    out->y = project_y(view, point->y_qv, depth);
}

/* Of a point that is not visible. One behind the eye can be outside on both sides; one bit of the two is enough,
 * because the codes are only used to find a side that every vertex is outside of. */
static LIM_RARE uint8_t codes_outside(const struct lim_view *view, int32_t at_x_qv, int32_t at_y_qv, int32_t z_qv)
{
    const int32_t x_qv = (int32_t)abs_s32(at_x_qv), y_qv = (int32_t)abs_s32(at_y_qv);
    const int32_t width_qv = lim_zoomed(&view->rows, z_qv, 0), height_qv = lim_zoomed(&view->rows, z_qv, 1);
    uint8_t codes = 0;

    /* The margin is taken from x and y: z has no room for it. */
    if (z_qv < view->rows.near_qv) codes = LIM_VIEW_NEAR | LIM_VIEW_GUARD;
    if (x_qv - margin_of(width_qv) > width_qv)
        codes = (uint8_t)(codes | (at_x_qv < 0 ? LIM_VIEW_LEFT : LIM_VIEW_RIGHT));
    if (y_qv - margin_of(height_qv) > height_qv)
        codes = (uint8_t)(codes | (at_y_qv < 0 ? LIM_VIEW_TOP : LIM_VIEW_BOTTOM));
    if (x_qv >> 1 > width_qv - 2 || y_qv >> 1 > height_qv - 2) codes |= LIM_VIEW_GUARD;
    return codes;
}

/* What is visible is inside the guard band: z is at least PERSPECTIVE_Z_MIN_QV, so zoomed it is 4 or more. */
static inline uint8_t codes_of(const struct lim_view *view, const struct lim_view_point *point)
{
    const int32_t z_qv = point->z_qv;
    const int32_t width_qv = lim_zoomed(&view->rows, z_qv, 0), height_qv = lim_zoomed(&view->rows, z_qv, 1);

    if (z_qv >= view->rows.near_qv && (int32_t)abs_s32(point->x_qv) - margin_of(width_qv) <= width_qv &&
        (int32_t)abs_s32(point->y_qv) - margin_of(height_qv) <= height_qv)
        return 0;
    return codes_outside(view, point->x_qv, point->y_qv, z_qv);
}

/* A vertex that is not remembered: one function, so that nothing of it goes through memory. */
void lim_view_remember(struct lim_view *view, const struct lim_scene *scene, lim_index vertex,
                       struct lim_view_cached *entry)
{
    struct lim_view_point point;

    if (LIM_HAS_LONG && view->rows.eye->all) {
        lim_view_remember_long(view, scene, vertex, entry);
        return;
    }
    transform(view, scene, &scene->vertices[vertex], &point);
    const uint8_t codes = codes_of(view, &point);
    entry->vertex = vertex;
    entry->codes = (lim_view_code_bits)(LIM_8_BIT ? codes : lim_view_both(codes));
    if (!(codes & LIM_VIEW_GUARD)) project(view, &point, &entry->at);
    if (LIM_HAS_STATS) view->vertices++;
}

#if LIM_VIEWS_ALL || LIM_HAS_MOVERS

/* One end of a box along an axis; a half of 32768 reaches a unit too far. */
static int16_t box_end(const LIM_FLASH struct lim_box *box, uint_fast8_t axis, bool upper)
{
    const int32_t end =
        upper ? box->centre[axis] + (int32_t)box->half[axis] : box->centre[axis] - (int32_t)box->half[axis];

    return (int16_t)(end > INT16_MAX ? INT16_MAX : end < INT16_MIN ? INT16_MIN : end);
}

static struct lim_vertex box_corner(const LIM_FLASH struct lim_box *box, uint_fast8_t k)
{
    return (struct lim_vertex){box_end(box, 0, k & 1), box_end(box, 1, k & 2), box_end(box, 2, k & 4)};
}

bool lim_view_box_rect(const struct lim_view *view, const LIM_FLASH struct lim_box *box, struct lim_rect *rect)
{
    int32_t left = INT32_MAX, right = INT32_MIN, top = INT32_MAX, bottom = INT32_MIN;

    for (uint_fast8_t k = 0; k < 8; k++) {
        const struct lim_vertex corner = box_corner(box, k);
        struct lim_view_point point;
        struct lim_point at;
        transform_units(view, &corner, &point);
        if (codes_of(view, &point) & LIM_VIEW_GUARD) return false;
        project(view, &point, &at);
        if (at.x < left) left = at.x;
        if (at.x > right) right = at.x;
        if (at.y < top) top = at.y;
        if (at.y > bottom) bottom = at.y;
    }
    rect->x0 = lim_view_pixel_within(left, -1, view->width.px);
    rect->x1 = lim_view_pixel_within(right, 2, view->width.px);
    rect->y0 = lim_view_pixel_within(top, -1, view->height.px);
    rect->y1 = lim_view_pixel_within(bottom, 2, view->height.px);
    return true;
}

/* Where the corners of the box that holds a part lie. */
struct box_view {
    int32_t least_z_qv;  /* how near any comes */
    uint8_t codes;       /* OR'ed */
    bool is_well_inside; /* all are far from the screen's border, so any vertex is on it; fractions may reach beyond */
};

/* A pixel or more from the border, so half of one or more from the outer centres: rounding does not pass them. */
static bool is_well_within(int32_t at_qv, int32_t z_qv, int32_t side_px)
{
    const uint_fast8_t margin_bits = (uint_fast8_t)(30 - clz_u32((uint32_t)side_px)); /* 2^margin_bits <= side_px / 2 */

    return side_px >= 2 && z_qv > 0 && abs_s32(at_qv) < (uint32_t)(z_qv - (z_qv >> margin_bits));
}

static struct box_view box_seen(const struct lim_view *view, const LIM_FLASH struct lim_box *box)
{
    struct box_view seen = {PERSPECTIVE_MAX_QV, 0, true};

    for (uint_fast8_t k = 0; k < 8; k++) {
        const struct lim_vertex corner = box_corner(box, k);
        struct lim_view_point point;
        transform_units(view, &corner, &point);
        seen.codes |= codes_of(view, &point);
        seen.is_well_inside = !LIM_OPTIMISE_SIZE && !LIM_HAS_FRACTIONS && seen.is_well_inside &&
                              is_well_within(point.x_qv, lim_zoomed(&view->rows, point.z_qv, 0), view->width.px) &&
                              is_well_within(point.y_qv, lim_zoomed(&view->rows, point.z_qv, 1), view->height.px);
        if (point.z_qv < seen.least_z_qv) seen.least_z_qv = point.z_qv;
    }
    return seen;
}

/* What the nearest vertex has; rounding may bring one a little nearer than the box. */
static uint32_t near_shift_of(const struct lim_view *view, int32_t least_z_qv)
{
    const int32_t near_qv = least_z_qv - (least_z_qv >> 2);

    return perspective_depth(near_qv > view->rows.near_qv ? near_qv : view->rows.near_qv).shift;
}

/* Nothing of it needs to be clipped. Returns whether all of it lies on the screen, between its first and its last lines
 * and columns of centres, where that is to be found out. */
static LIM_INLINE bool project_each(const struct lim_view *view, const struct lim_scene *scene,
                                    const struct lim_view_part *part, uint32_t near_shift, struct lim_point *points,
                                    uint16_t *nearness, bool finds_out)
{
    const LIM_FLASH struct lim_vertex *vertex = scene->vertices + part->first, *const end = vertex + part->count;
    const int32_t from = -LIM_ORIGIN_PX * LIM_SUB;
    const lim_packed first = lim_packed_of(from, from);
    const lim_packed last =
        lim_packed_of(from + (view->width.px - 1) * LIM_SUB, from + (view->height.px - 1) * LIM_SUB);
    uint32_t signs = 0;

    for (; vertex < end; vertex++) {
        struct lim_view_point point;
        transform(view, scene, vertex, &point);
        const struct lim_depth depth = perspective_depth(point.z_qv);
        const lim_packed at = lim_packed_of(project_x(view, point.x_qv, depth), project_y(view, point.y_qv, depth));
        if (finds_out) signs |= lim_packed_beyond(at, first, last);
        lim_packed_store(points++, at);
        *nearness++ = perspective_nearness(depth, near_shift);
    }
    return !lim_packed_is_beyond(signs);
}

static LIM_ALONE bool project_all(const struct lim_view *view, const struct lim_scene *scene,
                                  const struct lim_view_part *part, uint32_t near_shift, struct lim_point *points,
                                  uint16_t *nearness)
{
    return project_each(view, scene, part, near_shift, points, nearness, true);
}

static LIM_ALONE void project_inside(const struct lim_view *view, const struct lim_scene *scene,
                                     const struct lim_view_part *part, uint32_t near_shift, struct lim_point *points,
                                     uint16_t *nearness)
{
    project_each(view, scene, part, near_shift, points, nearness, false);
}

/* Those before the near plane or beyond the guard band are not, if there may be such. */
static void project_some(const struct lim_view *view, const struct lim_scene *scene, const struct lim_view_part *part,
                         uint32_t near_shift, struct lim_point *points, uint16_t *nearness, bool may_clip)
{
    for (lim_index i = 0; i < part->count; i++) {
        struct lim_view_point point;
        transform(view, scene, &scene->vertices[part->first + i], &point);
        const uint8_t codes = codes_of(view, &point);
        if (may_clip && (codes & LIM_VIEW_GUARD)) {
            points[i] = (struct lim_point){(int16_t)(codes & ~LIM_VIEW_GUARD), 0};
            nearness[i] = 0;
            continue;
        }
        const struct lim_depth depth = perspective_depth(point.z_qv);
        points[i] = (struct lim_point){project_x(view, point.x_qv, depth), project_y(view, point.y_qv, depth)};
        nearness[i] = perspective_nearness(depth, near_shift);
    }
}

uint16_t lim_view_nearness(const struct lim_view_point *point, uint8_t near_shift)
{
    return perspective_nearness(perspective_depth(point->z_qv), near_shift);
}

enum lim_view_extent lim_view_all(struct lim_view *view, const struct lim_scene *scene,
                                  const struct lim_view_part *part, struct lim_point *points, uint16_t *nearness,
                                  uint8_t *shift)
{
    const struct box_view seen = box_seen(view, &scene->boxes[part->box]);
    const uint32_t near_shift = near_shift_of(view, seen.least_z_qv);

    *shift = (uint8_t)near_shift;
    if (LIM_HAS_STATS) view->vertices += part->count;
    const bool may_clip = seen.codes & LIM_VIEW_GUARD;
    if (LIM_OPTIMISE_SIZE || may_clip) {
        project_some(view, scene, part, near_shift, points, nearness, may_clip);
        return may_clip ? LIM_VIEW_CLIPPED : LIM_VIEW_WHOLE;
    }
    if (!seen.is_well_inside)
        return project_all(view, scene, part, near_shift, points, nearness) ? LIM_VIEW_INSIDE : LIM_VIEW_WHOLE;
    project_inside(view, scene, part, near_shift, points, nearness);
    return LIM_VIEW_INSIDE;
}

/* 2^bits times as fine, where there is less than 2^(15 - bits). */
static LIM_RARE void view_finer(struct lim_view *view, const struct lim_scene *scene, const struct lim_view_part *part,
                                uint8_t bits, uint16_t *nearness, uint8_t *near_shift)
{
    const uint32_t finer_shift = perspective_finer(*near_shift, bits);

    *near_shift = (uint8_t)finer_shift;
    for (lim_index i = 0; i < part->count; i++) {
        struct lim_view_point point;
        if (!nearness[i] || nearness[i] >> (15 - bits)) continue;
        transform(view, scene, &scene->vertices[part->first + i], &point);
        nearness[i] = perspective_nearness(perspective_depth(point.z_qv), finer_shift);
        if (LIM_HAS_STATS) view->vertices++;
    }
}

enum { REFINED_BITS = 13 }; /* of nearness at most: a plane that is not quite right keeps within 16 */

void lim_view_refine(struct lim_view *view, const struct lim_scene *scene, const struct lim_view_part *part,
                     uint16_t seen, uint16_t *nearness, uint8_t *near_shift)
{
    const uint8_t zeros = seen ? clz_u32(seen) : 0;

    if (zeros > 32 - REFINED_BITS)
        view_finer(view, scene, part, (uint8_t)(zeros - (32 - REFINED_BITS)), nearness, near_shift);
}

#endif

/* For those who want a part of it: clipped polygons, pieces. */
void lim_view_transform(const struct lim_view *view, const struct lim_scene *scene,
                        const LIM_FLASH struct lim_vertex *vertex, struct lim_view_point *out)
{
    if (LIM_HAS_LONG && LIM_HAS_MOVERS && view->rows.eye->all)
        lim_view_transform_moved(view, scene, (lim_index)(vertex - scene->vertices), out);
    else
        transform(view, scene, vertex, out);
}

void lim_view_project(const struct lim_view *view, const struct lim_view_point *point, struct lim_point *out)
{
    if (LIM_HAS_LONG && view->rows.eye->all)
        lim_view_project_long(view, point, out);
    else
        project(view, point, out);
}
