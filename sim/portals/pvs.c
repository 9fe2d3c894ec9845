/* SPDX-License-Identifier: MIT
 *
 * Zones whose visible sets are alike share one, which shows what either shows: as long as the bytes saved are worth
 * more than the polygons that are reached in vain, by the zones' volumes. */
#include "portals/pvs.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "portals/flow.h"
#include "portals/set_boxes.h"

#include <stdlib.h>
#include <string.h>

/* The renderer numbers cells, two a node, in 16 bits. */
enum { NODES_MAX = 16384, PVS_MAX = 512, BYTES_A_POLYGON = 32 };

/* A zone of rooms takes 60 thousand at most, one of Freedoom's maps 2.2 million, and a map 16 million. */
const struct pvs_effort pvs_usual_effort = {.zone_work = 3000000, .work = 20000000, .given_up = 0.25, .hidden = 0.03};

/* A visible set and the zones that share it. */
struct group {
    uint8_t *bits;
    double volume; /* share of all; 0: it has become part of another */
    size_t polygons, packed_b;
};

struct work {
    const struct lim_scene *scene;
    struct cells cells;
    struct zones zones;
    struct flow flow;
    struct boxes boxes;
    size_t *own;          /* of each box: its polygons that no smaller one holds */
    size_t unboxed;       /* polygons in no box */
    struct group *groups; /* by zone at first */
    uint32_t *group_of;   /* of each zone */
    const struct pvs_effort *effort;
    size_t work_left;     /* of effort->work */
    size_t given_up;      /* zones whose portals lead too far */
    double part_given_up; /* of the volume */
    double part_shown;    /* of the polygons, by volume */
};

size_t pvs_pack(const uint8_t *bytes, size_t count, uint8_t *out)
{
    size_t used = 0;
    for (size_t i = 0; i < count;) {
        size_t zeros = 0;
        while (i + zeros < count && zeros < 255 && !bytes[i + zeros])
            zeros++;
        out[used++] = bytes[i];
        if (zeros) out[used++] = (uint8_t)zeros;
        i += zeros ? zeros : 1;
    }
    return used;
}

/* Boxes -------------------------------------------------------------------------------------- */

static void boxes_count(struct work *work)
{
    boxes_find(&work->boxes, work->scene);
    work->own = grow_zeroed(work->scene->box_count, sizeof *work->own);
    for (size_t r = 0; r < work->cells.record_count; r++) {
        const lim_index box = work->boxes.of_node[work->cells.records[r].node];
        ++*(box == LIM_NO_INDEX ? &work->unboxed : &work->own[box]);
    }
}

/* A visible record's box and all around it. */
static void bits_set(const struct work *work, const bool *visible, uint8_t *bits)
{
    for (size_t r = 0; r < work->cells.record_count; r++)
        if (visible[r]) boxes_show(&work->boxes, work->boxes.of_node[work->cells.records[r].node], bits);
}

static void group_weigh(const struct work *work, struct group *group)
{
    uint8_t *packed = grow_zeroed(2 * work->boxes.bits_b, 1);
    group->packed_b = pvs_pack(group->bits, work->boxes.bits_b, packed);
    group->polygons = work->unboxed;
    for (size_t box = 0; box < work->scene->box_count; box++)
        if (boxes_shown(group->bits, box)) group->polygons += work->own[box];
    free(packed);
}

/* Groups ------------------------------------------------------------------------------------- */

static double volume_of_zone(const struct work *work, size_t zone)
{
    double volume = 0;
    for (size_t i = work->zones.first[zone]; i < work->zones.first[zone + 1]; i++)
        volume += work->cells.items[work->zones.cells[i]].volume;
    return volume > 0 ? volume : 0;
}

struct zone_size {
    size_t zone;
    double volume;
};

static int compare_sizes(const void *a, const void *b)
{
    const struct zone_size *p = a, *q = b;
    if (p->volume != q->volume) return p->volume < q->volume ? 1 : -1;
    return (p->zone > q->zone) - (p->zone < q->zone);
}

/* All zones, the largest first. */
static struct zone_size *zones_by_size(const struct work *work, double *all)
{
    const size_t count = work->zones.count;
    struct zone_size *sizes = grow_zeroed(count, sizeof *sizes);
    *all = 0;
    for (size_t z = 0; z < count; z++) {
        sizes[z] = (struct zone_size){z, volume_of_zone(work, z)};
        *all += sizes[z].volume;
    }
    qsort(sizes, count, sizeof *sizes, compare_sizes);
    return sizes;
}

/* What is seen from a zone. One whose portals lead too far shows everything, which is always right; but there is
 * nothing to be had where these are too large a part. */
