/* SPDX-License-Identifier: MIT
 *
 * What moves in glTF files that are written here: nodes one below the other, all of one name, turned, mirrored and
 * scaled, with keys of every kind. What is expected are the points of a triangle, taken through the nodes in doubles
 * by this file's own arithmetic, which is that of the glTF 2.0 specification. */
#include "accuracy/source_pose.h"
#include "model/pose.h"
#include "readers/import_motion.h"
#include "readers/model_import.h"
#include "readers/source.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_NODES = 4, MOST_KEYS = 6, POINTS = 3, TIMES = 1000 };
enum join { LINEAR, STEP, CUBICSPLINE };
enum number { FLOAT, BYTES, SHORTS };

/* Of a cubic key the values are: tangent in, value, tangent out; else the second alone. */
struct keys {
    int count, width;
    enum join join;
    enum number number;
    double times_s[MOST_KEYS], values[MOST_KEYS][3][4];
};

struct node {
    double at[3], turn[4], scale;
    struct keys at_keys, turn_keys;
};

struct tree {
    int count;
    struct node nodes[MOST_NODES];
    double points[POINTS][3];
};

static char folder[] = "/tmp/limner-test-XXXXXX";
static char path[64], bytes_path[64];

/* Random trees ------------------------------------------------------------------------------- */

static double as_float(double value)
{
    return (double)(float)value;
}

static double spread(struct random *random)
{
    return as_float(random_unit(random) * 2 - 1);
}

static void to_unit(double q[4])
{
    const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; i++)
        q[i] /= length;
}

/* As a file can hold it: integers stand for their share of the largest. */
static double as_number(double value, enum number number)
{
    if (number == FLOAT) return as_float(value);
    const double largest = number == BYTES ? 127 : 32767;
    return round(value * largest) / largest;
}

/* A spline from a quaternion to its opposite turns without bound as it comes near zero. */
static void keep_near(const double before[4], double q[4])
{
    const double dot = before[0] * q[0] + before[1] * q[1] + before[2] * q[2] + before[3] * q[3];
    for (int i = 0; i < 4; i++)
        q[i] = dot < 0 ? -q[i] : q[i];
}

static void random_keys(struct random *random, int width, struct keys *keys)
{
    *keys = (struct keys){.width = width};
    if (random_in(random, 0, 4) == 0) return;
    keys->count = (int)random_in(random, 2, MOST_KEYS);
    keys->join = (enum join)random_in(random, 0, 2);
    keys->number = width == 4 && keys->join != CUBICSPLINE ? (enum number)random_in(random, 0, 2) : FLOAT;
    for (int k = 0; k < keys->count; k++) {
        keys->times_s[k] = as_float((k ? keys->times_s[k - 1] : 0) + 0.5 + random_unit(random));
        for (int part = 0; part < 3; part++)
            for (int i = 0; i < width; i++)
                keys->values[k][part][i] = spread(random);
        if (width == 4) to_unit(keys->values[k][1]);
        if (width == 4 && keys->join == CUBICSPLINE && k) keep_near(keys->values[k - 1][1], keys->values[k][1]);
        for (int i = 0; i < width; i++)
            keys->values[k][1][i] = as_number(keys->values[k][1][i], keys->number);
    }
}

static struct tree random_tree(struct random *random)
{
    struct tree tree = {.count = (int)random_in(random, 1, MOST_NODES)};
    for (int n = 0; n < tree.count; n++) {
        struct node *node = &tree.nodes[n];
        for (int i = 0; i < 3; i++)
            node->at[i] = spread(random);
        for (int i = 0; i < 4; i++)
            node->turn[i] = spread(random);
        to_unit(node->turn);
        node->scale = (0.5 + random_unit(random)) * (random_in(random, 0, 1) ? 1 : -1);
        random_keys(random, 3, &node->at_keys);
        random_keys(random, 4, &node->turn_keys);
    }
    for (int p = 0; p < POINTS; p++)
        for (int i = 0; i < 3; i++)
            tree.points[p][i] = spread(random);
    return tree;
}

/* Files -------------------------------------------------------------------------------------- */

struct writing {
    FILE *json, *bytes;
    long at_b;
    int views, accessors, samplers;
    char view_text[16384], accessor_text[16384], sampler_text[8192], channel_text[8192];
};

