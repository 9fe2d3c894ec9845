/* SPDX-License-Identifier: MIT
 *
 * Counters are nobody's need: who wants them says so to the C compiler. */
#include "scene/needs.h"

#include "core/core.h"
#include "scene/mcu_sizes.h"
#include "scene/moving.h"
#include "scene/records.h"
#include "scene/width.h"

enum { SIDE_MIN_PX = 8 };

static unsigned greater(unsigned a, unsigned b)
{
    return a > b ? a : b;
}

static bool walks_tree(enum lim_method draws)
{
    return draws == LIM_NEAREST_FIRST || draws == LIM_PAINTER || draws == LIM_SCANLINE;
}

/* Of that kind. */
static bool has_textures(const struct lim_scene *scene, unsigned kind)
{
    for (size_t i = 0; i < scene->texture_count && !*scene->uvs; i++)
        if (scene->textures[i].place_bits & kind) return true;
    return false;
}

static struct needs needs_of_scene(const struct compiled *scene)
{
    return (struct needs){.nearest = scene->report.draws == LIM_NEAREST_FIRST,
                          .convex = scene->report.draws == LIM_CONVEX,
                          .painter = scene->report.draws == LIM_PAINTER,
                          .scanline = scene->report.draws == LIM_SCANLINE,
                          .depth = scene->report.draws == LIM_DEPTH,
                          .newell = scene->report.draws == LIM_NEWELL,
                          .mesh = scene->report.draws == LIM_MESH,
                          .mesh_depth = scene->report.draws == LIM_MESH_DEPTH,
                          .cull = scene->scene.box_count > 0 && walks_tree(scene->report.draws),
                          .wide = width_is_wide(&scene->scene),
                          .leaves = scene->report.leaves > 0 || scene->scene.limits.leaf_polygons > 0,
                          .mesh_leaves = scene->scene.limits.leaf_polygons > 0,
                          .textures = scene->scene.texture_count > 0,
                          .masked = has_textures(&scene->scene, LIM_TEXTURE_MASKED),
                          .sky = has_textures(&scene->scene, LIM_TEXTURE_SKY),
                          .tele = scene->report.tele,
                          .portals = scene->scene.place_count > 0,
                          .slanted = scene->scene.plane_count > 0,
                          .large = scene->scene.exact_count > 0,
                          .of_32_bits = scene->grid.is_long,
                          .transparent = scene->scene.limits.layers > 0,
                          .wireframe = scene->report.wireframe,
                          .antialias = scene->report.antialias,
                          .delta = scene->report.delta_runs > 0,
                          .overlay = scene->report.overlay,
                          .round = scene->report.round,
                          .fill = scene->report.fill,
                          .framebuffer = scene->report.framebuffer,
                          .vertices = scene->scene.limits.vertices,
                          .side_px = greater(scene->report.w_px, scene->report.h_px),
                          .core = scene->report.core};
}

/* What an object's arrays hold; it is drawn by its scene's method. */
static void add_object(struct needs *needs, const struct compiled *object)
{
    needs->cull |= object->scene.box_count > 0;
    needs->wide |= width_is_wide(&object->scene);
    needs->leaves |= object->report.leaves > 0 || object->scene.limits.leaf_polygons > 0;
    needs->mesh_leaves |= object->scene.limits.leaf_polygons > 0;
    needs->slanted |= object->scene.plane_count > 0;
    needs->large |= object->scene.exact_count > 0;
    needs->transparent |= records_with(&object->scene, LIM_POLYGON_ALPHA) > 0;
    needs->vertices = greater(needs->vertices, object->scene.limits.vertices);
}

struct needs needs_of(const struct compiled *scene, const struct moving *moving)
{
    struct needs needs = needs_of_scene(scene);
    needs.movers = moving && moving->count > 0;
    needs.light = moving && moving->light.on;
    for (size_t i = 0; moving && i < moving->count; i++)
        add_object(&needs, &moving->objects[i].scene);
    return needs;
}

struct needs needs_union(const struct needs *a, const struct needs *b)
{
    return (struct needs){.nearest = a->nearest || b->nearest,
                          .convex = a->convex || b->convex,
                          .painter = a->painter || b->painter,
                          .scanline = a->scanline || b->scanline,
                          .depth = a->depth || b->depth,
                          .newell = a->newell || b->newell,
                          .mesh = a->mesh || b->mesh,
                          .mesh_depth = a->mesh_depth || b->mesh_depth,
                          .cull = a->cull || b->cull,
                          .wide = a->wide || b->wide,
                          .leaves = a->leaves || b->leaves,
                          .mesh_leaves = a->mesh_leaves || b->mesh_leaves,
                          .textures = a->textures || b->textures,
                          .masked = a->masked || b->masked,
                          .sky = a->sky || b->sky,
                          .tele = a->tele || b->tele,
                          .portals = a->portals || b->portals,
                          .slanted = a->slanted || b->slanted,
                          .large = a->large || b->large,
                          .of_32_bits = a->of_32_bits || b->of_32_bits,
                          .transparent = a->transparent || b->transparent,
                          .wireframe = a->wireframe || b->wireframe,
                          .movers = a->movers || b->movers,
                          .light = a->light || b->light,
                          .antialias = a->antialias || b->antialias,
                          .delta = a->delta || b->delta,
                          .overlay = a->overlay || b->overlay,
                          .round = a->round || b->round,
                          .fill = a->fill || b->fill,
                          .framebuffer = a->framebuffer || b->framebuffer,
                          .vertices = greater(a->vertices, b->vertices),
                          .side_px = greater(a->side_px, b->side_px),
                          .core = a->core};
}