static bool zone_see(struct work *work, size_t zone, double part, bool *visible, struct error *err)
{
    struct group *group = &work->groups[zone];
    struct flow *flow = &work->flow;
    const size_t most = work->effort->zone_work;
    flow->work_max = work->work_left < most ? work->work_left : most;
    const bool known = flow_see(flow, zone, visible);
    work->work_left -= flow->work < work->work_left ? flow->work : work->work_left;
    if (!known) {
        if (!deadline_check(err, "portals were still followed")) return false;
        work->given_up++;
        work->part_given_up += part;
        return work->part_given_up <= work->effort->given_up ||
               error_set(err, "its portals lead too far to be followed");
    }
    group->volume = part;
    bits_set(work, visible, group->bits);
    group_weigh(work, group);
    work->part_shown += part * (double)group->polygons / (double)work->cells.record_count;
    return work->part_shown <= 1.0 - work->effort->hidden ||
           error_set(err, "they would hide less than %.0f %% of the polygons", 100.0 * work->effort->hidden);
}

static bool groups_begin(struct work *work, struct error *err)
{
    const size_t count = work->zones.count;
    double all;
    struct zone_size *sizes = zones_by_size(work, &all);
    bool *visible = grow_zeroed(work->cells.record_count, sizeof *visible), ok = true;
    for (size_t z = 0; z < count; z++) {
        work->groups[z].bits = grow_zeroed(work->boxes.bits_b, 1);
        work->group_of[z] = (uint32_t)z;
    }
    for (size_t i = 0; ok && i < count && i < PVS_MAX && sizes[i].volume > 0; i++) /* of others nothing is known */
        ok = deadline_check(err, "portals were still followed") &&
             zone_see(work, sizes[i].zone, sizes[i].volume / all, visible, err);
    free(sizes);
    free(visible);
    return ok;
}

static struct group joined(const struct work *work, const struct group *a, const struct group *b)
{
    struct group both = {.bits = grow_zeroed(work->boxes.bits_b, 1), .volume = a->volume + b->volume};
    for (size_t i = 0; i < work->boxes.bits_b; i++)
        both.bits[i] = a->bits[i] | b->bits[i];
    group_weigh(work, &both);
    return both;
}

/* What joining two saves, as bytes. */
static double worth_of(const struct work *work, const struct group *a, const struct group *b)
{
    const struct group both = joined(work, a, b);
    const double more =
        (double)(both.polygons - a->polygons) * a->volume + (double)(both.polygons - b->polygons) * b->volume;
    free(both.bits);
    return (double)a->packed_b + (double)b->packed_b - (double)both.packed_b - BYTES_A_POLYGON * more;
}

static void group_join(struct work *work, size_t a, size_t b)
{
    const struct group both = joined(work, &work->groups[a], &work->groups[b]);
    free(work->groups[a].bits);
    work->groups[a] = both;
    work->groups[b].volume = 0;
    for (size_t z = 0; z < work->zones.count; z++)
        if (work->group_of[z] == b) work->group_of[z] = (uint32_t)a;
}

/* The best partner among the groups that come later; its worth is above 0, or there is none: the group itself. */
static size_t best_partner(const struct work *work, size_t a, double *worth)
{
    size_t best = a;
    *worth = 0;
    for (size_t b = a + 1; work->groups[a].volume > 0 && b < work->zones.count; b++) {
        if (work->groups[b].volume <= 0) continue;
        const double mine = worth_of(work, &work->groups[a], &work->groups[b]);
        if (mine <= *worth) continue;
        *worth = mine;
        best = b;
    }
    return best;
}

/* After `gone` has become part of `joint`. */
static void partner_renew(const struct work *work, size_t a, size_t joint, size_t gone, size_t *partner, double *worth)
{
    if (a == joint || a == gone || *partner == joint || *partner == gone) {
        *partner = best_partner(work, a, worth);
    } else if (a < joint && work->groups[a].volume > 0) {
        const double mine = worth_of(work, &work->groups[a], &work->groups[joint]);
        if (mine <= *worth) return;
        *worth = mine;
        *partner = joint;
    }
}

/* Joins the best pair until none is worth it. */
static void groups_join(struct work *work)
{
    const size_t count = work->zones.count;
    size_t *partners = grow_zeroed(count, sizeof *partners), best = 0;
    double *worths = grow_zeroed(count, sizeof *worths);
    for (size_t a = 0; a < count; a++)
        partners[a] = best_partner(work, a, &worths[a]);
    while (best < count) {
        best = count;
        for (size_t a = 0; a < count; a++)
            if (worths[a] > (best < count ? worths[best] : 0)) best = a;
        if (best == count) break;
        const size_t gone = partners[best];
        group_join(work, best, gone);
        for (size_t a = 0; a < count; a++)
            partner_renew(work, a, best, gone, &partners[a], &worths[a]);
    }
    free(partners);
    free(worths);
}

