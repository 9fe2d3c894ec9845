/* SPDX-License-Identifier: MIT
 *
 * NAME.h: the needs of its scenes as configuration; of each scene its grid, its memory, its declaration, for C and for
 * C++. config.h reads the first part through LIM_CONFIG, before any type is known. Whoever includes NAME.h has the
 * configuration, the renderer and the declarations in this order. */
#include "base/c_name.h"
#include "scene/moving.h"
#include "scene/needs.h"
#include "scene/scene_files.h"

#include <math.h>
#include <string.h>

/* What the three orders that leave gaps need. */
static void write_spans_memory(FILE *file, const struct compiled *scene, const struct lim_limits *limits)
{
    const unsigned count = (unsigned)scene->scene.polygon_count;

    if (scene->report.draws == LIM_NEWELL)
        fprintf(file, "LIM_NEWELL_MEM_B(h_px, %u, %u", count, (unsigned)limits->pieces);
    else if (scene->report.draws == LIM_DEPTH)
        fprintf(file, "LIM_DEPTH_MEM_B(h_px, %u", count);
    else
        fprintf(file, "LIM_MEM_B(h_px, %u", (unsigned)limits->depth);
    fprintf(file, ", %u, %u, %u)", (unsigned)limits->retained_cells, (unsigned)limits->gaps, (unsigned)limits->active);
    if (limits->layers) fprintf(file, " + LIM_LAYERS_MEM_B(%u)", (unsigned)limits->layers);
}

static void write_leaf_memory(FILE *file, unsigned vertices, unsigned polygons)
{
    if (polygons) fprintf(file, " + LIM_MESH_LEAF_MEM_B(%u, %u)", vertices, polygons);
}

/* How wide the target is, the macro is not told: a line of depths is as wide as the renderer draws. */
static void write_mesh_memory(FILE *file, const struct compiled *scene, const struct lim_limits *limits,
                              const struct needs *needs)
{
    fprintf(file, "LIM_MESH_MEM_B(h_px, %lu, %lu, %u)", (unsigned long)scene->scene.vertex_count,
            (unsigned long)scene->scene.polygon_count, (unsigned)limits->active);
    if (needs->mesh_depth) fputs(" + LIM_MESH_DEPTH_MEM_B(LIM_MAX_SIDE_PX)", file);
}

static void write_memory(FILE *file, const struct compiled *scene, const struct needs *needs, const char *macro)
{
    const struct lim_limits limits = needs_limits(scene, needs);
    fprintf(file, "\n/* How to draw it, and bytes for lim_init() on a target of h_px lines; limner.h has the rest of "
                  "both expressions. */\n");
    fprintf(file, "#define %s_SCENE_METHOD %s\n", macro, method_symbol(scene->report.draws));
    fprintf(file, "#define %s_SCENE_MEM_B(h_px) (", macro);
    if (scene->report.draws == LIM_CONVEX)
        fprintf(file, "LIM_CONVEX_MEM_B(h_px, %u, %u)", (unsigned)scene->scene.polygon_count, (unsigned)limits.active);
    else if (scene->report.draws == LIM_PAINTER)
        fprintf(file, "LIM_PAINTER_MEM_B(%u)", (unsigned)limits.depth);
    else if (method_draws_meshes(scene->report.draws))
        write_mesh_memory(file, scene, &limits, needs);
    else
        write_spans_memory(file, scene, &limits);
    write_leaf_memory(file, limits.leaf_vertices, limits.leaf_polygons);
    if (scene->scene.place_count)
        fprintf(file, " + LIM_PORTALS_MEM_B(%u, %u)", (unsigned)scene->scene.box_count, (unsigned)limits.depth);
    fputs(")\n", file);
    if (scene->scene.node_count)
        fprintf(file, "#define %s_SCENE_DEPTH %u /* how many lim_index lim_solid_init() takes: collide.h */\n", macro,
                scene->scene.limits.depth ? (unsigned)scene->scene.limits.depth : 1u);
    if (scene->report.delta_runs)
        fprintf(file,
                "#define %s_SCENE_DELTA_MEM_B(w_px, h_px) LIM_DELTA_MEM_B(w_px, h_px, %u) /* for lim_set_delta() */\n",
                macro, (unsigned)scene->report.delta_runs);
}

