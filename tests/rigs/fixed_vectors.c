/* SPDX-License-Identifier: MIT
 *
 * Expected values were worked out by hand or follow from the definition (reciprocals and ratios of
 * powers of two, rounding ties, ends of ranges); the series are checked against independent
 * arithmetic in test_fixed.c and here only have to agree from one CPU to the next. */
#include "fixed_vectors.h"

#include "camera.h"
#include "eye.h"
#include "math/fixed.h"
#include "screen/edge.h"
#include "view/view.h"

enum { LINE_LENGTH = 96, SERIES_CALLS = 2000 };

struct report {
    void (*put)(const char *line);
    char line[LINE_LENGTH];
    uint8_t used;
    int failed;
};

static void add_text(struct report *report, const char *text)
{
    while (*text && report->used < LINE_LENGTH - 1)
        report->line[report->used++] = *text++;
    report->line[report->used] = 0;
}

static void add_number(struct report *report, int64_t value)
{
    char digits[24];
    uint8_t at = sizeof digits;
    uint64_t rest = value < 0 ? 0u - (uint64_t)value : (uint64_t)value;

    digits[--at] = 0;
    do {
        digits[--at] = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest);
    if (value < 0) digits[--at] = '-';
    add_text(report, " ");
    add_text(report, &digits[at]);
}

static void end_line(struct report *report)
{
    report->put(report->line);
    report->used = 0;
}

/* One call with up to two arguments. */
static void expect(struct report *report, const char *name, int64_t a, int64_t b, int64_t got, int64_t expected)
{
    add_text(report, name);
    add_number(report, a);
    add_number(report, b);
    add_text(report, " =");
    add_number(report, got);
    if (got != expected) {
        report->failed++;
        add_text(report, " but should be");
        add_number(report, expected);
    }
    end_line(report);
}

/* Marsaglia's xorshift with 32 bits of state. */
static uint32_t random_u32(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

/* FNV-1a over the bytes of a value, low byte first. */
static uint32_t hash_s64(uint32_t hash, int64_t value)
{
    for (uint8_t i = 0; i < 8; i++)
        hash = (hash ^ (uint32_t)((uint64_t)value >> (8 * i) & 255u)) * UINT32_C(16777619);
    return hash;
}

static void series(struct report *report, const char *name, int64_t (*call)(uint32_t *random))
{
    uint32_t random = UINT32_C(2463534242), hash = UINT32_C(2166136261);

    for (uint16_t i = 0; i < SERIES_CALLS; i++)
        hash = hash_s64(hash, call(&random));
    add_text(report, name);
    add_text(report, " series");
    add_number(report, hash);
    end_line(report);
}

static void clz_vectors(struct report *report)
{
    for (uint8_t bit = 0; bit < 32; bit++) {
        const uint32_t power = UINT32_C(1) << bit;
        expect(report, "clz_u32", power, 0, clz_u32(power), 31 - bit);
        expect(report, "clz_u32", power | (power - 1), 0, clz_u32(power | (power - 1)), 31 - bit);
    }
}

/* All arguments of it: how many give what normalise_u32() does not. */
static void normalise_vectors(struct report *report)
{
    uint16_t wrong = 0;

    for (uint16_t x = 1; x < 4096; x++) {
        uint8_t zeros, all_zeros;
        const uint32_t short_q31 = normalise_u12(x, &zeros), q31 = normalise_u32(x, &all_zeros);
        if (short_q31 != q31 || zeros != all_zeros) wrong++;
    }
    expect(report, "normalise_u12", 1, 4095, wrong, 0);
}

static void rounding_vectors(struct report *report)
{
    static const struct {
        int32_t x;
        uint8_t bits;
        int32_t expected;
    } table[] = {
        {0, 1, 0},
        {1, 1, 1},
        {-1, 1, 0},
        {3, 1, 2},
        {-3, 1, -1},
        {5, 2, 1},
        {6, 2, 2},
        {7, 2, 2},
        {-5, 2, -1},
        {-6, 2, -1},
        {-7, 2, -2},
        {127, 8, 0},
        {128, 8, 1},
        {-128, 8, 0},
        {-129, 8, -1},
        {384, 8, 2},
        {INT32_MAX - 1, 1, 1073741823},
        {INT32_MIN, 1, -1073741824},
        {INT32_MIN, 30, -2},
        {INT32_MAX - 536870912, 30, 1},
    };

    for (uint8_t i = 0; i < sizeof table / sizeof *table; i++) {
        expect(report, "shift_round_s32", table[i].x, table[i].bits, shift_round_s32(table[i].x, table[i].bits),
               table[i].expected);
        expect(report, "shift_round_s64", table[i].x, table[i].bits, shift_round_s64(table[i].x, table[i].bits),
               table[i].expected);
    }
    expect(report, "shift_round_s64", INT64_MIN, 62, shift_round_s64(INT64_MIN, 62), -2);
    expect(report, "abs_s32", INT32_MIN, 0, abs_s32(INT32_MIN), INT64_C(2147483648));
    expect(report, "abs_s32", -1, 0, abs_s32(-1), 1);
    expect(report, "lim_mul_q30", -(INT32_C(1) << 30), INT32_C(1) << 30,
           lim_mul_q30(-(INT32_C(1) << 30), INT32_C(1) << 30), -(INT32_C(1) << 30));
    expect(report, "lim_mul_q30", 1, INT32_C(1) << 29, lim_mul_q30(1, INT32_C(1) << 29), 1);
    expect(report, "lim_mul_q30", -1, INT32_C(1) << 29, lim_mul_q30(-1, INT32_C(1) << 29), 0);
}

/* Both ends of the range in all combinations, and what carries from limb to limb. */
static void product_vectors(struct report *report)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -65537, -65536, -65535,        -1,       0,
                                   1,         65535,         65536,  65537,  INT32_MAX - 1, INT32_MAX};
    enum { ENDS = sizeof ends / sizeof *ends };

    for (uint8_t i = 0; i < ENDS; i++) {
        for (uint8_t k = 0; k < ENDS; k++) {
            const int64_t product = (int64_t)ends[i] * ends[k];
            const int64_t floor = product >= 0 ? product / 4294967296 : -((4294967295 - product) / 4294967296);
            expect(report, "mul_high_s32", ends[i], ends[k], mul_high_s32(ends[i], ends[k]), floor);
        }
    }
}