static void append(char *text, size_t size_b, const char *more)
{
    if (strlen(text) + strlen(more) + 2 > size_b) fail_msg("no room");
    if (*text) strcat(text, ",");
    strcat(text, more);
}

static void put_number(FILE *file, double value, enum number number)
{
    const float real = (float)value;
    const int8_t byte = (int8_t)lround(value * 127);
    const int16_t half = (int16_t)lround(value * 32767);
    if (number == FLOAT) fwrite(&real, sizeof real, 1, file);
    if (number == BYTES) fwrite(&byte, sizeof byte, 1, file);
    if (number == SHORTS) fwrite(&half, sizeof half, 1, file);
}

static int end_view(struct writing *out, long from_b)
{
    char text[128];
    snprintf(text, sizeof text, "{\"buffer\":0,\"byteOffset\":%ld,\"byteLength\":%ld}", from_b,
             ftell(out->bytes) - from_b);
    append(out->view_text, sizeof out->view_text, text);
    while (ftell(out->bytes) % 4)
        fputc(0x55, out->bytes);
    return out->views++;
}

/* With a sparse one of one value, where the rest has another. */
static int put_accessor(struct writing *out, const double *values, int count, int width, enum number number,
                        bool is_sparse)
{
    static const int kinds[] = {5126, 5120, 5122};
    char text[512], sparse[256] = "";
    long from_b = ftell(out->bytes);
    for (int i = 0; i < count * width; i++)
        put_number(out->bytes, is_sparse && i / width == count - 1 ? 0.25 : values[i], number);
    const int view = end_view(out, from_b);
    if (is_sparse) {
        const uint16_t place = (uint16_t)(count - 1);
        from_b = ftell(out->bytes);
        fwrite(&place, sizeof place, 1, out->bytes);
        const int places = end_view(out, from_b);
        from_b = ftell(out->bytes);
        for (int i = 0; i < width; i++)
            put_number(out->bytes, values[(count - 1) * width + i], number);
        snprintf(sparse, sizeof sparse,
                 ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":%d,\"componentType\":5123},"
                 "\"values\":{\"bufferView\":%d}}",
                 places, end_view(out, from_b));
    }
    snprintf(text, sizeof text,
             "{\"bufferView\":%d,\"componentType\":%d,\"normalized\":%s,\"count\":%d,\"type\":\"%s\"%s}", view,
             kinds[number], number == FLOAT ? "false" : "true", count,
             width == 1   ? "SCALAR"
             : width == 3 ? "VEC3"
                          : "VEC4",
             sparse);
    append(out->accessor_text, sizeof out->accessor_text, text);
    return out->accessors++;
}

static void put_keys(struct writing *out, const struct keys *keys, int node, bool is_sparse)
{
    static const char *const names[] = {"LINEAR", "STEP", "CUBICSPLINE"};
    double values[MOST_KEYS * 3 * 4];
    int count = 0;
    char text[256];
    if (!keys->count) return;
    for (int k = 0; k < keys->count; k++)
        for (int part = keys->join == CUBICSPLINE ? 0 : 1; part < (keys->join == CUBICSPLINE ? 3 : 2); part++)
            for (int i = 0; i < keys->width; i++)
                values[count++] = keys->values[k][part][i];
    const int times = put_accessor(out, keys->times_s, keys->count, 1, FLOAT, false);
    const int numbers = put_accessor(out, values, count / keys->width, keys->width, keys->number, is_sparse);
    snprintf(text, sizeof text, "{\"input\":%d,\"output\":%d,\"interpolation\":\"%s\"}", times, numbers,
             names[keys->join]);
    append(out->sampler_text, sizeof out->sampler_text, text);
    snprintf(text, sizeof text, "{\"sampler\":%d,\"target\":{\"node\":%d,\"path\":\"%s\"}}", out->samplers++, node,
             keys->width == 4 ? "rotation" : "translation");
    append(out->channel_text, sizeof out->channel_text, text);
}

