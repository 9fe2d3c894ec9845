/* SPDX-License-Identifier: MIT
 *
 * What antialiasing is made of: the samples of polygons that tile the plane are all of each pixel's, each once; gaps
 * against a picture of booleans; sums of colours. */
#include "colour.h"
#include "limner.h"
#include "lines/smooth.h"
#include "lines/span.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "screen/edge.h"
#include "screen/samples.h"

#include <math.h>
#include <string.h>

enum { W = 60, H = 50, POINTS = 40, MESHES = 200, TRIANGLES = 3 * POINTS };

/* Pairs -------------------------------------------------------------------------------------- */

static void pairs_are_compared_half_by_half(void **state)
{
    enum { PAIRS = 100000, MOST = 0x7FFF };
    struct random random = {70};

    (void)state;
    for (int i = 0; i < PAIRS; i++) {
        const int64_t least = i % 2 ? 0 : MOST - 3, most = i % 3 ? MOST : 3; /* at both ends, and equal at times */
        uint32_t half[4];
        for (int k = 0; k < 4; k++)
            half[k] = (uint32_t)random_in(&random, least < most ? least : 0, most);
        const uint32_t a = pair_of(half[0], half[1]), b = pair_of(half[2], half[3]);
        uint32_t max = 0, min = 0, beyond = 0;
        for (int k = 0; k < 2; k++) {
            const uint32_t x = half[k], y = half[k + 2];
            max |= (x > y ? x : y) << 16 * k;
            min |= (x < y ? x : y) << 16 * k;
            beyond |= (x > y ? x - y : 0) << 16 * k;
        }
        assert_int_equal(pair_max(a, b), max);
        assert_int_equal(pair_min(a, b), min);
        assert_int_equal(pair_beyond(a, b), beyond);
        assert_int_equal(pair_sum(a), half[0] + half[1]);
        assert_int_equal(pair_of_highs(a, b), half[1] | half[3] << 16);
    }
}

/* Strips ------------------------------------------------------------------------------------- */

static void set_row(struct lim_strip *strip, int row, int left, int right)
{
    const int shift = row & 1 ? 16 : 0;
    uint32_t *of_left = &strip->left.rows[row >> 1], *of_right = &strip->right.rows[row >> 1];

    *of_left = (*of_left & ~(0xFFFFu << shift)) | (uint32_t)(left + LIM_STRIP_BIAS) << shift;
    *of_right = (*of_right & ~(0xFFFFu << shift)) | (uint32_t)(right + LIM_STRIP_BIAS) << shift;
}

static uint16_t mask_of(const struct lim_strip *strip, int x)
{
    uint16_t mask = 0;

    for (uint8_t s = 0; s < LIM_SAMPLE_ROWS; s++)
        for (int k = 0; k < LIM_SAMPLES_A_ROW; k++)
            if (4 * x + k >= lim_bound_sample(&strip->left, s) && 4 * x + k < lim_bound_sample(&strip->right, s))
                mask |= (uint16_t)(1u << (4 * s + k));
    return mask;
}

/* Rows of random samples, some of them without any, against each pixel's count of them. */
static void a_strip_knows_where_its_samples_are(void **state)
{
    enum { COLUMNS = 12, STRIPS = 100000 };
    struct random random = {71};

    (void)state;
    for (int i = 0; i < STRIPS; i++) {
        struct lim_strip strip = {0};
        int count[COLUMNS] = {0};
        for (int s = 0; s < LIM_SAMPLE_ROWS; s++) {
            const int left = (int)random_in(&random, 0, 4 * COLUMNS);
            const int right = (int)random_in(&random, left, i % 2 ? 4 * COLUMNS : left + (4 * COLUMNS - left) / 4);
            set_row(&strip, s, left, right);
            assert_int_equal(lim_bound_sample(&strip.left, (uint_fast8_t)s), left);
            assert_int_equal(lim_bound_sample(&strip.right, (uint_fast8_t)s), right);
            for (int v = left; v < right; v++)
                count[v / 4]++;
        }
        for (int x = 0, before = 0; x < COLUMNS; x++) {
            assert_int_equal(lim_strip_count(&strip, (uint32_t)(x + LIM_STRIP_BIAS_PX)), before);
            before += count[x];
            if (count[x]) assert_true(lim_strip_first_px(&strip) <= x && x < lim_strip_end_px(&strip));
        }
    }
}

struct cover {
    uint16_t mask[H][W];
    unsigned twice; /* samples that were there already */
};