static void recip_vectors(struct report *report)
{
    static const struct {
        uint32_t z;
        uint32_t expected_q16;
    } table[] = {
        {1, 65535},          {2, 65535},          {3, 43691},          {UINT32_C(0x80000000), 65535},
        {UINT32_MAX, 32768}, {0x7FFFFFFF, 32768}, {0x60000000, 43691}, {0x10000, 65535},
        {0x1FFFF, 32768},    {256, 65535},        {511, 32832},
    };

    for (uint8_t i = 0; i < sizeof table / sizeof *table; i++) {
        uint8_t shift;
        const uint32_t recip = recip_q16(table[i].z, &shift);
        expect(report, "recip_q16", table[i].z, shift, recip, table[i].expected_q16);
    }
}

static void ratio_vectors(struct report *report)
{
    expect(report, "ratio_q31", 0, 1, ratio_q31(0, 1), 0);
    expect(report, "ratio_q31", 0, UINT32_MAX, ratio_q31(0, UINT32_MAX), 0);
    for (uint8_t bit = 0; bit < 32; bit += 5) { /* within 8 units of the truth; the same on every CPU */
        const uint32_t den = UINT32_C(0xC0000001) >> bit;
        const int64_t miss_one = (INT64_C(1) << 31) - (int64_t)ratio_q31(den, den);
        const int64_t miss_half = (INT64_C(1) << 30) - (int64_t)ratio_q31(den / 2, den / 2 * 2);
        expect(report, "ratio_q31 near 1", den, den, miss_one >= 0 && miss_one <= 8, 1);
        expect(report, "ratio_q31 near 1/2", den / 2, den / 2 * 2, miss_half >= -8 && miss_half <= 8, 1);
    }
    expect(report, "lerp_q31 at 0", -7, INT32_MAX, lerp_q31(-7, INT32_MAX - 7, 0), -7);
    expect(report, "lerp_q31 at 1", INT32_MIN, -1, lerp_q31(INT32_MIN, -1, UINT32_C(1) << 31), -1);
    expect(report, "lerp_q31 tie", 0, 1, lerp_q31(0, 1, UINT32_C(1) << 30), 1);
    expect(report, "lerp_q31 tie", 0, -1, lerp_q31(0, -1, UINT32_C(1) << 30), 0);
}

