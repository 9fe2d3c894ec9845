/* SPDX-License-Identifier: MIT
 *
 * The static part chooses the grid. An object's origin is that of its node, about which the animation turns it. */
#include "compiler/moving_compile.h"

#include "accuracy/moving_reference.h"
#include "accuracy/predict.h"
#include "accuracy/promise.h"
#include "base/choice.h"
#include "base/grow.h"
#include "cameras/camera_path.h"
#include "compiler/compile.h"
#include "compiler/order_choice.h"
#include "compiler/pool_sizes.h"
#include "compiler/texture_budget.h"
#include "model/baked_light.h"
#include "model/model_part.h"
#include "model/moving_frame.h"
#include "readers/import_motion.h"
#include "readers/model_read.h"
#include "readers/source.h"
#include "scene.h"
#include "scene/method.h"
#include "scene/moving.h"
#include "scene/moving_textures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FINER_BITS_MAX = 2, LONG_FINER_BITS_MAX = 8, COARSER_BITS_MAX = 14 };
static const double GRID_END = 32767.0, AT_END_Q8 = 16777216.0, ORIGIN_END = 1073741823.0;

bool moving_mode_parse(const char *text, enum moving_mode *out, struct error *err)
{
    static const char *const names[] = {[MOVING_ON] = "on", [MOVING_OFF] = "off", NULL};
    size_t index;
    if (!choice_find(&(struct choice){"--movers", "way", choice_in_array, names}, text, &index, err)) return false;
    *out = (enum moving_mode)index;
    return true;
}

bool moving_light_parse(const char *text, bool *out, struct error *err)
{
    static const char *const names[] = {"baked", "turning", NULL};
    size_t index;
    if (!choice_find(&(struct choice){"--mover-light", "light", choice_in_array, names}, text, &index, err))
        return false;
    *out = index == 1;
    return true;
}

/* The finest grid that holds the object. In a scene of many scales it may also be coarser. */
static bool object_grid(const struct grid *scene, const struct model *part, struct grid *grid,
                        struct lim_instance *instance)
{
    uint8_t *const finer_bits = &instance->finer_bits, *const coarser_bits = instance->coarser_bits;
    const int most = scene->is_long ? LONG_FINER_BITS_MAX : FINER_BITS_MAX;
    double farthest_m = 0;
    for (size_t i = 0; i < part->point_count; i++)
        for (int k = 0; k < 3; k++)
            farthest_m = fmax(farthest_m, fabs(part->points[i][k]));
    *grid = (struct grid){.units_per_m = scene->units_per_m};
    for (*coarser_bits = 0;
         scene->is_long && *coarser_bits < COARSER_BITS_MAX && !(farthest_m * grid->units_per_m <= GRID_END);
         ++*coarser_bits)
        grid->units_per_m /= 2;
    if (!(farthest_m * grid->units_per_m <= GRID_END)) return false;
    for (*finer_bits = 0; *finer_bits < most && !*coarser_bits && farthest_m * grid->units_per_m * 2 <= GRID_END;
         ++*finer_bits)
        grid->units_per_m *= 2;
    return true;
}

static void number_faces(struct compiled *scene, const uint32_t *numbers)
{
    for (size_t i = 0; i < scene->scene.polygon_count; i++)
        scene->faces[i] = numbers[scene->faces[i] - 1];
    for (size_t i = 0; i < LEAF_PARTS_TOLD && i < scene->report.leaf_parts.count; i++)
        scene->report.leaf_parts.parts[i].face = numbers[scene->report.leaf_parts.parts[i].face - 1];
}

/* `origin`: of a scene of many scales, where at_q8 counts from; or NULL. */
static bool place_set(const struct model_key *from, const struct grid *grid, struct lim_motion_key *to,
                      struct lim_long_vertex *origin)
{
    for (int i = 0; i < 3; i++) {
        const double at = (from->pose.at_m[i] - grid->origin_m[i]) * grid->units_per_m;
        if (!(origin ? fabs(at) < ORIGIN_END : fabs(at * 256) < AT_END_Q8)) return false;
        const double whole = origin ? floor(at) : 0;
        if (origin) origin->at[i] = (int32_t)whole;
        to->at_q8[i] = (int32_t)lround((at - whole) * 256);
    }
    return true;
}