/* A number with all its digits, which C never takes for an integer: on AVR those have 16 bits. */
static void write_number(FILE *file, const char *macro, const char *suffix, double number)
{
    char digits[40];
    snprintf(digits, sizeof digits, "%.17g", number);
    fprintf(file, "#define %s_%s %s%s\n", macro, suffix, digits, strpbrk(digits, ".e") ? "" : ".0");
}

/* Places of a long scene take 32 bits without any fraction; ways from there have 8. */
static void write_long_metres(FILE *file, const char *macro)
{
    fprintf(file,
            "/* Of metres that are constants: units with 8 fraction bits of a length of up to 2^23 units; units of "
            "any, of a\n"
            " * place, and of a point, which initialises int32_t[3]: lim_camera.origin, from which eye_q8 counts. */\n"
            "#define %s_M_Q8(metres) LIM_UNITS_Q8((metres)*%s_UNITS_PER_M)\n",
            macro, macro);
    fprintf(file, "#define %s_UNITS(metres) LIM_UNITS((metres)*%s_UNITS_PER_M)\n", macro, macro);
    for (int i = 0; i < 3; i++)
        fprintf(file, "#define %s_%c(metres) LIM_UNITS(((metres) - (%s_ORIGIN_%c_M)) * %s_UNITS_PER_M)\n", macro,
                "XYZ"[i], macro, "XYZ"[i], macro);
    fprintf(file, "#define %s_POINT(x_m, y_m, z_m) {%s_X(x_m), %s_Y(y_m), %s_Z(z_m)}\n", macro, macro, macro, macro);
}

/* Places and lengths of the model's world: the compiler has both numbers, so none of it is left for the processor. */
static void write_metres(FILE *file, const struct compiled *scene, const char *macro)
{
    static const char *const origins[] = {"ORIGIN_X_M", "ORIGIN_Y_M", "ORIGIN_Z_M"};
    write_number(file, macro, "UNITS_PER_M", scene->grid.units_per_m);
    for (int i = 0; i < 3; i++)
        write_number(file, macro, origins[i], scene->grid.origin_m[i]);
    if (scene->grid.is_long) {
        write_long_metres(file, macro);
        return;
    }
    fprintf(
        file,
        "/* Of metres that are constants, units with 8 fraction bits: of a length, of a place, and of a point, which\n"
        " * initialises int32_t[3]. */\n"
        "#define %s_M_Q8(metres) LIM_UNITS_Q8((metres)*%s_UNITS_PER_M)\n",
        macro, macro);
    for (int i = 0; i < 3; i++)
        fprintf(file, "#define %s_%c_Q8(metres) LIM_UNITS_Q8(((metres) - (%s_ORIGIN_%c_M)) * %s_UNITS_PER_M)\n", macro,
                "XYZ"[i], macro, "XYZ"[i], macro);
    fprintf(file, "#define %s_POINT_Q8(x_m, y_m, z_m) {%s_X_Q8(x_m), %s_Y_Q8(y_m), %s_Z_Q8(z_m)}\n", macro, macro,
            macro, macro);
}

/* What the target must be able to lend at any time. */
static void write_lines(FILE *file, const struct compiled *scene, const char *macro)
{
    const bool all = scene->report.draws == LIM_PAINTER || scene->report.framebuffer;

    fprintf(file, "#define %s_SCENE_LINES(h_px) %s\n", macro, all ? "(h_px)" : "1");
}

