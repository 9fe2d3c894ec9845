/* SPDX-License-Identifier: MIT
 *
 * What texturing sets up once a frame and once a polygon, and what a line makes of it, number by number against
 * doubles: the planes over the screen, the texel that each pixel's ray meets, the level of detail. */
#include "math/orientation.h"
#include "pixels/texture.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random_camera.h"
#include "view/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* LESS_Q4: by how much level_q4 is less than what it is of, as each pixel's logarithm is 30 less (texture.h). */
enum { ROUNDS = 4000, POINTS = 6, LESS_Q4 = 3 * 30 * 16 / 2 };

struct stage {
    struct lim_texturing texturing;
    struct lim_camera camera;
    struct lim_mapping mapping;
    struct lim_texture texture;
    struct lim_scene scene;
    lim_index words[2];
    int w_px, h_px;
    double right[3], down[3], ahead[3], n[3], uv[2][3], eye[3], h; /* in units; uv in texels a unit */
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* |x| + |y| + |z| <= 32767. */
static void any_normal(struct random *random, int16_t n[3], double out[3], int bits)
{
    const int64_t reach = INT64_C(1) << random_in(random, 8, 13);

    do {
        for (int i = 0; i < 3; i++)
            n[i] = (int16_t)random_in(random, -reach, reach);
    } while (abs(n[0]) + abs(n[1]) + abs(n[2]) < 128);
    for (int i = 0; i < 3; i++)
        out[i] = ldexp(n[i], -bits);
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
    camera->roll = random_angle(random);
    camera->tan_x_q28 = (uint32_t)random_in(random, 1 << 24, 1 << 30);
    camera->tan_y_q28 = (uint32_t)random_in(random, 1 << 24, 1 << 30);
    lim_orientation_set(axes_q30, camera);
    for (int i = 0; i < 3; i++) {
        stage->right[i] = ldexp(axes_q30[i], -30);
        stage->down[i] = ldexp(axes_q30[3 + i], -30);
        stage->ahead[i] = ldexp(axes_q30[6 + i], -30);
    }
}

static void stage_open(struct stage *stage, struct random *random)
{
    static struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view = {0};

    memset(stage, 0, sizeof *stage);
    stage->w_px = (int)random_in(random, 2, 240);
    stage->h_px = (int)random_in(random, 2, 240);
    any_camera(stage, random);
    any_normal(random, stage->mapping.n, stage->n, 0);
    for (int i = 0; i < 2; i++) {
        stage->mapping.bits[i] = (uint8_t)random_in(random, 4, 20);
        any_normal(random, stage->mapping.uv[i], stage->uv[i], stage->mapping.bits[i]);
        stage->mapping.at_zero_q16[i] = (int32_t)random_u64(random);
    }
    stage->mapping.d = (int32_t)random_in(random, -(1 << 28), 1 << 28);
    stage->mapping.level_q4 = (int16_t)random_in(random, -64, 64);
    stage->h = stage->mapping.d - dot(stage->n, stage->eye);
    stage->texture = (struct lim_texture){.w_bits = 9, .h_bits = 8, .levels = 9};
    stage->scene = (struct lim_scene){.polygons = stage->words,
                                      .mappings = &stage->mapping,
                                      .textures = &stage->texture,
                                      .mapping_count = 1,
                                      .texture_count = 1};
    lim_view_init(&view, (uint16_t)stage->w_px, (uint16_t)stage->h_px, cache);
    assert_true(lim_view_begin(&view, &stage->scene, &stage->camera));
    lim_texture_begin(&stage->texturing, &stage->scene, &view, &stage->camera);
    /* For the bounds that hang on it. */
    stage->texturing.far_bits = (uint8_t)random_in(random, 8, 17);
}

/* The way through X and Y half pixels from the middle. */
static void way_of(const struct stage *stage, int x, int y, double way[3])
{
    const double right = ldexp(stage->camera.tan_x_q28, -28) * x / stage->w_px;
    const double down = ldexp(stage->camera.tan_y_q28, -28) * y / stage->h_px;

    for (int i = 0; i < 3; i++)
        way[i] = stage->ahead[i] + right * stage->right[i] + down * stage->down[i];
}

static double at(const struct lim_texture_plane *plane, int x, int y)
{
    return plane->at + (double)plane->x * x + (double)plane->y * y;
}

/* What a plane is of, but for a power of two: that of the middle, where it is not 0. */
static double scale_of(const struct stage *stage, const struct lim_texture_plane *plane, const double n[3])
{
    const double right = dot(n, stage->right) * ldexp(stage->camera.tan_x_q28, -28) / stage->w_px;
    const double down = dot(n, stage->down) * ldexp(stage->camera.tan_y_q28, -28) / stage->h_px;
    const double sum = fabs(dot(n, stage->ahead)) + fabs(right) + fabs(down);
    const double found = fabs((double)plane->at) + fabs((double)plane->x) + fabs((double)plane->y);

    return found / sum;
}

/* As far as texture.h says that it is asked. */
static double most_of(const struct stage *stage, const struct lim_texture_plane *plane)
{
    return fabs((double)plane->at) + 2 * stage->w_px * fabs((double)plane->x) + stage->h_px * fabs((double)plane->y);
}

static void check_depth(const struct stage *stage, const struct lim_gradients *gradients)
{
    const double found = scale_of(stage, &gradients->depth, stage->n), scale = exp2(round(log2(found)));
    const double sign = stage->h < 0 ? -1 : 1, most = most_of(stage, &gradients->depth);

    assert_true(fabs(found / scale - 1) < 1e-4);
    assert_true(most < 1 << 30 && most > (1 << 29) - 1000000);
    /* Gradients and tangents are rounded, and dots of normals with axes to 2^-15. */
    const double tangents = ldexp(stage->camera.tan_x_q28, -28) + ldexp(stage->camera.tan_y_q28, -28);
    const double off = stage->w_px + stage->h_px + most / (1 << 20) + 2 * scale / 32768 * (1 + tangents);
    for (int k = 0; k < POINTS; k++) {
        const int x = (k % 3 - 1) * stage->w_px, y = (k % 2 * 2 - 1) * stage->h_px;
        double way[3];
        way_of(stage, x, y, way);
        assert_true(fabs(at(&gradients->depth, x, y) - sign * scale * dot(stage->n, way)) < off);
    }
    const double least = fabs(stage->h) * scale / exp2(stage->texturing.far_bits);
    const double expected = fmin(fmax(round(least), 1), 1 << 29);
    assert_true(fabs(gradients->depth_min - expected) <= 1 + expected / (1 << 28));
}

/* Modulo 2^16 texels. */
static double apart(double a, double b)
{
    return fabs(remainder(a - b, 65536));
}

static void check_texels(const struct stage *stage, const struct lim_gradients *gradients)
{
    for (int i = 0; i < 2; i++) {
        const double most = most_of(stage, &gradients->uv[i]);
        const double eye = dot(stage->uv[i], stage->eye) + stage->mapping.at_zero_q16[i] / 65536.0;
        assert_true(apart(gradients->eye_uv_q16[i] / 65536.0, eye) <= 1.01 / 65536);
        assert_true(most < 1 << 30 && most > 1 << 26);
        for (int k = 0; k < POINTS; k++) {
            const int x = (k % 3 - 1) * stage->w_px, y = (k % 2 * 2 - 1) * stage->h_px;
            const double depth = at(&gradients->depth, x, y);
            double way[3];
            way_of(stage, x, y, way);
            if (depth < 1 << 22) continue;
            const double expected = stage->h * dot(stage->uv[i], way) / dot(stage->n, way);
            const double per = ldexp(1, 30 - gradients->shift[i] - 16) / depth;
            const double found = at(&gradients->uv[i], x, y) * per;
            const double off = (stage->w_px + stage->h_px + most / (1 << 20)) * per + fabs(expected) * 1e-3;
            assert_true(fabs(found - expected) <= off);
        }
    }
}

/* log2 of texels a pixel, the mean of both directions: 3/2 log2(depth) of it is left for the pixels. */
static void check_level(const struct stage *stage, const struct lim_gradients *gradients)
{
    const double scale = exp2(round(log2(scale_of(stage, &gradients->depth, stage->n))));
    const double lens = (log2(2 * ldexp(stage->camera.tan_x_q28, -28) / stage->w_px) +
                         log2(2 * ldexp(stage->camera.tan_y_q28, -28) / stage->h_px)) /
                        2;
    const double level_q4 =
        stage->mapping.level_q4 + 16 * (lens + log2(fabs(stage->h)) + 1.5 * log2(scale)) + 8 /* to nearest */;

    /* A logarithm is at most 1.4 short; those of the lens are halved. */
    const double found = gradients->level_q4 + LESS_Q4;
    assert_true(found - level_q4 < 2 && found - level_q4 > -5);
}

static void planes_are_those_of_rays(void **state)
{
    struct random random = {701};

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_gradients gradients;
        struct stage stage;
        stage_open(&stage, &random);
        if (fabs(stage.h) < 1000) continue;
        stage.texturing.scene = &stage.scene;
        lim_texture_set(&stage.texturing, 0, &gradients);
        check_depth(&stage, &gradients);
        check_texels(&stage, &gradients);
        check_level(&stage, &gradients);
    }
}

