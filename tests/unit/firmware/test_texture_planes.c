/* SPDX-License-Identifier: MIT
 *
 * What texturing sets up once a frame and once a polygon, and what lines make of it, pixel by pixel against rays in
 * doubles: the place that each shows, and the level of detail. */
#include "math/orientation.h"
#include "pixels/texture.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random_camera.h"
#include "view/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 6000 };

struct stage {
    struct lim_texturing texturing;
    struct lim_camera camera;
    struct lim_mapping mapping;
    struct lim_texture texture;
    struct lim_plane plane;
    struct lim_scene scene;
    lim_index words[2];
    uint16_t palette[256];
    int w_px, h_px, axis;
    double right[3], down[3], ahead[3], n[3], d, eye[3]; /* in units */
    double even, seen;                                   /* polygons whose texels are even all over; all of them */
    double worst, pixels;
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void any_camera(struct stage *stage, struct random *random)
{
    struct lim_camera *camera = &stage->camera;
    int32_t axes_q30[9];

    *camera = (struct lim_camera){.near_q8 = 256};
    for (int i = 0; i < 3; i++) {
        camera->eye_q8[i] = (int32_t)random_in(random, -(1 << 22), 1 << 22);
        stage->eye[i] = camera->eye_q8[i] / 256.0;
    }
    camera->yaw = random_angle(random);
    camera->pitch = random_angle(random);
    camera->roll = random_in(random, 0, 1) ? random_angle(random) : 0;
    camera->tan_x_q28 = (uint32_t)random_in(random, 1 << 25, 1 << 29);
    camera->tan_y_q28 = (uint32_t)random_in(random, 1 << 25, 1 << 29);
    lim_orientation_set(axes_q30, camera);
    for (int i = 0; i < 3; i++) {
        stage->right[i] = ldexp(axes_q30[i], -30);
        stage->down[i] = ldexp(axes_q30[3 + i], -30);
        stage->ahead[i] = ldexp(axes_q30[6 + i], -30);
    }
}

/* A plane some way from the eye: an axis plane, or any. */
static void any_plane(struct stage *stage, struct random *random)
{
    int16_t n[3];

    stage->axis = (int)random_in(random, 0, 2);
    if (random_in(random, 0, 2) == 0) {
        const int16_t offset = (int16_t)random_in(random, -20000, 20000);
        stage->mapping.plane = (lim_index)(lim_offset)offset;
        stage->mapping.scale = LIM_MAPPING_UPRIGHT;
        for (int i = 0; i < 3; i++)
            stage->n[i] = i == stage->axis ? LIM_MAPPING_UPRIGHT_N : 0;
        stage->d = (double)offset * LIM_MAPPING_UPRIGHT_N;
    } else {
        for (int i = 0; i < 3; i++) {
            n[i] = (int16_t)(i == stage->axis ? 12000 : random_in(random, -10000, 10000));
            stage->n[i] = n[i];
        }
        stage->d = floor(dot(stage->n, stage->eye) + (double)random_in(random, -(1 << 28), 1 << 28));
        stage->d = fmax(fmin(stage->d, LIM_PLANE_D_MAX), -(double)LIM_PLANE_D_MAX);
        stage->plane = (struct lim_plane)LIM_PLANE(n[0], n[1], n[2], LIM_NO_INDEX, (int32_t)stage->d);
    }
    stage->mapping.scale |= (uint8_t)(stage->axis << LIM_MAPPING_AXIS_SHIFT);
}

/* A texel has 8 to some hundred units. */
static void any_mapping(struct stage *stage, struct random *random)
{
    struct lim_mapping *mapping = &stage->mapping;
    const int w_bits = (int)random_in(random, 0, 10), h_bits = (int)random_in(random, 0, w_bits);
    double cross;

    stage->texture = (struct lim_texture){
        .w_bits = (uint8_t)w_bits, .h_bits = (uint8_t)h_bits, .levels = (uint8_t)random_in(random, 1, h_bits + 1)};
    do {
        for (int i = 0; i < 4; i++)
            mapping->uv[i / 2][i % 2] = (int16_t)random_in(random, -16383, 16383);
        cross = fabs((double)mapping->uv[0][0] * mapping->uv[1][1] - (double)mapping->uv[0][1] * mapping->uv[1][0]);
    } while (cross < 1 << 24);
    const int bits = 19 + w_bits > 31 ? 31 : 19 + w_bits;
    mapping->scale |= (uint8_t)bits;
    for (int i = 0; i < 2; i++)
        mapping->at_zero_q16[i] = (uint16_t)random_u64(random);
    /* Seen across the plane, where it is larger by |n| / n of the axis. */
    const double size = sqrt(dot(stage->n, stage->n));
    const double area = cross * size == 0 ? 0 : cross * fabs(stage->n[stage->axis]) / size;
    const double level = (log2(area) + log2(size / 16384)) / 2 + w_bits - bits;
    mapping->level_q3 = (int8_t)floor(8 * level + 0.5);
}

static void stage_begin_frame(struct stage *stage)
{
    static struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view = {0};
    int32_t axes_q30[9];

    lim_view_init(&view, (uint16_t)stage->w_px, (uint16_t)stage->h_px, cache);
    assert_true(lim_view_begin(&view, &stage->scene, &stage->camera));
    lim_orientation_set(axes_q30, &stage->camera);
    lim_texture_begin(&stage->texturing, &stage->scene, &view, &stage->camera, axes_q30);
    stage->texturing.far_bits = 17; /* the scene has no vertices */
}

static void stage_open(struct stage *stage, struct random *random)
{
    stage->mapping = (struct lim_mapping){0};
    stage->w_px = (int)random_in(random, 2, 240);
    stage->h_px = (int)random_in(random, 2, 240);
    any_camera(stage, random);
    any_plane(stage, random);
    any_mapping(stage, random);
    stage->scene = (struct lim_scene){.polygons = stage->words,
                                      .polygon_words = sizeof stage->words / sizeof *stage->words,
                                      .planes = &stage->plane,
                                      .mappings = &stage->mapping,
                                      .textures = &stage->texture,
                                      .palettes = stage->palette,
                                      .mapping_count = 1,
                                      .texture_count = 1};
    stage_begin_frame(stage);
}

/* Where the ray through a pixel's centre meets the plane: how far away, and the place there. false: nowhere. */
static bool place_of(const struct stage *stage, int x, int y, double *z, double place[2])
{
    const double right = ldexp(stage->camera.tan_x_q28, -28) * (2 * x + 1 - stage->w_px) / stage->w_px;
    const double down = ldexp(stage->camera.tan_y_q28, -28) * (2 * y + 1 - stage->h_px) / stage->h_px;
    const int j = (stage->axis + 1) % 3, k = (stage->axis + 2) % 3;
    double way[3];

    for (int i = 0; i < 3; i++)
        way[i] = stage->ahead[i] + right * stage->right[i] + down * stage->down[i];
    *z = (stage->d - dot(stage->n, stage->eye)) / dot(stage->n, way);
    if (!(*z > 4) || *z > 1 << 16) return false;
    for (int i = 0; i < 2; i++)
        place[i] = ldexp(stage->mapping.uv[i][0] * (stage->eye[j] + *z * way[j]) +
                             stage->mapping.uv[i][1] * (stage->eye[k] + *z * way[k]),
                         -(stage->mapping.scale & LIM_MAPPING_BITS)) +
                   stage->mapping.at_zero_q16[i] / 65536.0;
    return true;
}

/* The distance in texels of a level, as the picture repeats; and what rounding alone may do: a reciprocal of 15 bits,
 * at a distance of z and with places of 16 bits. */
static void check_pixel(struct stage *stage, int x, int y, uint32_t place, unsigned level)
{
    const double texels = ldexp(1, stage->texture.w_bits - (int)level);
    double z, expected[2], way = 0;

    if (!place_of(stage, x, y, &z, expected)) return;
    for (int i = 0; i < 2; i++) {
        const double found = (i ? place & 0xFFFF : place >> 16) / 65536.0;
        way = hypot(way, texels * remainder(found - expected[i], 1));
    }
    const double scale = ldexp(hypot(stage->mapping.uv[0][0], stage->mapping.uv[0][1]) +
                                   hypot(stage->mapping.uv[1][0], stage->mapping.uv[1][1]),
                               -(stage->mapping.scale & LIM_MAPPING_BITS)) *
                         texels;
    /* n . D has some 2^-28 of |n|; near the horizon little is left of it. */
    const double facing = fabs(stage->d - dot(stage->n, stage->eye)) / z / sqrt(dot(stage->n, stage->n));
    const double rounding = z * scale * 4 * (LIM_HAS_LIMBS ? ldexp(1, -19) : ldexp(1, -13) + ldexp(1, -18) / facing);
    const double allowed = ldexp(1.5, -LIM_TEXTURE_OFF_BITS) + ldexp(texels, -11) + rounding;
    if (way > allowed) fail_msg("pixel %d, %d: off by %.3f of %.3f texels of level %u", x, y, way, allowed, level);
    stage->worst = fmax(stage->worst, way - rounding);
    stage->pixels++;
}

/* log2 of the texels to a pixel, from how far its neighbours' places are. */
static void check_level(const struct stage *stage, int x, int y, unsigned level)
{
    double z[3], at[3][2];

    for (int i = 0; i < 3; i++)
        if (!place_of(stage, x + (i == 1), y + (i == 2), &z[i], at[i])) return;
    const double u[2] = {at[1][0] - at[0][0], at[1][1] - at[0][1]}, v[2] = {at[2][0] - at[0][0], at[2][1] - at[0][1]};
    const double area = fabs(u[0] * v[1] - u[1] * v[0]) * ldexp(1, 2 * stage->texture.w_bits);
    const double expected = log2(area) / 2 + 0.5;
    const double last = stage->texture.levels - 1;
    if (fabs(z[1] / z[0] - 1) > 0.05 || fabs(z[2] / z[0] - 1) > 0.05) return; /* a pixel is no point */
    assert_true(level >= fmin(fmax(floor(expected - 0.4), 0), last));
    assert_true(level <= fmin(fmax(floor(expected + 0.4), 0), last));
}

static void check_line(struct stage *stage, struct lim_gradients *gradients, int y, int left, int right, int from)
{
    const struct lim_textured_span span = {&stage->texturing, gradients, y, left, right};
    struct lim_texture_line line;

    lim_texture_line_begin(&line, &span, (int16_t)from);
    for (int x = from; x < right; x++) {
        if (x == line.end) lim_texture_line_next(&line);
        assert_true(line.x <= x && x < line.end);
        const unsigned level = gradients->level.number;
        check_pixel(stage, x, y, lim_texture_place(&line, x), level);
        if (x == line.x && !gradients->is_even) check_level(stage, x, y, level);
        assert_int_equal(gradients->level.w_bits, stage->texture.w_bits - level);
        assert_int_equal(gradients->level.rows_mask, ((1u << (stage->texture.h_bits - level)) - 1)
                                                         << gradients->level.w_bits);
    }
}

/* A rectangle of the screen, and lines of it that begin anywhere. */
static void check_polygon(struct stage *stage, struct random *random, int most_px)
{
    const int left = (int)random_in(random, 0, stage->w_px - 1), top = (int)random_in(random, 0, stage->h_px - 1);
    const int w = (int)random_in(random, 1, most_px < stage->w_px - left ? most_px : stage->w_px - left);
    const int h = (int)random_in(random, 1, most_px < stage->h_px - top ? most_px : stage->h_px - top);
    struct lim_point at[4];
    struct lim_gradients gradients;
    double z, place[2];

    for (int i = 0; i < 4; i++) {
        const int x = left + (i == 1 || i == 2) * w, y = top + (i > 1) * h;
        if (!place_of(stage, x, y, &z, place)) return;
        at[i].x = (lim_sub)((x - LIM_ORIGIN_PX) * LIM_SUB - LIM_SUB / 2);
        at[i].y = (lim_sub)((y - LIM_ORIGIN_PX) * LIM_SUB - LIM_SUB / 2);
    }
    stage->texturing.scene = &stage->scene;
    lim_texture_set(&stage->texturing, 0, at, random_in(random, 0, 4) ? 4 : 0, &gradients);
    for (int y = top; y < top + h; y += 1 + h / 4)
        check_line(stage, &gradients, y, left, left + w, (int)random_in(random, left, left + w - 1));
    stage->even += gradients.is_even;
    stage->seen++;
}

static void pixels_show_what_rays_meet(void **state)
{
    static struct stage stage;
    struct random random = {701};

    (void)state;
    stage.worst = stage.even = stage.seen = stage.pixels = 0;
    for (int round = 0; round < ROUNDS; round++) {
        stage_open(&stage, &random);
        check_polygon(&stage, &random, round % 2 ? 240 : 12);
    }
    print_message("%.0f polygons, %.0f of them even; %.0f pixels, the worst %.2f texels off\n", stage.seen, stage.even,
                  stage.pixels, stage.worst);
    assert_true(stage.seen > ROUNDS / 20 && stage.even > stage.seen / 20 && stage.even < stage.seen * 0.9);
}

/* However near to the plane the eye is, and whatever is seen of it: nothing is divided by 0, and nothing shifted out.
 */
static void planes_through_the_eye_end_well(void **state)
{
    static struct stage stage;
    struct random random = {703};

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_gradients gradients;
        stage_open(&stage, &random);
        for (int i = 0; i < 3; i++)
            stage.texturing.eye_high[i] = stage.texturing.eye_low_q8[i] = 0;
        stage.mapping.scale = (uint8_t)((stage.mapping.scale & ~LIM_MAPPING_BITS) | random_in(&random, 0, 31));
        stage.plane.slack_less_d = LIM_PLANE_SLACK - (int32_t)random_in(&random, -2, 2);
        if (stage.mapping.scale & LIM_MAPPING_UPRIGHT) stage.mapping.plane = 0;
        lim_texture_set(&stage.texturing, 0, NULL, 0, &gradients);
        const struct lim_textured_span span = {&stage.texturing, &gradients,
                                               (int32_t)random_in(&random, 0, stage.h_px - 1), -300, 500};
        struct lim_texture_line line;
        lim_texture_line_begin(&line, &span, 0);
        while (!gradients.is_even && line.end < stage.w_px)
            lim_texture_line_next(&line);
    }
}

