/* SPDX-License-Identifier: MIT
 *
 * The tree: its kind, how deep and how bushy it is. */
#include "base/grow.h"
#include "page/html.h"
#include "page/page.h"

#include <stdlib.h>

enum { BARS_MAX = 40, CHART_W = 620, CHART_H = 180, CHART_LEFT = 44, CHART_FOOT = 28, LABELS = 8 };

struct histogram {
    size_t counts[BARS_MAX];
    size_t bars, step, most; /* a bar is so many depths */
};

/* Children come after their parents. */
static void fill(const struct lim_scene *scene, struct histogram *out)
{
    size_t *depths = grow_zeroed(scene->node_count, sizeof *depths), deepest = 0;
    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        if (depths[i] > deepest) deepest = depths[i];
        if (node->split.plane == LIM_NO_INDEX) continue;
        if (node->front != LIM_NO_INDEX) depths[node->front] = depths[i] + 1;
        if (node->back != LIM_NO_INDEX) depths[node->back] = depths[i] + 1;
    }
    *out = (struct histogram){.step = deepest / BARS_MAX + 1};
    out->bars = deepest / out->step + 1;
    for (size_t i = 0; i < scene->node_count; i++) {
        size_t *bar = &out->counts[depths[i] / out->step];
        if (++*bar > out->most) out->most = *bar;
    }
    free(depths);
}

static void draw_histogram(const struct histogram *histogram, FILE *file)
{
    const double w = (double)(CHART_W - CHART_LEFT) / (double)histogram->bars, h = CHART_H - CHART_FOOT - 14;
    const size_t every = (histogram->bars + LABELS - 1) / LABELS;
    fprintf(file,
            "<svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"nodes by depth\"><line x1=\"%d\" y1=\"%d\" x2=\"%d\" "
            "y2=\"%d\"/>\n<text x=\"%d\" y=\"18\" text-anchor=\"end\">%zu</text>",
            CHART_W, CHART_H, CHART_LEFT, CHART_H - CHART_FOOT, CHART_W, CHART_H - CHART_FOOT, CHART_LEFT - 8,
            histogram->most);
    for (size_t i = 0; i < histogram->bars; i++) {
        const double bar_h = h * (double)histogram->counts[i] / (double)histogram->most;
        const double x = CHART_LEFT + w * (double)i;
        fprintf(file, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n", x + 1.0,
                CHART_H - CHART_FOOT - bar_h, w > 3.0 ? w - 2.0 : w, bar_h);
        if (i % every == 0)
            fprintf(file, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%zu</text>\n", x + w / 2.0, CHART_H - 10,
                    i * histogram->step);
    }
    fputs("</svg>\n<p class=\"soft\">Nodes by their depth below the root.</p>\n", file);
}

static void write_row(FILE *file, const char *name, double number, int decimals)
{
    html_row_begin(file, name);
    html_cell(file, number, decimals);
    html_row_end(file);
}

static void write_figures(const struct page *page, FILE *file)
{
    static const char *const kinds[PLANE_KINDS] = {"nodes x = const", "nodes y = const",     "nodes z = const",
                                                   "upright nodes",   "nodes of any normal", "nodes of 32-bit normals"};
    const struct compile_report *report = &page->scene.report;
    fputs("<div class=\"wide\"><table>\n<tbody>\n", file);
    fprintf(file, "<tr><th scope=\"row\">kind</th><td>%s%s</td></tr>\n", tree_names[report->tree],
            report->convex ? ", one convex solid" : "");
    write_row(file, "faces in the model", (double)page->source.mesh.counts.faces, 0);
    write_row(file, "polygons before splitting", (double)report->polygons_in, 0);
    write_row(file, "splits", (double)report->splits, 0);
    write_row(file, "polygons in the scene", (double)report->polygons_out, 0);
    write_row(file, "depth", (double)report->depth, 0);
    write_row(file, "nodes", page->scene.scene.node_count, 0);
    for (int i = 0; i < PLANE_KINDS; i++)
        if (report->kinds[i]) write_row(file, kinds[i], (double)report->kinds[i], 0);
    if (report->leaves) write_row(file, "leaves", (double)report->leaves, 0);
    if (report->mesh_leaves)
        write_row(file, "mesh leaves, ordered by distance: not exact", (double)report->mesh_leaves, 0);
    write_row(file, "most vertices of a polygon", page->scene.scene.limits.vertices, 0);
    write_row(file, "units a metre", page->scene.grid.units_per_m, 1);
    write_row(file, "worst wrong side of a plane, certified, units", report->worst_violation_units, 4);
    fputs("</tbody></table></div>\n", file);
}

void page_tree_write(const struct page *page, FILE *file)
{
    struct histogram histogram;
    html_section(file, "tree", "The tree");
    fputs("<div class=\"pair\"><div>", file);
    write_figures(page, file);
    fputs("</div><div>\n", file);
    if (page->scene.scene.node_count) {
        fill(&page->scene.scene, &histogram);
        draw_histogram(&histogram, file);
    }
    fputs("</div></div>\n", file);
    html_section_end(file);
}
