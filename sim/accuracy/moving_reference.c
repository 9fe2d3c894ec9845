/* SPDX-License-Identifier: MIT
 *
 * Each part is cleaned as the compiler cleans it, and keeps its own numbers. */
#include "accuracy/moving_reference.h"

#include "accuracy/source_pose.h"
#include "base/grow.h"
#include "model/model_part.h"
#include "model/pose.h"
#include "readers/source.h"

#include <stdlib.h>

static bool add_groups(const struct moving *moving, size_t mover, uint32_t *groups, struct error *err)
{
    struct model part;
    struct mesh mesh;
    uint32_t *numbers;
    model_part(&moving->model, mover, !mover, &part, &numbers);
    bool ok = mover ? mesh_clean_on(&part, &moving->objects[mover - 1].scene.grid, &mesh, err)
                    : moving_clean_still(moving, &part, &mesh, err);
    if (ok) {
        ok = mesh_merge(&mesh, err);
        for (size_t i = 1; ok && i <= part.face_count; i++)
            groups[numbers[i - 1]] = mesh.merged_into[i] ? numbers[mesh.merged_into[i] - 1] : 0;
        mesh_free(&mesh);
    }
    model_free(&part);
    free(numbers);
    return ok;
}

bool moving_groups(const struct moving *moving, uint32_t **groups, struct error *err)
{
    bool ok = true;
    *groups = grow_zeroed(moving->model.face_count + 1, sizeof **groups);
    for (size_t i = 0; ok && i <= moving->count; i++)
        ok = add_groups(moving, i, *groups, err);
    return ok;
}

static bool reference_of_part(const struct moving *moving, size_t mover, struct reference *reference, unsigned w_px,
                              unsigned h_px, struct error *err)
{
    struct model part;
    struct mesh mesh;
    uint32_t *numbers;
    model_part(&moving->model, mover, !mover, &part, &numbers);
    const struct model view = source_view(&part);
    const struct grid *still = moving->grid.is_long ? &moving->grid : NULL;
    bool ok = mesh_clean_fine(&view, mover ? &moving->objects[mover - 1].scene.grid : still, &mesh, err);
    if (ok) {
        for (size_t i = 0; i < mesh.polygon_count; i++)
            mesh.polygons[i].face = numbers[mesh.polygons[i].face - 1];
        ok = mover ? reference_add(reference, &mesh, mover, err) : reference_init(reference, &mesh, w_px, h_px, err);
        mesh_free(&mesh);
    }
    model_free(&part);
    free(numbers);
    return ok;
}

bool moving_reference(const struct moving *moving, struct reference *reference, unsigned w_px, unsigned h_px,
                      struct error *err)
{
    bool ok = true;
    for (size_t i = 0; ok && i <= moving->count; i++)
        ok = reference_of_part(moving, i, reference, w_px, h_px, err);
    return ok;
}

void moving_pose_reference(const struct moving *moving, struct reference *reference, double time_s)
{
    for (size_t i = 0; i < moving->count; i++) {
        struct model_pose pose;
        if (!source_pose(&moving->model, i, time_s, &pose))
            pose = pose_at(&moving->model, &moving->model.movers[i], time_s);
        reference_pose(reference, i + 1, &pose);
    }
}
