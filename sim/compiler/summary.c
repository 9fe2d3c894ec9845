/* SPDX-License-Identifier: MIT
 *
 * What compiling made of a model, in the few lines that everybody wants; report.c has the rest. */
#include "base/notice.h"
#include "base/printable.h"
#include "compiler/compile.h"
#include "compiler/moving_compile.h"
#include "core/core.h"
#include "model/mapping.h"
#include "scene/mcu_mem.h"
#include "scene/moving.h"

#include <math.h>
#include <stdio.h>

static const char *profile_name(const struct compile_report *report)
{
    return report->core ? report->core->name : core_fast.name;
}

static void print_model(const struct compile_report *report, const struct moving *moving)
{
    printf("  %-14s %zu faces, drawn as %zu polygons", "model", report->mesh.faces, report->polygons_out);
    if (moving->count) printf("; %zu object%s", moving->count, moving->count == 1 ? " moves" : "s move");
    putchar('\n');
}

static void print_drawn(const struct compile_report *report)
{
    static const char *const trees[] = {[TREE_BSP] = ", by a BSP tree",
                                        [TREE_CLUSTERS] = ", by a tree of clusters",
                                        [TREE_AXIS] = ", by a tree of axial planes",
                                        [TREE_OCTREE] = ", by an octree",
                                        [TREE_NONE] = "",
                                        [TREE_MESH] = ""};
    const bool draws_by_tree = report->draws == LIM_NEAREST_FIRST || report->draws == LIM_PAINTER;
    printf("  %-14s %s%s; precision %s\n", "drawn", method_title(report->draws),
           draws_by_tree ? trees[report->tree] : "", profile_name(report));
}

static void print_memory(const struct compiled *scene, const struct moving *moving)
{
    const struct compile_report *report = &scene->report;
    const size_t moved_b = moving->count ? moving_flash_b(moving) : 0;
    const size_t frame_b = report->framebuffer ? framebuffer_b(report->w_px, report->h_px) : 0;
    const size_t beside_b = frame_b + (moving->count ? mcu_movers_mem_b(scene, moving) : 0);
    printf("  %-14s %zu bytes of data; the renderer's code comes on top\n", "flash", report->flash_b + moved_b);
    printf("  %-14s %zu bytes to work in at %ux%u pixels; %zu at least, for slower frames\n", "RAM",
           mcu_mem_b(scene) + beside_b, report->w_px, report->h_px, mcu_mem_min_b(scene) + beside_b);
}

static void print_predictions(const struct compile_report *report)
{
    if (isnan(report->wrong.percent))
        printf("  %-14s not predicted here; limner measure counts them\n", "wrong pixels");
    else
        printf("  %-14s %.4f %%, predicted\n", "wrong pixels", report->wrong.percent);
    if (compile_report_has_cost(report))
        printf("  %-14s %.0f a frame on Cortex-M0+, predicted\n", "instructions", report->instructions);
    else
        printf("  %-14s not predicted for such frames; limner measure counts them\n", "instructions");
}

/* Of more wrong pixels than the profile promises a notice tells. */
static void print_reservation(const struct compile_report *report)
{
    if (!method_is_exact(report->draws))
        printf("  %-14s the order of faces is approximate; --method nearest keeps it exact, at another cost\n", "note");
}

void compile_report_tell(const struct compile_report *report, bool all)
{
    for (size_t i = 0; i < report->note_count; i++)
        if (all ? !report->notes[i].is_detail : report->notes[i].is_loss) notice("%s", report->notes[i].text);
    if (report->mesh.clamped) notice("%zu faces have an opacity beyond 0..1, clamped", report->mesh.clamped);
    for (enum unmapped kind = 0; kind < UNMAPPED_KINDS; kind++)
        if (report->mesh.unmapped[kind])
            notice("%zu faces %s; they have its mean colour", report->mesh.unmapped[kind], unmapped_words(kind));
}

void compile_summary_print(const struct compiled *scene, const struct moving *moving, const char *name)
{
    printable_print(stdout, "%s\n", name);
    compile_report_tell(&scene->report, false);
    print_model(&scene->report, moving);
    print_drawn(&scene->report);
    print_memory(scene, moving);
    print_predictions(&scene->report);
    print_reservation(&scene->report);
}
