/* SPDX-License-Identifier: MIT
 *
 * One object's polygons come in the order of its own tree; of one that deforms as its file has them, for it has none.
 */
#include "orders/nearest.h"

#include "lines/retain.h"
#include "movers/deform.h"
#include "movers/meet.h"
#include "movers/mover.h"
#include "movers/route.h"
#include "pieces/mesh_leaf.h"
#include "screen/polygon.h"
#include "screen/project.h"
#include "view/pass.h"

#if LIM_HAS_SPANS && LIM_HAS_MOVERS

/* A polygon of a mover: its plane, in its object, and on which side of that the eye is. */
struct face {
    const LIM_FLASH lim_index *record;
    const LIM_FLASH struct lim_plane_ref *plane; /* NULL: of its corners */
    uint16_t mover;
    bool eye_in_front;
};

static const struct lim_scene *collected_object(const struct lim_nearest *nearest, uint16_t mover)
{
    return (*nearest->movers)->instances[mover].object;
}

/* What has no plane, because its corners have come to lie on a line, is not lit. */
static LIM_IF_CALLED uint16_t colour_of(const struct lim_movers *movers, const struct face *face)
{
    const struct lim_scene *object = movers->instances[face->mover].object;
    struct lim_plane_unpacked plane;

    if (!LIM_HAS_LIGHT) return (uint16_t)face->record[1];
    if (!LIM_HAS_CORNER_PLANES || face->plane)
        lim_plane_unpack(&plane, object, face->plane);
    else if (!lim_deform_plane(&plane, object, face->record))
        return (uint16_t)face->record[1];
    for (uint_fast8_t i = 0; i < 3 && !face->eye_in_front; i++)
        plane.n[i] = -plane.n[i];
    return lim_light_shade(movers->light, movers->movers[face->mover].to_q14, plane.n, (uint16_t)face->record[1]);
}

/* The word of its texture, as the frame counts them. */
static LIM_IF_CALLED void number_texture(const struct lim_movers *movers, struct lim_screen_polygon *out,
                                         uint16_t mover)
{
    const uint16_t first = lim_mover_first_texture(movers, mover), own = lim_screen_texture(out);

    *out->texture = first == LIM_NONE || own == LIM_NONE ? (uint16_t)LIM_NONE : (uint16_t)(first + own);
}

static inline bool is_lit(const struct lim_movers *movers)
{
    return LIM_HAS_LIGHT && movers->light->on;
}

/* Once it is projected. */
static bool collect_seen_face(struct lim_nearest *nearest, const struct face *face, struct lim_screen_polygon *polygon)
{
    const struct lim_movers *const movers = *nearest->movers;

    if (is_lit(movers)) polygon->colour = lim_memory_colour(colour_of(movers, face));
    if (LIM_HAS_TEXTURE) number_texture(movers, polygon, face->mover);
    return lim_collect_polygon(nearest, polygon);
}

/* A record as it lies in the object; of a mesh leaf whose corners are projected, if there is one. */
static bool collect_any_face(struct lim_nearest *nearest, const struct face *face, const struct lim_mesh_leaf *leaf)
{
    struct lim_movers *const movers = *nearest->movers;
    struct lim_view *const view = lim_mover_view(movers, face->mover);
    const struct lim_scene *const object = collected_object(nearest, face->mover);
    struct lim_stats *const stats = lim_stats_of(nearest->pass);
    struct lim_screen_polygon polygon;

    if (LIM_HAS_MESH_LEAVES && leaf)
        return !lim_mesh_leaf_project(&polygon, leaf, face->record, &nearest->spans.open, stats) ||
               collect_seen_face(nearest, face, &polygon);
    if (!LIM_OPTIMISE_SIZE && !is_lit(movers)) {
        const enum lim_collected how =
            lim_collect_moving(nearest, view, object, face->record, lim_mover_first_texture(movers, face->mover));
        if (how != LIM_COLLECT_SLOWLY) return how == LIM_COLLECTED;
    }
    return !lim_project(&polygon, view, object, face->record, &nearest->spans.open, stats) ||
           collect_seen_face(nearest, face, &polygon);
}

