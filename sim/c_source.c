/* SPDX-License-Identifier: MIT
 *
 * A scene as C: const arrays for flash in NAME.c; in NAME.h its limits as configuration (config.h
 * includes that file through LIM_CONFIG, before any type is known), its grid, its declaration. */
#include "scene_files.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { NAME_MAX_B = 64, PATH_MAX_B = 1024, NUMBERS_A_LINE = 16 };

/* What prefixes the symbols and the macros of a scene. */
struct prefix {
    const char *file;        /* last part of the path */
    char symbol[NAME_MAX_B]; /* "hall" */
    char macro[NAME_MAX_B];  /* "HALL" */
};

/* The name of the file with every other character turned into '_', and a letter in front. */
static bool prefix_init(struct prefix *prefix, const char *name, struct error *err)
{
    const char *slash = strrchr(name, '/');
    prefix->file = slash ? slash + 1 : name;
    size_t length = strlen(prefix->file);
    if (length == 0) return error_set(err, "-o '%s': names a folder, not a scene", name);
    bool has_letter = isalpha((unsigned char)prefix->file[0]) != 0;
    int printed = snprintf(prefix->symbol, NAME_MAX_B, "%s%s", has_letter ? "" : "scene_", prefix->file);
    if (printed >= NAME_MAX_B) return error_set(err, "-o '%s': the name is too long for C symbols", name);
    for (size_t i = 0; i <= strlen(prefix->symbol); i++) {
        unsigned char letter = (unsigned char)prefix->symbol[i];
        if (letter && (letter > 0x7F || !isalnum(letter))) prefix->symbol[i] = '_';
        prefix->macro[i] = (char)toupper((unsigned char)prefix->symbol[i]);
    }
    return true;
}

/* NAME.h ------------------------------------------------------------------------------------- */

static void write_header(FILE *file, const struct compiled *scene, const struct prefix *prefix)
{
    const char *macro = prefix->macro;
    fprintf(file, "/* A scene for Limner, written by `limner compile`: %u polygons, %.6g units per metre.\n",
            (unsigned)scene->scene.polygon_count, scene->grid.units_per_m);
    fprintf(file, " * Build with -DLIM_CONFIG='\"%s.h\"' to fit the renderer to this scene. */\n", prefix->file);
    fprintf(file, "#ifndef %s_SCENE_H\n#define %s_SCENE_H\n\n", macro, macro);
    fprintf(file, "#ifndef LIM_MAX_VERTICES\n#define LIM_MAX_VERTICES %u\n#endif\n\n",
            (unsigned)scene->scene.limits.vertices);
    const unsigned side_px = scene->report.w_px > scene->report.h_px ? scene->report.w_px : scene->report.h_px;
    if (side_px)
        fprintf(file,
                "/* The longest side of the panel that the memory below is for. */\n"
                "#ifndef LIM_MAX_SIDE_PX\n#define LIM_MAX_SIDE_PX %u\n#endif\n\n",
                side_px < 8 ? 8 : side_px);
    if (scene->report.core)
        fprintf(file, "#ifndef LIM_PROFILE\n#define LIM_PROFILE LIM_PROFILE_%s\n#endif\n\n",
                scene->report.core == &core_fine ? "FINE" : "FAST");
    fprintf(file, "/* unit = (metre - origin) * units per metre */\n");
    fprintf(file, "#define %s_UNITS_PER_M %.17g\n", macro, scene->grid.units_per_m);
    for (int i = 0; i < 3; i++)
        fprintf(file, "#define %s_ORIGIN_%c_M %.17g\n", macro, "XYZ"[i], scene -> grid.origin_m[i]);
    const struct lim_limits *limits = &scene->scene.limits;
    fprintf(file, "\n/* Bytes for lim_init() on a target of h_px lines; limner.h has the rest of the expression. */\n");
    fprintf(file, "#define %s_SCENE_MEM_B(h_px) LIM_MEM_B(h_px, %u, %u, %u, %u)\n", macro, (unsigned)limits->depth,
            (unsigned)limits->retained_cells, (unsigned)limits->gaps, (unsigned)limits->active);
    fprintf(file, "\nstruct lim_scene;\nextern const struct lim_scene %s_scene;\n\n#endif\n", prefix->symbol);
}

/* NAME.c ------------------------------------------------------------------------------------- */

static void begin_array(FILE *file, const struct prefix *prefix, const char *type, const char *name, unsigned count)
{
    fprintf(file, "\nstatic const LIM_FLASH %s %s_%s[%u] = {", type, prefix->symbol, name, count);
}

static void end_array(FILE *file)
{
    fputs("\n};\n", file);
}

static void write_vertices(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    begin_array(file, prefix, "struct lim_vertex", "vertices", scene->vertex_count);
    for (size_t i = 0; i < scene->vertex_count; i++) {
        const struct lim_vertex *vertex = &scene->vertices[i];
        fprintf(file, "%s{%d, %d, %d},", i % 4 ? " " : "\n    ", vertex->x, vertex->y, vertex->z);
    }
    end_array(file);
}

static void write_nodes(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    begin_array(file, prefix, "struct lim_node", "nodes", scene->node_count);
    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        fprintf(file, "%s{%u, %u, %u, %u, %u, %u, %u},", i % 2 ? " " : "\n    ", (unsigned)node->kind,
                (unsigned)node->plane, (unsigned)node->front, (unsigned)node->back, (unsigned)node->front_run,
                (unsigned)node->back_run, (unsigned)node->box);
    }
    end_array(file);
}

