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
 * |dx|, dy <= 2050 S (perspective.h): the last term's numerator stays below 2^31.
 *
 * From its first line on an edge is M / dy + 1 - 2^-f with f fraction bits, start and slope rounded down: the floor is
 * x on as many lines as (DIVISOR_ERROR lines + 1) dy <= 2^f allows. Why: DESIGN.md, "Which pixels". */
#include "screen/edge.h"

#include "math/divisor.h"
#include "screen/edge_begin.h"

#if LIM_EDGE_IS_SHORT
#define EDGE_SHIFT(area) shift_s32(area, LIM_SUB_BITS)
#else
#define EDGE_SHIFT(area) ((area) >> LIM_SUB_BITS)
#endif

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
#if LIM_EDGE_IS_SHORT
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
    if (LIM_EDGE_IS_SHORT) return divide((int32_t)a, by, rest);
    const int32_t quotient = (int32_t)(a / by);

    *rest = (int32_t)(a - (lim_sub_area)quotient * by);
    return quotient;
}

#if LIM_8_BIT

/* Below line y as well: quotient and remainder on each line. */
static void edge_set(struct lim_edge *edge, struct lim_point a, struct lim_point b, int16_t y, int16_t lines)
{
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    int32_t error, rest;
    int32_t x = divide_area(meeting(a, dx, dy, y), dy, &error); /* up, if negative */

    if (error > 0) {
        x++;
        error -= dy;
    }
    edge->x = (int16_t)(x + LIM_ORIGIN_PX);
    edge->error = error;
    edge->denominator = dy;
    edge->step_x = 0;
    edge->step_error = 0;
    if (lines < 2) return; /* never stepped */
    int32_t step = divide(dx, dy, &rest);
    if (rest < 0) {
        step--;
        rest += dy;
    }
    edge->step_x = (int16_t)step;
    edge->step_error = rest;
}

static inline void begin_long(struct lim_edge *edge, const struct lim_point *at, uint_fast16_t from, int16_t y)
{
    edge_set(edge, at[from], at[edge->next], (int16_t)(y - LIM_ORIGIN_PX), (int16_t)(edge->end - y));
}

#else

/* rest / dy, 0 <= rest < dy, with LIM_EDGE_BITS. */
/*@ requires \valid_read(divisor) && 0 < divisor->by <= 2050 * LIM_SUB && rest < divisor->by;
    requires LIM_EDGE_BITS == 32 || divisor->by < 1048576;
    assigns \nothing; */
static inline lim_edge_at fraction_of(uint32_t rest, const struct divisor *divisor)
{
#if LIM_EDGE_BITS == 32
    return (lim_edge_at)(((uint64_t)rest << 32) / (uint32_t)divisor->by);
#else
    if (!LIM_DIVIDES && LIM_EDGE_MOST_PX * LIM_SUB > UINT16_MAX && divisor->by > (int32_t)UINT16_MAX)
        return (lim_edge_at)divided_fraction((uint32_t)divisor->by, rest, LIM_EDGE_BITS);
    return (lim_edge_at)divisor_fraction(divisor, rest, LIM_EDGE_BITS);
#endif
}

/* floor(m / dy) and the rest of it. */
/*@ requires \valid_read(divisor) && divisor->by > 0 && \valid(rest) && \separated(divisor, rest);
    requires -2147483647 <= m / divisor->by <= 2147483647;
    assigns *rest;
    ensures LIM_DIVIDES ==> 0 <= *rest < divisor->by && *rest == m - \result * divisor->by; */
static inline int32_t floor_of(lim_sub_area m, const struct divisor *divisor, int32_t *rest)
{
#if LIM_EDGE_BITS == 32
    const int32_t quotient = divide_area(m, divisor->by, rest);
    if (*rest >= 0) return quotient;
    *rest += divisor->by;
    return quotient - 1;
#else
    return divisor_floor(divisor, m, rest);
#endif
}

/* m / dy as a fixed-point number, never too high. */
/*@ requires \valid_read(divisor) && 0 < divisor->by <= 2050 * LIM_SUB;
    requires LIM_EDGE_BITS == 32 || divisor->by < 1048576;
    requires -2147483647 <= m / divisor->by <= 2147483647;
    assigns \nothing; */