static void angle_vectors(struct report *report)
{
    const int32_t one = INT32_C(1) << 30;
    static const int8_t sines[4] = {0, 1, 0, -1};

    for (uint8_t quarter = 0; quarter < 4; quarter++) {
        const uint32_t angle = (uint32_t)quarter << 30;
        expect(report, "lim_sin_q30", angle, 0, lim_sin_q30(angle), (int64_t)sines[quarter] * one);
        expect(report, "lim_cos_q30", angle, 0, lim_cos_q30(angle), (int64_t)sines[(quarter + 1) & 3] * one);
        expect(report, "lim_sin_q30 odd", angle + 1, 0, lim_sin_q30(angle + 1) + lim_sin_q30(0u - angle - 1), 0);
    }
    expect(report, "lim_sin_q30 of 30 degrees", 357913941, 0, lim_sin_q30(357913941), 536870912);
}

/* A number of any length. */
static uint32_t random_length_u32(uint32_t *random)
{
    const uint8_t shift = random_u32(random) & 31;

    return random_u32(random) >> shift;
}

static int64_t random_recip(uint32_t *random)
{
    uint8_t shift;
    const uint32_t z = random_length_u32(random);
    const uint32_t recip = recip_q16(z ? z : 1, &shift);

    return (int64_t)recip << 8 | shift;
}

static int64_t random_ratio(uint32_t *random)
{
    const uint32_t den = random_length_u32(random) | 1;

    return ratio_q31(random_u32(random) % den, den);
}

static int64_t random_lerp(uint32_t *random)
{
    const int32_t a = (int32_t)random_u32(random) >> 1, b = (int32_t)random_u32(random) >> 1;

    return lerp_q31(a, b, random_u32(random) >> 1);
}

static int64_t random_product(uint32_t *random)
{
    const int32_t a = (int32_t)random_u32(random), b = (int32_t)random_u32(random);

    return mul_high_s32(a, b);
}

static int64_t random_sine(uint32_t *random)
{
    return lim_sin_q30(random_u32(random));
}

/* A camera that looks at a point, and one that is put around it. */
static int64_t random_aim(uint32_t *random)
{
    struct lim_camera looking = {.yaw = 0}, orbiting;
    int32_t eye_q8[3], target_q8[3];

    for (uint8_t i = 0; i < 3; i++) {
        eye_q8[i] = (int32_t)random_length_u32(random);
        target_q8[i] = (int32_t)random_u32(random);
    }
    lim_look_at(&looking, eye_q8, target_q8);
    lim_orbit(&orbiting, target_q8, eye_q8[0], looking.yaw, looking.pitch);
    return (int64_t)looking.pitch * 4096 + looking.yaw + (orbiting.eye_q8[0] ^ orbiting.eye_q8[1] ^ orbiting.eye_q8[2]);
}

/* A camera anywhere in the cube, a vertex anywhere: transformed, and projected where it may be. */
static int64_t random_vertex(uint32_t *random)
{
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view;
    struct lim_view_point p;
    struct lim_camera camera = {.tan_x_q28 = 155000000, .tan_y_q28 = 155000000, .near_q8 = 256 * 16};
    const struct lim_scene scene = {0};
    struct lim_vertex vertex;

    vertex.x = (int16_t)random_u32(random);
    vertex.y = (int16_t)random_u32(random);
    vertex.z = (int16_t)random_u32(random);
    for (uint8_t i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)random_u32(random) >> 8;
    camera.yaw = random_u32(random);
    camera.pitch = random_u32(random);
    camera.roll = random_u32(random);
    lim_view_init(&view, 240, 135, cache);
    if (!lim_view_begin(&view, &scene, &camera)) return -1;
    lim_view_transform(&view, &scene, &vertex, &p);
    if (p.z_qv < view.rows.near_qv || abs_s32(p.x_qv) / 2 > (uint32_t)p.z_qv ||
        abs_s32(p.y_qv) / 2 > (uint32_t)p.z_qv) {
        return (int64_t)p.x_qv * 3 + (int64_t)p.y_qv * 5 + p.z_qv;
    }
    struct lim_point at;
    lim_view_project(&view, &p, &at);
    return (int64_t)at.x * 65536 + at.y;
}

