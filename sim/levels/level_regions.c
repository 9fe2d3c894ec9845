/* SPDX-License-Identifier: MIT
 *
 * A region is what no line divides. Each line on its border says which sector it is of, and mostly all say the same:
 * else the sector has it that most of its border names, by length. There are maps with lines that name one sector on
 * both sides and lie within another one; the engine shows things there that no surfaces can be.
 *
 * The region that reaches to the frame is outside of the map. If lines name sectors on its border, these are open;
 * there each triangle takes the sector of the nearest of its neighbours that has one. */
#include "levels/level_regions.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

static const uint32_t UNKNOWN = UINT32_MAX - 1;

/* What an edge's line says of the triangle beside it. */
struct vote {
    uint32_t region, sector, triangle, line;
    double length;
};

struct finding {
    const struct level *level;
    struct level_sectors *sectors;
    uint32_t *region_of; /* of each triangle */
    uint32_t *queue;     /* of triangles */
    struct vote *votes;
    size_t vote_count, vote_capacity;
    uint32_t outside; /* the region */
};

/* Regions ------------------------------------------------------------------------------------ */

/* Spreads a number over triangles from those in the queue, across what is no line. */
static void spread(const struct finding *finding, uint32_t *numbers, size_t count)
{
    const struct triangles *triangles = &finding->sectors->triangles;
    for (size_t first = 0; first < count; first++) {
        const uint32_t triangle = finding->queue[first];
        for (uint32_t half = 3 * triangle; half < 3 * triangle + 3; half++) {
            const uint32_t twin = triangles->twin[half];
            if (twin == TRIANGLES_NONE || triangles->is_fixed[half] || numbers[twin / 3] != UNKNOWN) continue;
            numbers[twin / 3] = numbers[triangle];
            finding->queue[count++] = twin / 3;
        }
    }
}

static void find_regions(struct finding *finding)
{
    const struct triangles *triangles = &finding->sectors->triangles;
    const uint32_t count = triangles->half_count / 3;
    uint32_t region = 0;
    for (uint32_t i = 0; i < count; i++)
        finding->region_of[i] = UNKNOWN;
    for (uint32_t i = 0; i < count; i++) {
        if (finding->region_of[i] != UNKNOWN) continue;
        finding->region_of[i] = region++;
        finding->queue[0] = i;
        spread(finding, finding->region_of, 1);
    }
    for (uint32_t half = 0; half < triangles->half_count; half++)
        if (triangles->twin[half] == TRIANGLES_NONE) finding->outside = finding->region_of[half / 3];
}

/* Votes -------------------------------------------------------------------------------------- */

static void vote(struct finding *finding, uint32_t half, uint32_t line, uint16_t side)
{
    const struct triangles *triangles = &finding->sectors->triangles;
    const int32_t *a = triangles->points[triangles->origin[half]],
                  *b = triangles->points[triangles->origin[half_next(half)]];
    finding->votes = grow(finding->votes, finding->vote_count, &finding->vote_capacity, sizeof *finding->votes);
    finding->votes[finding->vote_count++] =
        (struct vote){.region = finding->region_of[half / 3],
                      .sector = side == LEVEL_NO_SIDE ? LEVEL_VOID : finding->level->sides[side].sector,
                      .triangle = half / 3,
                      .line = line,
                      .length = hypot(b[0] - a[0], b[1] - a[1])};
}

static void vote_all(struct finding *finding)
{
    const struct triangles *triangles = &finding->sectors->triangles;
    for (uint32_t i = 0; i < finding->level->line_count; i++) {
        const struct level_line *line = &finding->level->lines[i];
        uint32_t from = finding->sectors->points[line->from];
        const uint32_t to = finding->sectors->points[line->to];
        while (from != to) {
            const uint32_t half = triangles_along(triangles, from, to);
            if (half == TRIANGLES_NONE || !triangles->is_fixed[half]) break;
            vote(finding, triangles->twin[half], i, line->sides[0]);
            vote(finding, half, i, line->sides[1]);
            from = triangles->origin[half_next(half)];
        }
    }
}