static bool key_set(const struct model_key *from, const struct grid *grid, struct lim_motion_key *to,
                    struct lim_long_vertex *origin)
{
    to->time_ms = (uint32_t)llround(from->time_s * 1000);
    if (!place_set(from, grid, to, origin)) return false;
    for (int i = 0; i < 4; i++)
        to->turn_q15[i] = (int16_t)fmin(fmax(round(from->pose.turn[i] * 32768), -32767), 32767);
    return true;
}

/* Of a quaternion and its negative, which turn alike, the one that is nearer to the key before. */
static void arc_set(struct lim_motion_key *key, struct lim_motion_key *next)
{
    double dot = 0;
    for (int i = 0; i < 4; i++)
        dot += (double)key->turn_q15[i] * next->turn_q15[i] / (32768.0 * 32768.0);
    for (int i = 0; dot < 0 && i < 4; i++)
        next->turn_q15[i] = (int16_t)-next->turn_q15[i];
    key->arc = (uint16_t)fmin(round(acos(fmin(fabs(dot), 1)) / 6.283185307179586 * 65536), 16383);
}

static bool motion_set(const struct model *model, size_t index, const struct grid *grid, struct moving_object *object,
                       struct error *err)
{
    const struct model_mover *mover = &model->movers[index];
    object->keys = grow_zeroed(mover->key_count, sizeof *object->keys);
    if (grid->is_long) object->origins = grow_zeroed(mover->key_count, sizeof *object->origins);
    if (mover->key_count > UINT16_MAX) return error_set(err, "node '%s': more than 65535 keys", mover->name);
    for (uint32_t i = 0; i < mover->key_count; i++)
        if (!key_set(&model->keys[mover->first_key + i], grid, &object->keys[i],
                     grid->is_long ? &object->origins[i] : NULL))
            return error_set(err, "node '%s': it moves too far for coordinates of %d bits; %s--movers off helps",
                             mover->name, grid->is_long ? 32 : 16,
                             grid->is_long ? "" : "--coordinates 32, a ground in the scene or ");
    for (uint32_t i = 0; i + 1 < mover->key_count; i++)
        arc_set(&object->keys[i], &object->keys[i + 1]);
    object->motion = (struct lim_motion){
        .keys = object->keys, .count = (uint16_t)mover->key_count, .repeats = true, .origins = {object->origins}};
    return true;
}

/* Whether nobody names what the scene and its objects are drawn by. */
static bool is_open(const struct compile_options *options)
{
    return !options->method && options->tree == TREE_AUTO;
}

static bool compile_object(struct moving *moving, size_t index, const struct grid *scene_grid,
                           const struct compile_options *options, struct error *err)
{
    struct moving_object *object = &moving->objects[index];
    struct lim_instance *instance = &moving->instances[index];
    struct compile_options own = *options;
    struct model part;
    uint32_t *numbers;
    struct grid grid;
    own.predict = false;
    own.worst_tries = 0;                /* pools are the scene's */
    own.path = (struct camera_path){0}; /* and so are cameras */
    own.forced_near_m = lens_forced_near_m(scene_grid);
    own.leaves_open = is_open(options) && !scene_grid->is_long;
    own.whole_leaf = true;
    own.method = &methods[0];
    own.tree = TREE_BSP;
    own.portals = PORTALS_OFF;
    memcpy(object->name, moving->model.movers[index].name, sizeof object->name);
    model_part(&moving->model, index + 1, !moving->light.on, &part, &numbers);
    bool ok =
        object_grid(scene_grid, &part, &grid, instance) ||
        error_set(err, "its mesh is too large beside what stands still; --coordinates 32, a ground in the scene or "
                       "--movers off helps");
    ok = ok && compile_part(&part, &grid, &own, &object->scene, err);
    if (ok) number_faces(&object->scene, numbers);
    if (!ok) {
        char text[MODEL_NAME_B + 8];
        snprintf(text, sizeof text, "node '%s'", object->name);
        error_prefix(err, text);
    }
    ok = ok && motion_set(&moving->model, index, scene_grid, object, err);
    instance->object = &object->scene.scene;
    model_free(&part);
    free(numbers);
    return ok;
}