/* A record that faces the eye: whose it is, is told with it. */
static bool collect_face(struct lim_nearest *nearest, const struct face *face, const struct lim_mesh_leaf *leaf)
{
    const lim_index record = (lim_index)(face->record - collected_object(nearest, face->mover)->polygons);

    *nearest->comes = (struct lim_pixel_polygon){.met = {face->mover, record, 0}};
    if (*nearest->by_pixel) return collect_any_face(nearest, face, leaf);
    if (!lim_retain_tell_mover(&nearest->spans, &nearest->comes->met)) return false;
    const bool has_room = collect_any_face(nearest, face, leaf);
    lim_retain_told(&nearest->spans);
    return has_room;
}

static LIM_IF_CALLED bool collect_own_leaf(struct lim_nearest *nearest, uint16_t mover, const LIM_FLASH lim_index *run)
{
    struct lim_movers *const movers = *nearest->movers;
    const struct lim_mesh_leaf_seen seen = {collected_object(nearest, mover), lim_mover_view(movers, mover), false};
    struct lim_mesh_leaf *const leaf = movers->leaf;
    struct face face = {NULL, NULL, mover, true};

    lim_mesh_leaf_sort(leaf, &seen, run);
    while ((face.record = lim_mesh_leaf_next(leaf)) != NULL)
        if (!collect_face(nearest, &face, leaf)) return false;
    return true;
}

static bool collect_own_run(struct lim_nearest *nearest, const struct lim_route *route, uint16_t mover, lim_index run)
{
    const LIM_FLASH lim_index *record = &route->scene->polygons[run];
    const LIM_FLASH struct lim_plane_ref *const split = &route->scene->nodes[route->node].split;

    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(record)) return collect_own_leaf(nearest, mover, record);
    for (;;) {
        const bool has_own = LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE;
        const struct face face = {record, has_own ? lim_record_plane(record) : split, mover,
                                  has_own ? !(record[0] & LIM_POLYGON_BACK) : route->side > 0};
        if (lim_record_is_seen(route->eye, record) && !collect_face(nearest, &face, NULL)) return false;
        if (record[0] & LIM_POLYGON_LAST) return true;
        record += lim_record_words(record[0]);
    }
}

/* Every record, wherever in the tree it is: it knows its own plane. */
static LIM_IF_CALLED bool collect_deformed(struct lim_nearest *nearest, uint16_t mover)
{
    const struct lim_scene *const object = collected_object(nearest, mover);

    for (lim_index at = 0; at < object->polygon_words;) {
        const struct face face = {&object->polygons[at], NULL, mover, true};
        if (lim_deform_is_seen(&(*nearest->movers)->movers[mover].eye, face.record) &&
            !collect_face(nearest, &face, NULL))
            return false;
        at = (lim_index)(at + lim_record_words(face.record[0]));
    }
    return true;
}

static bool collect_by_tree(struct lim_nearest *nearest, uint16_t mover)
{
    struct lim_route route;
    lim_index run;

    lim_route_object(&route, nearest->pass, *nearest->movers, mover, &nearest->spans.open);
    while ((run = lim_route_next(&route)) != LIM_NO_INDEX)
        if (!collect_own_run(nearest, &route, mover, run)) return false;
    return true;
}

bool lim_collect_mover(struct lim_nearest *nearest, uint16_t mover)
{
    *nearest->moves = true;
    const bool has_room = LIM_HAS_DEFORM && lim_deforms(&(*nearest->movers)->instances[mover])
                              ? collect_deformed(nearest, mover)
                              : collect_by_tree(nearest, mover);
    *nearest->moves = false;
    nearest->comes->met.owner = LIM_NONE;
    return has_room;
}

bool lim_collect_met(struct lim_nearest *nearest, const LIM_FLASH lim_index *record, bool of_corners,
                     lim_collect_one *collect)
{
    struct lim_movers *const movers = *nearest->movers;
    uint16_t mover;
    bool is_any;

    while ((mover = lim_meet_before(nearest->progress.route, record, of_corners, &is_any)) != LIM_NONE)
        if (!lim_collect_mover(nearest, mover)) return false;
    const lim_index still = (lim_index)(record - nearest->pass->scene->polygons);
    *nearest->comes =
        (struct lim_pixel_polygon){.met = {is_any ? LIM_STILL_MET : LIM_NONE, still, nearest->progress.route->node}};
    if (is_any && !*nearest->by_pixel && !lim_retain_tell_still(&nearest->spans, movers, &nearest->comes->met))
        return false;
    const bool has_room = collect(nearest, record);
    if (is_any && !*nearest->by_pixel) lim_retain_told(&nearest->spans);
    nearest->comes->met.owner = LIM_NONE;
    return has_room;
}

#endif
