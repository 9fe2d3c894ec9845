/* SPDX-License-Identifier: MIT
 *
 * NAME.h: the needs of its scenes as configuration; of each scene its grid, its memory, its declaration, for C and for
 * C++. config.h reads the first part through LIM_CONFIG, before any type is known. Whoever includes NAME.h has the
 * configuration, the renderer and the declarations in this order. */
#include "base/c_name.h"
#include "scene/needs.h"
#include "scene/scene_files.h"

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
    else
        write_spans_memory(file, scene, &limits);
    if (scene->scene.place_count)
        fprintf(file, " + LIM_PORTALS_MEM_B(%u, %u)", (unsigned)scene->scene.box_count, (unsigned)limits.depth);
    fputs(")\n", file);
    if (scene->report.delta_runs)
        fprintf(file,
                "#define %s_SCENE_DELTA_MEM_B(w_px, h_px) LIM_DELTA_MEM_B(w_px, h_px, %u) /* for lim_set_delta() */\n",
                macro, (unsigned)scene->report.delta_runs);
}

/* What the target must be able to lend at any time. */
static void write_lines(FILE *file, const struct compiled *scene, const char *macro)
{
    const bool all = scene->report.draws == LIM_PAINTER || scene->report.framebuffer;

    fprintf(file, "#define %s_SCENE_LINES(h_px) %s\n", macro, all ? "(h_px)" : "1");
}

static void write_scene(FILE *file, const struct named_scene *named, const struct needs *needs,
                        const struct c_name *name)
{
    const struct compiled *scene = named->scene;
    const char *macro = name->macro;
    fprintf(file, "\n/* %s: %u polygons%s. unit = (metre - origin) * units per metre */\n", name->file,
            (unsigned)scene->scene.polygon_count, scene->report.convex ? ", one convex solid" : "");
    fprintf(file, "#define %s_UNITS_PER_M %.17g\n", macro, scene->grid.units_per_m);
    for (int i = 0; i < 3; i++)
        fprintf(file, "#define %s_ORIGIN_%c_M %.17g\n", macro, "XYZ"[i], scene -> grid.origin_m[i]);
    write_memory(file, scene, needs, macro);
    write_lines(file, scene, macro);
    fprintf(file, "\nextern const struct lim_scene %s_scene LIM_AGREES(%s_scene);\n", name->symbol, name->symbol);
    if (named->moving) c_movers_declare(file, named, name);
}

/* One after the other is shown in one block of memory: the greatest of all. */
static bool write_shared_memory(FILE *file, const struct named_scene *scenes, size_t count, const char *macro,
                                struct error *err)
{
    fputs("\n/* Enough for any of the scenes. */\n", file);
    fprintf(file, "#define %s_LARGER_B(a, b) ((a) > (b) ? (a) : (b))\n#define %s_SCENE_MEM_B(h_px) ", macro, macro);
    for (size_t i = 0; i + 1 < count; i++)
        fprintf(file, "%s_LARGER_B(", macro);
    for (size_t i = 0; i < count; i++) {
        struct c_name name;
        if (!c_name_init(&name, scenes[i].name, err)) return false;
        fprintf(file, "%s%s_SCENE_MEM_B(h_px)%s", i ? ", " : "", name.macro, i ? ")" : "");
    }
    fputs("\n", file);
    return true;
}

static struct needs needs_of_all(const struct named_scene *scenes, size_t count)
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
    fprintf(
        file,
        " * Build the renderer with -DLIM_CONFIG='\"%s.h\"' to fit it to %s. Files that include this one need no such\n"
        " * flag. */\n",
        header->file, count > 1 ? "them" : "it");
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

static bool write_header(FILE *file, const struct named_scene *scenes, size_t count, const char *header,
                         struct error *err)
{
    struct c_name name;
    const struct needs needs = needs_of_all(scenes, count);
    if (!c_name_init(&name, header, err)) return false;
    write_configuration(file, &needs, count, &name);
    begin_declarations(file, &name);
    for (size_t i = 0; i < count; i++) {
        struct c_name scene_name;
        if (!c_name_init(&scene_name, scenes[i].name, err)) return false;
        write_scene(file, &scenes[i], &needs, &scene_name);
    }
    if (count > 1 && !write_shared_memory(file, scenes, count, name.macro, err)) return false;
    end_declarations(file);
    return true;
}

bool c_header_put(const struct named_scene *scenes, size_t count, const char *header, struct outputs *outputs,
                  struct error *err)
{
    char path[C_PATH_MAX_B];
    struct c_name name;
    if (!c_path(path, header, ".h", err) || !c_name_init(&name, header, err)) return false;
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    bool written = write_header(file, scenes, count, header, err);
    return outputs_close(file, path, err) && written;
}