/* What a program may draw to see its slowest frame. */
static void write_worst(FILE *file, const struct compile_report *report, bool is_long, const char *macro)
{
    const struct worst_report *worst = &report->worst;
    if (!worst->tried) return;
    fprintf(
        file,
        "\n/* The view that costs most, of %zu: searched, not proved. Its camera; and what views take of the pools at "
        "most. */\n",
        worst->tried);
    if (!isnan(report->instructions))
        fprintf(file, "#define %s_WORST_M0PLUS_INSTRUCTIONS %.0f /* predicted; searched */\n", macro, worst->work);
    fprintf(file, "#define %s_WORST_EYE_Q8 {%ld, %ld, %ld}\n", macro, (long)worst->eye_q8[0], (long)worst->eye_q8[1],
            (long)worst->eye_q8[2]);
    if (is_long)
        fprintf(file, "#define %s_WORST_ORIGIN {%ld, %ld, %ld}\n", macro, (long)worst->origin[0],
                (long)worst->origin[1], (long)worst->origin[2]);
    fprintf(file, "#define %s_WORST_YAW UINT32_C(%lu)\n#define %s_WORST_PITCH UINT32_C(%lu)\n", macro,
            (unsigned long)worst->yaw, macro, (unsigned long)worst->pitch);
    if (worst->time_s > 0.0) fprintf(file, "#define %s_WORST_TIME_MS %.0f\n", macro, 1000.0 * worst->time_s);
    fprintf(file, "#define %s_WORST_CELLS %u\n#define %s_WORST_GAPS %u\n#define %s_WORST_ACTIVE %u\n", macro,
            worst->cells, macro, worst->gaps, macro, worst->active);
}

/* For lim_begin(). */
static void write_block(FILE *file, const struct c_name *name, bool moves)
{
    fprintf(file,
            "\n/* `%s_MEMORY(240, 240);` declares %s_memory, all that a display of so many pixels takes. */\n"
            "#define %s_MEMORY(w_px, h_px) \\\n    LIM_MEMORY(%s_memory, w_px, h_px, %s_SCENE_MEM_B(h_px), ",
            name->macro, name->symbol, name->macro, name->symbol, name->macro);
    fprintf(file, moves ? "%s_MOVERS_MEM_B" : "0", name->macro);
    fprintf(file, ", %s_SCENE_LINES(h_px))\n", name->macro);
}

/* Ties a scene to its method, its memory and what moves in it. */
static void write_begin(FILE *file, const struct named_scene *named, const struct c_name *name)
{
    const bool has_movers = named->moving != NULL, has_light = has_movers && named->moving->light.on;

    fprintf(
        file,
        "\n/* Prepares memory.lim to draw it on a display that send() sends to. 0, or what lim_init() returns. */\n"
        "LIM_MUST_CHECK static inline int %s_begin(const struct lim_memory *memory, lim_send *send, void *ctx)\n{\n",
        name->symbol);
    if (!has_movers) {
        fprintf(file, "    return lim_begin(memory, &%s_scene, %s_SCENE_METHOD, send, ctx);\n}\n", name->symbol,
                name->macro);
        return;
    }
    fprintf(file, "    const struct lim_movers_limits limits = %s_MOVERS_LIMITS;\n", name->macro);
    if (has_light) fprintf(file, "    const struct lim_light light = %s_LIGHT;\n", name->macro);
    fprintf(file,
            "    int err = lim_begin(memory, &%s_scene, %s_SCENE_METHOD, send, ctx);\n"
            "    if (!err) err = lim_movers_init(memory->lim, memory->movers, memory->movers_b, &limits);\n",
            name->symbol, name->macro);
    if (has_light) fputs("    if (!err) lim_light_set(memory->lim, &light);\n", file);
    fputs("    return err;\n}\n", file);
}

/* What is not exact says so. */
static const char *kind_of(const struct compiled *scene)
{
    if (scene->report.draws == LIM_MESH) return ", a mesh drawn by distance: an approximate order";
    if (scene->report.draws == LIM_MESH_DEPTH) return ", a mesh drawn by depths of 16 bits: an approximate order";
    if (scene->report.mesh_leaves) return ", some in mesh leaves by distance: an approximate order there";
    return scene->report.convex ? ", one convex solid" : "";
}

