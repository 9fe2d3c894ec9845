/* SPDX-License-Identifier: MIT
 *
 * Between two keys of any node on the way the motion is smooth. Such a stretch is halved until its ends, joined as
 * firmware joins them, are near enough to what lies between. Times are whole milliseconds in firmware's tables: keys
 * that lie nearer to each other are one, at which the motion jumps. */
#include "readers/motion_keys.h"

#include "base/grow.h"
#include "base/vec3.h"
#include "formats/float_step.h"
#include "model/pose.h"

#include <stdlib.h>
#include <string.h>

static const double SHEAR_MAX = 1e-4; /* cosine between axes, and how uneven their lengths may become */
static const double TICK_S = 0.001, BETWEEN_PROBES = 0.8;

enum { LIMIT_KEYS = UINT16_MAX, PROBES_A_LINK = 8 };

/* What stands still from the last node that moves down to this one, which moves. */
struct link {
    struct node_transform before;
    const struct node_motion *motion;
};

struct sampling {
    const struct motion_keys *from;
    const struct aiNode *node;
    struct link *links; /* from above */
    size_t link_count;
    double unrest[3][4];    /* rows: the inverse of what the node does at rest, without its place */
    double rest_axes[3][3]; /* of the mover's own coordinates */
    double tolerance_m, reach_m;
    struct model_key *keys;
    size_t count, capacity;
    struct error *err;
};

/* The way of the node ----------------------------------------------------------------------- */

static const struct node_transform IDENTITY = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

static bool moves(const struct node_motion *motion)
{
    return motion && (motion->tracks[PART_AT].count || motion->tracks[PART_TURN].count);
}

static void find_links(struct sampling *work)
{
    const struct motion_keys *from = work->from;
    size_t depth = 0;
    for (const struct aiNode *node = work->node; node; node = node->mParent)
        depth++;
    const struct aiNode **way = grow_zeroed(depth, sizeof(void *));
    work->links = grow_zeroed(depth, sizeof *work->links);
    const struct aiNode *node = work->node;
    for (size_t i = depth; i > 0; i--, node = node->mParent)
        way[i - 1] = node;
    struct node_transform before = IDENTITY;
    for (size_t i = 0; i < depth; i++) {
        const struct node_motion *motion = node_motions_of(from->nodes, way[i]);
        if (moves(motion)) {
            work->links[work->link_count++] = (struct link){before, motion};
            before = IDENTITY;
        } else {
            const struct node_transform own = node_transform_of(from->transforms, way[i]);
            before = node_transform_times(&before, &own);
        }
    }
    free(way);
}

static struct node_transform world_at(const struct sampling *work, double time_s, double within_s)
{
    struct node_transform world = IDENTITY;
    for (size_t i = 0; i < work->link_count; i++) {
        const struct node_transform own = node_motion_at(work->links[i].motion, time_s, within_s);
        world = node_transform_times(&world, &work->links[i].before);
        world = node_transform_times(&world, &own);
    }
    return world;
}

static struct node_transform world_at_rest(const struct sampling *work)
{
    struct node_transform world = IDENTITY;
    for (const struct aiNode *node = work->node; node; node = node->mParent) {
        const struct node_transform own = node_transform_of(work->from->transforms, node);
        world = node_transform_times(&own, &world);
    }
    return world;
}

/* Rigid or not ------------------------------------------------------------------------------- */

static double determinant(const struct node_transform *a)
{
    const double(*m)[4] = a->m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/* Of the linear part; false: it has none. */
static bool invert(const struct node_transform *a, double out[3][4])
{
    const double whole = determinant(a);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            out[i][k] = (a->m[k1][i1] * a->m[k2][i2] - a->m[k1][i2] * a->m[k2][i1]) / whole;
            if (!isfinite(out[i][k])) return false;
        }
    return true;
}

/* The mover's own axes: those of the node, turned round if it is mirrored; the scene's, if it is sheared. */
static void rest_axes_of(const struct node_transform *world, double axes[3][3])
{
    const double sign = determinant(world) < 0 ? -1 : 1;
    bool is_square = true;
    for (int i = 0; i < 3; i++) {
        double length = 0;
        for (int k = 0; k < 3; k++)
            length = hypot(length, world->m[k][i]);
        for (int k = 0; k < 3; k++)
            axes[i][k] = sign * world->m[k][i] / length;
    }
    for (int i = 0; i < 3; i++)
        is_square &= fabs(vec3_dot(axes[i], axes[(i + 1) % 3])) <= SHEAR_MAX;
    for (int i = 0; i < 9 && !is_square; i++)
        axes[i / 3][i % 3] = i / 3 == i % 3;
}

