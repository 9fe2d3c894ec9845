/* SPDX-License-Identifier: MIT
 *
 * What compiling made of a model, as a table. */
#include "base/printable.h"
#include "compiler/compile.h"
#include "compiler/leaf_report.h"
#include "core/core.h"
#include "scene/compiled.h"
#include "scene/mcu_mem.h"
#include "scene/mem_parts.h"
#include "scene/records.h"

#include <math.h>
#include <stdio.h>

static void print_count(const char *what, size_t count)
{
    printf("  %-28s %8zu\n", what, count);
}

/* What happened to the input, as far as it did. */
static void print_mended(const struct mesh_counts *mesh)
{
    const struct {
        const char *what;
        size_t count;
    } rows[] = {{"opacity beyond 0..1, clamped", mesh->clamped},
                {"invisible, dropped", mesh->invisible},
                {"no area, dropped", mesh->zero_area},
                {"too small for the grid", mesh->too_small},
                {"not planar, triangulated", mesh->non_planar},
                {"not convex, triangulated", mesh->concave},
                {"texture bent, triangulated", mesh->bent},
                {"no texture coordinates", mesh->unmapped[UNMAPPED_MISSING]},
                {"texture coordinates infinite", mesh->unmapped[UNMAPPED_INFINITE]},
                {"texture coordinates too far", mesh->unmapped[UNMAPPED_FAR]},
                {"texture too fine", mesh->unmapped[UNMAPPED_FINE]},
                {"merged into a neighbour", mesh->merged},
                {"T-vertices inserted", mesh->t_vertices}};
    print_count("faces in the model", mesh->faces);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (rows[i].count) print_count(rows[i].what, rows[i].count);
}

static void print_transparent(const struct compiled *scene)
{
    const size_t count = records_with(&scene->scene, LIM_POLYGON_ALPHA);
    if (!count) return;
    print_count("  of these transparent", count);
    print_count("  layers on a line, room for", scene->scene.limits.layers);
}

static void print_outlines(const struct compiled *scene)
{
    print_count("with edges that are not drawn", records_with(&scene->scene, LIM_POLYGON_EDGES));
}

static void print_choice(const struct compile_report *report)
{
    if (report->choice.kind == CHOICE_UNKNOWN)
        printf("    %-26s no cost is predicted where polygons are transparent\n", "chosen:");
    else if (report->choice.kind == CHOICE_LONG)
        printf("    %-26s others take long with so many polygons; --tree auto tries them\n", "chosen:");
    else if (report->choice.kind == CHOICE_NEEDLESS)
        printf("    %-26s it splits less than a quarter, and reaches %.1f polygons for one that is seen\n",
               "chosen:", report->reached_a_seen);
    else if (!report->choice.replaced)
        printf("    %-26s no other tree spares a tenth of its instructions\n", "chosen:");
    else
        printf("    %-26s %.1f %% of the smallest BSP tree's instructions, %.1f %% of its bytes\n",
               "chosen:", 100.0 * report->instructions / report->choice.bsp_instructions,
               100.0 * (double)report->flash_b / (double)report->choice.bsp_flash_b);
}

bool compile_report_has_cost(const struct compile_report *report)
{
    return !isnan(report->instructions) && report->core == &core_fast && !report->antialias && !report->wireframe;
}

/* What the choice of the order was made by. */
static void print_order(const struct compiled *scene)
{
    const struct compile_report *report = &scene->report;
    const struct order_choice *order = &report->order;

    if (!order->tried) return;
    if (report->draws != LIM_SCANLINE) {
        printf("  drawn nearest first: by scan lines more than %.0f instructions predicted\n", order->scanline_most);
        return;
    }
    printf("  drawn by scan lines: %.0f instead of %.0f instructions predicted\n", report->instructions,
           order->nearest_instructions);
    printf("    %zu instead of %zu bytes of working memory\n", mcu_mem_b(scene), order->nearest_mem_b);
}

static void print_trial(const char *what, const struct mesh_trial *trial)
{
    if (isnan(trial->instructions)) return;
    printf("    %-26s %8.0f instructions", what, trial->instructions);
    if (!isnan(trial->wrong_percent)) printf(", %.4f %% of pixels wrong", trial->wrong_percent);
    printf("%s\n", trial->taken ? ": taken" : "");
}

