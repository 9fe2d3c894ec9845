/* SPDX-License-Identifier: MIT
 *
 * Cells are joined through wide openings, wide for the smaller of the two: an area near that of a cube of the same
 * volume, as the halves of a room have that a table's plane divides, not rooms with a door between. The widest come
 * first. Sums of areas, open both ways, are kept by pairs of zones, found anew in each round; each round joins every
 * pair that is the best for both. */
#include "portals/zones.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

static const double WIDE = 0.3;
static const double DOORWAY_OPEN = 0.3, DOORWAY_VOLUME = 0.1; /* shares: of a cell's openings, of its zone */

struct pair {
    uint32_t a, b;  /* zones, a < b */
    double area[2]; /* open for one who looks from a to b, and back */
};

struct joining {
    const struct cells *cells;
    uint32_t *leaders; /* of each cell: a forest */
    double *volumes;   /* of zones, at their leaders */
    struct pair *pairs;
    size_t pair_count;
    uint32_t *best; /* pair of each zone */
    double *widest; /* how wide that is */
};

static uint32_t leader_of(struct joining *work, uint32_t cell)
{
    while (work->leaders[cell] != cell)
        cell = work->leaders[cell] = work->leaders[work->leaders[cell]];
    return cell;
}

static bool is_place(const struct cell *cell)
{
    return cell->exists && cell->is_free && cell->bounded;
}

static int compare_pairs(const void *a, const void *b)
{
    const struct pair *p = a, *q = b;
    if (p->a != q->a) return p->a < q->a ? -1 : 1;
    return (p->b > q->b) - (p->b < q->b);
}

static void pairs_add_up(struct joining *work)
{
    size_t kept = 0;
    if (work->pair_count) qsort(work->pairs, work->pair_count, sizeof *work->pairs, compare_pairs);
    for (size_t i = 0; i < work->pair_count; i++) {
        struct pair *last = kept ? &work->pairs[kept - 1] : NULL;
        if (last && last->a == work->pairs[i].a && last->b == work->pairs[i].b)
            for (int k = 0; k < 2; k++)
                last->area[k] += work->pairs[i].area[k];
        else
            work->pairs[kept++] = work->pairs[i];
    }
    work->pair_count = kept;
}

/* Pairs of leaders; what has come to lie inside a zone is dropped. */
static void pairs_renew(struct joining *work)
{
    size_t kept = 0;
    for (size_t i = 0; i < work->pair_count; i++) {
        const uint32_t a = leader_of(work, work->pairs[i].a), b = leader_of(work, work->pairs[i].b);
        if (a == b) continue;
        const double *area = work->pairs[i].area;
        const bool turned = a > b;
        work->pairs[kept++] =
            turned ? (struct pair){b, a, {area[1], area[0]}} : (struct pair){a, b, {area[0], area[1]}};
    }
    work->pair_count = kept;
    pairs_add_up(work);
}

static void pairs_begin(struct joining *work)
{
    for (size_t i = 0; i < work->cells->opening_count; i++) {
        const struct opening *opening = &work->cells->openings[i];
        if (!is_place(&work->cells->items[opening->from]) || !is_place(&work->cells->items[opening->to])) continue;
        const uint32_t a = opening->from, b = opening->to;
        const double area = patch_area(&opening->patch, &opening->flat);
        work->pairs[work->pair_count++] = a < b ? (struct pair){a, b, {area, 0}} : (struct pair){b, a, {0, area}};
    }
    pairs_add_up(work);
}

static double width_of(const struct joining *work, const struct pair *pair)
{
    const double a = work->volumes[pair->a], b = work->volumes[pair->b];
    const double edge = cbrt(fmax(fmin(a, b), 1.0));
    return fmin(pair->area[0], pair->area[1]) / (edge * edge);
}

static void judge(struct joining *work)
{
    for (size_t i = 0; i < work->cells->count; i++)
        work->widest[i] = 0;
    for (size_t i = 0; i < work->pair_count; i++) {
        const double width = width_of(work, &work->pairs[i]);
        const uint32_t zones[2] = {work->pairs[i].a, work->pairs[i].b};
        for (int k = 0; k < 2; k++) {
            if (width <= work->widest[zones[k]]) continue;
            work->widest[zones[k]] = width;
            work->best[zones[k]] = (uint32_t)i;
        }
    }
}

