/* SPDX-License-Identifier: MIT
 *
 * Scale and origin of a scene. Only corners of faces count; what else a file holds is not drawn. */
#include "model/grid.h"

#include "base/grow.h"
#include "long.h"
#include "model/extent.h"

#include <math.h>
#include <stdlib.h>

static const double GRID_SPAN_UNITS = 65534;      /* -32767 .. 32767 */
static const double LONG_SPAN_UNITS = 1073741820; /* 2^30, less what rounding adds */
static const double UNITS_A_FACE = 4096;          /* of the smallest one, on a long grid */
static const double FINER_THAN_SHORT = 4;
static const double UNITS_TO_NEAR = 16; /* any lens has its near plane there */
static const double USUAL_NEAR_M = 0.1;
static const double LONG_EYE_UNITS = LIM_LONG_EYE_END - 2; /* less what rounding adds */
static const double SQUEEZE = 1000;                        /* leaves the rest of the model 65 units or less */
static const double FLAT_UNITS = 0.5;                      /* what rounding to the grid does anyway */

struct bounds {
    double low[3], high[3];
};

/* A place where faces have corners, with one of those faces. */
struct place {
    const double *point;
    double distance; /* from the middle of the crowd, along the axis where it is largest */
    uint32_t face;   /* index */
};

static int compare_axis(const void *left, const void *right, int axis)
{
    double a = ((const struct place *)left)->point[axis], b = ((const struct place *)right)->point[axis];
    return (a > b) - (a < b);
}

static int by_x(const void *left, const void *right)
{
    return compare_axis(left, right, 0);
}
static int by_y(const void *left, const void *right)
{
    return compare_axis(left, right, 1);
}
static int by_z(const void *left, const void *right)
{
    return compare_axis(left, right, 2);
}

static int by_distance(const void *left, const void *right)
{
    const struct place *a = left, *b = right;
    int nearer = (a->distance > b->distance) - (a->distance < b->distance);
    return nearer ? nearer : (a->face > b->face) - (a->face < b->face);
}

static int by_place(const void *left, const void *right)
{
    const struct place *a = left, *b = right;
    for (int axis = 0; axis < 3; axis++) {
        int order = compare_axis(a, b, axis);
        if (order) return order;
    }
    return (a->face > b->face) - (a->face < b->face);
}

/* Different places only, each with the first face that has a corner there: importers repeat points,
 * and an outlier must not become a crowd by that. */
static size_t find_places(const struct model *model, struct place *places)
{
    size_t count = 0, kept = 0;
    for (size_t i = 0; i < model->face_count; i++)
        for (uint32_t k = 0; k < model->faces[i].count; k++) {
            const double *point = model->points[model->corners[model->faces[i].first + k]];
            places[count++] = (struct place){.point = point, .face = (uint32_t)i};
        }
    qsort(places, count, sizeof *places, by_place);
    for (size_t i = 0; i < count; i++) {
        struct place last = places[kept ? kept - 1 : 0];
        bool same = kept && compare_axis(&last, &places[i], 0) == 0 && compare_axis(&last, &places[i], 1) == 0 &&
                    compare_axis(&last, &places[i], 2) == 0;
        if (!same) places[kept++] = places[i];
    }
    return kept;
}

static double longest_side(const struct bounds *bounds)
{
    double longest = 0;
    for (int axis = 0; axis < 3; axis++)
        longest = fmax(longest, bounds->high[axis] - bounds->low[axis]);
    return longest;
}

static struct bounds bounds_of(const struct place *places, size_t count)
{
    struct bounds bounds;
    for (int axis = 0; axis < 3; axis++) {
        bounds.low[axis] = bounds.high[axis] = places[0].point[axis];
        for (size_t i = 1; i < count; i++) {
            bounds.low[axis] = fmin(bounds.low[axis], places[i].point[axis]);
            bounds.high[axis] = fmax(bounds.high[axis], places[i].point[axis]);
        }
    }
    return bounds;
}

/* Sorts the places by distance from the medians, which outliers cannot move. */
static void sort_outwards(struct place *places, size_t count)
{
    int (*const by_axis[3])(const void *, const void *) = {by_x, by_y, by_z};
    double median[3];
    for (int axis = 0; axis < 3; axis++) {
        qsort(places, count, sizeof *places, by_axis[axis]);
        median[axis] = places[count / 2].point[axis];
    }
    for (size_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++)
            places[i].distance = fmax(places[i].distance, fabs(places[i].point[axis] - median[axis]));
    qsort(places, count, sizeof *places, by_distance);
}

/* How many places may be outliers: 1 in 100; of a small model up to three, but 1 in 4 at most. */
static size_t most_outliers(size_t count)
{
    size_t of_small = count / 4 < 3 ? count / 4 : 3;
    size_t most = count / 100 > of_small ? count / 100 : of_small;
    return most ? most : 1;
}

static bool refuse_outlier(struct place *places, size_t count, double longest_m, struct error *err)
{
    if (count < 3) return true;
    sort_outwards(places, count);
    struct bounds bulk = bounds_of(places, count - most_outliers(count));
    double bulk_m = longest_side(&bulk);
    if (longest_m <= SQUEEZE * bulk_m) return true;
    const struct place *outlier = &places[count - 1];
    return error_set(err,
                     "face %u has a corner at (%g, %g, %g), so far out that the rest of the model "
                     "would be %.2g units wide, of %g",
                     outlier->face + 1, outlier->point[0], outlier->point[1], outlier->point[2],
                     bulk_m * GRID_SPAN_UNITS / longest_m, GRID_SPAN_UNITS);
}

