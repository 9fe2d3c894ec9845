/* SPDX-License-Identifier: MIT
 *
 * What else there is: precisions, methods, trees, each with what it gets wrong, costs and takes. */
#include "core/core.h"
#include "page/html.h"
#include "page/page.h"

#include <math.h>

enum { PLOT_W = 620, PLOT_H = 300, LEFT = 66, RIGHT = 26, TOP = 18, FOOT = 48, TICKS = 4 };

/* From 0 to a round number that is not less. */
static double scale_end(double most)
{
    static const double steps[] = {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    const double ten = most > 0.0 ? pow(10.0, floor(log10(most))) : 1.0;
    size_t i = 0;
    while (i + 1 < sizeof steps / sizeof *steps && steps[i] * ten < most)
        i++;
    return steps[i] * ten;
}

struct axis {
    const char *title;
    double (*value)(const struct page *page, const struct page_row *row); /* NaN: not known */
    double end;
    int decimals;
};

static double wrong_of(const struct page *page, const struct page_row *row)
{
    (void)page;
    return compare_wrong_percent(&row->accuracy.pixels.total);
}

static double instructions_of(const struct page *page, const struct page_row *row)
{
    (void)page;
    return row->instructions / 1000.0;
}

static double ram_of(const struct page *page, const struct page_row *row)
{
    return (double)page_ram_b(page, &row->scene) / 1024.0;
}

static size_t find_end(const struct page *page, struct axis *axis)
{
    double most = 0.0;
    size_t known = 0;
    for (size_t i = 0; i < page->row_count; i++) {
        const double value = axis->value(page, &page->rows[i]);
        if (isnan(value)) continue;
        known++;
        most = fmax(most, value);
    }
    axis->end = scale_end(most);
    axis->decimals = (int)fmax(0.0, ceil(1.0 - log10(axis->end / TICKS)));
    return known;
}

/* Wrong pixels by powers of ten, so that all precisions are told apart; none at all is at the bottom. */
struct decades {
    int low, high; /* of percent */
};

static struct decades find_decades(const struct page *page)
{
    double least = INFINITY, most = 0.0;
    for (size_t i = 0; i < page->row_count; i++) {
        const double wrong = wrong_of(page, &page->rows[i]);
        if (wrong > 0.0) least = fmin(least, wrong);
        most = fmax(most, wrong);
    }
    if (!(most > 0.0)) return (struct decades){-3, 0};
    const int low = (int)floor(log10(least)), high = (int)ceil(log10(most));
    return (struct decades){low, high > low ? high : low + 1};
}

static double height_of(const struct decades *decades, double wrong)
{
    if (!(wrong > 0.0)) return 0.0;
    return (log10(wrong) - decades->low) / (decades->high - decades->low);
}

static void draw_axes(const struct axis *x, const struct decades *y, FILE *file)
{
    const double w = PLOT_W - LEFT - RIGHT, h = PLOT_H - TOP - FOOT;
    for (int i = 0; i <= TICKS; i++) {
        const double at_x = LEFT + w * i / TICKS;
        fprintf(file,
                "<line x1=\"%.1f\" y1=\"%d\" x2=\"%.1f\" y2=\"%d\"/>"
                "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%.*f</text>\n",
                at_x, TOP, at_x, PLOT_H - FOOT, at_x, PLOT_H - FOOT + 16, x->decimals, x->end * i / TICKS);
    }
    for (int i = y->low; i <= y->high; i++) {
        const double at_y = TOP + h - h * (i - y->low) / (y->high - y->low);
        fprintf(file,
                "<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\"/>"
                "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%.*f</text>\n",
                LEFT, at_y, PLOT_W - RIGHT, at_y, LEFT - 8, at_y + 4.0, i < 0 ? -i : 0, pow(10.0, i));
    }
    fprintf(file,
            "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%s</text>"
            "<text transform=\"translate(14 %.1f) rotate(-90)\" text-anchor=\"middle\">wrong pixels, "
            "%%</text>\n",
            LEFT + w / 2.0, PLOT_H - 12, x->title, TOP + h / 2.0);
}

/* Where numbers stand beside their dots: elsewhere for each of those that lie together. */
static size_t neighbours_of(const double (*dots)[2], size_t i)
{
    const double near_px = 18.0;
    size_t count = 0;
    for (size_t k = 0; k < i; k++)
        count += fabs(dots[k][0] - dots[i][0]) < near_px && fabs(dots[k][1] - dots[i][1]) < near_px;
    return count;
}

static void draw_dot(const struct page_row *row, const double (*dots)[2], size_t i, FILE *file)
{
    static const double places[][2] = {{8.0, -7.0},   {8.0, 17.0},   {-17.0, -7.0},
                                       {-17.0, 17.0}, {-4.0, -12.0}, {-4.0, 22.0}};
    const double *place = places[neighbours_of(dots, i) % (sizeof places / sizeof *places)];
    fprintf(file,
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" class=\"dot%s\"/><text x=\"%.1f\" y=\"%.1f\" class=\"ink\">"
            "%zu</text>\n",
            dots[i][0], dots[i][1], row->is_on_front ? " on" : "", dots[i][0] + place[0], dots[i][1] + place[1], i + 1);
}

/* Rows by their numbers in the table. */
static void draw_plot(const struct page *page, struct axis x, FILE *file)
{
    const struct decades y = find_decades(page);
    const double w = PLOT_W - LEFT - RIGHT, h = PLOT_H - TOP - FOOT;
    double dots[PAGE_ROWS_MAX][2];
    if (find_end(page, &x) < 2) return;
    fprintf(file, "<div><svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"wrong pixels against %s\">\n", PLOT_W,
            PLOT_H, x.title);
    draw_axes(&x, &y, file);
    for (size_t i = 0; i < page->row_count; i++) {
        const struct page_row *row = &page->rows[i];
        const double at_x = x.value(page, row);
        dots[i][0] = isnan(at_x) ? -PLOT_W : LEFT + w * at_x / x.end;
        dots[i][1] = TOP + h - h * height_of(&y, wrong_of(page, row));
        if (!isnan(at_x)) draw_dot(row, dots, i, file);
    }
    fputs("</svg></div>\n", file);
}

static void write_row(const struct page *page, size_t i, FILE *file)
{
    const struct page_row *row = &page->rows[i];
    fprintf(file, "<tr%s><td>%zu</td><th scope=\"row\">", row->is_this ? " class=\"this\"" : "", i + 1);
    html_text(file, row->label);
    fputs(row->is_this ? " (this page)</th>" : "</th>", file);
    html_cell(file, wrong_of(page, row), 4);
    html_cell(file, compare_wrong_percent(&row->accuracy.pixels.worst), 4);
    html_cell(file, row->accuracy.vertex_max_px, 3);
    html_cell(file, row->instructions, 0);
    for (size_t k = 1; k < page->request.cpu_count; k++)
        html_cell(file, row->costs[k].frames ? row->costs[k].mean : NAN, 0);
    html_cell(file, (double)page_ram_b(page, &row->scene), 0);
    html_cell(file, (double)row->scene.report.flash_b, 0);
    fprintf(file, "<td>%s</td><td class=\"word\"><code>", row->is_on_front ? "&#9679;" : "");
    html_text(file, row->option);
    fputs("</code></td></tr>\n", file);
}

static void write_table(const struct page *page, FILE *file)
{
    fputs(
        "<div class=\"wide\"><table>\n<thead><tr><th></th><th class=\"word\">precision or method</th><th>wrong pixels, "
        "%</th><th>worst "
        "view, %</th><th>vertex off by, px</th>",
        file);
    if (!page->request.cpu_count) fputs("<th>instructions, predicted</th>", file);
    for (size_t i = 0; i < page->request.cpu_count; i++)
        fprintf(file, "<th>instructions, %s</th>", page->request.cpus[i]->title);
    fputs("<th>RAM, bytes</th><th>flash, bytes</th><th>front</th><th class=\"word\">by</th></tr></thead>\n<tbody>\n",
          file);
    for (size_t i = 0; i < page->row_count; i++)
        write_row(page, i, file);
    fputs("</tbody></table></div>\n", file);
}

void page_front_write(const struct page *page, FILE *file)
{
    const bool is_counted = page->request.cpu_count > 0;
    html_section(file, "front", "Choices");
    fprintf(
        file,
        "<p>Other precisions, methods and trees, on the same views. A full dot is on the front: no other row has both "
        "fewer wrong pixels and %s.%s</p>\n",
        is_counted ? "fewer instructions" : "less RAM",
        is_counted ? ""
                   : " Instructions are predicted in profile fast alone, as means of the cameras that the compiler "
                     "samples; <code>--core</code> counts them.");
    write_table(page, file);
    for (size_t i = 0; i < page->refused.count; i++) {
        fprintf(file, "<p class=\"soft\">Refused, %s: ", page->refused.rows[i].core->name);
        html_text(file, page->refused.rows[i].reason.text);
        fputs("</p>\n", file);
    }
    if (*page->too_long) fprintf(file, "<p class=\"soft\">%s</p>\n", page->too_long);
    fputs("<div class=\"pair\">\n", file);
    draw_plot(page, (struct axis){.title = "thousand instructions a frame", .value = instructions_of}, file);
    draw_plot(page, (struct axis){.title = "KB of RAM", .value = ram_of}, file);
    fputs("</div>\n", file);
    html_section_end(file);
}
