/* SPDX-License-Identifier: MIT
 *
 * A quarter of the tries are plain random cameras; an eighth looks at all of the scene, at faces from near, and at
 * vertices, as what costs most is seldom seen by chance. Then each goal has its part of the rest: half of it goes to
 * its STARTS best cameras alike, half to the best of what became of these. A climb moves eye, direction and time at
 * random within a step; the step grows where that finds something worse, and shrinks where it does not (Rechenberg's
 * rule of one success in five). Where time is limited each part has its share of it. */
#include "cameras/camera_search.h"

#include "base/deadline.h"
#include "base/progress.h"
#include "cameras/sample.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

enum { STARTS = 6, WAYS = 8, DIGITS_OF_SIDE = 6 };
static const double PLAIN_PART = 0.25, LOOKING_PART = 0.125, SPREAD = 4.0;
static const double STEP_LEAST = 1.0 / 2048.0, STEP_UP = 1.5, STEP_DOWN = 0.9; /* 1.5 * 0.9^4 is about 1 */
static const double STEP_AGAIN = 0.5; /* of a climb that came to a top, perhaps not the highest */
static const double EYE_REACH = 0.25, YAW_REACH = PI / 2.0, PITCH_REACH = PI / 4.0, TIME_REACH = 0.25;
static const double CLEARANCE = 1.5; /* near planes: a corner of it is 1.3 times as far as its middle */

struct start {
    struct viewpoint viewpoint;
    double score; /* below 0: none yet */
    double step;  /* of the climb, as a share of the reach */
};

struct run {
    const struct camera_search *search;
    struct search_result *out;
    struct sampler sampler;
    struct start starts[SEARCH_GOALS_MAX][STARTS]; /* the worst first */
    double side_m;                                 /* the longest of the bounds */
    double clear_m;                                /* what eyes keep away from things */
    int decimals;                                  /* of the metres that cameras are rounded to */
    size_t counted[SEARCH_GOALS_MAX];              /* plain cameras that had a score */
};

/* As a file of cameras has it, so that what is written is what was measured. */
static double as_written(double value, int decimals)
{
    char text[64];
    snprintf(text, sizeof text, "%.*f", decimals, value);
    return strtod(text, NULL);
}

static void round_viewpoint(const struct run *run, struct viewpoint *viewpoint)
{
    for (int i = 0; i < 3; i++) {
        viewpoint->eye_m[i] = as_written(viewpoint->eye_m[i], run->decimals);
        viewpoint->target_m[i] = as_written(viewpoint->target_m[i], run->decimals);
    }
    viewpoint->has_time = run->search->length_s > 0.0;
    viewpoint->time_s = as_written(viewpoint->time_s, 3);
}

/* Whether nothing with a front is as near as a near plane's corner may be. */
static bool is_clear(const struct run *run, const double eye_m[3])
{
    const double away_m = run->clear_m;
    for (int way = 0; way < 27; way++) {
        const double to[3] = {way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1};
        const double length = hypot(hypot(to[0], to[1]), to[2]);
        double at_m[3];
        for (int i = 0; i < 3; i++)
            at_m[i] = eye_m[i] + (length > 0.0 ? to[i] / length * away_m : 0.0);
        if (!sampler_may_be_at(&run->sampler, at_m)) return false;
    }
    return true;
}

static bool is_in_reach(const struct run *run, const struct viewpoint *viewpoint)
{
    double apart2 = 0.0;
    for (int i = 0; i < 3; i++) {
        const double middle_m = (run->sampler.low_m[i] + run->sampler.high_m[i]) / 2.0;
        const double way_m = viewpoint->target_m[i] - viewpoint->eye_m[i];
        if (!(fabs(viewpoint->eye_m[i] - middle_m) <= SPREAD / 2.0 * run->side_m)) return false;
        apart2 += way_m * way_m;
    }
    return apart2 > 0.0;
}

/* Into the list of the best starts, if it belongs there. */
static void keep(struct start *starts, const struct viewpoint *viewpoint, double score)
{
    size_t at = STARTS;
    while (at > 0 && starts[at - 1].score < score)
        at--;
    if (at == STARTS || score < 0.0) return;
    memmove(&starts[at + 1], &starts[at], (STARTS - 1 - at) * sizeof *starts);
    starts[at] = (struct start){*viewpoint, score, 1.0};
}

static bool measure(struct run *run, struct viewpoint *viewpoint, double *scores, struct error *err)
{
    const struct camera_search *search = run->search;
    progress_bar(run->out->tried, search->tries, "%s, camera %zu", search->doing, run->out->tried + 1);
    run->out->tried++;
    viewpoint->line = run->out->tried;
    return search->measure(search->ctx, viewpoint, scores, err);
}

