/* SPDX-License-Identifier: MIT */
#include "model/moving_frame.h"

#include "base/grow.h"
#include "model/pose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FACES = 2, CORNERS = 3, SIZE_PARTS = 8192, MOST_WIDER = 16 };

static const double ROOM = 1.001; /* so that rounding keeps what just fits */

struct box {
    double low_m[3], high_m[3];
};

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

static struct box still_box(const struct model *model)
{
    struct box box = EMPTY;
    for (size_t i = 0; i < model->face_count; i++)
        for (uint32_t k = 0; k < model->faces[i].count && !model->faces[i].mover; k++)
            extend(&box, model->points[model->corners[model->faces[i].first + k]]);
    return box;
}

static bool is_empty(const struct box *box)
{
    return box->low_m[0] > box->high_m[0];
}

static double longest_side_m(const struct box *box)
{
    double longest_m = 0;
    for (int axis = 0; axis < 3; axis++)
        longest_m = fmax(longest_m, box->high_m[axis] - box->low_m[axis]);
    return longest_m;
}

/* The farthest that it reaches from its origin along an axis. */
static double own_reach_m(const struct box *own)
{
    double reach_m = 0;
    for (int axis = 0; axis < 3 && !is_empty(own); axis++)
        reach_m = fmax(reach_m, fmax(-own->low_m[axis], own->high_m[axis]));
    return reach_m;
}

/* Firmware draws what moves as far as the scene's longest side from its middle, along each axis; a cube around the
 * mover's origin, in any turn, is held to that. The mover's own coordinates end at half the longest side. */
static bool goes_beyond(const struct model *model, const struct box *still)
{
    static const double SURE = 0.95;
    const double most_m = SURE * longest_side_m(still);
    for (size_t i = 0; i < model->mover_count; i++) {
        const struct model_mover *mover = &model->movers[i];
        const struct box own = own_box(model, i);
        const double reach_m = own_reach_m(&own);
        if (2 * reach_m > most_m) return true;
        for (uint32_t key = 0; key < mover->key_count; key++)
            for (int axis = 0; axis < 3; axis++) {
                const double middle_m = (still->low_m[axis] + still->high_m[axis]) / 2;
                const double at_m = model->keys[mover->first_key + key].pose.at_m[axis];
                if (fabs(at_m - middle_m) + sqrt(3) * reach_m > most_m) return true;
            }
    }
    return false;
}

/* A mover's box goes where its keys are; around its origin there is room for its own coordinates. */
static struct box swept_box(const struct model *model, const struct box *still)
{
    struct box all = *still;
    for (size_t i = 0; i < model->mover_count; i++) {
        const struct model_mover *mover = &model->movers[i];
        const struct box own = own_box(model, i);
        for (int side = -1; side <= 1 && !is_empty(&own); side += 2) {
            double at_m[3];
            for (int axis = 0; axis < 3; axis++)
                at_m[axis] = mover->rest.at_m[axis] + side * ROOM * own_reach_m(&own);
            extend(&all, at_m);
        }
        for (uint32_t key = 0; key < mover->key_count && !is_empty(&own); key++)
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
    const struct box still = still_box(model);
    if (!model->mover_count || (!is_empty(&still) && !goes_beyond(model, &still))) return;
    const struct box all = swept_box(model, &still);
    const double size_m = longest_side_m(&all) / SIZE_PARTS;
    if (!is_empty(&still) && longest_side_m(&all) > MOST_WIDER * longest_side_m(&still))
        return; /* refused by motion_set() */
    make_room(model);
    add_face(model, all.low_m, size_m, rgb888_from(background_rgb565));
    add_face(model, all.high_m, -size_m, rgb888_from(background_rgb565));
    model->made_faces = FACES;
}