/* How the node is turned from where it is at rest; false: not by a rotation. */
static bool turned_by(const struct sampling *work, const struct node_transform *world, double columns[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            columns[i][k] = world->m[k][0] * work->unrest[0][i] + world->m[k][1] * work->unrest[1][i] +
                            world->m[k][2] * work->unrest[2][i];
    double handed = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (!(fabs(vec3_dot(columns[i], columns[j])) <= SHEAR_MAX)) return false;
        if (!(fabs(sqrt(vec3_dot(columns[i], columns[i])) - 1) <= SHEAR_MAX)) return false;
        handed += columns[0][i] * (columns[1][j] * columns[2][k] - columns[1][k] * columns[2][j]);
    }
    return handed > 0;
}

static bool pose_within(const struct sampling *work, double time_s, double within_s, struct model_pose *out)
{
    const struct node_transform world = world_at(work, time_s, within_s);
    double columns[3][3], axes[3][3];
    if (!turned_by(work, &world, columns))
        return error_set(work->err,
                         "%s: node '%s': the uneven scale of a node above shears it as it turns; apply that scale in "
                         "the program that it was made with, or --movers off",
                         work->from->path, work->node->mName.data);
    for (int i = 0; i < 3; i++) {
        out->at_m[i] = world.m[i][3];
        for (int k = 0; k < 3; k++)
            axes[i][k] = columns[0][k] * work->rest_axes[i][0] + columns[1][k] * work->rest_axes[i][1] +
                         columns[2][k] * work->rest_axes[i][2];
    }
    pose_turn_from_axes(out->turn, axes);
    return true;
}

/* Keys --------------------------------------------------------------------------------------- */

static long long tick_of(double time_s)
{
    return llround(time_s / TICK_S);
}

/* A key in the same millisecond as the last one takes its place. */
static bool add_key(struct sampling *work, double time_s, const struct model_pose *pose)
{
    if (work->count && tick_of(time_s) <= tick_of(work->keys[work->count - 1].time_s)) {
        work->keys[work->count - 1].pose = *pose;
        return true;
    }
    if (work->count == LIMIT_KEYS)
        return error_set(
            work->err,
            "%s: node '%s': its animation takes more than %d keys; a shorter one helps, one whose keys are "
            "joined by lines, or --movers off",
            work->from->path, work->node->mName.data, LIMIT_KEYS);
    work->keys = grow(work->keys, work->count, &work->capacity, sizeof *work->keys);
    work->keys[work->count++] = (struct model_key){time_s, *pose};
    return true;
}

/* No point is farther from where it should be. */
static double apart_m(const struct sampling *work, const struct model_pose *a, const struct model_pose *b)
{
    double with = 0, against = 0;
    for (int i = 0; i < 4; i++) {
        with = hypot(with, a->turn[i] - b->turn[i]);
        against = hypot(against, a->turn[i] + b->turn[i]);
    }
    return sqrt(vec3_distance2(a->at_m, b->at_m)) + 2 * fmin(with, against) * work->reach_m;
}

static struct model_pose pose_between(const struct model_key *a, const struct model_key *b, double t)
{
    struct model_pose pose;
    for (int i = 0; i < 3; i++)
        pose.at_m[i] = a->pose.at_m[i] + t * (b->pose.at_m[i] - a->pose.at_m[i]);
    pose_turn_between(a->pose.turn, b->pose.turn, t, pose.turn);
    return pose;
}

/* Between probes the error may be larger than at any of them; a part of the tolerance is held back for that. */
static bool is_near_enough(const struct sampling *work, const struct model_key *a, const struct model_key *b,
                           double within_s, size_t probes, bool *near)
{
    *near = true;
    for (size_t i = 1; i < probes && *near; i++) {
        const double t = (double)i / (double)probes;
        const struct model_pose joined = pose_between(a, b, t);
        struct model_pose pose;
        if (!pose_within(work, a->time_s + t * (b->time_s - a->time_s), within_s, &pose)) return false;
        *near = apart_m(work, &joined, &pose) <= BETWEEN_PROBES * work->tolerance_m;
    }
    return true;
}