/* What the choice of a mesh was made by. */
static void print_mesh_choice(const struct compiled *scene)
{
    const struct mesh_choice *choice = &scene->report.as_mesh;
    if (!choice->tried) return;
    printf("  %s, predicted\n",
           lim_scene_is_mesh(&scene->scene) ? "drawn as a mesh instead of by a tree" : "not drawn as a mesh");
    printf("    %-26s %8.0f instructions", "by the tree", choice->tree_instructions);
    if (!isnan(choice->tree_wrong_percent)) printf(", %.4f %% of pixels wrong", choice->tree_wrong_percent);
    printf("\n");
    if (choice->vertices_instructions > choice->tree_instructions)
        printf("    %-26s %8.0f instructions for its vertices alone\n", "as a mesh", choice->vertices_instructions);
    print_trial("by distance", &choice->by_distance);
    print_trial("by depth", &choice->by_depth);
    if (choice->cameras)
        printf("    %-26s %8.4f %%, on %zu cameras that nothing was tuned on\n", "at most wrong", choice->bound_percent,
               choice->cameras);
    if (lim_scene_is_mesh(&scene->scene))
        printf("    %-26s %8zu bytes of flash and %zu of working memory\n", "the tree took", choice->tree_flash_b,
               choice->tree_mem_b);
}

/* Searched, not proved. */
static void print_worst(const struct compile_report *report)
{
    const struct worst_report *worst = &report->worst;
    if (!worst->tried) return;
    printf("  %-28s %8zu cameras searched, not proved\n", "worst view, of", worst->tried);
    if (compile_report_has_cost(report))
        printf("    %-26s %8.0f on Cortex-M0+, predicted\n", "instructions", worst->work);
    printf("    %-26s %8.2f times the mean, %.2f times the worst\n", "of random cameras",
           worst->work / worst->work_mean, worst->work / worst->work_random);
    printf("    camera:");
    for (int i = 0; i < 3; i++)
        printf(" %.15g", worst->eye_m[i]);
    for (int i = 0; i < 3; i++)
        printf(" %.15g", worst->target_m[i]);
    putchar('\n');
}

static void print_tree(const struct compiled *scene)
{
    static const char *const kinds[] = {"x = const", "y = const",     "z = const",
                                        "upright",   "16-bit normal", "32-bit normal"};
    const struct compile_report *report = &scene->report;
    print_count("polygons before splitting", report->polygons_in);
    if (report->tree != TREE_MESH) print_count("splits", report->splits);
    if (report->left_out) print_count("left out, too small", report->left_out);
    if (report->covered) print_count("covered by a later, coplanar", report->covered);
    if (report->unordered) print_count("too near to others to order", report->unordered);
    if (report->collapsed) print_count("pieces rounded to nothing", report->collapsed);
    print_count("polygons in the scene", report->polygons_out);
    print_transparent(scene);
    print_count("most vertices of a polygon", scene->scene.limits.vertices);
    printf("  %-28s %8s\n", "tree", tree_names[report->tree]);
    if (report->choice.kind) print_choice(report);
    if (report->tree == TREE_MESH) printf("    %-26s its order is approximate\n", method_name(report->draws));
    if (report->tree == TREE_MESH && report->draws == LIM_MESH_DEPTH) {
        print_count("  triangles with depth", report->deep);
        print_count("    near the eye", report->near_deep);
    }
    if (*report->splitter && report->tree != TREE_NONE) printf("  %-28s %8s\n", "splitter", report->splitter);
    if (report->tree != TREE_MESH) print_count("depth of the tree", report->depth);
    if (report->mono) printf("  %-28s %8s\n", "light and tones", "for black and white pixels");
    if (report->wireframe) print_outlines(scene);
    if (report->convex) printf("  %-28s %8s\n", "one convex solid", "yes");
    if (report->convex && report->draws != LIM_CONVEX)
        printf("    less code and memory, more instructions: --method convex\n");
    if (report->tree != TREE_MESH) print_count("nodes", scene->scene.node_count);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (report->kinds[i]) printf("    %-26s %8zu\n", kinds[i], report->kinds[i]);
    if (report->leaves && report->tree != TREE_NONE) print_count("  leaves with an order", report->leaves);
    if (report->mesh_leaves) print_count("  mesh leaves, by distance", report->mesh_leaves);
    printf("  %-28s %8.1f\n", "units per metre", scene->grid.units_per_m);
    if (scene->grid.is_long)
        printf("  %-28s %8s%s\n", "coordinates", "32 bits", scene->scene.fractions ? ", and 8 of fractions" : "");
    if (report->tree != TREE_MESH)
        printf("  %-28s %8.4f units\n", "worst wrong side, certified", report->worst_violation_units);
    if (report->core) printf("  %-28s %8s\n", "precision", report->core->name);
    printf("  %-28s %8s\n", "exact through lenses",
           report->tele ? "of any angle" : "of 14 degrees and more; of less: --fov");
    if (compile_report_has_cost(report))
        printf("  %-28s %8.0f on Cortex-M0+, predicted\n", "instructions a frame", report->instructions);
    if (report->path.count)
        printable_print(stdout, "  %-28s %8zu of %s: chosen for these\n", "cameras", report->path.count,
                        report->path.name);
    if (compile_report_has_cost(report)) print_order(scene);
    print_mesh_choice(scene);
    leaf_report_print(&report->leaf_parts, NULL);
    print_worst(report);
    if (!isnan(report->wrong.percent))
        printf("  %-28s %8.4f %%, %zu sampled cameras\n", "wrong pixels, predicted", report->wrong.percent,
               report->wrong.cameras);
    if (!isnan(report->wrong.percent) && report->wrong.near_cameras)
        printf("  %-28s %8.4f %%, %zu of them\n", "  near faces, small ones too", report->wrong.near_percent,
               report->wrong.near_cameras);
    if (!isnan(report->wrong.percent) && report->wrong.grazing_cameras)
        printf("  %-28s %8.4f %%, %zu cameras along faces\n", "wrong pixels, grazing views",
               report->wrong.grazing_percent, report->wrong.grazing_cameras);
}

