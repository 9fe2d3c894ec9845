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
 * |dx|, dy <= 2050 S (perspective.h): the last term's numerator stays below 2^31. */
#include "edge.h"

#include "fixed.h"

/* Neither is a quotient in here longer than the guard band is wide, nor, on small screens, a divisor than 16 bits. */
#define EDGE_MOST_PX (2 * LIM_MAX_SIDE_PX + 2)
#define EDGE_IS_SHORT (LIM_8_BIT && EDGE_MOST_PX < 512 && EDGE_MOST_PX <= UINT16_MAX >> LIM_SUB_BITS)

/* A coordinate and what is added to it, or a line from the origin. */
#if EDGE_IS_SHORT
typedef int16_t edge_sub;
#define EDGE_SUB_MIN INT16_MIN
#define EDGE_SUB_MAX INT16_MAX
#define EDGE_SHIFT(area) shift_s32(area, LIM_SUB_BITS)
#else
typedef int32_t edge_sub;
#define EDGE_SUB_MIN INT32_MIN
#define EDGE_SUB_MAX INT32_MAX
#define EDGE_SHIFT(area) ((area) >> LIM_SUB_BITS)
#endif

/* The first line at or below y. */
/*@ requires -8388608 <= y <= 8388608;
    assigns \nothing; */
static inline int16_t line_of(lim_sub y)
{
    return (int16_t)(((edge_sub)(y + (edge_sub)(LIM_SUB - 1)) >> LIM_SUB_BITS) + LIM_ORIGIN_PX);
}

/* M above, for line y from the origin. */
/*@ requires -2050 * LIM_SUB <= dx <= 2050 * LIM_SUB && 0 < dy <= 2050 * LIM_SUB;
    requires -8388608 <= a.x <= 8388608 && -8388608 <= a.y <= 8388608;
    assigns \nothing;
    ensures LIM_SUB_BITS > 9 ==>
            0 <= \result * LIM_SUB - (a.x * dy + dx * (y * LIM_SUB - a.y)) < LIM_SUB; */
static inline lim_sub_area meeting(struct lim_point a, int32_t dx, int32_t dy, int16_t y)
{
    const int32_t part_x = a.x & (LIM_SUB - 1), part_y = a.y & (LIM_SUB - 1);
    const int32_t whole_x = a.x >> LIM_SUB_BITS, whole_y = a.y >> LIM_SUB_BITS;
    //@ assert 0 <= part_x * dy <= 2050 * LIM_SUB * LIM_SUB;
    //@ assert -2050 * LIM_SUB * LIM_SUB <= part_y * dx <= 2050 * LIM_SUB * LIM_SUB;
    //@ assert a.x == whole_x * LIM_SUB + part_x && a.y == whole_y * LIM_SUB + part_y;
    const lim_sub_area part = (lim_sub_area)part_x * dy - (lim_sub_area)part_y * dx;
    const lim_sub_wrap whole =
        (lim_sub_wrap)whole_x * (lim_sub_wrap)dy + (lim_sub_wrap)(y - whole_y) * (lim_sub_wrap)dx;
    //@ assert a.x * dy == whole_x * dy * LIM_SUB + part_x * dy;
    //@ assert dx * (y * LIM_SUB - a.y) == (y - whole_y) * dx * LIM_SUB - part_y * dx;

    return (lim_sub_area)(whole + (lim_sub_wrap)EDGE_SHIFT(part + (LIM_SUB - 1)));
}

/* a / by, rounded to zero, and what is left. */
#if EDGE_IS_SHORT
static int32_t divide(int32_t a, int32_t by, int32_t *rest)
{
    const uint32_t both = lim_divide_u9(abs_s32(a), (uint16_t)by);
    const int16_t quotient = (int16_t)(both & 511);

    *rest = (int32_t)(both >> 16);
    if (a >= 0) return quotient;
    *rest = -*rest;
    return -quotient;
}
#else
/*@ requires by > 0 && \valid(rest);
    assigns *rest;
    ensures \result == a / by && *rest == a - \result * by; */
static inline int32_t divide(int32_t a, int32_t by, int32_t *rest)
{
    const int32_t quotient = a / by;

    *rest = a - quotient * by;
    return quotient;
}
#endif

/*@ requires by > 0 && -2147483648 <= a / by <= 2147483647 && \valid(rest);
    assigns *rest;
    ensures \result == a / by && *rest == a - \result * by; */
static inline int32_t divide_area(lim_sub_area a, int32_t by, int32_t *rest)
{
    if (EDGE_IS_SHORT) return divide((int32_t)a, by, rest);
    const int32_t quotient = (int32_t)(a / by);

    *rest = (int32_t)(a - (lim_sub_area)quotient * by);
    return quotient;
}

/*@ requires \valid(edge) && a.y < b.y && -2050 * LIM_SUB <= b.x - a.x <= 2050 * LIM_SUB;
    requires b.y - a.y <= 2050 * LIM_SUB && -8388608 <= a.x <= 8388608 && -8388608 <= a.y <= 8388608;
    requires a.y <= (y - LIM_ORIGIN_PX) * LIM_SUB <= b.y && -8388608 <= b.x <= 8388608;
    assigns *edge;
    ensures edge->denominator > 0 && -edge->denominator < edge->error <= 0;
    ensures 0 <= edge->step_error < edge->denominator; */