static bool join_round(struct joining *work)
{
    bool joined = false;
    judge(work);
    for (size_t i = 0; i < work->pair_count; i++) {
        const struct pair *pair = &work->pairs[i];
        if (work->widest[pair->a] < WIDE || work->best[pair->a] != i || work->best[pair->b] != i) continue;
        work->leaders[pair->b] = pair->a;
        work->volumes[pair->a] += work->volumes[pair->b];
        joined = true;
    }
    return joined;
}

/* A small cell that leads out of its zone is a doorway: from inside of it one sees far into both rooms, so it must not
 * speak for a room. */
static bool is_doorway(struct joining *work, uint32_t index)
{
    const struct cell *cell = &work->cells->items[index];
    const uint32_t leader = leader_of(work, index);
    double all = 0, out = 0;
    if (!is_place(cell) || cell->volume > DOORWAY_VOLUME * work->volumes[leader]) return false;
    for (size_t i = 0; i < cell->opening_count; i++) {
        const struct opening *opening = &work->cells->openings[cell->first_opening + i];
        const double area = patch_area(&opening->patch, &opening->flat);
        all += area;
        if (leader_of(work, opening->to) != leader) out += area;
    }
    return out > DOORWAY_OPEN * all;
}

static void doorways_part(struct joining *work)
{
    bool *parted = grow_zeroed(work->cells->count, sizeof *parted);
    uint32_t *leaders = grow_zeroed(work->cells->count, sizeof *leaders);
    for (uint32_t i = 0; i < work->cells->count; i++) {
        parted[i] = is_doorway(work, i);
        leaders[i] = leader_of(work, i);
    }
    for (uint32_t i = 0; i < work->cells->count; i++) /* a leader that parts leaves its zone to the next cell */
        if (parted[i] && leaders[i] == i) {
            uint32_t heir = ZONE_NONE;
            for (uint32_t k = 0; k < work->cells->count; k++)
                if (leaders[k] == i && !parted[k]) heir = leaders[k] = heir == ZONE_NONE ? k : heir;
        }
    for (uint32_t i = 0; i < work->cells->count; i++)
        work->leaders[i] = parted[i] ? i : leaders[i];
    free(parted);
    free(leaders);
}

static void number(struct joining *work, struct zones *out)
{
    uint32_t *numbers = grow_zeroed(work->cells->count, sizeof *numbers);
    size_t *filled;
    for (uint32_t i = 0; i < work->cells->count; i++)
        if (is_place(&work->cells->items[i]) && leader_of(work, i) == i) numbers[i] = (uint32_t)out->count++;
    out->first = grow_zeroed(out->count + 1, sizeof *out->first);
    filled = grow_zeroed(out->count + 1, sizeof *filled);
    for (uint32_t i = 0; i < work->cells->count; i++) {
        out->of_cell[i] = is_place(&work->cells->items[i]) ? numbers[leader_of(work, i)] : ZONE_NONE;
        if (out->of_cell[i] != ZONE_NONE) out->first[out->of_cell[i] + 1]++;
    }
    for (size_t z = 0; z < out->count; z++)
        out->first[z + 1] += out->first[z];
    for (uint32_t i = 0; i < work->cells->count; i++) {
        const uint32_t zone = out->of_cell[i];
        if (zone != ZONE_NONE) out->cells[out->first[zone] + filled[zone]++] = i;
    }
    free(numbers);
    free(filled);
}

void zones_find(const struct cells *cells, struct zones *out)
{
    struct joining work = {.cells = cells};
    *out = (struct zones){.of_cell = grow_zeroed(cells->count, sizeof *out->of_cell),
                          .cells = grow_zeroed(cells->count, sizeof *out->cells)};
    work.leaders = grow_zeroed(cells->count, sizeof *work.leaders);
    work.volumes = grow_zeroed(cells->count, sizeof *work.volumes);
    work.widest = grow_zeroed(cells->count, sizeof *work.widest);
    work.best = grow_zeroed(cells->count, sizeof *work.best);
    work.pairs = grow_zeroed(cells->opening_count, sizeof *work.pairs);
    for (uint32_t i = 0; i < cells->count; i++)
        work.leaders[i] = i, work.volumes[i] = cells->items[i].volume;
    pairs_begin(&work);
    while (join_round(&work))
        pairs_renew(&work);
    doorways_part(&work);
    number(&work, out);
    free(work.leaders);
    free(work.volumes);
    free(work.widest);
    free(work.best);
    free(work.pairs);
}

void zones_free(struct zones *zones)
{
    free(zones->of_cell);
    free(zones->cells);
    free(zones->first);
    *zones = (struct zones){0};
}
