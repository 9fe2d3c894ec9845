/* SPDX-License-Identifier: MIT
 *
 * What options of a command line set, and what follows from them: a method may need a tree of its own kind, or none. */
#include "compiler/compile_options.h"

#include "base/choice.h"
#include "base/parse.h"
#include "cameras/gltf_cameras.h"
#include "core/core.h"
#include "model/baked_light.h"
#include "model/model.h"

#include <string.h>

const char *const mesh_leaves_names[] = {"auto", "none", "all", NULL};

/* Options --------------------------------------------------------------------------------------- */

static bool parse_tree(const char *text, struct compile_options *out, struct error *err)
{
    if (!tree_kind_parse(text, &out->tree, err)) return false;
    out->trial = TRIAL_ALWAYS;
    return true;
}

static bool parse_mesh_leaves(const char *text, enum mesh_leaves *out, struct error *err)
{
    size_t index;
    if (!choice_find(&(struct choice){"--mesh-leaves", "choice", choice_in_array, mesh_leaves_names}, text, &index,
                     err))
        return false;
    *out = (enum mesh_leaves)index;
    return true;
}

static bool parse_coordinates(const char *text, enum coordinates *out, struct error *err)
{
    static const char *const names[] = {"auto", "16", "32", NULL};
    size_t index;
    if (!choice_find(&(struct choice){"--coordinates", "choice", choice_in_array, names}, text, &index, err))
        return false;
    *out = (enum coordinates)index;
    return true;
}

bool portals_parse(const char *text, enum portals_wanted *out, struct error *err)
{
    static const char *const names[] = {[PORTALS_OFF] = "off", [PORTALS_AUTO] = "auto", [PORTALS_ON] = "on"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strcmp(text, names[i]) != 0) continue;
        *out = (enum portals_wanted)i;
        return true;
    }
    return error_set(err, "--portals %s: there are on, off and auto", text);
}

static const double USUAL_DEG = 60; /* of a picture whose size nobody has said */

bool compile_options_cameras(struct compile_options *options, const struct camera_choice *choice,
                             struct camera_path *out, struct error *err)
{
    struct camera_choice here = *choice;
    here.z_is_up = options->orientation.up == UP_Z;
    here.fov_deg = options->fov_deg;
    if (!(here.fov_deg > 0))
        here.fov_deg = options->h_px ? lens_usual_fov_deg(options->w_px, options->h_px) : USUAL_DEG;
    if (!camera_choice_read(&here, out, err)) return false;
    camera_path_free(&options->eyes);
    return !out->count || camera_path_few(out, out->count, &options->eyes, err);
}

/* What was read before is freed. */
static bool parse_path(const char *text, struct compile_options *out, struct error *err)
{
    struct camera_choice choice;
    if (!camera_choice_parse(text, &choice, err)) return false;
    if (choice.random_count) return error_set(err, "--path %s: a program's cameras are in a file, not at random", text);
    if (gltf_cameras_are_named(text))
        return error_set(err, "--path %s: a file of cameras, or a map; those of glTF are for --camera alone", text);
    camera_path_free(&out->path);
    return camera_choice_read(&choice, &out->path, err);
}

struct compile_options compile_options_usual(void)
{
    return (struct compile_options){.tolerance_units = 0.5,
                                    .splitter = "auto",
                                    .trial = TRIAL_IF_SPLIT,
                                    .choose_order = true,
                                    .portals = PORTALS_AUTO};
}

bool compile_options_know(int code)
{
    return code >= ORIENTATION_UP && code < COMPILE_CODES_END;
}

bool compile_options_take(int code, const char *text, struct compile_options *out, struct error *err)
{
    switch (code) {
    case COMPILE_NEAR:
        return parse_near(text, &out->near_m, err);
    case COMPILE_COORDINATES:
        return parse_coordinates(text, &out->coordinates, err);
    case COMPILE_UNLIT:
        return out->unlit = true;
    case COMPILE_DROP_SMALL:
        return out->drop_small = true;
    case COMPILE_TREE:
        return parse_tree(text, out, err);
    case COMPILE_SPLITTER:
        out->splitter = text;
        return true;
    case COMPILE_MESH_LEAVES:
        return parse_mesh_leaves(text, &out->mesh_leaves, err);
    case COMPILE_PORTALS:
        return portals_parse(text, &out->portals, err);
    case COMPILE_PATH:
        return parse_path(text, out, err);
    case COMPILE_FOV:
        return parse_fov(text, &out->fov_deg, err);
    default:
        return orientation_parse(code, text, &out->orientation, err);
    }
}

/* What follows from them --------------------------------------------------------------------------- */

bool compile_options_settle(struct compile_options *options, struct error *err)
{
    const struct method *method = options->method;
    if (!method) return true;
    if (options->tree == TREE_AUTO) options->tree = method->tree;
    if (options->tree == TREE_MESH && !method_draws_meshes(method->draws))
        return error_set(err, "--method %s --tree mesh: it draws no meshes; mesh and mesh-depth do", method->name);
    if (method_sorts(method->draws)) return true;
    if (options->tree == TREE_NONE && !method_draws_meshes(method->draws))
        return error_set(err, "--method %s --tree none: a set has no order; depth and newell draw it", method->name);
    return method->tree == TREE_AUTO || method->tree == options->tree ||
           error_set(err, "--method %s --tree %s: that method has a tree of its own", method->name,
                     tree_names[options->tree]);
}

void compile_options_free(struct compile_options *options)
{
    camera_path_free(&options->path);
    camera_path_free(&options->eyes);
}

bool compile_method_parse(const char *text, struct compile_options *out, struct error *err)
{
    out->method = method_parse(text, err);
    if (!out->method) return false;
    if (out->method->portals) out->portals = PORTALS_ON;
    return true;
}

enum lim_method compile_options_draws(const struct compile_options *options)
{
    if (options->method) return options->method->draws;
    if (options->tree == TREE_NONE) return LIM_NEWELL;
    return options->tree == TREE_MESH ? LIM_MESH_DEPTH : LIM_NEAREST_FIRST;
}

bool compile_options_may_leaf(const struct compile_options *options)
{
    const enum lim_method draws = compile_options_draws(options);
    if (options->core && options->core->profile == LIM_PROFILE_EXACT) return false;
    if (options->wireframe || options->framebuffer || options->portals == PORTALS_ON) return false;
    return draws == LIM_NEAREST_FIRST || draws == LIM_SCANLINE || draws == LIM_PAINTER;
}

bool compile_options_may_be_long(const struct compile_options *options)
{
    const enum lim_method draws = compile_options_draws(options);
    if (options->drop_small) return false;
    if (options->mesh_leaves == MESH_LEAVES_ALL) return false;
    return draws == LIM_NEAREST_FIRST || draws == LIM_SCANLINE || draws == LIM_PAINTER;
}

bool compile_options_coordinates(const struct compile_options *options, enum coordinates *out, struct error *err)
{
    const bool may = compile_options_may_be_long(options);
    *out = may ? options->coordinates : COORDINATES_16;
    return may || options->coordinates != COORDINATES_32 ||
           error_set(err, "--coordinates 32: not with --drop-small, mesh leaves, or methods that do not walk a tree");
}

void compile_options_light(const struct compile_options *options, struct model *model)
{
    (options->unlit ? light_none : options->mono ? light_bake_mono : light_bake)(model);
}