static void print_notes(const struct compile_report *report)
{
    for (size_t i = 0; i < report->note_count; i++)
        printable_print(stdout, "  note: %s\n", report->notes[i].text);
}

/* Bytes against polygons: what the compiler decided by. */
static void print_portals(const struct portal_report *portals)
{
    if (portals->refused[0]) printable_print(stdout, "portals: %s\n", portals->refused);
    if (!portals->tried) return;
    printf("%-30s %8s\n", "portals",
           portals->kept        ? "kept"
           : portals->different ? "left out: pictures differ"
                                : "left out");
    print_count("rooms", portals->zones);
    if (portals->given_up) print_count("  that all is seen from", portals->given_up);
    print_count("different visible sets", portals->pvs);
    print_count("bytes", portals->bytes);
    printf("  %-28s %8.1f\n", "polygons a visible set shows", portals->mean_polygons);
    printf("  %-28s %8.1f, %zu sampled cameras\n", "polygons reached, without",
           (double)portals->polygons_before / (double)portals->cameras, portals->cameras);
    printf("  %-28s %8.1f\n", "polygons reached, with", (double)portals->polygons_after / (double)portals->cameras);
    printf("  %-28s %8.1f\n", "vertices, without", (double)portals->vertices_before / (double)portals->cameras);
    printf("  %-28s %8.1f\n", "vertices, with", (double)portals->vertices_after / (double)portals->cameras);
    if (isnan(portals->cost_before)) return;
    printf("  %-28s %8.0f, predicted\n", "instructions, without", portals->cost_before / (double)portals->cameras);
    printf("  %-28s %8.0f, %.1f %% less\n", "instructions, with", portals->cost_after / (double)portals->cameras,
           100.0 * (1.0 - portals->cost_after / portals->cost_before));
}

static void print_bytes(const char *what, size_t size_b, size_t polygons)
{
    printf("  %-28s %8zu %10.1f\n", what, size_b, (double)size_b / (double)polygons);
}

static void print_flash(const struct compiled *scene)
{
    struct mem_part parts[FLASH_PARTS_MAX];
    const bool is_mesh = lim_scene_is_mesh(&scene->scene);
    const size_t count = flash_parts(scene, parts);
    const size_t polygons = is_mesh ? scene->report.polygons_out : scene->report.polygons_in;
    printf("%-30s %8s %10s\n", "flash", "bytes", is_mesh ? "a triangle" : "a polygon");
    for (size_t i = 0; i < count; i++)
        print_bytes(parts[i].name, parts[i].size_b, polygons);
    print_bytes("in all", scene->report.flash_b, polygons);
    if (scene->scene.texture_count) print_bytes("  of these textures", texture_memory_b(&scene->scene), polygons);
}

size_t framebuffer_b(unsigned w_px, unsigned h_px)
{
    return (size_t)(w_px + 1) / 2 * 4 * h_px;
}

static void print_ram(const struct compiled *scene)
{
    printf("RAM at %ux%u pixels, %s\n", scene->report.w_px, scene->report.h_px, method_title(scene->report.draws));
    if (scene->report.framebuffer)
        print_count("framebuffer, bytes", framebuffer_b(scene->report.w_px, scene->report.h_px));
    print_count("working memory, bytes", mcu_mem_b(scene));
    if (scene->report.few_cameras)
        printf("    %-26s %8zu sampled cameras alone, as the depth sort takes long\n", "measured on",
               scene->report.few_cameras);
    print_count("least, bytes", mcu_mem_min_b(scene));
}

void compile_report_print(const struct compiled *scene, const char *name)
{
    printable_print(stdout, "%s\n", name);
    print_mended(&scene->report.mesh);
    print_notes(&scene->report);
    print_tree(scene);
    print_flash(scene);
    print_ram(scene);
    print_portals(&scene->report.portals);
}