static struct note *add_note(struct compile_report *report)
{
    size_t capacity = report->note_count;
    report->notes = grow(report->notes, report->note_count, &capacity, sizeof *report->notes);
    report->notes[report->note_count] = (struct note){.is_detail = false};
    return &report->notes[report->note_count++];
}

/* What of an object is not seen as its file has it. */
static void note_left_out(const struct moving_object *object, struct compile_report *report)
{
    const struct compile_report *own = &object->scene.report;
    if (own->left_out)
        snprintf(add_note(report)->text, sizeof report->notes->text,
                 "object '%s': --drop-small left out %zu of %zu faces, too small for the grid", object->name,
                 own->left_out, own->mesh.faces);
    if (own->covered)
        snprintf(add_note(report)->text, sizeof report->notes->text,
                 "object '%s': %zu faces are covered by later faces of the file in the same plane", object->name,
                 own->covered);
}

/* What moves has the mean colours of its pictures: it is lit in each frame, or there are too many. */
static void note_untextured(const struct model *model, size_t index, struct compile_report *report)
{
    bool textured = false;
    for (size_t i = 0; i < model->face_count; i++)
        textured |= model->faces[i].mover == index + 1 && model->faces[i].picture;
    if (textured)
        snprintf(add_note(report)->text, sizeof report->notes->text,
                 "object '%s': textures are not drawn on what moves", model->movers[index].name);
}

/* A frame has numbers for so many textured polygons, and what moves gets them as it comes. */
static void note_numbers(const struct moving *moving, struct compiled *scene)
{
    size_t numbers = lim_texture_numbers(&scene->scene);
    for (size_t i = 0; i < moving->count; i++)
        if (moving->objects[i].words) numbers += lim_texture_numbers(&moving->objects[i].scene.scene);
    if (numbers > LIM_NONE)
        snprintf(add_note(&scene->report)->text, sizeof scene->report.notes->text,
                 "too many textured polygons: where all that moves is in view, some of it shows colours");
}

static void limits_set(struct moving *moving)
{
    struct lim_movers_limits *limits = &moving->limits;
    *limits = (struct lim_movers_limits){.instances = (uint16_t)moving->count};
    for (size_t i = 0; i < moving->count; i++) {
        const struct lim_scene *object = &moving->objects[i].scene.scene;
        if (object->limits.depth > limits->depth) limits->depth = object->limits.depth;
        if (object->limits.leaf_vertices > limits->leaf_vertices) limits->leaf_vertices = object->limits.leaf_vertices;
        if (object->limits.leaf_polygons > limits->leaf_polygons) limits->leaf_polygons = object->limits.leaf_polygons;
    }
}

/* Face numbers of all parts together have 16 bits where something moves. */
static bool has_numbers(const struct moving *moving, const struct compiled *scene)
{
    size_t polygons = scene->scene.polygon_count;
    for (size_t i = 0; i < moving->count; i++)
        polygons += moving->objects[i].scene.scene.polygon_count;
    return polygons <= UINT16_MAX;
}

static bool predict_parts(struct moving *moving, const struct core *core, struct compiled *scene, struct error *err)
{
    struct reference reference = {0};
    uint32_t *groups = NULL;
    if (!has_numbers(moving, scene)) {
        snprintf(add_note(&scene->report)->text, sizeof scene->report.notes->text,
                 "wrong pixels are not predicted: scene and objects have more than 65535 polygons");
        return true;
    }
    scene->moving = moving;
    const bool ok = moving_groups(moving, &groups, err) &&
                    moving_reference(moving, &reference, PREDICT_SIDE_PX, PREDICT_SIDE_PX, err) &&
                    predict_wrong(scene, core, &reference, groups, moving->model.face_count, &scene->report.wrong, err);
    if (ok) promise_note(scene);
    scene->moving = NULL; /* the caller's */
    reference_free(&reference);
    free(groups);
    return ok;
}

/* In a scene of many scales what moves is not sorted with a leaf's polygons. */
static bool may_move(const struct compiled *scene, enum tree_kind tree, struct error *err)
{
    return !scene->grid.is_long || !scene->report.leaves ||
           error_set(err, "--tree %s: in a scene with coordinates of 32 bits nothing moves in a tree with leaves",
                     tree_names[tree]);
}