/* A quadrilateral with corners in the guard band of a 240-pixel screen, followed down its lines. */
static int64_t random_edges(uint32_t *random)
{
    struct lim_point at[3];
    struct lim_edge_shape shape;
    struct lim_edge_pair pair;
    uint32_t hash = 0;

    for (uint8_t i = 0; i < 3; i++) {
        at[i].x = (lim_sub)((int32_t)(random_u32(random) % 30720u) - 7712);
        at[i].y = (lim_sub)((int32_t)(random_u32(random) % 30720u) - 7712);
    }
    lim_edge_bounds(&shape, at, 3);
    if (shape.top >= shape.bottom) return 0;
    lim_edge_begin(&pair, 3, shape.first);
    for (int16_t y = shape.top;;) {
        lim_edge_advance(&pair, at, 3, y);
        hash = hash_s64(hash, (int64_t)lim_edge_x(&pair.left) * 4096 + lim_edge_x(&pair.right));
        if (++y >= shape.bottom) return hash;
    }
}

static void side_vectors(struct report *report)
{
    enum { SIDES = 3 };
    static const LIM_FLASH struct lim_plane_exact exact[1] = {{{INT32_MAX, -INT32_MAX, 1}, 32767, UINT32_MAX}};
    static const LIM_FLASH struct lim_plane planes[2] = {LIM_PLANE(16383, 0, -16384, LIM_NO_INDEX, 0),
                                                         LIM_PLANE(8191, -8191, 0, 0, 536805376)};
    static const LIM_FLASH struct lim_plane_ref refs[SIDES] = {
        {LIM_PLANE_X, -32768},
        {0, 0},
        {LIM_PLANE_WORDS, 0},
    };
    const struct lim_scene scene = {.planes = planes, .exact = exact};
    static const struct {
        int32_t eye_q8[3];
        int8_t expected[SIDES];
    } table[] = {
        {{-32768 * 256, 0, 0}, {0, -1, -1}},
        {{-32768 * 256 + 1, 0, 0}, {1, -1, -1}},
        {{-32768 * 256 - 1, 0, 0}, {-1, -1, -1}},
        {{16384, 0, 16383}, {1, 0, -1}},
        {{16385, 5, 16383}, {1, 1, -1}},
        {{16383, -5, 16383}, {1, -1, -1}},
        {{LIM_EYE_MAX_Q8 - 1, LIM_EYE_MAX_Q8 - 1, LIM_EYE_MAX_Q8 - 1}, {1, -1, -1}},
        {{LIM_EYE_MAX_Q8 - 1, -(LIM_EYE_MAX_Q8 - 1), 0}, {1, 1, 1}},
    };

    for (uint8_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct lim_eye eye;
        lim_eye_set(&eye, &scene, table[i].eye_q8);
        for (uint8_t k = 0; k < SIDES; k++) {
            const int32_t side = lim_eye_side(&eye, &refs[k]);
            expect(report, "lim_eye_side", i, k, (side > 0) - (side < 0), table[i].expected[k]);
        }
    }
}

int fixed_vectors_run(void (*put)(const char *line))
{
    struct report report = {.put = put};

    clz_vectors(&report);
    normalise_vectors(&report);
    rounding_vectors(&report);
    product_vectors(&report);
    recip_vectors(&report);
    ratio_vectors(&report);
    angle_vectors(&report);
    side_vectors(&report);
    series(&report, "recip_q16", random_recip);
    series(&report, "ratio_q31", random_ratio);
    series(&report, "lerp_q31", random_lerp);
    series(&report, "mul_high_s32", random_product);
    series(&report, "lim_sin_q30", random_sine);
    series(&report, "aim", random_aim);
    series(&report, "vertex", random_vertex);
    series(&report, "edges", random_edges);
    return report.failed;
}