static void put_node(FILE *json, const struct tree *tree, int n)
{
    const struct node *node = &tree->nodes[n];
    fprintf(json, ",{\"name\":\"same\",\"translation\":[%.17g,%.17g,%.17g],\"rotation\":[%.17g,%.17g,%.17g,%.17g],",
            node->at[0], node->at[1], node->at[2], node->turn[0], node->turn[1], node->turn[2], node->turn[3]);
    fprintf(json, "\"scale\":[%.17g,%.17g,%.17g],", node->scale, node->scale, node->scale);
    if (n + 1 < tree->count)
        fprintf(json, "\"children\":[%d]}", n + 2);
    else
        fprintf(json, "\"mesh\":1}");
}

static void put_tree(const struct tree *tree, bool is_sparse)
{
    static const double floor_m[] = {-9, -9, -9, -9, -9, 9, 9, -9, -9};
    struct writing out = {.json = fopen(path, "w"), .bytes = fopen(bytes_path, "wb")};
    assert_true(out.json && out.bytes);
    put_accessor(&out, floor_m, 3, 3, FLOAT, false);
    put_accessor(&out, tree->points[0], POINTS, 3, FLOAT, false);
    for (int n = 0; n < tree->count; n++) {
        put_keys(&out, &tree->nodes[n].at_keys, n + 1, is_sparse);
        put_keys(&out, &tree->nodes[n].turn_keys, n + 1, is_sparse);
    }
    fprintf(out.json, "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],"
                      "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]},"
                      "{\"primitives\":[{\"attributes\":{\"POSITION\":1}}]}],"
                      "\"nodes\":[{\"mesh\":0,\"name\":\"same\"}");
    for (int n = 0; n < tree->count; n++)
        put_node(out.json, tree, n);
    fprintf(out.json,
            "],\"buffers\":[{\"byteLength\":%ld,\"uri\":\"m.bin\"}],\"bufferViews\":[%s],\"accessors\":[%s],"
            "\"animations\":[{\"samplers\":[%s],\"channels\":[%s]}]}",
            ftell(out.bytes), out.view_text, out.accessor_text, out.sampler_text, out.channel_text);
    fclose(out.bytes);
    fclose(out.json);
}

/* What is so ---------------------------------------------------------------------------------- */

static void value_at(const struct keys *keys, double time_s, double out[4])
{
    int k = 0;
    while (k + 1 < keys->count && keys->times_s[k + 1] <= time_s)
        k++;
    const bool between = k + 1 < keys->count && time_s > keys->times_s[k];
    const double d = between ? keys->times_s[k + 1] - keys->times_s[k] : 1;
    const double t = between ? (time_s - keys->times_s[k]) / d : 0;
    double a[4], b[4], dot = 0;
    memcpy(a, keys->values[k][1], sizeof a);
    memcpy(b, keys->values[between ? k + 1 : k][1], sizeof b);
    if (keys->width == 4 && keys->join != CUBICSPLINE) to_unit(a), to_unit(b);
    for (int i = 0; i < keys->width; i++)
        dot += a[i] * b[i];
    const double theta = acos(fmin(fabs(dot), 1));
    for (int i = 0; i < keys->width; i++) {
        if (!between || keys->join == STEP)
            out[i] = a[i];
        else if (keys->join == CUBICSPLINE)
            out[i] = (2 * t * t * t - 3 * t * t + 1) * a[i] + d * (t * t * t - 2 * t * t + t) * keys->values[k][2][i] +
                     (-2 * t * t * t + 3 * t * t) * b[i] + d * (t * t * t - t * t) * keys->values[k + 1][0][i];
        else if (keys->width == 4 && theta > 1e-6)
            out[i] = (sin((1 - t) * theta) * a[i] + (dot < 0 ? -1 : 1) * sin(t * theta) * b[i]) / sin(theta);
        else
            out[i] = a[i] + t * (b[i] - a[i]);
    }
    if (keys->width == 4) to_unit(out);
}

/* The matrix of a quaternion, as textbooks write it. */
static void turn_point(const double q[4], double v[3])
{
    const double x = q[0], y = q[1], z = q[2], w = q[3], p[3] = {v[0], v[1], v[2]};
    v[0] = (1 - 2 * y * y - 2 * z * z) * p[0] + (2 * x * y - 2 * z * w) * p[1] + (2 * x * z + 2 * y * w) * p[2];
    v[1] = (2 * x * y + 2 * z * w) * p[0] + (1 - 2 * x * x - 2 * z * z) * p[1] + (2 * y * z - 2 * x * w) * p[2];
    v[2] = (2 * x * z - 2 * y * w) * p[0] + (2 * y * z + 2 * x * w) * p[1] + (1 - 2 * x * x - 2 * y * y) * p[2];
}

