/* SPDX-License-Identifier: MIT
 *
 * An edge from (ax, ay) down to (bx, by), all in sub-pixels, S of them in a pixel, meets line y at
 * N / dy with N = ax dy + dx (y S - ay). The first pixel centre at or right of it is
 * x = ceil(N / (S dy)) = ceil(M / dy) with M = ceil(N / S): a ceiling of a ceiling. M takes an edge from
 * line to line by adding dx, and needs S times less room than N: with ax = wx S + px, ay = wy S + py
 *
 *     M = wx dy + dx (y - wy) + ceil((px dy - dx py) / S)
 *
 * Range: the intersection lies between the end points, so |M| <= 1.5 w * 2 h S: below 2^31 for 1024
 * pixels a side and 9 sub-pixel bits, and 64 bits do beyond. The sum may wrap on the way. px, py < S and
 * |dx|, dy <= 2 * 1024 S: the last term's numerator stays below 2^30. */
#include "edge.h"

/* The first line at or below y. */
/*@ requires -8388608 <= y <= 8388608;
    assigns \nothing; */
static inline int16_t line_of(lim_sub y)
{
    return (int16_t)(((y + (LIM_SUB - 1)) >> LIM_SUB_BITS) + LIM_ORIGIN_PX);
}

/* M above, for line y from the origin. */
/*@ requires -2 * 1024 * LIM_SUB <= dx <= 2 * 1024 * LIM_SUB && 0 < dy <= 2 * 1024 * LIM_SUB;
    requires -8388608 <= a.x <= 8388608 && -8388608 <= a.y <= 8388608;
    assigns \nothing; */
static inline lim_sub_area meeting(struct lim_point a, int32_t dx, int32_t dy, int16_t y)
{
    const int32_t part_x = a.x & (LIM_SUB - 1), part_y = a.y & (LIM_SUB - 1);
    //@ assert 0 <= part_x * dy <= 2048 * LIM_SUB * LIM_SUB;
    //@ assert -2048 * LIM_SUB * LIM_SUB <= part_y * dx <= 2048 * LIM_SUB * LIM_SUB;
    const lim_sub_area part = (lim_sub_area)part_x * dy - (lim_sub_area)part_y * dx;
    const lim_sub_wrap whole = (lim_sub_wrap)(a.x >> LIM_SUB_BITS) * (lim_sub_wrap)dy +
                               (lim_sub_wrap)(y - (a.y >> LIM_SUB_BITS)) * (lim_sub_wrap)dx;

    return (lim_sub_area)(whole + (lim_sub_wrap)((part + (LIM_SUB - 1)) >> LIM_SUB_BITS));
}

/*@ requires \valid(edge) && a.y < b.y && -2 * 1024 * LIM_SUB <= b.x - a.x <= 2 * 1024 * LIM_SUB;
    requires b.y - a.y <= 2 * 1024 * LIM_SUB && -8388608 <= a.x <= 8388608 && -8388608 <= a.y <= 8388608;
    assigns *edge;
    ensures edge->denominator > 0 && -edge->denominator < edge->error <= 0;
    ensures 0 <= edge->step_error < edge->denominator; */
static void edge_set(struct lim_edge *edge, struct lim_point a, struct lim_point b, int16_t y, int16_t end)
{
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    const lim_sub_area m = meeting(a, dx, dy, (int16_t)(y - LIM_ORIGIN_PX));
    int32_t x = (int32_t)(m / dy); /* rounds to zero: up, if negative */
    int32_t error = (int32_t)(m - (lim_sub_area)x * dy);

    if (error > 0) {
        x++;
        error -= dy;
    }
    edge->x = (int16_t)(x + LIM_ORIGIN_PX);
    edge->error = error;
    edge->denominator = dy;
    edge->step_x = 0;
    edge->step_error = 0;
    if (end - y < 2) return; /* never stepped */
    int32_t step = dx / dy;
    int32_t rest = dx - step * dy;
    if (rest < 0) {
        step--;
        rest += dy;
    }
    edge->step_x = (int16_t)step;
    edge->step_error = rest;
}

/* The left boundary runs forward through the vertices, the right one backward. */
static void turn_left(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    uint8_t from, to = pair->left_at;
    int16_t end;

    do {
        from = to;
        to = (uint8_t)(to + 1 == n ? 0 : to + 1);
        end = line_of(at[to].y);
    } while (end <= y);
    edge_set(&pair->left, at[from], at[to], y, end);
    pair->left_at = to;
    pair->left_end = end;
}

static void turn_right(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    uint8_t from, to = pair->right_at;
    int16_t end;

    do {
        from = to;
        to = (uint8_t)(to == 0 ? n - 1 : to - 1);
        end = line_of(at[to].y);
    } while (end <= y);
    edge_set(&pair->right, at[from], at[to], y, end);
    pair->right_at = to;
    pair->right_end = end;
}

static int16_t next_turn(const struct lim_edge_pair *pair)
{
    return pair->left_end < pair->right_end ? pair->left_end : pair->right_end;
}

void lim_edge_begin(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, uint8_t first, int16_t y)
{
    pair->left_at = first;
    pair->right_at = first;
    turn_left(pair, at, n, y);
    turn_right(pair, at, n, y);
}

int16_t lim_edge_turn(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    if (pair->left_end <= y) turn_left(pair, at, n, y);
    if (pair->right_end <= y) turn_right(pair, at, n, y);
    return next_turn(pair);
}

/* A folded polygon has more than one local extreme of either kind. Where the extra ones lie near
 * its top, a fan from the bottom sees every other corner, and the other way round. */
static uint8_t choose_apex(const struct lim_point *at, uint8_t n, uint8_t top_at, uint8_t bottom_at)
{
    int16_t highest_bottom = INT16_MAX, lowest_top = INT16_MIN;

    for (uint8_t k = 0; k < n; k++) {
        const int16_t before = line_of(at[k == 0 ? n - 1 : k - 1].y), here = line_of(at[k].y);
        const int16_t after = line_of(at[k + 1 == n ? 0 : k + 1].y);
        if (here >= before && here >= after && here < highest_bottom) highest_bottom = here;
        if (here <= before && here <= after && here > lowest_top) lowest_top = here;
    }
    const int16_t top = line_of(at[top_at].y), bottom = line_of(at[bottom_at].y);
    return highest_bottom - top < bottom - lowest_top ? bottom_at : top_at;
}

/* The boundary's direction, down (1) or up (-1), changes twice on a plain polygon, once around. */
void lim_edge_measure(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    int8_t first_direction = 0, direction = 0;
    uint8_t turns = 0, top_at = 0, bottom_at = 0;
    int16_t before = line_of(at[n - 1].y), top = INT16_MAX, bottom = INT16_MIN;
    lim_sub left = at[0].x, right = at[0].x;

    for (uint8_t k = 0; k < n; k++) {
        const int16_t line = line_of(at[k].y);
        const int8_t now = (int8_t)((line > before) - (line < before));

        if (now && direction && now != direction) turns++;
        if (now && !direction) first_direction = now;
        if (now) direction = now;
        if (line < top) top = line, top_at = k;
        if (line > bottom) bottom = line, bottom_at = k;
        if (at[k].x < left) left = at[k].x;
        if (at[k].x > right) right = at[k].x;
        before = line;
    }
    turns = (uint8_t)(turns + (direction != first_direction));
    shape->top = top;
    shape->bottom = bottom;
    shape->left = line_of(left);
    shape->right = line_of(right);
    shape->first = top_at;
    shape->folded = turns > 2;
    shape->apex = shape->folded ? choose_apex(at, n, top_at, bottom_at) : 0;
}
