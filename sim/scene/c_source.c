/* SPDX-License-Identifier: MIT
 *
 * A scene as C: const arrays for flash in NAME.c. */
#include "base/c_name.h"
#include "colour.h"
#include "long.h"
#include "scene/records.h"
#include "scene/scene_files.h"

#include <stdio.h>

enum { NUMBERS_A_LINE = 16 };

static void begin_array(FILE *file, const struct c_name *prefix, const char *type, const char *name, unsigned count)
{
    fprintf(file, "\nstatic const LIM_FLASH %s %s_%s[%u] = {", type, prefix->symbol, name, count);
}

/* Objects may lead into it. */
static void begin_shared(FILE *file, const struct c_name *prefix, const char *type, const char *name, unsigned count,
                         bool is_shared)
{
    fprintf(file, "\n%sconst LIM_FLASH %s %s_%s[%u] = {", is_shared ? "" : "static ", type, prefix->symbol, name,
            count);
}

static void end_array(FILE *file)
{
    fputs("\n};\n", file);
}

/* NONE, and the macros that stand for numbers of a width, are what the firmware's width makes of them. */
static void write_index(FILE *file, lim_index index)
{
    if (index == LIM_NO_INDEX)
        fputs(", NONE", file);
    else
        fprintf(file, ", %lu", (unsigned long)index);
}

static void write_plane_index(FILE *file, const struct lim_scene *scene, lim_index plane)
{
    const lim_index size = lim_scene_long(scene) ? 1 : LIM_PLANE_WORDS;
    if (plane == LIM_NO_INDEX)
        fputs("NONE, ", file);
    else if (plane >= LIM_PLANE_X)
        fprintf(file, "LIM_PLANE_%c, ", "XYZ"[plane - LIM_PLANE_X]);
    else
        fprintf(file, "AT(%lu), ", (unsigned long)(plane / size));
}

/* Of a long scene an index, which may take the sign's bit where indices have 16. */
static void write_offset(FILE *file, lim_offset offset)
{
    if (offset > INT16_MAX)
        fprintf(file, "(lim_offset)%luu", (unsigned long)offset);
    else
        fprintf(file, "%ld", (long)offset);
}

static void write_vertices(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_vertex", "vertices", scene->vertex_count);
    for (size_t i = 0; i < scene->vertex_count; i++) {
        const struct lim_vertex *vertex = &scene->vertices[i];
        fprintf(file, "%s{%d, %d, %d},", i % 4 ? " " : "\n    ", vertex->x, vertex->y, vertex->z);
    }
    end_array(file);
}

static void write_long_mappings(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_long_mapping", "long_mappings", scene->mapping_count);
    for (size_t i = 0; i < scene->mapping_count; i++) {
        const struct lim_long_mapping *m = &lim_scene_long(scene)->mappings[i];
        fprintf(file, "\n    {{{%ld, %ld}, {%ld, %ld}}, %d, %u, 0},", (long)m->uv[0][0], (long)m->uv[0][1],
                (long)m->uv[1][0], (long)m->uv[1][1], m->level_q4, m->bits);
    }
    end_array(file);
}