/* At rest, if the time is NaN. */
static void point_at(const struct tree *tree, double time_s, const double own[3], double out[3])
{
    memcpy(out, own, 3 * sizeof *out);
    for (int n = tree->count - 1; n >= 0; n--) {
        const struct node *node = &tree->nodes[n];
        double at[4], turn[4];
        memcpy(at, node->at, 3 * sizeof *at);
        memcpy(turn, node->turn, sizeof turn);
        if (!isnan(time_s) && node->at_keys.count) value_at(&node->at_keys, time_s, at);
        if (!isnan(time_s) && node->turn_keys.count) value_at(&node->turn_keys, time_s, turn);
        for (int i = 0; i < 3; i++)
            out[i] *= node->scale;
        turn_point(turn, out);
        for (int i = 0; i < 3; i++)
            out[i] += at[i];
    }
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

static double bound_m(const struct tree *tree)
{
    const double origin[3] = {0, 0, 0};
    double from[3], at[3], reach_m = 0, low[3] = {-9, -9, -9}, high[3] = {9, -9, 9};
    point_at(tree, NAN, origin, from);
    for (int p = 0; p < POINTS; p++) {
        point_at(tree, NAN, tree->points[p], at);
        reach_m = fmax(reach_m, distance(at, from));
        for (int i = 0; i < 3; i++)
            low[i] = fmin(low[i], at[i]), high[i] = fmax(high[i], at[i]);
    }
    return fmax(reach_m / 1024, fmax(high[0] - low[0], fmax(high[1] - low[1], high[2] - low[2])) / (1 << 17));
}

static double end_s(const struct tree *tree)
{
    double end = 0;
    for (int n = 0; n < tree->count; n++) {
        const struct keys *at = &tree->nodes[n].at_keys, *turn = &tree->nodes[n].turn_keys;
        if (at->count) end = fmax(end, at->times_s[at->count - 1]);
        if (turn->count) end = fmax(end, turn->times_s[turn->count - 1]);
    }
    return end;
}

/* Jumps take the millisecond before the one in which they are over. */
static bool is_jump(const struct keys *keys, double time_s)
{
    bool is = false;
    for (int k = 0; k < keys->count && keys->join == STEP; k++)
        is |= time_s > keys->times_s[k] - 0.002 && time_s < keys->times_s[k] + 0.0011;
    return is;
}

static bool jumps(const struct tree *tree, double time_s)
{
    bool is = false;
    for (int n = 0; n < tree->count; n++)
        is |= is_jump(&tree->nodes[n].at_keys, time_s) || is_jump(&tree->nodes[n].turn_keys, time_s);
    return is;
}

/* Firmware's tables have whole milliseconds: what is faster than keys at each of them is not held to the bound. */
static bool is_too_fast(const struct model *model, double time_s)
{
    size_t k = 0;
    while (k + 1 < model->key_count && model->keys[k + 1].time_s <= time_s)
        k++;
    return time_s >= model->keys[k].time_s && k + 1 < model->key_count &&
           model->keys[k + 1].time_s - model->keys[k].time_s < 0.0021;
}

/* Tests -------------------------------------------------------------------------------------- */

static struct model read_model(void)
{
    struct model model;
    struct error err = {""};
    if (!model_import(path, &model, &err) || !source_take(path, &model, &err)) fail_msg("%s", err.text);
    return model;
}

static double worst_m(const struct tree *tree, const struct model *model, const struct model_pose *pose, double time_s)
{
    double worst = 0;
    for (int p = 0; p < POINTS; p++) {
        double own[3], is[3], expected[3], rest[3], nearest = INFINITY;
        point_at(tree, time_s, tree->points[p], expected);
        point_at(tree, NAN, tree->points[p], rest);
        for (uint32_t k = 0; k < POINTS; k++) /* a mirrored face has its corners the other way round */
            if (distance(model->points[model->corners[POINTS + k]], rest) < 1e-9) {
                pose_enter(&model->movers[0].rest, model->points[model->corners[POINTS + k]], own);
                pose_leave(pose, own, is);
                nearest = distance(is, expected);
            }
        worst = fmax(worst, nearest);
    }
    return worst;
}

/* Both the keys that firmware gets, within the bound, and the reference's own reading, as exact as doubles are. */
static void check_tree(struct random *random, bool is_sparse)
{
    const struct tree tree = random_tree(random);
    const double end = end_s(&tree), bound = bound_m(&tree);
    put_tree(&tree, is_sparse);
    if (end == 0) return;
    struct model model = read_model();
    int left_out = 0;
    assert_int_equal(model.mover_count, 1);
    for (int i = 0; i < TIMES; i++) {
        const double time_s = random_unit(random) * end * 0.9999;
        struct model_pose pose = pose_at(&model, &model.movers[0], time_s);
        if (jumps(&tree, time_s)) continue;
        double off_m = worst_m(&tree, &model, &pose, time_s);
        left_out += is_too_fast(&model, time_s);
        if (!(off_m <= bound) && !is_too_fast(&model, time_s))
            fail_msg("at %g s a point is %g m off, for %g", time_s, off_m, bound);
        assert_true(source_pose(&model, 0, time_s, &pose));
        off_m = worst_m(&tree, &model, &pose, time_s);
        if (!(off_m <= 1e-9)) fail_msg("at %g s the reference has a point %g m off", time_s, off_m);
    }
    assert_true(left_out < TIMES / 20);
    model_free(&model);
}

static void points_are_where_the_file_has_them(void **state)
{
    struct random random = {.state = 11};
    (void)state;
    for (int i = 0; i < effort(200); i++)
        check_tree(&random, i % 3 == 0);
}

/* At whole milliseconds, which frames are drawn at, a jump is where the file has it. */
static void a_jump_is_over_in_a_millisecond(void **state)
{
    struct tree tree = {.count = 1, .nodes = {{.turn = {0, 0, 0, 1}, .scale = 1}}, .points = {{1, 0, 0}, {0, 1, 0}}};
    (void)state;
    tree.nodes[0].at_keys = (struct keys){.count = 3,
                                          .width = 3,
                                          .join = STEP,
                                          .times_s = {0, as_float(0.1), as_float(0.7)},
                                          .values = {{{0}, {0, 0, 0}}, {{0}, {5, 0, 0}}, {{0}, {5, 2, 0}}}};
    put_tree(&tree, false);
    struct model model = read_model();
    for (int ms = 0; ms < 700; ms++) {
        const struct model_pose pose = pose_at(&model, &model.movers[0], ms / 1000.0);
        assert_true(fabs(pose.at_m[0] - (ms < 100 ? 0 : 5)) < 1e-6 && fabs(pose.at_m[1]) < 1e-6);
    }
    assert_int_equal(model.movers[0].key_count, 5);
    model_free(&model);
}

static void what_is_left_out_moves_nothing(void **state)
{
    struct random random = {.state = 5};
    struct tree tree = random_tree(&random);
    (void)state;
    tree.nodes[0].at_keys = (struct keys){.count = 2, .width = 3, .times_s = {0, 1}, .values = {{{0}, {NAN}}}};
    put_tree(&tree, false);
    motions_leave_out(true);
    struct model model = read_model();
    motions_leave_out(false);
    assert_true(model.is_stopped && !model.mover_count && !model.key_count);
    for (int p = 0; p < POINTS; p++) {
        double rest[3];
        point_at(&tree, NAN, tree.points[p], rest);
        bool is_there = false;
        for (uint32_t k = 0; k < POINTS; k++)
            is_there |= distance(model.points[model.corners[POINTS + k]], rest) < 1e-9;
        assert_true(is_there);
    }
    model_free(&model);
    struct error err = {""};
    assert_false(model_import(path, &model, &err));
    assert_non_null(
        strstr(err.text, "animation 1: its times do not ascend from 0, or a key is no number; --movers off"));
}

static int set_up(void **state)
{
    (void)state;
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/m.gltf", folder);
    snprintf(bytes_path, sizeof bytes_path, "%s/m.bin", folder);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    unlink(bytes_path);
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_where_the_file_has_them),
        cmocka_unit_test(a_jump_is_over_in_a_millisecond),
        cmocka_unit_test(what_is_left_out_moves_nothing),
    };
    return cmocka_run_group_tests_name("node motion", tests, set_up, tear_down);
}
