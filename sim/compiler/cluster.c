/* SPDX-License-Identifier: MIT
 *
 * An eye that sees both p and q is in front of both planes. Let a ray from it meet p, then q: it meets p where it
 * is still in front of q's plane, and q where it is behind p's already. So p can hide q only if p has a part in
 * front of q's plane and q has a part behind p's plane. An order in which p comes before q wherever that holds is
 * right from everywhere; it exists if the relation has no ring. */
#include "compiler/cluster.h"

#include "base/deadline.h"
#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

/* hides[p * count + q]: p can hide q, both numbers in the list. */
struct relation {
    uint8_t *hides;
    size_t count;
    uint32_t *hidden_by; /* how many that are not yet in order can hide this one */
};

/* Where a piece lies as the face of another sees it: a two-sided face sees, and hides, both ways. */
static int sides_of_face(const struct bsp *bsp, const struct bsp_piece *piece, const struct bsp_piece *face)
{
    const uint32_t group = bsp->coplanar->group[face->polygon];
    if (bsp->coplanar->group[piece->polygon] == group) return BSP_ON;
    const int sides = bsp_piece_sides(bsp, piece, bsp_plane(bsp, group));
    if (sides == BSP_ON) return BSP_ON;
    if (bsp->mesh->polygons[face->polygon].two_sided) return BSP_BOTH;
    if (sides == BSP_BOTH || !bsp->coplanar->faces_back[face->polygon]) return sides;
    return sides == BSP_FRONT ? BSP_BACK : BSP_FRONT;
}

struct cluster_pair cluster_pair(const struct bsp *bsp, uint32_t p, uint32_t q)
{
    const int p_from_q = sides_of_face(bsp, &bsp->pieces[p], &bsp->pieces[q]);
    const int q_from_p = sides_of_face(bsp, &bsp->pieces[q], &bsp->pieces[p]);
    return (struct cluster_pair){(p_from_q & BSP_FRONT) && (q_from_p & BSP_BACK),
                                 (q_from_p & BSP_FRONT) && (p_from_q & BSP_BACK)};
}

static void relate(struct relation *relation, const struct bsp *bsp, const uint32_t *list, size_t p, size_t q)
{
    const struct cluster_pair pair = cluster_pair(bsp, list[p], list[q]);
    relation->hides[p * relation->count + q] = pair.p_hides_q;
    relation->hides[q * relation->count + p] = pair.q_hides_p;
    relation->hidden_by[q] += pair.p_hides_q;
    relation->hidden_by[p] += pair.q_hides_p;
}

/* The first in the list that none left can hide; `count`: there is none. */
static size_t next_free(const struct relation *relation, const bool *taken)
{
    size_t p = 0;
    while (p < relation->count && (taken[p] || relation->hidden_by[p]))
        p++;
    return p;
}

static bool sort(struct relation *relation, const uint32_t *list, uint32_t *order)
{
    bool *taken = grow_zeroed(relation->count, sizeof *taken);
    size_t done = 0;
    for (size_t p; done < relation->count; done++) {
        p = next_free(relation, taken);
        if (p == relation->count) break;
        taken[p] = true;
        order[done] = list[p];
        for (size_t q = 0; q < relation->count; q++)
            relation->hidden_by[q] -= relation->hides[p * relation->count + q];
    }
    free(taken);
    return done == relation->count;
}

static void relation_make(struct relation *relation, const struct bsp *bsp, const uint32_t *list, size_t count)
{
    *relation = (struct relation){grow_zeroed(count * count, 1), count, grow_zeroed(count, sizeof(uint32_t))};
    for (size_t p = 0; p < count && !deadline_passed(); p++)
        for (size_t q = p + 1; q < count; q++)
            relate(relation, bsp, list, p, q);
}

static void relation_free(struct relation *relation)
{
    free(relation->hides);
    free(relation->hidden_by);
}

bool cluster_order(const struct bsp *bsp, const uint32_t *list, size_t count, uint32_t *order)
{
    struct relation relation;
    relation_make(&relation, bsp, list, count);
    const bool sorted = sort(&relation, list, order);
    relation_free(&relation);
    return sorted;
}