/* Of a long scene in the place of vertices, planes and boxes, and beside mappings. */
static void write_long(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    const struct lim_long *all = lim_scene_long(scene);
    begin_array(file, prefix, "struct lim_long_vertex", "vertices", scene->vertex_count);
    for (size_t i = 0; i < scene->vertex_count; i++)
        fprintf(file, "%s{{%ld, %ld, %ld}},", i % 2 ? " " : "\n    ", (long)all->vertices[i].at[0],
                (long)all->vertices[i].at[1], (long)all->vertices[i].at[2]);
    end_array(file);
    if (scene->plane_count) begin_array(file, prefix, "struct lim_long_plane", "planes", scene->plane_count);
    for (size_t i = 0; i < scene->plane_count; i++) {
        const struct lim_long_plane *plane = &all->planes[i];
        fprintf(file, "\n    {{%ld, %ld, %ld}, %ld, %lu},", (long)plane->n[0], (long)plane->n[1], (long)plane->n[2],
                (long)plane->rest, (unsigned long)plane->vertex);
    }
    if (scene->plane_count) end_array(file);
    if (scene->box_count) begin_array(file, prefix, "struct lim_long_box", "boxes", scene->box_count);
    for (size_t i = 0; i < scene->box_count; i++) {
        const struct lim_long_box *box = &all->boxes[i];
        fprintf(file, "\n    {{%ld, %ld, %ld}, {%luu, %luu, %luu}},", (long)box->centre[0], (long)box->centre[1],
                (long)box->centre[2], (unsigned long)box->half[0], (unsigned long)box->half[1],
                (unsigned long)box->half[2]);
    }
    if (scene->box_count) end_array(file);
    if (scene->mapping_count) write_long_mappings(file, scene, prefix);
    fprintf(file, "\nstatic const struct lim_long %s_of_32_bits = {", prefix->symbol);
    fprintf(file, "%s_vertices, ", prefix->symbol);
    fprintf(file, scene->plane_count ? "%s_planes, " : "NULL, ", prefix->symbol);
    fprintf(file, scene->box_count ? "%s_boxes, " : "NULL, ", prefix->symbol);
    fprintf(file, scene->fractions ? "%s_fractions, " : "NULL, ", prefix->symbol);
    fprintf(file, scene->mapping_count ? "%s_long_mappings};\n" : "NULL};\n", prefix->symbol);
}

static void write_fractions(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_fraction", "fractions", scene->vertex_count);
    for (size_t i = 0; i < scene->vertex_count; i++) {
        const struct lim_fraction *fraction = &scene->fractions[i];
        fprintf(file, "%s{%d, %d, %d},", i % 4 ? " " : "\n    ", fraction->x_q8, fraction->y_q8, fraction->z_q8);
    }
    end_array(file);
}

static void write_nodes(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_node", "nodes", scene->node_count);
    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        fprintf(file, "%s{{", i % 2 ? " " : "\n    ");
        write_plane_index(file, scene, node->split.plane);
        write_offset(file, node->split.offset);
        fputs("}", file);
        write_index(file, node->front);
        write_index(file, node->back);
        write_index(file, node->front_run);
        write_index(file, node->back_run);
        write_index(file, node->box);
        fputs("},", file);
    }
    end_array(file);
}

static void write_planes(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_plane", "planes", scene->plane_count);
    for (size_t i = 0; i < scene->plane_count; i++) {
        const struct lim_plane *plane = &scene->planes[i];
        fprintf(file, "%sLIM_PLANE(%d, %d, %d", i % 2 ? " " : "\n    ", lim_plane_x(plane), lim_plane_y(plane),
                lim_plane_z(plane));
        write_index(file, lim_plane_exact(plane));
        fprintf(file, ", %ld),", (long)lim_plane_d(plane));
    }
    end_array(file);
}

static void write_exact(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_plane_exact", "exact", scene->exact_count);
    for (size_t i = 0; i < scene->exact_count; i++) {
        const struct lim_plane_exact *exact = &scene->exact[i];
        fprintf(file, "\n    {{%ld, %ld, %ld}, %ld, %luu},", (long)exact->n[0], (long)exact->n[1], (long)exact->n[2],
                (long)exact->d_hi, (unsigned long)exact->d_lo);
    }
    end_array(file);
}

static void write_boxes(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_box", "boxes", scene->box_count);
    for (size_t i = 0; i < scene->box_count; i++) {
        const struct lim_box *box = &scene->boxes[i];
        fprintf(file, "%s{{%d, %d, %d}, {%u, %u, %u}},", i % 2 ? " " : "\n    ", box->centre[0], box->centre[1],
                box->centre[2], (unsigned)box->half[0], (unsigned)box->half[1], (unsigned)box->half[2]);
    }
    end_array(file);
}

static void write_places(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_place", "places", scene->place_count);
    for (size_t i = 0; i < scene->place_count; i++)
        fprintf(file, "%s{%u, %u},", i % 8 ? " " : "\n    ", (unsigned)scene->places[i].cell,
                (unsigned)scene->places[i].pvs);
    end_array(file);
    begin_array(file, prefix, "uint8_t", "pvs", scene->pvs_bytes);
    for (size_t i = 0; i < scene->pvs_bytes; i++)
        fprintf(file, "%s%u,", i % NUMBERS_A_LINE ? " " : "\n    ", (unsigned)scene->pvs[i]);
    end_array(file);
}

