/* SPDX-License-Identifier: MIT
 *
 * The left side of the open rectangle is x - l z >= 0 in view space, l in -1..1 the screen position
 * of the left edge of its first pixel: half a pixel outside the first pixel's centre. The normal is
 * row x of the view matrix minus l times row z, kept with two bits less so that a box test fits 32
 * bits: its length is at most scale / 2, a box's centre is as far as the scene's far end, whose distance times
 * scale is below 2^31, and its half diagonal below 56,756 units: 2^30 + 56,756 * 2^14 < 2^31.
 *
 * Slack, in units of the offset's last place; let D be the distance of the scene's far end. Each component of
 * the normal is off by at most 5/8 (1/2 from its own rounding, 1/8 from the product's), times a sum of three
 * distances below sqrt(3) D. l is off by 2^-15, times z * 2^13. The eye of the view matrix, which is
 * not quite the camera's when that is outside of the scene's box (rows.c), moves row and ahead by at
 * most 1/8 each, times sqrt(3) D. Together below 1.8 D. */
#include "view/cull.h"

#include "math/fixed.h"

enum { CULL_DROPPED_BITS = 2, MARGIN_Q14 = LIM_SUB_BITS ? 0 : 1 << (14 - LIM_DRAFT_MARGIN_BITS) };

/* Position of pixel edge i of n on the screen, -1..1, rounded to nearest. */
/*@ requires 1 <= n <= 1024 && i <= n;
    assigns \nothing;
    ensures -16384 <= \result <= 16384; */
static int32_t edge_q14(uint16_t i, int32_t n)
{
    return ((int32_t)i * 32768 + n / 2) / n - 16384;
}

/* How many times, as a power of two, the row of z is longer than what `row` is compared with. */
static inline uint8_t bits_of_z(const struct lim_view *view, uint8_t row)
{
    return (uint8_t)(view->rows.tele_bits + (LIM_HAS_TELE ? view->rows.zoom_bits[row] : 0));
}

/* sign * (row - l * ahead). The offset's value fits 32 bits: see above. */
static void set_plane(struct lim_cull_plane *plane, const struct lim_view *view, const int32_t eye_q8[3], uint8_t row,
                      int32_t l_q14, int8_t sign)
{
    uint32_t offset = 2 * view->rows.far_units; /* sums wrap on the way */
    int32_t below_q8 = 0;                       /* of the eye's fractions */

    for (uint8_t i = 0; i < 3; i++) {
        const int32_t ahead =
            shift_round_s32(l_q14 * (int32_t)view->rows.row[2].n_qv[i], (uint8_t)(14 + bits_of_z(view, row)));
        const int32_t n = sign * ((int32_t)view->rows.row[row].n_qv[i] - ahead);
        plane->n[i] = (int16_t)shift_round_s32(n, CULL_DROPPED_BITS);
        offset -= (uint32_t)plane->n[i] * (uint32_t)(eye_q8[i] >> 8);
        below_q8 -= plane->n[i] * (eye_q8[i] & 0xFF);
    }
    plane->offset = (int32_t)(offset + (uint32_t)(below_q8 >> 8));
    plane->inside_depth = LIM_NONE;
}

void lim_cull_set(struct lim_cull *cull, const struct lim_view *view, const int32_t eye_q8[3],
                  const struct lim_rect *open)
{
    set_plane(&cull->sides[0], view, eye_q8, 0, edge_q14(open->x0, view->width.px), 1);
    set_plane(&cull->sides[1], view, eye_q8, 0, edge_q14(open->x1, view->width.px) + MARGIN_Q14, -1);
    set_plane(&cull->sides[2], view, eye_q8, 1, edge_q14(open->y0, view->height.px), 1);
    set_plane(&cull->sides[3], view, eye_q8, 1, edge_q14(open->y1, view->height.px) + MARGIN_Q14, -1);
    cull->inside_depth = LIM_NONE;
}

enum { OUTSIDE = 0, ACROSS, INSIDE };

/* By the corners that are farthest and nearest along the normal. Sums wrap on the way; their values fit. */
/*@ requires \valid_read(plane) && \valid_read(box);
    assigns \nothing;
    ensures 0 <= \result <= 2; */
static LIM_HOT_INLINE uint8_t side_of(const struct lim_cull_plane *plane, const LIM_FLASH struct lim_box *box)
{
    uint32_t middle = (uint32_t)plane->offset, reach = 0;

    LIM_HOT_UNROLLED(3)
    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t n = plane->n[i];
        middle += (uint32_t)(n * box->centre[i]);
        reach += abs_s32(n) * box->half[i];
    }
    if ((int32_t)(middle + reach) < 0) return OUTSIDE;
    return (int32_t)(middle - reach) < 0 ? ACROSS : INSIDE;
}

/*@ requires \valid_read(cull) && \valid_read(box);
    assigns \nothing; */
bool lim_cull_sees(const struct lim_cull *cull, const LIM_FLASH struct lim_box *box)
{
    /*@ loop invariant 0 <= i <= 4;
        loop assigns i;
        loop variant 4 - i; */
    for (uint8_t i = 0; i < 4; i++) {
        if (side_of(&cull->sides[i], box) == OUTSIDE) return false;
    }
    return true;
}

/*@ requires \valid(cull) && \valid_read(box) && \separated(cull, box);
    assigns cull->sides[0 .. 3].inside_depth, cull->inside_depth; */
bool lim_cull_enters(struct lim_cull *cull, const LIM_FLASH struct lim_box *box, uint16_t depth)
{
    uint16_t deepest = 0;

    LIM_UNROLLED(4)
    /*@ loop invariant 0 <= i <= 4;
        loop assigns i, deepest, cull->sides[0 .. 3].inside_depth;
        loop variant 4 - i; */
    for (uint8_t i = 0; i < 4; i++) {
        struct lim_cull_plane *plane = &cull->sides[i];
        uint16_t inside_depth = plane->inside_depth;
        if (inside_depth > depth) {
            const uint8_t side = side_of(plane, box);
            if (side == OUTSIDE) return false;
            plane->inside_depth = inside_depth = side == INSIDE ? depth : (uint16_t)LIM_NONE;
        }
        if (inside_depth > deepest) deepest = inside_depth;
    }
    cull->inside_depth = deepest;
    return true;
}