/* A camera at random, or one that looks at all of the scene, a face from near, or a vertex; false: there is none of
 * that kind. */
static bool draw(struct run *run, bool is_plain, size_t i, struct viewpoint *out)
{
    if (is_plain) return sampler_anywhere(&run->sampler, out);
    if (i % 3 == 0) return sampler_portrait(&run->sampler, out);
    if (i % 3 == 1) return sampler_near(&run->sampler, out);
    *out = sampler_next(&run->sampler);
    return true;
}

static bool is_over(const struct run *run)
{
    return run->out->tried >= run->search->tries || deadline_passed();
}

static void add_plain(struct run *run, const double *scores)
{
    run->out->plain++;
    for (size_t goal = 0; goal < run->search->goals; goal++) {
        struct search_goal *out = &run->out->goals[goal];
        if (scores[goal] < 0.0) continue;
        out->mean += (scores[goal] - out->mean) / (double)++run->counted[goal];
        out->most = fmax(out->most, scores[goal]);
    }
}

/* So many cameras; those that are too near to something are drawn anew. The first is drawn whatever time it takes. */
static bool sow(struct run *run, bool is_plain, double part, struct error *err)
{
    const struct deadline_end whole = deadline_share(part);
    const size_t count = (size_t)ceil(part * (double)run->search->tries);
    bool ok = true;
    for (size_t i = 0, misses = 0; ok && i < count && misses < 64 * count && !(run->out->tried && is_over(run));) {
        struct viewpoint viewpoint = {0};
        double scores[SEARCH_GOALS_MAX];
        run->sampler.time_s = sampler_unit(&run->sampler) * run->search->length_s;
        const bool is_drawn = draw(run, is_plain, i + misses, &viewpoint);
        if (!is_drawn && is_plain) break;
        viewpoint.time_s = run->sampler.time_s;
        if (is_drawn) round_viewpoint(run, &viewpoint);
        if (!is_drawn || !is_in_reach(run, &viewpoint) || !is_clear(run, viewpoint.eye_m)) {
            misses++;
            continue;
        }
        i++;
        ok = measure(run, &viewpoint, scores, err);
        if (ok && is_plain) add_plain(run, scores);
        for (size_t goal = 0; ok && goal < run->search->goals; goal++)
            keep(run->starts[goal], &viewpoint, scores[goal]);
    }
    deadline_restore(whole);
    return ok;
}

static double swing(struct run *run, double reach)
{
    return (2.0 * sampler_unit(&run->sampler) - 1.0) * reach;
}

/* Eye, direction, or both, within the step. */
static void move(struct run *run, const struct start *from, struct viewpoint *out)
{
    const double kind = sampler_unit(&run->sampler), step = from->step;
    const bool moves = kind < 0.75, turns = kind >= 0.25;
    double way_m[3], away_m = 0.0;

    *out = from->viewpoint;
    for (int i = 0; i < 3; i++) {
        way_m[i] = out->target_m[i] - out->eye_m[i];
        away_m = hypot(away_m, way_m[i]);
        if (moves) out->eye_m[i] += swing(run, step * EYE_REACH * run->side_m);
    }
    double yaw = atan2(way_m[0], way_m[2]), pitch = asin(fmax(-1.0, fmin(1.0, way_m[1] / away_m)));
    if (turns) yaw += swing(run, step * YAW_REACH);
    if (turns) pitch += swing(run, step * PITCH_REACH);
    pitch = fmax(-PI / 2.0, fmin(PI / 2.0, pitch));
    /* Far enough for the direction to survive rounding. */
    const double to_m = fmax(away_m, run->side_m / 4.0);
    out->target_m[0] = out->eye_m[0] + to_m * cos(pitch) * sin(yaw);
    out->target_m[1] = out->eye_m[1] + to_m * sin(pitch);
    out->target_m[2] = out->eye_m[2] + to_m * cos(pitch) * cos(yaw);
    const double length_s = run->search->length_s;
    if (length_s > 0.0) out->time_s = fmod(out->time_s + length_s + swing(run, step * TIME_REACH * length_s), length_s);
    round_viewpoint(run, out);
}

/* Moves until one is where an eye may be; false: none was. */
static bool move_in_space(struct run *run, const struct start *from, struct viewpoint *out)
{
    for (int i = 0; i < WAYS; i++) {
        move(run, from, out);
        if (is_in_reach(run, out) && is_clear(run, out->eye_m)) return true;
    }
    return false;
}

/* What another goal finds on its way counts as well. */
static void keep_others(struct run *run, size_t mine, const struct viewpoint *viewpoint, const double *scores)
{
    for (size_t goal = 0; goal < run->search->goals; goal++)
        if (goal != mine) keep(run->starts[goal], viewpoint, scores[goal]);
}