static void add_strip(struct cover *cover, const struct lim_strip *strip, int16_t y)
{
    const int first = lim_strip_first_px(strip), end = lim_strip_end_px(strip);

    for (int x = first > 0 ? first : 0; x < end && x < W; x++) {
        const uint16_t mask = mask_of(strip, x);
        cover->twice += lim_sample_count(cover->mask[y][x] & mask);
        cover->mask[y][x] |= mask;
    }
}

static void add_plain(struct cover *cover, const struct lim_point *at, uint8_t n, const struct lim_edge_shape *shape)
{
    struct lim_sample_edges edges;

    lim_strip_begin(&edges, n, shape->first);
    for (int16_t y = shape->top > 0 ? shape->top : 0; y < shape->bottom && y < H; y++) {
        const struct lim_strip strip = lim_strip_next(&edges, at, n, shape->first, y, *shape->end_row);
        add_strip(cover, &strip, y);
    }
}

/* As a fan if it is non-monotone, as the renderer draws it. Returns whether it is. */
static bool add_polygon(struct cover *cover, const struct lim_point *at, uint8_t n)
{
    struct lim_edge_shape shape;

    lim_samples_bounds(&shape, at, n);
    if (!shape.non_monotone) add_plain(cover, at, n, &shape);
    for (uint8_t k = 1; shape.non_monotone && k + 1 < n; k++) {
        const struct lim_point triangle[3] = {at[shape.apex], at[(shape.apex + k) % n], at[(shape.apex + k + 1) % n]};
        struct lim_edge_shape of;
        lim_samples_bounds(&of, triangle, 3);
        add_plain(cover, triangle, 3, &of);
    }
    return shape.non_monotone;
}

/* In pixels from the middle of the first one's. */
static struct lim_point point(double x, double y)
{
    return (struct lim_point){(lim_sub)lround((x - LIM_ORIGIN_PX) * LIM_SUB),
                              (lim_sub)lround((y - LIM_ORIGIN_PX) * LIM_SUB)};
}

/* Corners counter-clockwise as seen, y down. */
static void rectangle(struct lim_point at[4], double x0, double y0, double x1, double y1)
{
    at[0] = point(x0, y0);
    at[1] = point(x0, y1);
    at[2] = point(x1, y1);
    at[3] = point(x1, y0);
}

static unsigned count_of(double x0, double y0, double x1, double y1, int x, int y)
{
    struct cover cover = {0};
    struct lim_point at[4];

    rectangle(at, x0, y0, x1, y1);
    add_polygon(&cover, at, 4);
    return lim_sample_count(cover.mask[y][x]);
}

static void a_pixel_that_is_covered_by_half_has_eight_samples(void **state)
{
    (void)state;
    assert_int_equal(count_of(10, 5, 20, 15, 10, 10), 8); /* from its centre on to the right */
    assert_int_equal(count_of(10, 5, 20, 15, 20, 10), 8); /* up to its centre from the left */
    assert_int_equal(count_of(10, 5, 20, 15, 15, 5), 8);
    assert_int_equal(count_of(10, 5, 20, 15, 15, 15), 8);
    assert_int_equal(count_of(10, 5, 20, 15, 10, 5), 4); /* a corner: a quarter */
    assert_int_equal(count_of(10, 5, 20, 15, 15, 10), 16);
    assert_int_equal(count_of(10, 5, 20, 15, 21, 10), 0);
}

static void an_upright_edge_knows_all_sixteenths_and_a_level_one_all_quarters(void **state)
{
    (void)state;
    for (int i = 0; i <= 16; i++) {
        assert_int_equal(count_of(9.5 + i / 16.0, 5, 20, 15, 10, 10), 16 - i);
        assert_int_equal(count_of(5, 9.5 + i / 16.0, 20, 15, 10, 10), 4 * (4 - (i + 1) / 4));
    }
}

/* A tenth of a pixel wide, between the centres of pixels: without antialiasing there is nothing of it. */
static void a_sliver_covers_what_it_covers(void **state)
{
    unsigned samples = 0;
    struct cover cover = {0};
    const struct lim_point at[4] = {point(20.20, 5), point(20.20, 45), point(20.30, 45), point(20.30, 5)};
    struct lim_edge_shape shape;

    (void)state;
    lim_edge_bounds_sides(&shape, at, 4);
    assert_true(shape.left == shape.right);
    add_polygon(&cover, at, 4);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            samples += lim_sample_count(cover.mask[y][x]);
    assert_true(samples >= 40 && samples <= 80); /* 0.1 * 16 a line, 40 lines */
    assert_int_equal(cover.twice, 0);
}