/* In a leaf a record names its plane. */
static void write_record(FILE *file, const struct lim_scene *scene, const lim_index *record)
{
    const size_t plane_at =
        record[0] & LIM_POLYGON_PLANE ? LIM_POLYGON_HEAD_WORDS + (record[0] & LIM_POLYGON_COUNT) : 0;
    fputs("\n   ", file);
    for (size_t i = 0; i < lim_record_words(record[0]); i++) {
        fputc(' ', file);
        if (i && i == plane_at) {
            write_plane_index(file, scene, record[i++]);
            fprintf(file, "(lim_index)%ld,", (long)(lim_offset)record[i]);
        } else
            fprintf(file, "%lu,", (unsigned long)record[i]);
    }
}

static void write_triangle(FILE *file, const lim_index *words, bool begins_line)
{
    fputs(begins_line ? "\n   " : "", file);
    for (size_t i = 0; i < LIM_TRIANGLE_WORDS; i++)
        fprintf(file, " %lu,", (unsigned long)words[i]);
}

static void write_polygons(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "lim_index", "polygons", scene->polygon_words);
    for (size_t i = 0; i < scene->polygon_words; i += record_at(scene, i).words)
        if (lim_scene_is_mesh(scene))
            write_triangle(file, &scene->polygons[i], i % NUMBERS_A_LINE == 0);
        else
            write_record(file, scene, &scene->polygons[i]);
    end_array(file);
}

static void write_mappings(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_mapping", "mappings", scene->mapping_count);
    for (size_t i = 0; i < scene->mapping_count; i++) {
        const struct lim_mapping *m = &scene->mappings[i];
        fprintf(file, "%sLIM_MAPPING(%d, %d, %d, %d, %u, %u, ", i % 2 ? " " : "\n    ", m->uv[0][0], m->uv[0][1],
                m->uv[1][0], m->uv[1][1], (unsigned)m->at_zero_q16[0], (unsigned)m->at_zero_q16[1]);
        if (m->scale & LIM_MAPPING_UPRIGHT)
            fprintf(file, "(lim_index)(%d), ", (int)(lim_offset)m->plane);
        else
            write_plane_index(file, scene, m->plane);
        fprintf(file, "%d, %u, %u),", m->level_q3, m->scale, m->texture);
    }
    end_array(file);
}

static void write_uvs(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    begin_array(file, prefix, "struct lim_uv", "uvs", scene->vertex_count);
    for (size_t i = 0; i < scene->vertex_count; i++)
        fprintf(file, "%s{%d, %d},", i % 8 ? " " : "\n    ", (*scene->uvs)[i].u, (*scene->uvs)[i].v);
    end_array(file);
}

static void write_looks(FILE *file, const struct lim_scene *scene, const struct c_name *prefix, bool is_shared)
{
    begin_shared(file, prefix, "struct lim_texture", "textures", scene->texture_count, is_shared);
    for (size_t i = 0; i < scene->texture_count; i++) {
        const struct lim_texture *texture = &scene->textures[i];
        fprintf(file, "%s{%u, %u, %u, %u, %u, %u},", i % 4 ? " " : "\n    ", (unsigned)texture->texels,
                (unsigned)texture->palette, texture->w_bits, texture->h_bits, texture->levels, texture->place_bits);
    }
    end_array(file);
}

/* Numbers, which the macro turns into what memory holds. */
static void write_palettes(FILE *file, const struct lim_scene *scene, const struct c_name *prefix, bool is_shared)
{
    begin_shared(file, prefix, "uint16_t", "palettes", scene->palette_colours, is_shared);
    for (size_t i = 0; i < scene->palette_colours; i++)
        fprintf(file, "%sLIM_MEMORY_COLOUR(%u),", i % 4 ? " " : "\n    ", lim_memory_colour(scene->palettes[i]));
    end_array(file);
}

