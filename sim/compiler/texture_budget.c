/* SPDX-License-Identifier: MIT
 *
 * The model is compiled once by the plainest options, for the cameras' sake: they are sampled in its free space. */
#include "compiler/texture_budget.h"

#include "base/grow.h"
#include "base/names.h"
#include "base/parse.h"
#include "base/rgb565.h"
#include "base/rgb888.h"
#include "cameras/random_path.h"
#include "compiler/compile_mesh.h"
#include "compiler/coordinates.h"
#include "compiler/faithful.h"
#include "compiler/texture_plan.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SCENE_MOST_B = 0xFFFF * LIM_TEXEL_BLOCK }; /* of texels: what a scene can hold */
enum { KB = 1000, CAMERAS = 48, SEED = 31, FOV_DEG = 60, SIDE_PX = 240 };

static size_t budget_b; /* --texture-budget */
static bool has_budget;

bool texture_budget_parse(const char *text, struct error *err)
{
    double kb;
    if (!parse_number("--texture-budget", text, &kb, err)) return false;
    if (!(kb >= 0 && kb <= 65535)) return error_set(err, "--texture-budget %s: not a number of KB, 0 to 65535", text);
    budget_b = (size_t)floor(kb * KB);
    has_budget = true;
    return true;
}

/* What is seen ---------------------------------------------------------------------------------- */

static bool sample_cameras(const struct mesh *mesh, const struct compile_options *options, struct camera_path *path,
                           struct error *err)
{
    const struct compile_options plain = {.tolerance_units = options->tolerance_units,
                                          .splitter = "auto",
                                          .tree = TREE_BSP,
                                          .core = options->core,
                                          .near_m = options->near_m,
                                          .w_px = options->w_px,
                                          .h_px = options->h_px};
    struct compiled scene = {0};
    const bool ok =
        compile_mesh(mesh, &plain, &scene, err) && random_path(&scene, "sampled cameras", SEED, CAMERAS, path, err);
    compiled_free(&scene);
    return ok;
}

/* On the mesh before anything is merged, whose mappings are those of the model's faces. */
static bool look(const struct mesh *mesh, const struct model *model, const struct compile_options *options,
                 struct texels_seen *seen, struct error *err)
{
    const unsigned w_px = options->w_px ? options->w_px : SIDE_PX;
    struct camera_path sampled = {0};
    struct mesh joined = {0};
    struct lens lens;
    bool ok = true;
    if (!options->path.count)
        ok = mesh_clean_on(model, &mesh->grid, &joined, err) && mesh_insert_t_vertices(&joined, err) &&
             sample_cameras(&joined, options, &sampled, err);
    ok = ok &&
         lens_init(&lens, FOV_DEG, options->near_m > 0 ? options->near_m : lens_usual_near_m(&mesh->grid), 1, 1, err);
    ok = ok && texels_seen_add(mesh, model, sampled.count ? &sampled : &options->path, &lens, w_px, seen, err);
    camera_path_free(&sampled);
    mesh_free(&joined);
    return ok;
}

/* Half a per cent of all that is seen, by pictures' faces, finest level: so what no camera met is not for nothing. */
static void add_unseen(const struct mesh *mesh, struct texels_seen *seen)
{
    double pixels = 0, faces = 0;
    double *const shown = grow_zeroed(mesh->texture_count, sizeof *shown);
    for (size_t i = 0; i < mesh->texture_count; i++)
        for (int level = 0; level < TEXELS_SEEN_LEVELS; level++)
            pixels += seen[i].pixels[level];
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        if (!mesh->polygons[i].mapping) continue;
        shown[mesh->mappings[mesh->polygons[i].mapping].texture]++;
        faces++;
    }
    for (size_t i = 0; i < mesh->texture_count && faces > 0; i++)
        seen[i].pixels[0] += fmax(pixels, 1) / 200 * shown[i] / faces;
    free(shown);
}

/* What a mesh without a tree takes for its flat faces: a texture and a colour for each colour. */
static size_t flat_colours_b(const struct mesh *mesh, const struct model *model, const struct compile_options *options)
{
    enum { LOOK_B = sizeof(struct lim_texture) + sizeof(uint16_t) };
    struct map colours = {0};
    const bool may_be_mesh = options->tree == TREE_MESH || (options->tree == TREE_AUTO && !model->is_interior);
    for (size_t i = 0; may_be_mesh && i < mesh->polygon_count; i++)
        if (!mesh->polygons[i].mapping) map_at(&colours, rgb565_nearest(mesh->polygons[i].colour), 0);
    const size_t count = colours.count;
    map_free(&colours);
    return count ? count * LOOK_B + LIM_TEXEL_BLOCK : 0;
}