static bool climb(struct run *run, size_t goal, struct start *start, size_t tries, double share, struct error *err)
{
    const struct deadline_end whole = deadline_share(share);
    bool ok = true;
    for (size_t i = 0; ok && i < tries && start->step > STEP_LEAST && !is_over(run); i++) {
        struct viewpoint viewpoint;
        double scores[SEARCH_GOALS_MAX];
        const bool is_better = move_in_space(run, start, &viewpoint) && (ok = measure(run, &viewpoint, scores, err)) &&
                               scores[goal] >= start->score;
        if (!ok) break;
        if (!is_better) {
            start->step *= STEP_DOWN;
            continue;
        }
        const bool is_worse_view = scores[goal] > start->score; /* equals only drift */
        start->viewpoint = viewpoint;
        start->score = scores[goal];
        if (is_worse_view) {
            start->step = fmin(1.0, start->step * STEP_UP);
            keep_others(run, goal, &viewpoint, scores);
        } else {
            start->step *= STEP_DOWN;
        }
    }
    deadline_restore(whole);
    return ok;
}

static struct start *best_of(struct start *starts)
{
    struct start *best = starts;
    for (size_t i = 1; i < STARTS; i++)
        if (starts[i].score > best->score) best = &starts[i];
    return best;
}

/* Half of the tries to all starts alike, the rest to the best. */
static bool refine(struct run *run, size_t goal, size_t tries, struct error *err)
{
    struct start *starts = run->starts[goal];
    const size_t end = run->out->tried + tries;
    size_t count = 0;
    while (count < STARTS && starts[count].score >= 0.0)
        count++;
    for (size_t i = 0; i < count; i++)
        if (!climb(run, goal, &starts[i], tries / (2 * count), 0.5 / (double)(count - i), err)) return false;
    for (size_t before = SIZE_MAX; count && run->out->tried < end && run->out->tried != before && !is_over(run);) {
        struct start *best = best_of(starts);
        before = run->out->tried;
        if (best->step <= STEP_LEAST) best->step = STEP_AGAIN;
        if (!climb(run, goal, best, end - before, 1.0, err)) return false;
    }
    return true;
}

/* What another search found may be worse than all that this one does. */
static bool take_hint(struct run *run, struct error *err)
{
    double scores[SEARCH_GOALS_MAX];
    if (!run->search->hint || is_over(run)) return true;
    struct viewpoint viewpoint = *run->search->hint;
    if (!measure(run, &viewpoint, scores, err)) return false;
    for (size_t goal = 0; goal < run->search->goals; goal++)
        keep(run->starts[goal], &viewpoint, scores[goal]);
    return true;
}

static void begin(struct run *run, const struct camera_search *search, struct search_result *out)
{
    *out = (struct search_result){0};
    *run = (struct run){.search = search, .out = out};
    sampler_init(&run->sampler, search->scene);
    sampler_seed(&run->sampler, search->seed);
    run->sampler.near_m = search->lens.near_m;
    run->clear_m = CLEARANCE * search->lens.near_m;
    for (int i = 0; i < 3; i++)
        run->side_m = fmax(run->side_m, run->sampler.high_m[i] - run->sampler.low_m[i]);
    run->decimals = (int)fmax(0.0, DIGITS_OF_SIDE - floor(log10(run->side_m)));
    for (size_t goal = 0; goal < SEARCH_GOALS_MAX; goal++)
        for (size_t i = 0; i < STARTS; i++)
            run->starts[goal][i].score = -1.0;
}

bool camera_search_run(const struct camera_search *search, struct search_result *out, struct error *err)
{
    struct run run;
    if (search->scene->scene.vertex_count == 0) return error_set(err, "nothing stands still in this scene");
    begin(&run, search, out);
    bool ok = sow(&run, true, PLAIN_PART, err);
    if (ok && !out->plain) { /* narrower than near planes are apart */
        run.clear_m = 0.0;
        ok = sow(&run, true, PLAIN_PART, err) && (out->plain || error_set(err, "the scene has no free space"));
    }
    ok = ok && take_hint(&run, err) && sow(&run, false, LOOKING_PART, err);
    for (size_t goal = 0; ok && goal < search->goals; goal++) {
        const size_t goals_left = search->goals - goal;
        const struct deadline_end whole = deadline_share(1.0 / (double)goals_left);
        ok = out->tried >= search->tries || refine(&run, goal, (search->tries - out->tried) / goals_left, err);
        deadline_restore(whole);
        const struct start *best = best_of(run.starts[goal]);
        out->goals[goal].worst = best->viewpoint;
        out->goals[goal].score = best->score;
    }
    out->is_cut = out->tried < search->tries && deadline_passed();
    progress_end();
    return ok;
}
