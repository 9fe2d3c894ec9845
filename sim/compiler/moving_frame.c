/* SPDX-License-Identifier: MIT */
#include "compiler/moving_frame.h"

#include "base/grow.h"
#include "model/pose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FACES = 2, CORNERS = 3, SIZE_PARTS = 1024 };

struct box {
    double low_m[3], high_m[3];
};

static bool stands_still(const struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++)
        if (!model->faces[i].mover) return true;
    return false;
}

static const struct box EMPTY = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void extend(struct box *box, const double at_m[3])
{
    for (int axis = 0; axis < 3; axis++) {
        box->low_m[axis] = fmin(box->low_m[axis], at_m[axis]);
        box->high_m[axis] = fmax(box->high_m[axis], at_m[axis]);
    }
}

static struct box own_box(const struct model *model, size_t mover)
{
    struct box box = EMPTY;
    for (size_t i = 0; i < model->face_count; i++)
        for (uint32_t k = 0; k < model->faces[i].count && model->faces[i].mover == mover + 1; k++) {
            double own_m[3];
            pose_enter(&model->movers[mover].rest, model->points[model->corners[model->faces[i].first + k]], own_m);
            extend(&box, own_m);
        }
    return box;
}

/* A mover's box goes where its keys are. */
static struct box swept_box(const struct model *model)
{
    struct box all = EMPTY;
    for (size_t i = 0; i < model->mover_count; i++) {
        const struct model_mover *mover = &model->movers[i];
        const struct box own = own_box(model, i);
        for (uint32_t key = 0; key < mover->key_count && own.low_m[0] <= own.high_m[0]; key++)
            for (int corner = 0; corner < 8; corner++) {
                double own_m[3], at_m[3];
                for (int axis = 0; axis < 3; axis++)
                    own_m[axis] = corner >> axis & 1 ? own.high_m[axis] : own.low_m[axis];
                pose_leave(&model->keys[mover->first_key + key].pose, own_m, at_m);
                extend(&all, at_m);
            }
    }
    return all;
}

static void *longer(void *items, size_t count, size_t more, size_t item_b)
{
    void *all = grow_zeroed(count + more, item_b);
    if (count) memcpy(all, items, count * item_b);
    free(items);
    return all;
}

static void make_room(struct model *model)
{
    const size_t points = FACES * CORNERS;
    model->points = longer(model->points, model->point_count, points, sizeof *model->points);
    model->corners = longer(model->corners, model->corner_count, points, sizeof *model->corners);
    model->faces = longer(model->faces, model->face_count, FACES, sizeof *model->faces);
    if (model->uvs) model->uvs = longer(model->uvs, model->point_count, points, sizeof *model->uvs);
    if (model->source_points)
        model->source_points = longer(model->source_points, model->point_count, points, sizeof *model->source_points);
}

/* Counter-clockwise seen from below, or from above where steps go back. */
static void add_face(struct model *model, const double at_m[3], double step_m, uint32_t colour)
{
    const double sides_m[CORNERS][3] = {{0, 0, 0},
                                        {step_m > 0 ? step_m : 0, 0, step_m > 0 ? 0 : step_m},
                                        {step_m > 0 ? 0 : step_m, 0, step_m > 0 ? step_m : 0}};
    model->faces[model->face_count++] =
        (struct model_face){.first = (uint32_t)model->corner_count, .count = CORNERS, .colour = colour, .unlit = true};
    for (int k = 0; k < CORNERS; k++) {
        for (int axis = 0; axis < 3; axis++)
            model->points[model->point_count][axis] = at_m[axis] + sides_m[k][axis];
        if (model->source_points)
            memcpy(model->source_points[model->point_count], model->points[model->point_count],
                   sizeof *model->source_points);
        model->corners[model->corner_count++] = (uint32_t)model->point_count++;
    }
}

static uint32_t rgb888_from(uint16_t rgb565)
{
    const uint32_t red = rgb565 >> 11, green = rgb565 >> 5 & 63, blue = rgb565 & 31;
    return (red << 3 | red >> 2) << 16 | (green << 2 | green >> 4) << 8 | (blue << 3 | blue >> 2);
}

void moving_frame_add(struct model *model, uint16_t background_rgb565)
{
    if (!model->mover_count || stands_still(model)) return;
    const struct box box = swept_box(model);
    double size_m = 0;
    for (int axis = 0; axis < 3; axis++)
        size_m = fmax(size_m, (box.high_m[axis] - box.low_m[axis]) / SIZE_PARTS);
    make_room(model);
    add_face(model, box.low_m, size_m, rgb888_from(background_rgb565));
    add_face(model, box.high_m, -size_m, rgb888_from(background_rgb565));
    model->made_faces = FACES;
    model_note(model,
               "everything in it moves; two faces of the background's colour, 1/%d of its length, stand still at its "
               "ends",
               SIZE_PARTS);
}
