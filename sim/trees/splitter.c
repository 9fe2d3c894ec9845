/* SPDX-License-Identifier: MIT
 *
 * Greedy choice: every candidate plane is tried on the list and the cheapest wins. Candidates are
 * the planes of the groups in the list, a regular sample of them when the list is long, or a few at random. */
#include "trees/splitter.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "trees/bsp.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Pieces tried against planes at one node: bounds the time on long lists. Of very long ones some pieces stand for all,
 * else too few candidates could be tried to find a good one. */
enum { TRIALS_A_NODE = 100000, LONG_LIST = 8192, SAMPLE = 2048 };

const struct splitter splitters[] = {
    {"first", 0.0, 0.0, 0.0, 0.0, false, false, 0},        {"fewest", 1000.0, 1.0, 1.0, 0.0, true, false, 0},
    {"weighted-2", 2.0, 1.0, 1.0, 0.0, false, false, 0},   {"weighted-8", 8.0, 1.0, 1.0, 0.0, false, true, 0},
    {"weighted-12", 12.0, 1.0, 1.0, 0.5, false, true, 0},  {"weighted-20", 20.0, 1.0, 1.0, 1.0, true, true, 0},
    {"weighted-32", 32.0, 1.0, 1.0, 0.0, false, false, 0}, {"weighted-64", 64.0, 1.0, 1.0, 0.5, false, false, 0},
    {"balanced", 0.0, 1.0, 0.0, 0.0, false, false, 0},     {"sampled", 12.0, 1.0, 1.0, 0.5, false, false, 5},
};
const size_t splitter_count = sizeof splitters / sizeof *splitters;
const struct splitter *const splitter_scout = &splitters[5];

const char *const splitter_names[] = {"auto", "first", "fewest", "balanced", "weighted", "sampled"};
const size_t splitter_name_count = sizeof splitter_names / sizeof *splitter_names;

bool splitter_answers(const struct splitter *splitter, const char *name)
{
    const bool weighted = strncmp(splitter->name, "weighted-", 9) == 0;
    if (strcmp(name, "weighted") == 0) return weighted;
    if (strcmp(name, "auto") == 0) return weighted || strcmp(splitter->name, "fewest") == 0;
    return strcmp(splitter->name, name) == 0;
}

bool splitter_check(const char *name, struct error *err)
{
    for (size_t i = 0; i < splitter_count; i++)
        if (splitter_answers(&splitters[i], name)) return true;
    return error_set(
        err, "--splitter %s: no such heuristic; there are auto, first, fewest, balanced, weighted and sampled", name);
}

static uint32_t piece_group(const struct bsp *bsp, uint32_t piece)
{
    return bsp->coplanar->group[bsp->pieces[piece].polygon];
}

/* Dearer kinds cost bytes and time on the way; a fraction of a split decides between equals. */
static double kind_cost(enum plane_kind kind)
{
    static const double cost[] = {0.0, 0.0, 0.0, 1.0, 1.5, 3.0};
    return cost[kind];
}

double splitter_cost(const struct splitter *splitter, enum plane_kind kind, const struct splitter_tally *tally,
                     size_t count)
{
    const double front = (double)tally->front, back = (double)tally->back;
    double cost = kind_cost(kind) + (double)tally->splits * splitter->split_cost +
                  fabs(front - back) * splitter->imbalance_cost - (double)tally->on * splitter->coplanar_gain;
    if (count > 40 && fmin(front, back) * 10.0 < (double)count) cost += splitter->lopsided_cost * (double)count;
    return cost;
}

/* The cost of dividing the list by a group's plane; may stop early once it exceeds `limit`. */
static double division_cost(const struct splitter *splitter, const struct bsp *bsp, const uint32_t *list, size_t count,
                            uint32_t group, double limit)
{
    const struct plane *plane = &bsp->coplanar->planes[group];
    const double least = kind_cost(plane->kind) - splitter->coplanar_gain * (double)count;
    struct splitter_tally tally = {0};
    for (size_t i = 0; i < count && least + (double)tally.splits * splitter->split_cost <= limit; i++) {
        if (piece_group(bsp, list[i]) == group) {
            tally.on++;
            continue;
        }
        int sides = bsp_piece_sides(bsp, &bsp->pieces[list[i]], plane);
        tally.splits += sides == BSP_BOTH;
        tally.front += sides == BSP_FRONT;
        tally.back += sides == BSP_BACK;
    }
    return splitter_cost(splitter, plane->kind, &tally, count);
}

/* The distinct groups of a list, in its order. The caller frees them. */
static uint32_t *list_groups(const struct bsp *bsp, const uint32_t *list, size_t count, size_t *group_count)
{
    uint32_t *groups = grow_zeroed(count, sizeof *groups);
    struct map seen = {0};
    *group_count = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t group = piece_group(bsp, list[i]);
        if (*map_at(&seen, group, (uint32_t)*group_count) == *group_count) groups[(*group_count)++] = group;
    }
    map_free(&seen);
    return groups;
}

/* The same list gives the same numbers. */
static uint64_t random_next(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * UINT64_C(0x2545F4914F6CDD1D) >> 32;
}

static uint32_t cheapest(const struct splitter *splitter, const struct bsp *bsp, const uint32_t *list, size_t count,
                         double *best_cost)
{
    size_t group_count, affordable = TRIALS_A_NODE / count;
    uint32_t *groups = list_groups(bsp, list, count, &group_count);
    size_t tries = group_count < affordable ? group_count : affordable;
    uint64_t state = UINT64_C(0x9E3779B97F4A7C15) + count + ((uint64_t)list[0] << 32);
    if (splitter->samples) tries = splitter->samples;
    uint32_t best = groups[0];
    *best_cost = DBL_MAX;
    for (size_t i = 0; i < tries && !(i && deadline_passed()); i++) {
        uint32_t group = groups[splitter->samples ? random_next(&state) % group_count : i * group_count / tries];
        double cost = division_cost(splitter, bsp, list, count, group, *best_cost);
        if (cost < *best_cost) best = group;
        *best_cost = fmin(cost, *best_cost);
    }
    free(groups);
    return best;
}

/* Every so many pieces of the list. */
static uint32_t cheapest_of_sample(const struct splitter *splitter, const struct bsp *bsp, const uint32_t *list,
                                   size_t count, double *best_cost)
{
    uint32_t sample[SAMPLE];
    for (size_t i = 0; i < SAMPLE; i++)
        sample[i] = list[i * count / SAMPLE];
    const uint32_t best = cheapest(splitter, bsp, sample, SAMPLE, best_cost);
    *best_cost *= (double)count / SAMPLE;
    return best;
}

uint32_t splitter_choose(const struct splitter *splitter, const struct bsp *bsp, const uint32_t *list, size_t count,
                         double *cost)
{
    *cost = 0.0;
    if (splitter == &splitters[0] || count == 1) return piece_group(bsp, list[0]);
    return count > LONG_LIST ? cheapest_of_sample(splitter, bsp, list, count, cost)
                             : cheapest(splitter, bsp, list, count, cost);
}