/* However near to the plane the eye is. */
static void depths_are_never_below_the_least(void **state)
{
    struct random random = {703};
    int least = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_gradients gradients;
        struct stage stage;
        stage_open(&stage, &random);
        stage.texturing.far_bits = 17;
        stage.mapping.d = (int32_t)floor(dot(stage.n, stage.eye)) + round % 3;
        stage.h = stage.mapping.d - dot(stage.n, stage.eye);
        lim_texture_set(&stage.texturing, 0, &gradients);
        if (stage.h == 0) stage.h = 1.0 / 256;
        const double scale = exp2(nearbyint(log2(scale_of(&stage, &gradients.depth, stage.n))));
        const double depth = fabs(stage.h) * scale / exp2(stage.texturing.far_bits);
        assert_true(gradients.depth_min >= 1 && fabs(gradients.depth_min - fmax(depth, 1)) <= 0.51);
        least += depth < 0.4;
    }
    assert_true(least > 10);
}

/* Lines -------------------------------------------------------------------------------------- */

/* The texel of the planes as they are, and how far reciprocals of 15 bits may be off. */
static double texel_of(const struct lim_gradients *gradients, int i, int x, int y, double *off)
{
    const double depth = at(&gradients->depth, x, y);
    const double way =
        at(&gradients->uv[i], x, y) / fmax(depth, gradients->depth_min) * ldexp(1, 30 - gradients->shift[i] - 16);

    /* A product is cut to units, which a shift makes larger. */
    const double unit = exp2(31 - floor(log2(fmax(depth, gradients->depth_min))) - gradients->shift[i]) / 65536;
    *off = fabs(way) / (LIM_HAS_LIMBS ? 1 << 26 : 1 << 14) + 2 * unit + 2.0 / 65536;
    return gradients->eye_uv_q16[i] / 65536.0 + way;
}

