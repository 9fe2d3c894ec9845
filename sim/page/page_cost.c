/* SPDX-License-Identifier: MIT
 *
 * What frames cost: by what the renderer counts, and, where processors are named, by the instructions of its files. */
#include "core/core.h"
#include "page/html.h"
#include "page/page.h"
#include "render/frame_cost.h"

#include <stdlib.h>

enum { PERCENT = 100 };

struct sums {
    double counts[FRAME_COST_TERMS], most[FRAME_COST_TERMS], instructions[FRAME_COST_TERMS], all;
    const char *names[FRAME_COST_TERMS];
};

static void sum_up(const struct page *page, struct sums *sums)
{
    const struct lim_target target = {.method = page->scene.report.draws, .h_px = (uint16_t)page->request.h_px};
    *sums = (struct sums){0};
    for (size_t i = 0; i < page->view_count; i++) {
        struct frame_cost_term terms[FRAME_COST_TERMS];
        frame_cost_terms(&page->views[i].stats, &target, terms);
        for (int k = 0; k < FRAME_COST_TERMS; k++) {
            const double count = terms[k].count / (double)page->view_count;
            sums->names[k] = terms[k].name;
            sums->counts[k] += count;
            if (terms[k].count > sums->most[k]) sums->most[k] = terms[k].count;
            sums->instructions[k] += count * terms[k].each;
            sums->all += count * terms[k].each;
        }
    }
}

static void write_counters(const struct page *page, FILE *file)
{
    struct sums sums;
    const bool is_known = page_is_predicted(page);
    sum_up(page, &sums);
    fprintf(
        file,
        "<p>Counted by the renderer in %zu views%s.</p>\n<div class=\"wide\"><table>\n<thead><tr><th>in a frame</th>"
        "<th>mean</th><th>most</th>%s</tr></thead>\n<tbody>\n",
        page->view_count,
        is_known ? ", and the instructions of a Cortex-M0+ that they explain, to within some percent"
                 : "; instructions of such frames are not predicted",
        is_known ? "<th>instructions, predicted</th><th></th>" : "");
    for (int k = 0; k < FRAME_COST_TERMS; k++) {
        if (!(sums.most[k] > 0.0)) continue;
        html_row_begin(file, sums.names[k]);
        html_cell(file, sums.counts[k], 0);
        html_cell(file, sums.most[k], 0);
        if (is_known) html_cell(file, sums.instructions[k], 0);
        if (is_known) html_bar(file, 2.0 * sums.instructions[k] / sums.all);
        html_row_end(file);
    }
    if (is_known) {
        fputs("<tr class=\"sum\"><th scope=\"row\">all of it</th><td></td><td></td>", file);
        html_cell(file, sums.all, 0);
        fputs("<td></td></tr>\n", file);
    }
    fputs("</tbody></table></div>\n", file);
}

static int by_mean(const void *left, const void *right)
{
    const double a = ((const struct cost_stage *)left)->mean, b = ((const struct cost_stage *)right)->mean;
    return a < b ? 1 : a > b ? -1 : 0;
}

/* The stages of one processor, the dearest first. */
static void write_stages(const struct cost *cost, const char *title, FILE *file)
{
    struct cost stages = *cost;
    qsort(stages.stages, stages.stage_count, sizeof *stages.stages, by_mean);
    fprintf(file, "<h3>Counted on %s, by file of the renderer</h3>\n<p>", title);
    html_number(file, cost->mean, 0);
    fputs(" instructions a frame, ", file);
    html_number(file, (double)cost->worst, 0);
    fputs(" at most in these views.</p>\n<div class=\"wide\"><table>\n<thead><tr><th>file</th><th>mean</th><th>worst "
          "frame</th><th>of all, %</th><th></th></tr></thead>\n<tbody>\n",
          file);
    for (size_t i = 0; i < stages.stage_count; i++) {
        const struct cost_stage *stage = &stages.stages[i];
        if (stage->mean < cost->mean / 1000.0) continue;
        html_row_begin(file, stage->name);
        html_cell(file, stage->mean, 0);
        html_cell(file, (double)stage->worst, 0);
        html_cell(file, PERCENT * stage->mean / cost->mean, 1);
        html_bar(file, 2.0 * stage->mean / cost->mean);
        html_row_end(file);
    }
    fputs("</tbody></table></div>\n", file);
}

void page_cost_write(const struct page *page, FILE *file)
{
    const struct page_row *row = &page->rows[page->this_row];
    html_section(file, "cost", "What a frame costs");
    write_counters(page, file);
    for (size_t i = 0; i < page->request.cpu_count; i++)
        if (row->costs[i].frames) write_stages(&row->costs[i], page->request.cpus[i]->title, file);
    html_section_end(file);
}