static void write_texels(FILE *file, const struct lim_scene *scene, const struct c_name *prefix, bool is_shared)
{
    const unsigned count = scene->texel_blocks * (unsigned)LIM_TEXEL_BLOCK;
    begin_shared(file, prefix, "uint8_t", "texels", count, is_shared);
    for (size_t i = 0; i < count; i++)
        fprintf(file, "%s%u,", i % NUMBERS_A_LINE ? " " : "\n    ", scene->texels[i]);
    end_array(file);
}

/* An object's are in the file of the scene that it moves in. */
static void write_textures(FILE *file, const struct named_scene *named, const struct c_name *prefix)
{
    const struct lim_scene *scene = &named->scene->scene;
    const bool is_shared = c_movers_share_textures(named);
    if (scene->mapping_count) write_mappings(file, scene, prefix);
    if (*scene->uvs) write_uvs(file, scene, prefix);
    if (named->textures_of) return;
    write_looks(file, scene, prefix, is_shared);
    write_palettes(file, scene, prefix, is_shared);
    write_texels(file, scene, prefix, is_shared);
}

/* C has no arrays of no elements: what is empty is left out, here and where it is written. */
static void write_pointer(FILE *file, const struct c_name *prefix, const char *field, unsigned count)
{
    if (count) fprintf(file, "    .%s = %s_%s,\n", field, prefix->symbol, field);
}

static void write_texture_fields(FILE *file, const struct lim_scene *scene, const struct c_name *prefix,
                                 const struct c_name *textures)
{
    if (!scene->texture_count) return;
    write_pointer(file, prefix, "mappings", scene->mapping_count);
    if (*scene->uvs) fprintf(file, "    .uvs = {%s_uvs},\n", prefix->symbol);
    write_pointer(file, textures, "textures", scene->texture_count);
    write_pointer(file, textures, "palettes", scene->palette_colours);
    write_pointer(file, textures, "texels", scene->texel_blocks);
    fprintf(file,
            "    .mapping_count = %u,\n    .texture_count = %u,\n    .palette_colours = %u,\n    .texel_blocks = %u,\n",
            (unsigned)scene->mapping_count, (unsigned)scene->texture_count, (unsigned)scene->palette_colours,
            (unsigned)scene->texel_blocks);
}

/* A build may do without. */
static void write_portals(FILE *file, const struct lim_scene *scene, const struct c_name *prefix)
{
    fputs("#if LIM_HAS_PORTALS\n", file);
    write_pointer(file, prefix, "places", scene->place_count);
    write_pointer(file, prefix, "pvs", scene->pvs_bytes);
    fprintf(file, "    .place_count = %u,\n    .pvs_bytes = %u,\n#endif\n", (unsigned)scene->place_count,
            (unsigned)scene->pvs_bytes);
}

static void write_scene(FILE *file, const struct lim_scene *scene, const struct c_name *prefix,
                        const struct c_name *textures)
{
    const struct lim_limits *limits = &scene->limits;
    fprintf(file, "\nconst struct lim_scene %s_scene = {\n", prefix->symbol);
    const bool is_long = lim_scene_long(scene) != NULL;
    if (is_long) fprintf(file, "    .of_32_bits = {&%s_of_32_bits},\n", prefix->symbol);
    write_pointer(file, prefix, "vertices", is_long ? 0 : scene->vertex_count);
    write_pointer(file, prefix, "nodes", scene->node_count);
    write_pointer(file, prefix, "planes", is_long ? 0 : scene->plane_count);
    write_pointer(file, prefix, "exact", scene->exact_count);
    write_pointer(file, prefix, "boxes", is_long ? 0 : scene->box_count);
    write_pointer(file, prefix, "polygons", scene->polygon_words);
    write_pointer(file, prefix, "fractions", scene->fractions ? scene->vertex_count : 0);
    if (scene->place_count) write_portals(file, scene, prefix);
    if (lim_scene_is_mesh(scene))
        fprintf(file, "#if LIM_HAS_MESH_DEPTH\n    .deep_from = {%lu},\n    .near_deep_from = {%lu},\n#endif\n",
                (unsigned long)*scene->deep_from, (unsigned long)*scene->near_deep_from);
    fprintf(file, "    .vertex_count = %u,\n    .node_count = %u,\n    .plane_count = %u,\n    .exact_count = %u,\n",
            (unsigned)scene->vertex_count, (unsigned)scene->node_count, (unsigned)scene->plane_count,
            (unsigned)scene->exact_count);
    fprintf(file, "    .box_count = %u,\n    .polygon_words = %u,\n    .polygon_count = %u,\n    .background = %u,\n",
            (unsigned)scene->box_count, (unsigned)scene->polygon_words, (unsigned)scene->polygon_count,
            (unsigned)scene->background);
    write_texture_fields(file, scene, prefix, textures);
    fprintf(file,
            "    .limits = {.depth = %u, .vertices = %u, .retained_cells = %u, .gaps = %u, .active = %u,\n"
            "               .pieces = %u, .layers = %u, .leaf_vertices = %u, .leaf_polygons = %u},\n};\n",
            (unsigned)limits->depth, (unsigned)limits->vertices, (unsigned)limits->retained_cells,
            (unsigned)limits->gaps, (unsigned)limits->active, (unsigned)limits->pieces, (unsigned)limits->layers,
            (unsigned)limits->leaf_vertices, (unsigned)limits->leaf_polygons);
}