/* What a line's pieces show, pixel by pixel. */
static uint16_t painted_pixels[240];
static uint32_t painted_places[240];

static void keep_places(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    assert_true(n >= 1 && end - n >= painted_pixels && end <= painted_pixels + 240);
    for (uint32_t *to = painted_places + (end - n - painted_pixels); n; n--, place += level->step)
        *to++ = place;
}

/* Of a polygon of one level, whose texels nobody has. */
static void check_painted(struct stage *stage, struct random *random, struct lim_gradients *gradients)
{
    const int left = (int)random_in(random, -300, stage->w_px - 1);
    const int right = (int)random_in(random, (left > 0 ? left : 0) + 1, 500);
    const struct lim_textured_span span = {&stage->texturing, gradients, (int32_t)random_in(random, 0, stage->h_px - 1),
                                           left, right};
    const int last = right < stage->w_px ? right : stage->w_px;
    const int x0 = (int)random_in(random, left > 0 ? left : 0, last - 1), x1 = (int)random_in(random, x0 + 1, last);
    struct lim_texture_line line;

    gradients->planes.level_depth = 0;
    gradients->planes.level_depths = UINT32_MAX;
    gradients->paint = keep_places;
    memset(painted_places, 0x55, sizeof painted_places);
    (void)lim_texture_fill_stretches(&span, painted_pixels, x0, x1);
    lim_texture_line_begin(&line, &span, (int16_t)x0);
    for (int x = x0; x < x1; x++) {
        if (x == line.end) lim_texture_line_next(&line);
        assert_int_equal(painted_places[x], lim_texture_place(&line, x));
    }
    assert_true(x1 == 240 || painted_places[x1] == 0x55555555);
}