static void write_scene(FILE *file, const struct named_scene *named, const struct needs *needs,
                        const struct c_name *name)
{
    const struct compiled *scene = named->scene;
    const char *macro = name->macro;
    fprintf(file, "\n/* %s: %u polygons%s. unit = (metre - origin) * units per metre */\n", name->file,
            (unsigned)scene->scene.polygon_count, kind_of(scene));
    write_metres(file, scene, macro);
    write_memory(file, scene, needs, macro);
    write_lines(file, scene, macro);
    write_worst(file, &scene->report, scene->grid.is_long, macro);
    fprintf(file, "\nextern const struct lim_scene %s_scene LIM_AGREES(%s_scene);\n", name->symbol, name->symbol);
    if (named->moving) c_movers_declare(file, named, name);
    write_block(file, name, named->moving != NULL);
    write_begin(file, named, name);
}

typedef bool has_part(const struct named_scene *scene);

static bool is_any(const struct named_scene *scene)
{
    return scene->scene != NULL;
}

static bool moves(const struct named_scene *scene)
{
    return scene->moving != NULL;
}

static bool tells_changes(const struct named_scene *scene)
{
    return scene->scene->report.delta_runs > 0;
}

static bool has_tree(const struct named_scene *scene)
{
    return scene->scene->scene.node_count > 0;
}

static size_t count_of(const struct named_scene *scenes, size_t count, has_part *has)
{
    size_t having = 0;
    for (size_t i = 0; i < count; i++)
        having += has(&scenes[i]);
    return having;
}

/* NAME_`what`: the greatest of those scenes that have it, if there are any. */
static bool write_greatest(FILE *file, const struct named_scene *scenes, size_t count, const char *macro,
                           const char *what, has_part *has, struct error *err)
{
    const size_t left = count_of(scenes, count, has);
    if (!left) return true;
    fprintf(file, "#define %s_%s ", macro, what);
    for (size_t i = 1; i < left; i++)
        fprintf(file, "%s_LARGER(", macro);
    for (size_t i = 0, at = 0; i < count; i++) {
        struct c_name name;
        if (!c_name_init(&name, scenes[i].name, err)) return false;
        if (!has(&scenes[i])) continue;
        fprintf(file, "%s%s_%s%s", at ? ", " : "", name.macro, what, at ? ")" : "");
        at++;
    }
    fputs("\n", file);
    return true;
}

/* One after the other is shown in one block of memory. */
static bool write_shared_memory(FILE *file, const struct named_scene *scenes, size_t count, const struct c_name *header,
                                struct error *err)
{
    const char *macro = header->macro;
    fputs("\n/* Enough for any of the scenes. */\n", file);
    fprintf(file, "#define %s_LARGER(a, b) ((a) > (b) ? (a) : (b))\n", macro);
    if (!write_greatest(file, scenes, count, macro, "SCENE_MEM_B(h_px)", is_any, err) ||
        !write_greatest(file, scenes, count, macro, "SCENE_LINES(h_px)", is_any, err) ||
        !write_greatest(file, scenes, count, macro, "SCENE_DEPTH", has_tree, err) ||
        !write_greatest(file, scenes, count, macro, "SCENE_DELTA_MEM_B(w_px, h_px)", tells_changes, err) ||
        !write_greatest(file, scenes, count, macro, "MOVERS_MEM_B", moves, err))
        return false;
    write_block(file, header, count_of(scenes, count, moves) > 0);
    return true;
}

struct needs c_header_needs(const struct named_scene *scenes, size_t count)
{
    struct needs needs = needs_of(scenes[0].scene, scenes[0].moving);
    for (size_t i = 1; i < count; i++) {
        const struct needs more = needs_of(scenes[i].scene, scenes[i].moving);
        needs = needs_union(&needs, &more);
    }
    return needs;
}