static LIM_HOT_INLINE lim_edge_wrap quotient_of(lim_sub_area m, const struct divisor *divisor)
{
    int32_t rest;
    const int32_t whole = floor_of(m, divisor, &rest);

    return (lim_edge_wrap)(lim_edge_at)whole * ((lim_edge_wrap)1 << LIM_EDGE_BITS) +
           (lim_edge_wrap)fraction_of((uint32_t)rest, divisor);
}

/* How many lines an edge can be followed without being begun anew, if not all of them. */
/*@ requires 0 < dy <= 2050 * LIM_SUB && (LIM_EDGE_BITS == 32 ==> dy >= 1048576);
    assigns \nothing;
    ensures \result >= 1;
    ensures \result == 1 || (DIVISOR_ERROR * \result + 1) * dy <= (LIM_EDGE_BITS == 32 ? 4294967296 : LIM_EDGE_BITS ==
   22 ? 4194304 : 1048576); */
static LIM_RARE int32_t stretch_of(int32_t dy)
{
    const lim_edge_wrap most = ((lim_edge_wrap)1 << LIM_EDGE_BITS) / (lim_edge_wrap)dy;

    return most > 2 * DIVISOR_ERROR ? (int32_t)(most - 1) / DIVISOR_ERROR : 1;
}

/* A single line, which may have more sub-pixels than a fraction has bits for: ceil(m / dy). */
/*@ requires \valid(edge) && dy > 0 && -4096 <= m / dy <= 4096;
    assigns edge->at; */
static LIM_RARE void set_line(struct lim_edge *edge, lim_sub_area m, int32_t dy)
{
    int32_t rest, whole = divide_area(m, dy, &rest);

    if (rest > 0) whole++;
    edge->at = (lim_edge_at)((lim_edge_wrap)(lim_edge_at)(whole + LIM_ORIGIN_PX) << LIM_EDGE_BITS);
}

/* Sets the edge from a corner to edge->next for the lines from y on: for all of them, or it is begun anew. */
static LIM_ALONE void begin_long(struct lim_edge *edge, const struct lim_point *at, uint_fast16_t from, int16_t y)
{
    const struct lim_point a = at[from], b = at[edge->next];

    if (EDGE_HAS_SMALL && begin_medium(edge, a.x, a.y, b.x, b.y, y - LIM_ORIGIN_PX)) return;
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    const lim_sub_area m = meeting(a, dx, dy, (int16_t)(y - LIM_ORIGIN_PX));
    int32_t lines = edge->end - y;

    if ((lim_edge_wrap)(DIVISOR_ERROR * lines + 1) * (lim_edge_wrap)dy > (lim_edge_wrap)1 << LIM_EDGE_BITS) {
        const int32_t stretch = stretch_of(dy);
        if (stretch < lines) {
            lines = stretch;
            edge->end = (int16_t)(y + lines);
            edge->next = (uint8_t)from;
        }
    }
    if (lines == 1) {
        set_line(edge, m, dy);
        return;
    }
    const struct divisor divisor = divisor_of(dy);
    edge->at = (lim_edge_at)(quotient_of(m, &divisor) + EDGE_BEFORE_NEXT);
    edge->step = (lim_edge_at)quotient_of(dx, &divisor);
}

#endif

#if LIM_HAS_MESHES

bool lim_edge_begin_slow(struct lim_edge *edge, struct lim_point from, struct lim_point to, int16_t y, int16_t end)
{
    const struct lim_point at[2] = {from, to};
    const int32_t row = y - LIM_ORIGIN_PX;

    edge->end = end;
    edge->next = 1;
    if (EDGE_HAS_SMALL && begin_low(edge, from.x, from.y, to.x, to.y, row)) return true;
    if (EDGE_HAS_SMALL && begin_short(edge, from.x, from.y, to.x, to.y, row, end - LIM_ORIGIN_PX)) return true;
    begin_long(edge, at, 0, y);
    return edge->end == end;
}