/* Adds what a stretch of smooth motion needs between its ends, at whole milliseconds. Each half of it has half of the
 * probes: they lie no wider apart than in the whole. */
static bool add_between(struct sampling *work, const struct model_key *a, const struct model_key *b, double within_s,
                        size_t probes)
{
    const size_t halved = probes / 2 < PROBES_A_LINK ? PROBES_A_LINK : probes / 2;
    bool near;
    struct model_key middle = {.time_s = (double)tick_of((a->time_s + b->time_s) / 2) * TICK_S};
    if (tick_of(middle.time_s) <= tick_of(a->time_s) || tick_of(middle.time_s) >= tick_of(b->time_s)) return true;
    if (!is_near_enough(work, a, b, within_s, probes, &near)) return false;
    if (near) return true;
    return pose_within(work, middle.time_s, within_s, &middle.pose) &&
           add_between(work, a, &middle, within_s, halved) && add_key(work, middle.time_s, &middle.pose) &&
           add_between(work, &middle, b, within_s, halved);
}

/* Keys of the file that lie less than a millisecond from the first of them. */
struct moment {
    double first_s, last_s;
};

static int by_value(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

/* The moments of all keys on the way, and the end of all. */
static size_t find_moments(const struct sampling *work, struct moment **out)
{
    size_t most = 1, count = 0, kept = 0;
    for (size_t i = 0; i < work->link_count; i++)
        most += work->links[i].motion->tracks[PART_AT].count + work->links[i].motion->tracks[PART_TURN].count;
    double *times_s = grow_zeroed(most, sizeof *times_s);
    *out = grow_zeroed(most, sizeof **out);
    for (size_t i = 0; i < work->link_count; i++)
        for (int part = PART_AT; part <= PART_TURN; part++) {
            const struct track *track = &work->links[i].motion->tracks[part];
            if (track->count) memcpy(times_s + count, track->times_s, track->count * sizeof *times_s);
            count += track->count;
        }
    times_s[count++] = work->from->nodes->end_s;
    qsort(times_s, count, sizeof *times_s, by_value);
    for (size_t i = 0; i < count; i++) {
        if (!kept || times_s[i] - (*out)[kept - 1].first_s >= TICK_S) (*out)[kept++].first_s = times_s[i];
        (*out)[kept - 1].last_s = times_s[i];
    }
    free(times_s);
    return kept;
}

/* The float32 numbers that positions are in the file, where they come to in the scene. */
static void note_step(const struct sampling *work, double time_s)
{
    struct node_transform above = IDENTITY;
    for (size_t i = 0; i < work->link_count; i++) {
        const struct node_transform own = node_motion_at(work->links[i].motion, time_s, time_s);
        above = node_transform_times(&above, &work->links[i].before);
        for (int axis = 0; axis < 3 && work->links[i].motion->tracks[PART_AT].count; axis++) {
            double step_m = 0;
            for (int k = 0; k < 3; k++)
                step_m += fabs(above.m[axis][k]) * float_step_at(fabs(own.m[k][3]));
            *work->from->step_m = fmax(*work->from->step_m, step_m);
        }
        above = node_transform_times(&above, &own);
    }
}

/* When keys stand for a moment: one, or two where the motion jumps. That ends in the first whole millisecond in which
 * the file has all of it, but for what float32 adds to a decimal. */
struct turning {
    double left_s, right_s;
    bool jumps;
};

static bool find_turning(const struct sampling *work, const struct moment *moment, double within_before_s,
                         double within_after_s, struct turning *out)
{
    static const double FLOAT_TICKS = 0.01, SAME = 1e-3;
    struct model_pose before, after;
    *out = (struct turning){moment->first_s, moment->first_s, false};
    if (!pose_within(work, moment->first_s, within_before_s, &before) ||
        !pose_within(work, moment->last_s, within_after_s, &after))
        return false;
    if (apart_m(work, &before, &after) <= SAME * work->tolerance_m) return true;
    const double end_s = ceil(moment->last_s / TICK_S - FLOAT_TICKS) * TICK_S;
    *out = (struct turning){end_s - TICK_S, end_s, true};
    return true;
}

/* The way from the last key to a moment; of a jump the key before it, too, unless the last one is as late. */
static bool add_stretch(struct sampling *work, double left_s, bool is_key, double within_s)
{
    const struct model_key *last = work->count ? &work->keys[work->count - 1] : NULL;
    struct model_key to = {.time_s = left_s};
    if (last ? tick_of(left_s) <= tick_of(last->time_s) : !is_key || left_s < 0) return true;
    if (!pose_within(work, left_s, within_s, &to.pose)) return false;
    if (last) {
        const struct model_key from = *last;
        if (!add_between(work, &from, &to, within_s, PROBES_A_LINK * work->link_count)) return false;
    }
    return !is_key || add_key(work, left_s, &to.pose);
}

static bool add_keys(struct sampling *work, const struct moment *moments, size_t count)
{
    double before_s = moments[0].first_s - 1;
    for (size_t i = 0; i < count; i++) {
        const struct moment *moment = &moments[i];
        const double after_s = i + 1 < count ? (moment->last_s + moments[i + 1].first_s) / 2 : moment->last_s + 1;
        struct turning turning;
        struct model_pose pose;
        if (!find_turning(work, moment, before_s, after_s, &turning) ||
            !add_stretch(work, turning.left_s, turning.jumps, before_s) ||
            !pose_within(work, turning.right_s, after_s, &pose) || !add_key(work, turning.right_s, &pose))
            return false;
        note_step(work, moment->last_s);
        before_s = after_s;
    }
    return true;
}

/* Sizes -------------------------------------------------------------------------------------- */

static double reach_of(const struct model *model, size_t mover, const double from_m[3])
{
    double reach2 = 0;
    for (size_t i = 0; i < model->face_count; i++)
        for (uint32_t k = 0; k < model->faces[i].count && model->faces[i].mover == mover + 1; k++)
            reach2 = fmax(reach2, vec3_distance2(model->points[model->corners[model->faces[i].first + k]], from_m));
    return sqrt(reach2);
}

static double longest_side_m(const struct model *model)
{
    double longest_m = 0;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < model->corner_count; i++) {
            low = fmin(low, model->points[model->corners[i]][axis]);
            high = fmax(high, model->points[model->corners[i]][axis]);
        }
        longest_m = fmax(longest_m, high - low);
    }
    return longest_m;
}

