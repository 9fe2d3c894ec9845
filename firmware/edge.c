/* SPDX-License-Identifier: MIT
 *
 * An edge from (ax, ay) down to (bx, by), all in sub-pixels, S of them in a pixel, meets line y at
 * N / dy with N = ax dy + dx (y S - ay). The first pixel centre at or right of it is
 * x = ceil(N / (S dy)), and N - x S dy is the error. A line further down N grows by dx S.
 *
 * Range: the intersection lies between the end points, so |N| <= 1.5 w S * 2 h S: below 2^31 for
 * 341 pixels a side. The sum may wrap on the way. S dy < 2^21 there, 2^24 for 1024 pixels. */
#include "edge.h"

/* The first line at or below y. */
static inline int16_t line_of(lim_sub y)
{
    return (int16_t)((y + (LIM_SUB - 1)) >> LIM_SUB_BITS);
}

/* a b + c d, whose value fits although the sum may wrap on the way. */
static inline lim_sub_area sum_of_products(lim_sub_area a, lim_sub_area b, lim_sub_area c, lim_sub_area d)
{
    return (lim_sub_area)((lim_sub_wrap)a * (lim_sub_wrap)b + (lim_sub_wrap)c * (lim_sub_wrap)d);
}

static void edge_set(struct lim_edge *edge, struct lim_point a, struct lim_point b, int16_t y, int16_t end)
{
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    const lim_sub_area n = sum_of_products(a.x, dy, dx, y * LIM_SUB - a.y);
    const int32_t denominator = dy * LIM_SUB;
    int32_t x = (int32_t)(n / denominator); /* rounds to zero: up, if negative */
    int32_t error = (int32_t)(n - (lim_sub_area)x * denominator);

    if (error > 0) {
        x++;
        error -= denominator;
    }
    edge->x = (int16_t)x;
    edge->error = error;
    edge->denominator = denominator;
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
    edge->step_error = rest * LIM_SUB;
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