#endif

/* The next edge of a boundary that goes on below line y, or the next stretch of the same. */
void lim_edge_next(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t y)
{
    const int32_t row = y - LIM_ORIGIN_PX;
    uint_fast16_t from, to = edge->next;
    int32_t end;

    do {
        from = to;
        to += edge->step_vertex;
        if (to >= n) to -= n;
        end = lim_edge_row(at[to].y);
    } while (end <= row);
    const struct lim_point a = at[from], b = at[to];
    edge->end = (int16_t)(end + LIM_ORIGIN_PX);
    edge->next = (uint8_t)to;
    if (!lim_edge_begin_fast(edge, a.x, a.y, b.x, b.y, row, end)) begin_long(edge, at, from, y);
}

/* The boundary's edge from its first corner, a, to the one after it, or, if that is above, what follows. */
static inline void start(struct lim_edge *edge, const struct lim_point *at, uint8_t n, uint8_t first, uint8_t second,
                         const struct lim_point *a, int16_t y)
{
    const int32_t row = y - LIM_ORIGIN_PX;
    const struct lim_point b = at[second];
    const int32_t end = lim_edge_row(b.y);

    edge->end = (int16_t)(end + LIM_ORIGIN_PX);
    edge->next = second;
    if (LIM_UNLIKELY(end <= row))
        lim_edge_next(edge, at, n, y);
    else if (!lim_edge_begin_fast(edge, a->x, a->y, b.x, b.y, row, end))
        begin_long(edge, at, first, y);
}

int16_t lim_edge_start(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, uint8_t first, int16_t y)
{
    const struct lim_point a = at[first];
    const uint8_t last = (uint8_t)(n - 1);

    if (LIM_OPTIMISE_SIZE) {
        lim_edge_begin(pair, n, first);
        return lim_edge_turn(pair, at, n, y);
    }
    pair->left.step_vertex = 1;
    pair->right.step_vertex = last;
    start(&pair->left, at, n, first, first == last ? 0 : (uint8_t)(first + 1), &a, y);
    start(&pair->right, at, n, first, first ? (uint8_t)(first - 1) : last, &a, y);
    return pair->left.end < pair->right.end ? pair->left.end : pair->right.end;
}

static void advance(struct lim_edge *edge, const struct lim_point *at, uint8_t n, int16_t y)
{
    if (edge->end > y)
        lim_edge_step(edge);
    else
        lim_edge_next(edge, at, n, y);
}

void lim_edge_advance(struct lim_edge_pair *pair, const struct lim_point *at, uint8_t n, int16_t y)
{
    advance(&pair->left, at, n, y);
    advance(&pair->right, at, n, y);
}

#if LIM_HAS_WIREFRAME

/* The first line at or below y. */
/*@ requires -8388608 <= y <= 8388608;
    assigns \nothing; */
static inline int16_t line_of(lim_sub y)
{
    return (int16_t)(((lim_edge_sub)(y + (lim_edge_sub)(LIM_SUB - 1)) >> LIM_SUB_BITS) + LIM_ORIGIN_PX);
}

int16_t lim_edge_line_of(lim_sub at)
{
    return line_of(at);
}

/* Of an edge of any length, on a line from the origin: that one alone is asked for, so nothing is set to be stepped. */
static inline void begin_line(struct lim_edge *edge, struct lim_point a, struct lim_point b, int16_t y)
{
#if LIM_8_BIT
    edge_set(edge, a, b, y, 1);
#else
    const int32_t dx = (int32_t)b.x - a.x, dy = (int32_t)b.y - a.y;
    set_line(edge, meeting(a, dx, dy, y), dy);
#endif
}

int16_t lim_edge_column(struct lim_point upper, struct lim_point lower, int16_t y)
{
    struct lim_edge edge;

    if (y < line_of(upper.y)) return line_of(upper.x);
    if (y >= line_of(lower.y)) return line_of(lower.x);
    begin_line(&edge, upper, lower, (int16_t)(y - LIM_ORIGIN_PX));
    return lim_edge_x(&edge);
}

#endif