/* What is done ---------------------------------------------------------------------------------- */

static void change_faces(struct model *model, const struct mesh *mesh, const struct texture_step *steps)
{
    for (size_t i = 0; i < model->face_count; i++) {
        struct model_face *face = &model->faces[i];
        if (!face->picture) continue;
        const uint32_t texture = face->picture - 1;
        if (!mesh->textures[texture].texel_count) continue;
        if (steps[texture].is_flat) face->colour = rgb888_times(mesh->textures[texture].mean, face->colour);
        face->picture = steps[texture].is_flat ? 0 : steps[texture].shows + 1;
        if (face->picture == texture + 1) continue;
        model->pictures[texture].faces--;
        if (face->picture) model->pictures[face->picture - 1].faces++;
    }
}

static unsigned side_px(const struct texture *texture, bool is_height, unsigned cut)
{
    return 1u << ((is_height != texture->transposed ? texture->h_bits : texture->w_bits) - cut);
}

static void note_picture(struct model *model, const struct mesh *mesh, uint32_t number, const struct texture_step *step)
{
    struct picture *picture = &model->pictures[number];
    const struct texture *texture = &mesh->textures[number];
    const unsigned w_px = side_px(texture, false, step->cut), h_px = side_px(texture, true, step->cut);
    const int size = sizeof picture->became;
    if (step->is_flat)
        snprintf(picture->became, (size_t)size, "its mean colour, off by %.1f of 255", step->rms);
    else if (step->shows != number)
        snprintf(picture->became, (size_t)size, "%s, %ux%u, off by %.1f of 255",
                 name_end(model->pictures[step->shows].name).text, w_px, h_px, step->rms);
    else if (step->cut)
        snprintf(picture->became, (size_t)size, "%ux%u, off by %.1f of 255", w_px, h_px, step->rms);
}

static void apply(struct model *model, const struct mesh *mesh, const struct texture_plan *plan)
{
    size_t cut = 0, merged = 0, flat = 0;
    for (uint32_t i = 0; i < mesh->texture_count; i++) {
        const struct texture_step *step = &plan->steps[i];
        if (!mesh->textures[i].texel_count) continue;
        note_picture(model, mesh, i, step);
        if (step->is_flat)
            flat++;
        else if (step->shows != i)
            merged++;
        else if (step->cut)
            cut++;
        if (!step->is_flat && step->shows == i)
            model->pictures[i].w_bits_end = (uint8_t)(mesh->textures[i].w_bits - step->cut + 1);
    }
    change_faces(model, mesh, plan->steps);
    snprintf(
        model->textures_became, sizeof model->textures_became,
        "textures for %.1f KB, before %.1f KB: smaller %zu, shown as another %zu, as a colour %zu; texels seen are "
        "off by %.1f of 255",
        (double)budget_b / KB, (double)plan->before_b / KB, cut, merged, flat, plan->rms);
}

static bool plan_and_apply(struct model *model, const struct mesh *mesh, const struct compile_options *options,
                           struct error *err)
{
    const size_t flat_b = flat_colours_b(mesh, model, options);
    const size_t most_b = budget_b < SCENE_MOST_B ? budget_b : SCENE_MOST_B;
    if (texture_plan_bytes(mesh) + flat_b <= most_b) return true;
    struct texels_seen *const seen = grow_zeroed(mesh->texture_count, sizeof *seen);
    struct texture_plan plan = {0};
    bool ok = look(mesh, model, options, seen, err);
    if (ok) {
        add_unseen(mesh, seen);
        ok = texture_plan_make(mesh, seen, most_b > flat_b ? most_b - flat_b : 0, &plan) ||
             error_set(err, "--texture-budget %.4g: textures take %.1f KB at the least; --no-textures does without",
                       (double)budget_b / KB, ceil((double)(plan.after_b + flat_b) / KB * 10) / 10);
    }
    if (ok) apply(model, mesh, &plan);
    texture_plan_free(&plan);
    free(seen);
    return ok;
}

bool texture_budget_apply(struct model *model, const struct compile_options *options, struct error *err)
{
    struct mesh mesh;
    if (!has_budget || !model->picture_count) return true;
    if (!coordinates_clean(model, options, &mesh, err)) return false;
    const bool ok = mesh_textures_enlarge(model, &mesh, err) && plan_and_apply(model, &mesh, options, err);
    mesh_free(&mesh);
    return ok;
}