/* Texels do not go past the stretch's end, but for what is cut to units; and as near to it as a reciprocal of 15 bits
 * takes them, which is exact for powers of two. */
static void check_share(double step_q16, double way_q16, int steps)
{
    const double share_q16 = way_q16 / steps, off_q16 = steps & (steps - 1) ? fabs(way_q16) / 32768 : 0;

    assert_true(fabs(step_q16 - share_q16) <= 2 + off_q16);
    if (way_q16 > 0) assert_true(step_q16 <= share_q16);
    if (way_q16 < 0) assert_true(step_q16 >= share_q16 - 2);
}

static void check_line(const struct stage *stage, const struct lim_gradients *gradients, struct random *random)
{
    const int y = (int)random_in(random, 0, stage->h_px - 1), left = (int)random_in(random, 0, stage->w_px - 1);
    const int right = (int)random_in(random, left + 1, stage->w_px), from = (int)random_in(random, left, right - 1);
    const struct lim_textured_span span = {&stage->texturing, gradients, (int16_t)y, (int16_t)left, (int16_t)right};
    const int step_px = 1 << LIM_TEXTURE_STEP_BITS;
    int begin = left + (from - left) / step_px * step_px;
    struct lim_texture_line line;

    lim_texture_line_begin(&line, &span, (int16_t)from);
    for (;;) {
        const int last = right - begin > step_px ? begin + step_px : right - 1;
        double off;
        assert_int_equal(line.x, begin);
        assert_int_equal(line.end, right - begin > step_px ? last : right);
        for (int i = 0; i < 2; i++) {
            const double first = texel_of(gradients, i, 2 * begin + 1 - stage->w_px, 2 * y + 1 - stage->h_px, &off);
            assert_true(apart(line.at.uv_q16[i] / 65536.0, first) <= off);
            const double end = texel_of(gradients, i, 2 * last + 1 - stage->w_px, 2 * y + 1 - stage->h_px, &off);
            assert_true(apart(line.to.uv_q16[i] / 65536.0, end) <= off);
            const double way_q16 = (int32_t)(line.to.uv_q16[i] - line.at.uv_q16[i]);
            const double steps = last > begin ? last - begin : 1, share_q16 = way_q16 / steps;
            check_share(line.step_q16[i], way_q16, (int)steps);
            assert_true(fabs(line.step_q16[i] - share_q16) <= 2 + fabs(share_q16) / 2000);
        }
        assert_int_equal(line.level, line.at.level < line.to.level ? line.at.level : line.to.level);
        if (line.end == right) break;
        begin = last;
        lim_texture_line_next(&line);
    }
    assert_true(line.divisions > 0);
}