static void edge_set(struct lim_edge *edge, struct lim_point a, struct lim_point b, int16_t y, int16_t end)
{
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    const lim_sub_area m = meeting(a, dx, dy, (int16_t)(y - LIM_ORIGIN_PX));
    /* For the prover: line y meets the edge between its ends, so the quotient is not far from the screen. */
    /*@ ghost int64_t down = (int64_t)(y - LIM_ORIGIN_PX) * LIM_SUB - a.y;
              scale(a.x, 8388608, dy - down);
              scale(-8388608, a.x, dy - down);
              scale(b.x, 8388608, down);
              scale(-8388608, b.x, down); */
    //@ assert a.x * dy + dx * down == a.x * (dy - down) + b.x * down;
    //@ assert LIM_SUB_BITS > 9 ==> -8388608 * dy <= m * LIM_SUB <= 8388608 * dy + LIM_SUB;
    //@ assert LIM_SUB_BITS > 9 ==> -2049 * dy <= m <= 2049 * dy;
    //@ assert m == (m / dy) * dy + m % dy && -dy < m % dy < dy;
    //@ assert LIM_SUB_BITS > 9 ==> -2050 * dy < (m / dy) * dy < 2050 * dy;
    /*@ ghost if (m / dy >= 2050) scale(2050, m / dy, dy);
              if (m / dy <= -2050) scale(m / dy, -2050, dy); */
    //@ assert LIM_SUB_BITS > 9 ==> -2050 < m / dy < 2050;
    int32_t error, rest;
    int32_t x = divide_area(m, dy, &error); /* rounds to zero: up, if negative */
    //@ assert x == m / dy && error == m - x * dy && -dy < error < dy;

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
    int32_t step = divide(dx, dy, &rest);
    if (rest < 0) {
        step--;
        rest += dy;
    }
    edge->step_x = (int16_t)step;
    edge->step_error = rest;
}

/* The next edge of a boundary that goes on below line y. */
static void turn(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t y)
{
    uint_fast16_t from, to = edge->to;
    int16_t end;

    do {
        from = to;
        to += edge->step;
        if (to >= n) to -= n;
        end = line_of(at[to].y);
    } while (end <= y);
    edge_set(edge, at[from], at[to], y, end);
    edge->to = (uint8_t)to;
    edge->end = end;
}

int16_t lim_edge_turn(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    if (pair->left.end <= y) turn(&pair->left, at, n, y);
    if (pair->right.end <= y) turn(&pair->right, at, n, y);
    return pair->left.end < pair->right.end ? pair->left.end : pair->right.end;
}

static void advance(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t y)
{
    if (edge->end > y)
        lim_edge_step(edge);
    else
        turn(edge, at, n, y);
}

void lim_edge_advance(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    advance(&pair->left, at, n, y);
    advance(&pair->right, at, n, y);
}

/* line_of() from the origin: what two of them have between them is the same. So are columns. */
static edge_sub row_of(edge_sub y)
{
    return (edge_sub)(y + (edge_sub)(LIM_SUB - 1)) >> LIM_SUB_BITS;
}

/* A folded polygon has more than one local extreme of either kind, a low one a line below a high one as a rule. Where
 * the extra ones lie near its top, a fan from the bottom sees every other corner, and the other way round. */
static LIM_RARE uint8_t choose_apex(const struct lim_point *at, uint8_t n, uint8_t top_at, edge_sub bottom)
{
    const edge_sub top = row_of(at[top_at].y);
    edge_sub lowest_top = top, after = row_of(at[1].y), here = row_of(at[0].y);
    uint8_t bottom_at = 0;

    for (uint_fast8_t k = n; k-- > 0;) {
        const edge_sub before = row_of(at[k].y);
        if (here <= before && here <= after && here > lowest_top) lowest_top = here;
        if (before == bottom) bottom_at = (uint8_t)k;
        after = here;
        here = before;
    }
    return 2 * lowest_top + 1 < top + bottom ? bottom_at : top_at;
}

/* A plain polygon's boundary goes from its top to its bottom and back; what goes farther is folded. */
void lim_edge_measure(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n)
{
    edge_sub before = row_of(at[n - 1].y), top = EDGE_SUB_MAX, bottom = EDGE_SUB_MIN, left = EDGE_SUB_MAX;
    edge_sub right = EDGE_SUB_MIN, way = 0;
    uint8_t top_at = 0;

    for (uint8_t k = 0; k < n; k++) {
        const edge_sub x = at[k].x, row = row_of(at[k].y);

        way = (edge_sub)(way + (row > before ? row - before : before - row));
        if (row < top) top = row, top_at = k;
        if (row > bottom) bottom = row;
        if (x < left) left = x;
        if (x > right) right = x;
        before = row;
    }
    shape->top = (int16_t)(top + LIM_ORIGIN_PX);
    shape->bottom = (int16_t)(bottom + LIM_ORIGIN_PX);
    if (LIM_HAS_HIDDEN) {
        shape->left = (int16_t)(row_of(left) + LIM_ORIGIN_PX);
        shape->right = (int16_t)(row_of(right) + LIM_ORIGIN_PX);
    }
    shape->first = top_at;
    shape->folded = way > 2 * (bottom - top);
    if (shape->folded) shape->apex = choose_apex(at, n, top_at, bottom);
}

#if LIM_HAS_WIREFRAME

int16_t lim_edge_line_of(lim_sub at)
{
    return line_of(at);
}

int16_t lim_edge_column(struct lim_point upper, struct lim_point lower, int16_t y)
{
    struct lim_edge edge;

    if (y < line_of(upper.y)) return line_of(upper.x);
    if (y >= line_of(lower.y)) return line_of(lower.x);
    edge_set(&edge, upper, lower, y, (int16_t)(y + 1));
    return edge.x;
}

#endif