bool needs_retain_nothing(const struct needs *needs)
{
    return (needs->fill || needs->framebuffer) && !needs->textures && !needs->transparent && !needs->wireframe &&
           !needs->antialias && !needs->delta && !needs->movers;
}

uint16_t needs_least_cells(const struct lim_limits *limits)
{
    return (uint16_t)(MCU_HEAD_CELLS + limits->vertices + MCU_CLIP_PLANES);
}

struct lim_limits needs_limits(const struct compiled *scene, const struct needs *needs)
{
    struct lim_limits limits = scene->scene.limits;
    if (scene->report.draws == LIM_SCANLINE) limits.gaps = needs->antialias || limits.layers ? limits.gaps : 1;
    const bool keeps = scene->report.fill || scene->report.framebuffer;
    if (scene->report.draws != LIM_NEAREST_FIRST || !keeps || !needs_retain_nothing(needs)) return limits;
    limits.retained_cells = needs_least_cells(&limits);
    limits.active = 1;
    return limits;
}

static void write_macro(FILE *file, const char *name, unsigned value)
{
    fprintf(file, "#ifndef LIM_%s\n#define LIM_%s %u\n#endif\n", name, name, value);
}

/* A profile's own sub-pixel bits go without saying. */
static void write_profile(FILE *file, const struct core *core)
{
    static const char *const names[] = {"DRAFT", "FAST", "FINE", "EXACT"};
    fprintf(file, "#ifndef LIM_PROFILE\n#define LIM_PROFILE LIM_PROFILE_%s\n#endif\n", names[core->profile]);
    if (!core->is_profile) write_macro(file, "SUB_BITS", core->sub_bits);
}

void needs_write(const struct needs *needs, FILE *file)
{
    write_macro(file, "HAS_NEAREST", needs->nearest);
    write_macro(file, "HAS_CONVEX", needs->convex);
    write_macro(file, "HAS_PAINTER", needs->painter);
    write_macro(file, "HAS_SCANLINE", needs->scanline);
    write_macro(file, "HAS_DEPTH", needs->depth);
    write_macro(file, "HAS_NEWELL", needs->newell);
    write_macro(file, "HAS_MESH", needs->mesh);
    write_macro(file, "HAS_MESH_DEPTH", needs->mesh_depth);
    write_macro(file, "HAS_MOVERS", needs->movers);
    write_macro(file, "HAS_LIGHT", needs->light);
    write_macro(file, "HAS_DEFORM", 0);
    write_macro(file, "HAS_CULL", needs->cull);
    write_macro(file, "HAS_WIDE", needs->wide);
    write_macro(file, "HAS_LEAVES", needs->leaves);
    write_macro(file, "HAS_MESH_LEAVES", needs->mesh_leaves);
    write_macro(file, "HAS_TEXTURE", needs->textures);
    write_macro(file, "HAS_MASKED", needs->masked);
    write_macro(file, "HAS_SKY", needs->sky);
    write_macro(file, "HAS_TELE", needs->tele);
    write_macro(file, "HAS_PORTALS", needs->portals);
    write_macro(file, "HAS_SLANTED", needs->slanted);
    write_macro(file, "HAS_LARGE", needs->large);
    write_macro(file, "HAS_LONG", needs->of_32_bits);
    write_macro(file, "HAS_TRANSPARENT", needs->transparent);
    write_macro(file, "HAS_WIREFRAME", needs->wireframe);
    write_macro(file, "HAS_ANTIALIAS", needs->antialias);
    write_macro(file, "HAS_DELTA", needs->delta);
    write_macro(file, "HAS_OVERLAY", needs->overlay);
    write_macro(file, "HAS_ROUND", needs->round);
    write_macro(file, "HAS_FILL", needs->fill && needs->nearest);
    write_macro(file, "HAS_FRAMEBUFFER", needs->framebuffer);
    write_macro(file, "HAS_STATS", 0);
    write_macro(file, "MAX_VERTICES", needs->vertices);
    if (needs->side_px) write_macro(file, "MAX_SIDE_PX", greater(needs->side_px, SIDE_MIN_PX));
    if (needs->core) write_profile(file, needs->core);
}