/* The level of a depth, as doubles have it. */
static void check_levels(const struct stage *stage, const struct lim_gradients *gradients, struct random *random)
{
    const int y = (int)random_in(random, 0, stage->h_px - 1), x = (int)random_in(random, 0, stage->w_px - 1);
    const struct lim_textured_span span = {&stage->texturing, gradients, (int16_t)y, (int16_t)x, (int16_t)(x + 1)};
    const double depth =
        fmax(at(&gradients->depth, 2 * x + 1 - stage->w_px, 2 * y + 1 - stage->h_px), gradients->depth_min);
    const double level = (gradients->level_q4 + LESS_Q4 - 24 * log2(depth)) / 16;
    struct lim_texture_line line;

    lim_texture_line_begin(&line, &span, (int16_t)x);
    const double low = fmin(fmax(floor(level - 0.3), 0), 8), high = fmin(fmax(floor(level + 0.3), 0), 8);
    assert_true(line.at.level >= low && line.at.level <= high);
}

static void lines_show_what_planes_say(void **state)
{
    struct random random = {702};
    int lines = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_gradients gradients;
        struct stage stage;
        stage_open(&stage, &random);
        stage.texturing.scene = &stage.scene;
        lim_texture_set(&stage.texturing, 0, &gradients);
        if (gradients.shift[0] < -8 || gradients.shift[1] < -8) continue; /* whole turns are left out */
        check_line(&stage, &gradients, &random);
        check_levels(&stage, &gradients, &random);
        lines++;
    }
    assert_true(lines > ROUNDS / 8);
}

/* What is beyond 32 bits on the left are whole turns. */
static void steps_are_shifted_modulo_turns(void **state)
{
    struct stage stage;
    struct random random = {704};

    (void)state;
    stage_open(&stage, &random);
    for (int sign = -1; sign < 2; sign += 2) {
        struct lim_gradients gradients = {.depth = {1 << 29, 0, 0}, .uv = {{sign * 12345678, 0, 0}}, .depth_min = 1};
        const struct lim_textured_span span = {&stage.texturing, &gradients, 0, 0, 1};
        struct lim_texture_line line;
        gradients.texture = stage.texture;
        gradients.shift[0] = 2; /* as many as 2^29 has zeros: none is left */
        lim_texture_line_begin(&line, &span, 0);
        const int64_t product = (int32_t)line.at.uv_q16[0];
        assert_true(fabs((double)product - sign * 12345678.0 / 2) < 1000);
        for (int bits = -60; bits <= 60; bits++) {
            const uint64_t left = bits < 0 ? (uint64_t)product << -bits : (uint64_t)(product >> bits);
            gradients.shift[0] = (int8_t)(bits + 2);
            lim_texture_line_begin(&line, &span, 0);
            assert_int_equal(line.at.uv_q16[0], (uint32_t)left);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_are_those_of_rays),
        cmocka_unit_test(depths_are_never_below_the_least),
        cmocka_unit_test(lines_show_what_planes_say),
        cmocka_unit_test(steps_are_shifted_modulo_turns),
    };

    return cmocka_run_group_tests_name("texture_planes", tests, NULL, NULL);
}