static int by_sector(const void *left, const void *right)
{
    const struct vote *a = left, *b = right;
    if (a->region != b->region) return a->region < b->region ? -1 : 1;
    if (a->sector != b->sector) return a->sector < b->sector ? -1 : 1;
    if (a->line != b->line) return a->line < b->line ? -1 : 1;
    return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* Votes of one region, from `first` on, whose sectors come one after the other: the one with most. */
static uint32_t elect(const struct finding *finding, size_t first, size_t end)
{
    double most = -1, sum = 0;
    uint32_t elected = LEVEL_VOID;
    for (size_t i = first; i < end; i++) {
        sum = i > first && finding->votes[i].sector == finding->votes[i - 1].sector ? sum : 0;
        sum += finding->votes[i].length;
        if (sum <= most) continue;
        most = sum;
        elected = finding->votes[i].sector;
    }
    return elected;
}

static void note_astray(struct level_sectors *sectors, uint32_t line)
{
    if (!sectors->astray_count++ || line < sectors->first_astray) sectors->first_astray = line;
}

/* Of a closed region. */
static void settle_region(const struct finding *finding, uint32_t *elected, size_t first, size_t end)
{
    const uint32_t sector = elect(finding, first, end);
    elected[finding->votes[first].region] = sector;
    for (size_t i = first; i < end; i++)
        if (finding->votes[i].sector != sector) note_astray(finding->sectors, finding->votes[i].line);
}

/* Of the region outside: sectors that are named there spread from their lines, as what is outside does from the frame.
 */
static void settle_outside(const struct finding *finding, size_t first, size_t end)
{
    struct level_sectors *sectors = finding->sectors;
    const struct triangles *triangles = &sectors->triangles;
    size_t count = 0;
    for (uint32_t i = 0; i < triangles->half_count / 3; i++)
        if (finding->region_of[i] == finding->outside) sectors->sector_of[i] = UNKNOWN;
    for (uint32_t half = 0; half < triangles->half_count; half++) {
        if (triangles->origin[half] >= TRIANGLES_FRAME || sectors->sector_of[half / 3] != UNKNOWN) continue;
        sectors->sector_of[half / 3] = LEVEL_VOID;
        finding->queue[count++] = half / 3;
    }
    for (size_t i = first; i < end; i++) {
        const struct vote *at = &finding->votes[i];
        const bool is_new = i == first || at->sector != at[-1].sector;
        if (at->sector != LEVEL_VOID && is_new && !sectors->open_count++) sectors->first_open = at->sector;
        if (sectors->sector_of[at->triangle] != UNKNOWN) continue;
        sectors->sector_of[at->triangle] = at->sector;
        finding->queue[count++] = at->triangle;
    }
    spread(finding, sectors->sector_of, count);
}

static void settle(struct finding *finding)
{
    struct level_sectors *sectors = finding->sectors;
    const uint32_t count = sectors->triangles.half_count / 3;
    uint32_t *elected = grow_zeroed(count, sizeof *elected); /* of each region, of which there are no more */
    size_t outside = 0, outside_end = 0;
    for (uint32_t i = 0; i < count; i++)
        elected[i] = LEVEL_VOID;
    if (finding->vote_count) qsort(finding->votes, finding->vote_count, sizeof *finding->votes, by_sector);
    for (size_t first = 0, end; first < finding->vote_count; first = end) {
        for (end = first + 1; end < finding->vote_count && finding->votes[end].region == finding->votes[first].region;)
            end++;
        if (finding->votes[first].region != finding->outside) {
            settle_region(finding, elected, first, end);
            continue;
        }
        outside = first;
        outside_end = end;
    }
    for (uint32_t i = 0; i < count; i++)
        sectors->sector_of[i] = elected[finding->region_of[i]];
    settle_outside(finding, outside, outside_end);
    free(elected);
}

void level_regions_find(const struct level *level, struct level_sectors *sectors)
{
    const uint32_t count = sectors->triangles.half_count / 3;
    struct finding finding = {.level = level, .sectors = sectors};
    finding.region_of = grow_zeroed(count, sizeof *finding.region_of);
    finding.queue = grow_zeroed(count, sizeof *finding.queue);
    sectors->sector_of = grow_zeroed(count, sizeof *sectors->sector_of);
    find_regions(&finding);
    vote_all(&finding);
    settle(&finding);
    free(finding.region_of);
    free(finding.queue);
    free(finding.votes);
}