/* Mean square of what rounding to the grid moves a coordinate, in square metres. */
static double rounding_error(const struct place *places, size_t count, const struct grid *grid)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++) {
            const double units = (places[i].point[axis] - grid->origin_m[axis]) * grid->units_per_m;
            const double error_m = (units - floor(units + 0.5)) / grid->units_per_m;
            sum += error_m * error_m;
        }
    return sum / (3.0 * (double)count);
}

/* The largest scale at which multiples of step_m are whole units. 0: none is as large as 1. */
static struct grid lattice_grid(const struct bounds *all, double step_m)
{
    struct grid grid = {.units_per_m = 0};
    double half_m = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double middle_m = all->low[axis] + (all->high[axis] - all->low[axis]) / 2;
        grid.origin_m[axis] = floor(middle_m / step_m + 0.5) * step_m;
        half_m = fmax(half_m, fmax(all->high[axis] - grid.origin_m[axis], grid.origin_m[axis] - all->low[axis]));
    }
    grid.units_per_m = floor(GRID_SPAN_UNITS / 2 / half_m * step_m) / step_m;
    return grid;
}

/* What people build has its corners on multiples of something: where the scale divides that, they
 * round to the grid without error. A little resolution is given for it, no more than a third. */
static void prefer_lattice(const struct place *places, size_t count, const struct bounds *all, double lattice_m,
                           struct grid *grid)
{
    static const double STEPS_M[] = {1.0,  0.5,   0.25,  0.2,   0.1,    0.05,   0.025,      0.02,
                                     0.01, 0.005, 0.002, 0.001, 0.0005, 0.0001, 0.0254 / 4, 0.0254};
    const double least_units_per_m = grid->units_per_m * 2 / 3;
    double best = rounding_error(places, count, grid);
    for (size_t i = lattice_m > 0 ? 0 : 1; i <= sizeof STEPS_M / sizeof *STEPS_M; i++) {
        const struct grid candidate = lattice_grid(all, i ? STEPS_M[i - 1] : lattice_m);
        if (!(candidate.units_per_m >= least_units_per_m)) continue;
        const double error = rounding_error(places, count, &candidate);
        if (error >= best) continue;
        best = error;
        *grid = candidate;
    }
}

static void choose_scale(const struct place *places, size_t count, const struct bounds *all, double longest_m,
                         double lattice_m, struct grid *grid)
{
    *grid = (struct grid){0};
    for (int axis = 0; axis < 3; axis++)
        grid->origin_m[axis] = all->low[axis] + (all->high[axis] - all->low[axis]) / 2;
    grid->units_per_m = GRID_SPAN_UNITS / longest_m;
    prefer_lattice(places, count, all, lattice_m, grid);
}

bool grid_choose(const struct model *model, struct grid *grid, struct error *err)
{
    struct place *places = grow_zeroed(model->corner_count, sizeof *places);
    size_t count = find_places(model, places);
    struct bounds all = bounds_of(places, count);
    double longest_m = longest_side(&all);
    bool ok = longest_m > 0 ? refuse_outlier(places, count, longest_m, err)
                            : error_set(err, "no face has an area: all corners are at one place");
    if (ok) choose_scale(places, count, &all, longest_m, model->lattice_m, grid);
    free(places);
    return ok;
}

/* The least that any face spans along the axis that it is longest along; faces at one place have none. */
static double least_face_m(const struct model *model)
{
    double least_m = INFINITY;
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        const double longest_m = extent_longest_side(model->points, model->corners + face->first, face->count);
        if (longest_m > 0) least_m = fmin(least_m, longest_m);
    }
    return least_m;
}

void grid_scale_long(double longest_m, double least_face_m, const struct grid_views *views, struct grid *grid)
{
    const bool is_near_known = views->near_m > 0;
    const double largest = is_near_known ? LIM_LONG_NEAR_MAX_Q8 / 256.0 / views->near_m : INFINITY;
    const double faces = fmax(UNITS_A_FACE / least_face_m, FINER_THAN_SHORT * GRID_SPAN_UNITS / longest_m);
    const double wanted = fmax(faces, UNITS_TO_NEAR / (is_near_known ? views->near_m : USUAL_NEAR_M));
    double most = LONG_SPAN_UNITS / longest_m;
    if (views->far_m > 0) most = fmin(most, LONG_EYE_UNITS / views->far_m);
    grid->is_long = true;
    grid->units_per_m = fmin(most, fmin(wanted, largest));
    grid->has_fractions = grid->units_per_m < fmin(faces, largest);
}

bool grid_choose_long(const struct model *model, const struct grid_views *views, struct grid *grid, struct error *err)
{
    struct place *places = grow_zeroed(model->corner_count, sizeof *places);
    size_t count = find_places(model, places);
    const struct bounds all = bounds_of(places, count);
    const double longest_m = longest_side(&all);
    free(places);
    if (!(longest_m > 0)) return error_set(err, "no face has an area: all corners are at one place");
    *grid = (struct grid){0};
    for (int axis = 0; axis < 3; axis++)
        grid->origin_m[axis] = all.low[axis] + (all.high[axis] - all.low[axis]) / 2;
    grid_scale_long(longest_m, least_face_m(model), views, grid);
    return true;
}

double grid_weld_m(const struct grid *grid)
{
    return 1 / (16 * grid->units_per_m);
}

double grid_near_m(const struct grid *grid)
{
    return grid_weld_m(grid) / 2;
}

double grid_flat_m(const struct grid *grid)
{
    return FLAT_UNITS / grid->units_per_m;
}
