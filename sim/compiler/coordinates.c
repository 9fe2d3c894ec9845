/* SPDX-License-Identifier: MIT
 *
 * 16 bits come first, as they are cheaper to draw. */
#include "compiler/coordinates.h"

#include "cameras/camera_path.h"
#include "compiler/faithful.h"
#include "model/grid.h"

#include <math.h>

static const struct camera_path *eyes_of(const struct compile_options *options)
{
    return options->eyes.count ? &options->eyes : &options->path;
}

/* How far the farthest eye is from the grid's origin, along an axis. */
static double farthest_eye_m(const struct compile_options *options, const struct grid *grid)
{
    const struct camera_path *eyes = eyes_of(options);
    double far_m = 0;
    for (size_t i = 0; i < eyes->count; i++)
        for (int axis = 0; axis < 3; axis++)
            far_m = fmax(far_m, fabs(eyes->frames[i].eye_m[axis] - grid->origin_m[axis]));
    return far_m;
}

/* Whether a camera would be refused: its eye is too far away, or the near plane that was asked for too near. */
static bool views_want_long(const struct grid *grid, const struct compile_options *options)
{
    struct lens lens;
    struct error ignored;
    if (farthest_eye_m(options, grid) >= camera_eye_end_m(grid)) return true;
    return options->near_m > 0 &&
           !lens_for_grid(&lens, options->fov_deg, options->near_m, grid, options->w_px ? options->w_px : 240,
                          options->h_px ? options->h_px : 240, &ignored);
}

static bool clean_for(const struct model *model, const struct grid_views *views, struct mesh *mesh, struct error *err)
{
    struct grid grid;
    return grid_choose_long(model, views, &grid, err) && mesh_clean_on(model, &grid, mesh, err);
}

/* Eyes so far away that faces would be too small for the grid are not made room for: who draws refuses them. */
static bool clean_long(const struct model *model, const struct compile_options *options, struct mesh *mesh,
                       struct error *err)
{
    const struct grid_views near = {.near_m = options->near_m};
    struct grid_views far = near;
    struct grid grid;
    struct error ignored;
    if (!eyes_of(options)->count) return clean_for(model, &near, mesh, err);
    if (!grid_choose_long(model, &near, &grid, err)) return false;
    far.far_m = farthest_eye_m(options, &grid);
    const bool ok = clean_for(model, &far, mesh, &ignored);
    if (ok && !faithful_wants_finer(mesh, options)) return true;
    if (ok) mesh_free(mesh);
    return clean_for(model, &near, mesh, err);
}

bool coordinates_clean(const struct model *model, const struct compile_options *options, struct mesh *mesh,
                       struct error *err)
{
    enum coordinates coordinates;
    if (!compile_options_coordinates(options, &coordinates, err)) return false;
    if (coordinates == COORDINATES_32) return clean_long(model, options, mesh, err);
    struct error refused = {0};
    const bool ok = mesh_clean(model, mesh, &refused);
    if (coordinates == COORDINATES_16) {
        if (!ok) *err = refused;
        return ok;
    }
    if (ok && !faithful_wants_finer(mesh, options) && !views_want_long(&mesh->grid, options)) return true;
    if (ok) mesh_free(mesh);
    return clean_long(model, options, mesh, err);
}

bool coordinates_may_retry(const struct mesh *mesh, const struct compile_options *options)
{
    enum coordinates coordinates;
    struct error ignored;
    return !mesh->grid.is_long && compile_options_coordinates(options, &coordinates, &ignored) &&
           coordinates == COORDINATES_AUTO;
}