/* Storage ------------------------------------------------------------------------------------ */

static bool groups_pack(struct work *work, uint16_t *starts, struct pvs *out, struct error *err)
{
    size_t total_b = 0;
    for (size_t g = 0; g < work->zones.count; g++)
        total_b += work->groups[g].volume > 0 ? work->groups[g].packed_b : 0;
    if (total_b >= LIM_NONE) return error_set(err, "its visible sets take %zu bytes, too many", total_b);
    out->bytes = grow_zeroed(total_b + 2 * work->boxes.bits_b, 1);
    for (size_t g = 0; g < work->zones.count; g++) {
        const struct group *group = &work->groups[g];
        starts[g] = LIM_NONE;
        if (group->volume <= 0) continue;
        starts[g] = (uint16_t)out->byte_count;
        out->byte_count += pvs_pack(group->bits, work->boxes.bits_b, out->bytes + out->byte_count);
        out->mean_polygons += (double)group->polygons * group->volume;
        out->kept++;
    }
    return true;
}

/* A cell that no eye is looked up in takes the place of its neighbours. A cell without a known extent gets none. */
static bool is_asked_for(const struct work *work, uint32_t cell)
{
    const struct lim_node *node = &work->scene->nodes[cell / 2];
    const lim_index child = cell % 2 ? node->back : node->front, run = cell % 2 ? node->back_run : node->front_run;
    return child == LIM_NO_INDEX && run != LIM_NO_INDEX;
}

static void places_make(const struct work *work, const uint16_t *starts, struct pvs *out)
{
    uint16_t before = LIM_NONE;
    out->places = grow_zeroed(work->cells.count, sizeof *out->places);
    for (uint32_t cell = 0; cell < work->cells.count; cell++) {
        if (!is_asked_for(work, cell)) continue;
        const uint32_t zone = work->zones.of_cell[cell];
        const uint16_t pvs = zone == ZONE_NONE ? (uint16_t)LIM_NONE : starts[work->group_of[zone]];
        if (pvs != before) out->places[out->place_count++] = (struct lim_place){(uint16_t)cell, pvs};
        before = pvs;
    }
}

static bool store(struct work *work, struct pvs *out, struct error *err)
{
    uint16_t *starts = grow_zeroed(work->zones.count, sizeof *starts);
    const bool ok = groups_pack(work, starts, out, err);
    if (ok) places_make(work, starts, out);
    free(starts);
    return ok;
}

/* All -------------------------------------------------------------------------------------- */

static bool has_leaves(const struct lim_scene *scene)
{
    for (size_t i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].split.plane == LIM_NO_INDEX) return true;
    return false;
}

bool pvs_may_be(const struct lim_scene *scene, struct error *err)
{
    if (has_leaves(scene)) return error_set(err, "they lead between cells of a BSP tree; this has none");
    if (scene->node_count > NODES_MAX)
        return error_set(err, "too many nodes for portals: %u, %d are the most", (unsigned)scene->node_count,
                         NODES_MAX);
    return scene->box_count > 0 || error_set(err, "too few polygons for portals");
}

static bool find_in(struct work *work, double angle_rad, struct pvs *out, struct error *err)
{
    if (!cells_find(work->scene, &work->cells, err) || !deadline_check(err, "cells were still sought")) return false;
    zones_find(&work->cells, &work->zones);
    out->zones = work->zones.count;
    if (!work->zones.count)
        return error_set(err, "none of its cells is closed: there is nothing that portals could hide");
    boxes_count(work);
    work->groups = grow_zeroed(work->zones.count, sizeof *work->groups);
    work->group_of = grow_zeroed(work->zones.count, sizeof *work->group_of);
    flow_init(&work->flow, &work->cells, &work->zones, angle_rad);
    if (!groups_begin(work, err)) return false;
    out->given_up = work->given_up;
    groups_join(work);
    return store(work, out, err);
}

bool pvs_find(const struct lim_scene *scene, double angle_rad, const struct pvs_effort *effort, struct pvs *out,
              struct error *err)
{
    struct work work = {.scene = scene, .effort = effort, .work_left = effort->work};
    *out = (struct pvs){0};
    if (!pvs_may_be(scene, err)) return false;
    const bool ok = find_in(&work, angle_rad, out, err);
    for (size_t g = 0; work.groups && g < work.zones.count; g++)
        free(work.groups[g].bits);
    free(work.groups);
    free(work.group_of);
    boxes_free(&work.boxes);
    free(work.own);
    flow_free(&work.flow);
    zones_free(&work.zones);
    cells_free(&work.cells);
    if (!ok) pvs_free(out);
    return ok;
}

void pvs_free(struct pvs *pvs)
{
    free(pvs->places);
    free(pvs->bytes);
    *pvs = (struct pvs){0};
}