static bool is_inside(const struct lim_point t[3], struct lim_point p)
{
    for (int k = 0; k < 3; k++) {
        const struct lim_point a = t[k], b = t[(k + 1) % 3];
        if ((int64_t)(b.x - a.x) * (p.y - a.y) - (int64_t)(b.y - a.y) * (p.x - a.x) >= 0) return false;
    }
    return true;
}

struct tiles {
    struct lim_point at[TRIANGLES][3];
    int count;
};

/* A quad about the picture in two triangles, points put into them one by one: slivers result. */
static void make_tiles(struct tiles *tiles, struct random *random)
{
    const struct lim_point corner[4] = {point(-20, -20), point(-20, H + 20), point(W + 20, H + 20), point(W + 20, -20)};

    tiles->count = 2;
    memcpy(tiles->at[0], (struct lim_point[3]){corner[0], corner[1], corner[2]}, sizeof tiles->at[0]);
    memcpy(tiles->at[1], (struct lim_point[3]){corner[0], corner[2], corner[3]}, sizeof tiles->at[1]);
    for (int i = 0; i < POINTS; i++) {
        const struct lim_point p = point(random_unit(random) * W, random_unit(random) * H);
        for (int t = 0; t < tiles->count; t++) {
            if (!is_inside(tiles->at[t], p)) continue;
            struct lim_point old[3];
            memcpy(old, tiles->at[t], sizeof old);
            for (int k = 0; k < 3; k++) {
                const int to = k ? tiles->count++ : t;
                memcpy(tiles->at[to], (struct lim_point[3]){old[k], old[(k + 1) % 3], p}, sizeof old);
            }
            break;
        }
    }
}

static void neighbours_cover_all_of_each_pixel_and_nothing_twice(void **state)
{
    struct random random = {31};

    (void)state;
    for (int m = 0; m < MESHES; m++) {
        struct cover cover = {0};
        struct tiles tiles;
        make_tiles(&tiles, &random);
        for (int t = 0; t < tiles.count; t++)
            add_polygon(&cover, tiles.at[t], 3);
        assert_int_equal(cover.twice, 0);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                assert_int_equal(cover.mask[y][x], LIM_ALL_SAMPLES);
    }
}

/* Corners on a level edge, which rounding has moved up and down by up to a row. */
static void non_monotone_polygons_leave_nothing_open(void **state)
{
    struct random random = {33};
    unsigned non_monotone = 0;

    (void)state;
    for (int m = 0; m < MESHES; m++) {
        struct lim_point upper[14], lower[14];
        struct cover cover = {0};
        upper[0] = point(-10, -10);
        lower[0] = point(-10, H + 10);
        for (int k = 1; k <= 11; k++) {
            const struct lim_point p =
                point(-10 + (W + 20) * (k - 1) / 10.0, 20 + (random_unit(&random) - 0.5) / 64 + m / 400.0);
            upper[k] = p;
            lower[12 - k + 1] = p;
        }
        upper[12] = point(W + 10, -10);
        lower[1] = point(W + 10, H + 10);
        for (int k = 1; k <= 11; k++)
            lower[1 + k] = upper[12 - k];
        non_monotone += add_polygon(&cover, upper, 13);
        non_monotone += add_polygon(&cover, lower, 13);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                assert_int_equal(cover.mask[y][x], LIM_ALL_SAMPLES);
    }
    print_message("# samples: %u of %u polygons were non-monotone\n", non_monotone, 2 * (unsigned)MESHES);
    assert_true(non_monotone > 0);
}

/* Gaps --------------------------------------------------------------------------------------- */

enum { POOL = 200, STRIPS = 60, LINES = 300 };

struct fixture {
    struct lim_line line;
    struct lim_open_strip pool[POOL];
    struct lim_retained retained; /* nothing, in the same memory */
    struct lim_spans spans;
    uint16_t closed[W], fresh[W]; /* what is closed, and what the last call closed */
};

static const struct lim_target everything; /* is seen */

static void open_line(struct fixture *f, uint16_t pool_size)
{
    const struct lim_rect all = {0, 0, W, 1};

    memset(f, 0, sizeof *f);
    f->spans.lines = &f->line;
    *f->spans.strips = f->pool;
    *f->spans.has_strips = true;
    *f->spans.strips_size = pool_size;
    f->spans.retained = &f->retained;
    f->retained.cells = (void *)f->pool;
    lim_spans_open(&f->spans, &everything, &all);
}

