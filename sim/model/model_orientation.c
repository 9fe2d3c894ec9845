/* SPDX-License-Identifier: MIT
 *
 * What stands, stands on something flat. CAD programs and slicers have z up, and their models stand on a plane of equal
 * z: that is the evidence. */
#include "model/model_orientation.h"

#include "base/vec3.h"
#include "model/face_normal.h"
#include "model/note_words.h"
#include "model/winding.h"

#include <string.h>

static const double FLAT = 0.999;        /* cosine between a face's normal and the axis */
static const double LEVEL = 0.005;       /* of the model's height: how far from its least coordinate a corner may be */
static const double STANDS = 0.05;       /* of the box's area: a smaller underside is none */
static const double LIES_BESIDE = 0.005; /* a larger one may be one */

bool orientation_parse(int code, const char *text, struct orientation *out, struct error *err)
{
    if (code == ORIENTATION_REVERSE_FACES) return out->reverse_faces = true;
    if (code == ORIENTATION_TWO_SIDED) return out->two_sided = true;
    out->up = strcmp(text, "y") == 0 ? UP_Y : strcmp(text, "z") == 0 ? UP_Z : UP_BY_EVIDENCE;
    return out->up != UP_BY_EVIDENCE || error_set(err, "--up %s: there are y and z", text);
}

/* Evidence --------------------------------------------------------------------------------------------------------- */

static void box_of(const struct model *model, double least[3], double most[3])
{
    for (int axis = 0; axis < 3; axis++)
        least[axis] = INFINITY, most[axis] = -INFINITY;
    for (size_t i = 0; i < model->corner_count; i++)
        for (int axis = 0; axis < 3; axis++) {
            least[axis] = fmin(least[axis], model->points[model->corners[i]][axis]);
            most[axis] = fmax(most[axis], model->points[model->corners[i]][axis]);
        }
}

static bool is_below(const struct model *model, const struct model_face *face, int axis, double level_m)
{
    for (uint32_t k = 0; k < face->count; k++)
        if (model->points[model->corners[face->first + k]][axis] > level_m) return false;
    return true;
}

double orientation_underside(const struct model *model, int axis)
{
    double least[3], most[3], twice_m2 = 0;
    box_of(model, least, most);
    const double height_m = most[axis] - least[axis],
                 reach_m = fmax(most[0] - least[0], most[3 - axis] - least[3 - axis]);
    const double box_m2 = (most[0] - least[0]) * (most[3 - axis] - least[3 - axis]);
    const double level_m = least[axis] + LEVEL * height_m;
    if (!(height_m > LEVEL * reach_m)) return 0;
    for (size_t i = 0; i < model->face_count; i++) {
        double normal[3];
        if (!is_below(model, &model->faces[i], axis, level_m)) continue;
        face_normal(model, &model->faces[i], normal);
        if (fabs(normal[axis]) >= FLAT * sqrt(vec3_dot(normal, normal))) twice_m2 += fabs(normal[axis]);
    }
    return box_m2 > 0 ? twice_m2 / 2 / box_m2 : 0;
}

/* Which side it stands on, if it is one alone; else 0. */
static int stands_on(const struct model *model)
{
    const double y = orientation_underside(model, 1), z = orientation_underside(model, 2);
    if (y >= STANDS && z < LIES_BESIDE) return 1;
    return z >= STANDS && y < LIES_BESIDE ? 2 : 0;
}

static bool is_z_up(const struct orientation *orientation, enum up_custom custom, struct model *model)
{
    if (orientation->up != UP_BY_EVIDENCE) return orientation->up == UP_Z;
    if (custom == CUSTOM_ALWAYS_Y || custom == CUSTOM_ALWAYS_Z) return custom == CUSTOM_ALWAYS_Z;
    const int axis = stands_on(model);
    if (custom == CUSTOM_Y && axis == 2) model_note(model, "it stands on its least z: --up z, if it lies on its back");
    if (custom == CUSTOM_Y) return false;
    if (axis == 1) model_note(model, "y is up, it stands on its least y; --up z, if not");
    if (axis == 1) return false;
    model_note(model, axis == 2 ? "z is up, it stands on its least z; --up y, if not" : WORDS_Z_UP);
    return true;
}

/* Turning ---------------------------------------------------------------------------------------------------------- */

/* By a quarter round x: z becomes y. */
void orientation_turn_up(double at_m[3])
{
    const double y_m = at_m[1];
    at_m[1] = at_m[2];
    at_m[2] = -y_m;
}

/* turn = quarter * turn, quarter = (-h, 0, 0, h). */
static void turn_pose(struct model_pose *pose)
{
    const double h = sqrt(0.5), x = pose->turn[0], y = pose->turn[1], z = pose->turn[2], w = pose->turn[3];
    orientation_turn_up(pose->at_m);
    pose->turn[0] = h * (x - w);
    pose->turn[1] = h * (y + z);
    pose->turn[2] = h * (z - y);
    pose->turn[3] = h * (w + x);
}

/* What the importer did to it is undone. It has no animations then. */
static void turn_back(struct model *model)
{
    for (size_t i = 0; i < model->point_count; i++) {
        const double y_m = model->points[i][1];
        model->points[i][1] = -model->points[i][2];
        model->points[i][2] = y_m;
    }
}

static void turn_up(struct model *model)
{
    for (size_t i = 0; i < model->point_count; i++)
        orientation_turn_up(model->points[i]);
    for (size_t i = 0; i < model->mover_count; i++)
        turn_pose(&model->movers[i].rest);
    for (size_t i = 0; i < model->key_count; i++)
        turn_pose(&model->keys[i].pose);
    model->z_was_up = true;
}

static void reverse_faces(struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++) {
        uint32_t *corners = &model->corners[model->faces[i].first], count = model->faces[i].count;
        for (uint32_t k = 0; k < count / 2; k++) {
            const uint32_t corner = corners[k];
            corners[k] = corners[count - 1 - k];
            corners[count - 1 - k] = corner;
        }
    }
    model->faces_were_reversed = true;
}

/* As it was handed over its least z is its least y. */
static void apply_to_turned(const struct orientation *orientation, struct model *model)
{
    if (orientation->up == UP_Y) turn_back(model);
    if (orientation->up == UP_BY_EVIDENCE && stands_on(model) != 1) model_note(model, WORDS_Z_UP);
}

/* Some importers hand over faces that all have two sides (OFF). */
static void note_winding(const struct orientation *orientation, struct model *model)
{
    if (orientation->two_sided || !winding_is_clockwise(model)) return;
    if (orientation->reverse_faces)
        model_note(model, "faces run clockwise now: leave out --reverse-faces");
    else
        model_note(model, model->faces[0].two_sided ? "faces run clockwise, it is lit from inside: --reverse-faces"
                                                    : "faces run clockwise, it is seen from inside: --reverse-faces");
}

void orientation_apply(const struct orientation *orientation, enum up_custom custom, struct model *model)
{
    if (custom == CUSTOM_TURNED)
        apply_to_turned(orientation, model);
    else if (is_z_up(orientation, custom, model))
        turn_up(model);
    if (orientation->reverse_faces) reverse_faces(model);
    if (custom != CUSTOM_ALWAYS_Y) note_winding(orientation, model);
    for (size_t i = 0; i < model->face_count && orientation->two_sided; i++)
        model->faces[i].two_sided = true;
}

void orientation_point(const struct model *model, double at_m[3])
{
    if (model->z_was_up) orientation_turn_up(at_m);
}