double motion_keys_tolerance_m(const struct model *model, size_t mover)
{
    const double reach_m = reach_of(model, mover, model->movers[mover].rest.at_m);
    return fmax(reach_m / 1024, longest_side_m(model) / (1 << 17));
}

static bool set_rest(struct sampling *work, struct model_mover *mover, size_t index)
{
    const struct node_transform rest = world_at_rest(work);
    if (!invert(&rest, work->unrest))
        return error_set(work->err,
                         "%s: node '%s': it is animated, and scaled to nothing; take it out, or --movers off",
                         work->from->path, work->node->mName.data);
    rest_axes_of(&rest, work->rest_axes);
    for (int i = 0; i < 3; i++)
        mover->rest.at_m[i] = rest.m[i][3];
    pose_turn_from_axes(mover->rest.turn, work->rest_axes);
    work->reach_m = reach_of(work->from->model, index, mover->rest.at_m);
    work->tolerance_m = motion_keys_tolerance_m(work->from->model, index);
    return true;
}

/* The model's own, at its end. */
static void hand_over(struct sampling *work, struct model_mover *mover)
{
    struct model *model = work->from->model;
    struct model_key *all = grow_zeroed(model->key_count + work->count, sizeof *all);
    if (model->key_count) memcpy(all, model->keys, model->key_count * sizeof *all);
    memcpy(all + model->key_count, work->keys, work->count * sizeof *all);
    free(model->keys);
    model->keys = all;
    mover->first_key = (uint32_t)model->key_count;
    mover->key_count = (uint32_t)work->count;
    model->key_count += work->count;
}

bool motion_keys_set(const struct motion_keys *from, const struct aiNode *node, size_t mover, struct error *err)
{
    struct sampling work = {.from = from, .node = node, .err = err};
    struct moment *moments = NULL;
    find_links(&work);
    bool ok = set_rest(&work, &from->model->movers[mover], mover);
    if (ok) {
        const size_t count = find_moments(&work, &moments);
        ok = add_keys(&work, moments, count);
    }
    if (ok) hand_over(&work, &from->model->movers[mover]);
    free(moments);
    free(work.links);
    free(work.keys);
    return ok;
}