static void write_planes(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    begin_array(file, prefix, "struct lim_plane", "planes", scene->plane_count);
    for (size_t i = 0; i < scene->plane_count; i++) {
        const struct lim_plane *plane = &scene->planes[i];
        fprintf(file, "%s{{%d, %d, %d}, %u, %ld},", i % 2 ? " " : "\n    ", plane->n[0], plane->n[1], plane->n[2],
                (unsigned)plane->exact, (long)plane->d);
    }
    end_array(file);
}

static void write_exact(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    begin_array(file, prefix, "struct lim_plane_exact", "exact", scene->exact_count);
    for (size_t i = 0; i < scene->exact_count; i++) {
        const struct lim_plane_exact *exact = &scene->exact[i];
        fprintf(file, "\n    {{%ld, %ld, %ld}, %ld, %luu},", (long)exact->n[0], (long)exact->n[1], (long)exact->n[2],
                (long)exact->d_hi, (unsigned long)exact->d_lo);
    }
    end_array(file);
}

static void write_boxes(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    begin_array(file, prefix, "struct lim_box", "boxes", scene->box_count);
    for (size_t i = 0; i < scene->box_count; i++) {
        const struct lim_box *box = &scene->boxes[i];
        fprintf(file, "%s{{%d, %d, %d}, {%u, %u, %u}},", i % 2 ? " " : "\n    ", box->centre[0], box->centre[1],
                box->centre[2], (unsigned)box->half[0], (unsigned)box->half[1], (unsigned)box->half[2]);
    }
    end_array(file);
}

static void write_polygons(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    begin_array(file, prefix, "uint16_t", "polygons", scene->polygon_words);
    for (size_t i = 0; i < scene->polygon_words; i++)
        fprintf(file, "%s%u,", i % NUMBERS_A_LINE ? " " : "\n    ", (unsigned)scene->polygons[i]);
    end_array(file);
}

/* C has no arrays of no elements: what is empty is left out, here and where it is written. */
static void write_pointer(FILE *file, const struct prefix *prefix, const char *field, unsigned count)
{
    if (count) fprintf(file, "    .%s = %s_%s,\n", field, prefix->symbol, field);
}

static void write_scene(FILE *file, const struct lim_scene *scene, const struct prefix *prefix)
{
    const struct lim_limits *limits = &scene->limits;
    fprintf(file, "\nconst struct lim_scene %s_scene = {\n", prefix->symbol);
    write_pointer(file, prefix, "vertices", scene->vertex_count);
    write_pointer(file, prefix, "nodes", scene->node_count);
    write_pointer(file, prefix, "planes", scene->plane_count);
    write_pointer(file, prefix, "exact", scene->exact_count);
    write_pointer(file, prefix, "boxes", scene->box_count);
    write_pointer(file, prefix, "polygons", scene->polygon_words);
    fprintf(file, "    .vertex_count = %u,\n    .node_count = %u,\n    .plane_count = %u,\n    .exact_count = %u,\n",
            (unsigned)scene->vertex_count, (unsigned)scene->node_count, (unsigned)scene->plane_count,
            (unsigned)scene->exact_count);
    fprintf(file, "    .box_count = %u,\n    .polygon_words = %u,\n    .polygon_count = %u,\n    .background = %u,\n",
            (unsigned)scene->box_count, (unsigned)scene->polygon_words, (unsigned)scene->polygon_count,
            (unsigned)scene->background);
    fprintf(file, "    .limits = {.depth = %u, .vertices = %u, .retained_cells = %u, .gaps = %u, .active = %u},\n};\n",
            (unsigned)limits->depth, (unsigned)limits->vertices, (unsigned)limits->retained_cells,
            (unsigned)limits->gaps, (unsigned)limits->active);
}

static void write_source(FILE *file, const struct compiled *scene, const struct prefix *prefix)
{
    const struct lim_scene *arrays = &scene->scene;
    fprintf(file, "/* The arrays of %s.h, written by `limner compile`. */\n", prefix->file);
    fprintf(file, "#include \"scene.h\"\n\n#include \"%s.h\"\n\n", prefix->file);
    fprintf(file, "_Static_assert(LIM_SCENE_VERSION == %d, \"compile this scene again\");\n", LIM_SCENE_VERSION);
    write_vertices(file, arrays, prefix);
    write_nodes(file, arrays, prefix);
    if (arrays->plane_count) write_planes(file, arrays, prefix);
    if (arrays->exact_count) write_exact(file, arrays, prefix);
    if (arrays->box_count) write_boxes(file, arrays, prefix);
    write_polygons(file, arrays, prefix);
    write_scene(file, arrays, prefix);
}

/* Files -------------------------------------------------------------------------------------- */

static bool put_file(const struct compiled *scene, const char *name, const char *suffix, struct outputs *outputs,
                     void (*write)(FILE *, const struct compiled *, const struct prefix *), struct error *err)
{
    struct prefix prefix;
    char path[PATH_MAX_B];
    if (snprintf(path, sizeof path, "%s%s", name, suffix) >= (int)sizeof path)
        return error_set(err, "-o '%.64s...': the path is too long", name);
    if (!prefix_init(&prefix, name, err)) return false;
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    write(file, scene, &prefix);
    return outputs_close(file, path, err);
}

bool c_source_put(const struct compiled *scene, const char *name, struct outputs *outputs, struct error *err)
{
    return put_file(scene, name, ".h", outputs, write_header, err) &&
           put_file(scene, name, ".c", outputs, write_source, err);
}

bool c_source_write(const struct compiled *scene, const char *name, struct error *err)
{
    struct outputs outputs = {0};
    return scene_files_finish(&outputs, c_source_put(scene, name, &outputs, err), err);
}

bool scene_files_finish(struct outputs *outputs, bool ok, struct error *err)
{
    if (ok) return outputs_keep(outputs, err);
    outputs_discard(outputs);
    return false;
}