/* Lines that are equally far away all over have a way of their own. Every other camera looks straight ahead at floors.
 */
static void what_is_painted_is_what_is_walked(void **state)
{
    static struct stage stage;
    struct random random = {709};
    int flat = 0, slanted = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_gradients gradients;
        stage_open(&stage, &random);
        if (round % 2) {
            stage.camera.pitch = stage.camera.roll = 0;
            stage.mapping.scale =
                (uint8_t)((stage.mapping.scale & LIM_MAPPING_BITS) | LIM_MAPPING_UPRIGHT | 1 << LIM_MAPPING_AXIS_SHIFT);
            stage_begin_frame(&stage);
        }
        lim_texture_set(&stage.texturing, 0, NULL, 0, &gradients);
        if (gradients.is_even) continue;
        *(gradients.planes.depth.x ? &slanted : &flat) += 1;
        check_painted(&stage, &random, &gradients);
    }
    print_message("%d polygons whose lines are equally far away all over, %d others\n", flat, slanted);
    assert_true(flat > ROUNDS / 20 && slanted > ROUNDS / 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_painted_is_what_is_walked),
        cmocka_unit_test(pixels_show_what_rays_meet),
        cmocka_unit_test(planes_through_the_eye_end_well),
    };

    return cmocka_run_group_tests_name("texture_planes", tests, NULL, NULL);
}