static void write_source(FILE *file, const struct named_scene *named, const struct c_name *prefix,
                         const struct c_name *textures, const struct c_name *header)
{
    const struct lim_scene *arrays = &named->scene->scene;
    fprintf(file, "/* The arrays of %s, declared in %s.h; written by `limner compile`. */\n", prefix->file,
            header->file);
    fprintf(file, "#include \"%s.h\"\n\n", header->file);
    fprintf(
        file,
        "_Static_assert(LIM_SCENE_FORMAT == %d, \"compile this scene again: it was written for another version\");\n",
        LIM_SCENE_FORMAT);
    const bool is_long = lim_scene_long(arrays) != NULL;
    fputs("#define NONE LIM_NO_INDEX\n", file);
    fputs(is_long ? "#define AT(plane) (plane)\n" : "#define AT(plane) ((plane)*LIM_PLANE_WORDS)\n", file);
    if (arrays->fractions) write_fractions(file, arrays, prefix);
    if (is_long)
        write_long(file, arrays, prefix);
    else
        write_vertices(file, arrays, prefix);
    if (arrays->node_count) write_nodes(file, arrays, prefix);
    if (arrays->plane_count && !is_long) write_planes(file, arrays, prefix);
    if (arrays->exact_count) write_exact(file, arrays, prefix);
    if (arrays->box_count && !is_long) write_boxes(file, arrays, prefix);
    write_polygons(file, arrays, prefix);
    if (arrays->texture_count) write_textures(file, named, prefix);
    if (arrays->place_count) {
        fputs("\n#if LIM_HAS_PORTALS", file);
        write_places(file, arrays, prefix);
        fputs("#endif\n", file);
    }
    write_scene(file, arrays, prefix, textures);
}

/* Files -------------------------------------------------------------------------------------- */

bool c_source_put(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    struct c_name name, textures, header_name;
    if (!c_path(path, scene->name, ".c", err) || !c_name_init(&name, scene->name, err) ||
        !c_name_init(&textures, scene->textures_of ? scene->textures_of : scene->name, err) ||
        !c_name_init(&header_name, header, err))
        return false;
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    write_source(file, scene, &name, &textures, &header_name);
    return outputs_close(file, path, err);
}

bool c_source_write(const struct compiled *scene, const char *name, struct error *err)
{
    const struct named_scene named = {scene, name, scene->moving, NULL};
    struct outputs outputs = {0};
    bool ok = c_header_put(&named, 1, name, &outputs, err) && c_source_put(&named, name, &outputs, err) &&
              (!named.moving || c_movers_put(&named, name, &outputs, err));
    return scene_files_finish(&outputs, ok, err);
}

bool scene_files_finish(struct outputs *outputs, bool ok, struct error *err)
{
    if (ok) return outputs_keep(outputs, err);
    outputs_discard(outputs);
    return false;
}