static lim_strip_sink note_open;

static void note_open(void *ctx, uint32_t left0, uint32_t left1, uint32_t right0, uint32_t right1)
{
    const struct lim_strip open = {{{left0, left1}}, {{right0, right1}}};
    struct fixture *f = ctx;
    bool any = false;

    for (int x = -1; x <= W; x++) {
        const uint16_t mask = mask_of(&open, x);
        any |= mask != 0;
        if (!mask) continue;
        assert_true(x >= 0 && x < W);
        assert_int_equal(mask & f->closed[x], 0);
        assert_int_equal(mask & f->fresh[x], 0);
        f->fresh[x] |= mask;
    }
    assert_true(any);
}

/* Some of them without some of their rows, which are anywhere. */
static void random_strip(struct lim_strip *strip, struct random *random)
{
    const int wide = (int)random_in(random, 1, 120), left = (int)random_in(random, -60, 4 * W + 20);
    const int lean = (int)random_in(random, -40, 40);

    for (int s = 0; s < LIM_SAMPLE_ROWS; s++) {
        const int at = left + lean * s / 4;
        set_row(strip, s, at, at + wide - (int)random_in(random, 0, 5));
        if (random_in(random, 0, 9) == 0) {
            const int nowhere = (int)random_in(random, 0, 4 * W);
            set_row(strip, s, nowhere, nowhere - (int)random_in(random, 0, 9));
        }
    }
}

static enum lim_span_result close_strip(struct fixture *f, const struct lim_strip *strip)
{
    if (lim_line_is_closed(&f->line)) return LIM_SPAN_NOTHING;
    if (f->line.gap.next == LIM_NONE && !lim_strips_begin(&f->spans, &f->line)) return LIM_SPAN_EXHAUSTED;
    return lim_strips_close(&f->spans, &f->line, strip->left, strip->right, note_open, f);
}

/* false: the pool is exhausted; what was closed until then is. */
static bool close_and_compare(struct fixture *f, const struct lim_strip *strip)
{
    uint16_t seen[W];
    bool any = false;

    memset(f->fresh, 0, sizeof f->fresh);
    const bool sees = lim_strips_see(&f->spans, &f->line, strip, note_open, f);
    assert_int_equal(lim_strips_see(&f->spans, &f->line, strip, NULL, NULL), sees);
    memcpy(seen, f->fresh, sizeof seen);
    memset(f->fresh, 0, sizeof f->fresh);
    const enum lim_span_result result = close_strip(f, strip);
    for (int x = 0; x < W; x++) {
        const uint16_t wanted = (uint16_t)(mask_of(strip, x) & ~f->closed[x]);
        any |= wanted != 0;
        assert_int_equal(seen[x], wanted);
        if (result != LIM_SPAN_EXHAUSTED) assert_int_equal(f->fresh[x], wanted);
        assert_int_equal(f->fresh[x] & ~wanted, 0);
        f->closed[x] |= f->fresh[x];
    }
    assert_int_equal(sees, any);
    if (result != LIM_SPAN_EXHAUSTED) assert_int_equal(result, any ? LIM_SPAN_SOME : LIM_SPAN_NOTHING);
    return result != LIM_SPAN_EXHAUSTED;
}

/* The line's gap holds all that is open on it, and little more. */
static void assert_bounded(struct fixture *f)
{
    if (lim_line_is_closed(&f->line)) return;
    lim_strips_bound(&f->spans, &f->line);
    for (int x = 0; x < W; x++)
        if (f->closed[x] != LIM_ALL_SAMPLES) assert_true(x >= f->line.gap.x0 && x < f->line.gap.x1);
    assert_true(f->line.gap.x0 < f->line.gap.x1 && f->line.gap.x1 <= W);
}

static bool is_all_closed(const struct fixture *f)
{
    for (int x = 0; x < W; x++)
        if (f->closed[x] != LIM_ALL_SAMPLES) return false;
    return true;
}

static void gaps_agree_with_a_picture_of_their_samples(void **state)
{
    struct random random = {57};
    unsigned exhausted = 0, closed = 0;

    (void)state;
    for (int i = 0; i < LINES; i++) {
        struct fixture f;
        open_line(&f, (uint16_t)(i % 2 ? POOL : random_in(&random, 0, 12)));
        for (int s = 0; s < STRIPS; s++) {
            struct lim_strip strip = {0};
            random_strip(&strip, &random);
            exhausted += !close_and_compare(&f, &strip);
            assert_int_equal(f.spans.open_lines, !is_all_closed(&f));
            assert_bounded(&f);
        }
        closed += is_all_closed(&f);
    }
    print_message("# samples: of %u lines %u were closed, %u calls found the pool exhausted\n", (unsigned)LINES, closed,
                  exhausted);
    assert_true(exhausted > 0 && closed > 0 && closed < LINES);
}