static void write_configuration(FILE *file, const struct needs *needs, size_t count, const struct c_name *header)
{
    fprintf(file, "/* %s for Limner, written by `limner compile`.\n", count > 1 ? "Scenes" : "A scene");
    fprintf(file,
            " * Build the renderer with -DLIM_CONFIG='\"%s.h\"' to fit it to %s, or include this file in a "
            "limner_config.h\n"
            " * that the compiler finds: firmware/config.h. Files that include this one need no such flag. */\n",
            header->file, count > 1 ? "them" : "it");
    /* What the build has to say comes first. */
    fputs("#ifndef LIM_READS_CONFIG\n#define LIM_READS_SETTINGS\n#include \"config.h\"\n#undef "
          "LIM_READS_SETTINGS\n#endif\n\n",
          file);
    fprintf(file, "#ifndef %s_SCENE_NEEDS\n#define %s_SCENE_NEEDS\n\n", header->macro, header->macro);
    needs_write(needs, file);
    fputs("\n#endif\n", file);
}

/* All that is not configuration. limner.h may come back here, and does the declarations then. */
static void begin_declarations(FILE *file, const struct c_name *header)
{
    fprintf(file, "\n#ifndef LIM_READS_CONFIG\n#include \"limner.h\"\n\n#ifndef %s_SCENE_H\n#define %s_SCENE_H\n\n",
            header->macro, header->macro);
    fprintf(file,
            "LIM_STATIC_ASSERT(LIM_SCENE_FORMAT == %d, \"compile this scene again: it was written for another "
            "version\");\n",
            LIM_SCENE_FORMAT);
    fputs("\nLIM_C_BEGIN\n", file);
}

static void end_declarations(FILE *file)
{
    fputs("\nLIM_C_END\n\n#endif\n#endif\n", file);
}

static bool write_scenes(FILE *file, const struct named_scene *scenes, size_t count, const struct needs *needs,
                         const struct c_name *header, struct error *err)
{
    for (size_t i = 0; i < count; i++) {
        struct c_name name;
        if (!c_name_init(&name, scenes[i].name, err)) return false;
        write_scene(file, &scenes[i], needs, &name);
    }
    return count < 2 || write_shared_memory(file, scenes, count, header, err);
}

static bool write_configured(FILE *file, const struct named_scene *scenes, size_t count, const struct c_name *header,
                             struct error *err)
{
    const struct needs needs = c_header_needs(scenes, count);
    write_configuration(file, &needs, count, header);
    begin_declarations(file, header);
    const bool ok = write_scenes(file, scenes, count, &needs, header, err);
    end_declarations(file);
    return ok;
}

static bool write_declarations(FILE *file, const struct named_scene *scenes, size_t count, const struct c_name *header,
                               struct error *err)
{
    const struct needs needs = c_header_needs(scenes, count);
    fprintf(file, "/* %s for Limner, written by `limner export`. limner.h was written with it, and fits it. */\n",
            count > 1 ? "Scenes" : "A scene");
    fprintf(file, "#ifndef %s_SCENE_H\n#define %s_SCENE_H\n\n#include \"limner.h\"\n\nLIM_C_BEGIN\n", header->macro,
            header->macro);
    const bool ok = write_scenes(file, scenes, count, &needs, header, err);
    fputs("\nLIM_C_END\n\n#endif\n", file);
    return ok;
}

typedef bool header_writer(FILE *file, const struct named_scene *scenes, size_t count, const struct c_name *header,
                           struct error *err);

static bool put(header_writer *write, const struct named_scene *scenes, size_t count, const char *header,
                struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    struct c_name name;
    if (!c_path(path, header, ".h", err) || !c_name_init(&name, header, err)) return false;
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    const bool written = write(file, scenes, count, &name, err);
    return outputs_close(file, path, err) && written;
}

bool c_header_put(const struct named_scene *scenes, size_t count, const char *header, struct outputs *outputs,
                  struct error *err)
{
    return put(write_configured, scenes, count, header, outputs, err);
}

bool c_declarations_put(const struct named_scene *scenes, size_t count, const char *header, struct outputs *outputs,
                        struct error *err)
{
    return put(write_declarations, scenes, count, header, outputs, err);
}
