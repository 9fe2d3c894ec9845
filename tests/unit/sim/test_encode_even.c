/* SPDX-License-Identifier: MIT
 *
 * From how far away on texels advance evenly, as the compiler writes it into triangles: there even texels are right
 * enough, whichever way the triangle is turned, by its places in doubles; and it is not much farther than that. */
#include "compiler/encode_even.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"

#include <math.h>
#include <stdlib.h>

enum { TURNS = 60, SAMPLES = 12 };

struct stage {
    struct lim_vertex vertices[3];
    struct lim_uv uvs[3];
    struct lim_texture texture;
    lim_index words[LIM_TRIANGLE_WORDS];
    struct encoding encoding;
};

static void make(struct stage *stage, struct random *random, uint16_t textures)
{
    const int size = 1 << random_in(random, 3, 13), gain = 1 << random_in(random, 0, 14);

    *stage = (struct stage){.words = {0, 1, 2, 0}};
    for (int k = 0; k < 3; k++) {
        stage->vertices[k] =
            (struct lim_vertex){(int16_t)random_in(random, -size, size), (int16_t)random_in(random, -size, size),
                                (int16_t)random_in(random, -size, size)};
        stage->uvs[k] = (struct lim_uv){(int16_t)random_in(random, 0, gain), (int16_t)random_in(random, 0, gain)};
    }
    stage->texture.w_bits = (uint8_t)random_in(random, 1, 10);
    stage->texture.place_bits = (uint8_t)random_in(random, stage->texture.w_bits + 1, 15);
    stage->encoding.vertices = stage->vertices;
    stage->encoding.uvs = stage->uvs;
    stage->encoding.words = stage->words;
    stage->encoding.word_count = LIM_TRIANGLE_WORDS;
    stage->encoding.textures.textures = &stage->texture;
    stage->encoding.textures.texture_count = textures;
    encode_even(&stage->encoding);
}

/* Of a triangle's last word, as scene.h has it; 0: nobody knows. */
static double distance_of(lim_index word)
{
    const unsigned code = word >> LIM_TRIANGLE_TEXTURE_BITS, e = code / 4, m = code % 4;
    return code ? (7.0 - m) * pow(2, 29.0 - e) : 0;
}

static double side_of(const struct stage *stage, int k, double way[3])
{
    const struct lim_vertex *a = &stage->vertices[k], *b = &stage->vertices[(k + 1) % 3];
    way[0] = b->x - a->x, way[1] = b->y - a->y, way[2] = b->z - a->z;
    return sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
}

static double texels_of(const struct stage *stage, int place)
{
    return ldexp(place, stage->texture.w_bits - stage->texture.place_bits);
}

/* By how much even texels are off at most between the corners, if they are so far away. */
static double most_off(const struct stage *stage, const double z[3])
{
    double most = 0;
    for (int i = 0; i <= SAMPLES; i++)
        for (int j = 0; i + j <= SAMPLES; j++) {
            const double part[3] = {(double)i / SAMPLES, (double)j / SAMPLES, (double)(SAMPLES - i - j) / SAMPLES};
            double w = 0, even[2] = {0, 0}, right[2] = {0, 0};
            for (int k = 0; k < 3; k++) {
                const double places[2] = {texels_of(stage, stage->uvs[k].u), texels_of(stage, stage->uvs[k].v)};
                w += part[k] / z[k];
                for (int c = 0; c < 2; c++)
                    even[c] += part[k] * places[c], right[c] += part[k] * places[c] / z[k];
            }
            for (int c = 0; c < 2; c++)
                most = fmax(most, fabs(even[c] - right[c] / w));
        }
    return most;
}

/* Along a direction of any kind, or a side, which is the worst. The mean is that of nearness. */
static double most_off_turned(const struct stage *stage, struct random *random, double distance, int turn)
{
    double ahead[3], z[3], length = 0, mean = 0;
    if (turn < 3) (void)side_of(stage, turn, ahead);
    for (int i = 0; i < 3; i++) {
        if (turn >= 3) ahead[i] = 2 * random_unit(random) - 1;
        length += ahead[i] * ahead[i];
    }
    if (length <= 0) return 0;
    for (int k = 0; k < 3; k++)
        z[k] = (ahead[0] * stage->vertices[k].x + ahead[1] * stage->vertices[k].y + ahead[2] * stage->vertices[k].z) /
               sqrt(length);
    const double first = z[0];
    double low = 0, high = 4 * distance; /* where the corner 0 lies */
    for (int i = 0; i < 60; i++) {
        const double at = (low + high) / 2;
        mean = 0;
        for (int k = 0; k < 3; k++)
            mean += at + z[k] - first > 1e-3 ? 1 / (at + z[k] - first) / 3 : INFINITY;
        *(mean > 1 / distance ? &low : &high) = at;
    }
    for (int k = 0; k < 3; k++)
        z[k] += high - first;
    return most_off(stage, z);
}

static void there_even_texels_are_right_enough(void **state)
{
    struct random random = {1};
    int known = 0;

    (void)state;
    for (int i = 0; i < effort(3000); i++) {
        struct stage stage;
        make(&stage, &random, 1);
        const double distance = distance_of(stage.words[3]);
        if (distance <= 0) continue;
        known++;
        for (int turn = 0; turn < TURNS / 10; turn++)
            assert_true(most_off_turned(&stage, &random, distance, turn) <= 0.25);
    }
    assert_true(known > effort(3000) * 9 / 10);
}

static void it_is_not_farther_than_that(void **state)
{
    struct random random = {2};
    int tight = 0, count = 0;

    (void)state;
    for (int i = 0; i < effort(1000); i++) {
        struct stage stage;
        double most = 0, gain = 0, longest = 0, way[3];
        make(&stage, &random, 1);
        for (int k = 0; k < 3; k++) {
            const struct lim_uv *a = &stage.uvs[k], *b = &stage.uvs[(k + 1) % 3];
            gain = fmax(gain,
                        texels_of(&stage, abs(a->u - b->u) > abs(a->v - b->v) ? abs(a->u - b->u) : abs(a->v - b->v)));
            longest = fmax(longest, side_of(&stage, k, way));
        }
        if (gain < 20 || stage.texture.w_bits > 8 || longest < 20 || distance_of(stage.words[3]) <= 0) continue;
        for (int turn = 0; turn < TURNS; turn++)
            most = fmax(most, most_off_turned(&stage, &random, distance_of(stage.words[3]) / 2, turn));
        count++;
        tight += most > 0.25;
    }
    assert_true(count > effort(1000) / 20);
    assert_true(tight > count * 3 / 4);
}

static void too_many_textures_leave_no_room_for_it(void **state)
{
    struct random random = {3};
    struct stage stage;

    (void)state;
    make(&stage, &random, LIM_TRIANGLE_TEXTURES);
    assert_true(stage.words[3] >= LIM_TRIANGLE_TEXTURES);
    make(&stage, &random, LIM_TRIANGLE_TEXTURES + 1);
    assert_int_equal(stage.words[3], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_even_texels_are_right_enough),
        cmocka_unit_test(it_is_not_farther_than_that),
        cmocka_unit_test(too_many_textures_leave_no_room_for_it),
    };

    return cmocka_run_group_tests_name("encode_even", tests, NULL, NULL);
}