/* Colours ------------------------------------------------------------------------------------ */

enum { MIX_W = 40, MIX_STRIPS = 12 };

/* What all strips that were mixed should make of a line. */
struct mixture {
    uint32_t sum[MIX_W][3];
    unsigned count[MIX_W];
};

static void add_to_mixture(struct mixture *mixture, const struct lim_strip *strip, uint16_t rgb565)
{
    for (int x = 0; x < MIX_W; x++) {
        const unsigned n = (unsigned)__builtin_popcount(mask_of(strip, x));
        assert_int_equal(lim_sample_count(mask_of(strip, x)), n);
        mixture->count[x] += n;
        mixture->sum[x][0] += n * (rgb565 >> 11);
        mixture->sum[x][1] += n * (rgb565 >> 5 & 63);
        mixture->sum[x][2] += n * (rgb565 & 31);
    }
}

/* Strips that lie beside each other, from edges as steep and as level as they come: each pixel is the sum of their
 * shares, rounded once, in whatever order they come. */
static void polygons_in_a_pixel_are_mixed_by_what_they_cover(void **state)
{
    struct random random = {7};

    (void)state;
    for (int i = 0; i < 4000; i++) {
        struct lim_strip strips[MIX_STRIPS];
        uint16_t line[MIX_W] LIM_WORD_ALIGNED;
        uint32_t sums[MIX_W] = {0};
        struct mixture mixture = {0};
        struct lim_smooth_sink sink = {.line = line, .sums = sums};
        int at[LIM_SAMPLE_ROWS] = {0};
        memset(strips, 0, sizeof strips);
        for (int k = 0; k < MIX_STRIPS; k++) {
            const int far = (int)random_in(&random, 0, i % 3 ? 20 : 60), spread = (int)random_in(&random, 0, i % 5 * 9);
            for (int s = 0; s < LIM_SAMPLE_ROWS; s++) {
                int end = at[s] + far + (int)random_in(&random, 0, spread);
                if (end > 4 * MIX_W || k + 1 == MIX_STRIPS) end = 4 * MIX_W;
                set_row(&strips[k], s, at[s], end);
                at[s] = end;
            }
        }
        for (int k = 0; k < MIX_STRIPS; k++) {
            const struct lim_strip *strip = &strips[(5 * k + i) % MIX_STRIPS];
            const uint16_t colour = i ? (uint16_t)random_u64(&random) : 0xFFFF;
            if (lim_bound_equals(&strip->left, &strip->right)) continue;
            sink.colour = lim_memory_colour(colour);
            sink.share = lim_smooth_share(sink.colour);
            lim_strip_to_sink(lim_smooth_mix, &sink, &strip->left, &strip->right);
            add_to_mixture(&mixture, strip, colour);
        }
        for (int x = 0; x < MIX_W; x++) {
            const uint32_t *sum = mixture.sum[x];
            assert_int_equal(mixture.count[x], LIM_SAMPLES);
            assert_int_equal(sums[x], 0);
            assert_int_equal(lim_memory_colour(line[x]),
                             ((sum[0] + 8) / 16) << 11 | ((sum[1] + 8) / 16) << 5 | (sum[2] + 8) / 16);
        }
        if (LIM_HAS_STATS) assert_int_equal(sink.painted_px, MIX_W);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_are_compared_half_by_half),
        cmocka_unit_test(a_strip_knows_where_its_samples_are),
        cmocka_unit_test(a_pixel_that_is_covered_by_half_has_eight_samples),
        cmocka_unit_test(an_upright_edge_knows_all_sixteenths_and_a_level_one_all_quarters),
        cmocka_unit_test(a_sliver_covers_what_it_covers),
        cmocka_unit_test(neighbours_cover_all_of_each_pixel_and_nothing_twice),
        cmocka_unit_test(non_monotone_polygons_leave_nothing_open),
        cmocka_unit_test(gaps_agree_with_a_picture_of_their_samples),
        cmocka_unit_test(polygons_in_a_pixel_are_mixed_by_what_they_cover),
    };
    return cmocka_run_group_tests_name("samples", tests, NULL, NULL);
}