static bool compile_parts(struct moving *moving, const struct compile_options *options, struct compiled *scene,
                          struct error *err)
{
    struct compile_options own = *options;
    struct model part;
    uint32_t *numbers;
    own.leaves_open = is_open(options);
    if (!own.method) own.method = &methods[0]; /* nearest first */
    if (own.tree == TREE_AUTO) own.tree = TREE_BSP;
    own.predict = false; /* all parts together are */
    model_part(&moving->model, 0, true, &part, &numbers);
    bool ok = compile_part(&part, NULL, &own, scene, err) && may_move(scene, own.tree, err);
    if (ok) number_faces(scene, numbers);
    model_free(&part);
    free(numbers);
    if (!ok) return false;
    moving->grid = scene->grid;
    moving->count = moving->model.mover_count;
    scene->report.moves = true;
    moving->objects = grow_zeroed(moving->count, sizeof *moving->objects);
    moving->instances = grow_zeroed(moving->count, sizeof *moving->instances);
    for (size_t i = 0; ok && i < moving->count; i++) {
        ok = compile_object(moving, i, &scene->grid, options, err);
        if (ok) note_left_out(&moving->objects[i], &scene->report);
    }
    if (!ok) return false;
    const bool is_textured = moving_share_textures(moving, scene) && !moving->light.on;
    for (size_t i = 0; !is_textured && i < moving->count; i++)
        note_untextured(&moving->model, i, &scene->report);
    if (is_textured) note_numbers(moving, scene);
    limits_set(moving);
    if (!method_can_move(own.method->draws)) return true; /* refused where they are to be drawn */
    return order_choose_moving(scene, moving, options, err) &&
           (!options->predict || predict_parts(moving, options->core, scene, err));
}

static void stop_movers(struct moving *moving)
{
    struct model *model = &moving->model;
    for (size_t i = 0; i < model->face_count; i++)
        model->faces[i].mover = 0;
    moving->stopped = model->mover_count + model->is_stopped;
    if (moving->stopped) model_note(model, "what is animated stands still where the file has it");
    model->mover_count = model->key_count = 0;
}

/* Their light comes later; a material that has none of its own is lit all the same. */
static void keep_movers_unlit(struct moving *moving, bool mono)
{
    for (size_t i = 0; i < moving->model.face_count; i++)
        moving->model.faces[i].unlit |= moving->model.faces[i].mover > 0;
    moving->light = mono ? light_lamp_mono() : light_lamp();
}

bool moving_compile(const char *path, const struct compile_options *options, const struct moving_options *movers,
                    struct compiled *scene, struct moving *moving, struct error *err)
{
    struct model model;
    *moving = (struct moving){0};
    motions_leave_out(movers->mode == MOVING_OFF);
    if (!model_read(path, &options->orientation, &model, err)) return false;
    if (!compile_source(path, &model, options, err)) {
        model_free(&model);
        return false;
    }
    return (moving_compile_model(&model, options, movers, scene, moving, err) || error_prefix(err, path));
}

bool moving_compile_model(const struct model *model, const struct compile_options *options,
                          const struct moving_options *movers, struct compiled *scene, struct moving *moving,
                          struct error *err)
{
    *moving = (struct moving){.model = *model};
    if (movers->mode == MOVING_OFF) stop_movers(moving);
    moving_frame_add(&moving->model, options->background);
    if (movers->light && !options->unlit) keep_movers_unlit(moving, options->mono);
    compile_options_light(options, &moving->model);
    if (!texture_budget_apply(&moving->model, options, err)) return false;
    const struct compile_options own = order_options_for(options, &moving->model);
    if (!moving->model.mover_count) return compile_part(&moving->model, NULL, &own, scene, err);
    if (own.framebuffer) return error_set(err, "--framebuffer: objects that move are drawn line by line");
    return compile_parts(moving, &own, scene, err);
}

bool moving_compile_own(const char *path, const struct compile_options *options, enum moving_mode mode,
                        struct compiled *scene, struct error *err)
{
    const struct moving_options movers = {.mode = mode};
    struct moving *moving = grow_zeroed(1, sizeof *moving);
    bool ok = moving_compile(path, options, &movers, scene, moving, err);
    if (ok && moving->count) {
        scene->moving = moving;
        return true;
    }
    moving_free(moving);
    free(moving);
    if (!ok) compiled_free(scene);
    return ok;
}
