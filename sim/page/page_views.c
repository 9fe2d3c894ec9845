/* SPDX-License-Identifier: MIT
 *
 * Pictures: the views and where these are wrong, and what was searched. */
#include "page/html.h"
#include "page/page.h"

#include <string.h>

enum { ALT_B = 64 };

static const char COLOURS[] =
    "<p class=\"soft\">Grey is right. <b style=\"color:#c08000\">Amber</b> shows another face than the reference in "
    "double "
    "precision does, as an edge that is off by less than a pixel; <b style=\"color:#ff2020\">red</b> is a hole, or "
    "something that should be hidden. "
    "All are drawn larger than they are.</p>\n";

static void write_counts(const struct page_view *view, FILE *file)
{
    html_number(file, (double)view->wrong.wrong, 0);
    fputs(" wrong", file);
    if (!view->wrong.holes) return;
    fputs(", <b class=\"bad\">", file);
    html_number(file, (double)view->wrong.holes, 0);
    fputs(" holes</b>", file);
}

static bool write_shot(FILE *file, gdImagePtr picture, const char *what, size_t number, struct error *err)
{
    char alt[ALT_B];
    snprintf(alt, sizeof alt, "%s %zu", what, number);
    fputs("<figure>", file);
    return html_picture(file, picture, alt, err);
}

bool page_views_write(const struct page *page, FILE *file, struct error *err)
{
    html_section(file, "views", "Views");
    fprintf(file, "<p>%s%zu of ", page->shown_count < page->view_count ? "The first " : "", page->shown_count);
    html_text(file, page->path_words);
    fputs(".</p>\n<div class=\"shots\">\n", file);
    for (size_t i = 0; i < page->shown_count; i++) {
        if (!write_shot(file, page->views[i].picture, "view", i + 1, err)) return false;
        fprintf(file, "<figcaption>%zu: ", i + 1);
        html_number(file, page->views[i].stats.polygons_seen, 0);
        fputs(" polygons seen</figcaption></figure>\n", file);
    }
    fputs("</div>\n<h3>Where pixels are wrong</h3>\n", file);
    fputs(COLOURS, file);
    fputs("<div class=\"shots\">\n", file);
    for (size_t i = 0; i < page->shown_count; i++) {
        if (!write_shot(file, page->views[i].difference, "wrong pixels of view", i + 1, err)) return false;
        fprintf(file, "<figcaption>%zu: ", i + 1);
        write_counts(&page->views[i], file);
        fputs("</figcaption></figure>\n", file);
    }
    fputs("</div>\n", file);
    html_section_end(file);
    return true;
}

/* Worst frames ------------------------------------------------------------------------------- */

static void write_times(const struct search_result *result, FILE *file)
{
    const struct search_goal *goal = &result->goals[0];
    if (goal->mean > 0.0) {
        html_number(file, goal->score / goal->mean, 1);
        fputs(" times the mean", file);
    }
    if (goal->most > 0.0) {
        fputs(goal->mean > 0.0 ? " and " : "", file);
        html_number(file, goal->score / goal->most, 1);
        fprintf(file, " times the worst of %zu random cameras", result->plain);
    }
    fprintf(file, "%s of %zu cameras tried%s.", goal->mean > 0.0 || goal->most > 0.0 ? "; the worst" : "the worst",
            result->tried, result->is_cut ? " in the time that there was" : "");
}

static void write_camera(const struct viewpoint *viewpoint, FILE *file)
{
    fputs("<br>Camera: <code>", file);
    viewpoint_write(viewpoint, file);
    fputs("</code></figcaption></figure>\n", file);
}

static bool write_costly(const struct page *page, FILE *file, struct error *err)
{
    const struct search_goal *goal = &page->worst.cost.goals[0];
    if (!write_shot(file, page->worst_cost.picture, "the view that costs most,", 1, err)) return false;
    fputs("<figcaption><b>Costs most</b>: ", file);
    html_number(file, goal->score, 0);
    fputs(page_is_predicted(page) ? " instructions on Cortex-M0+, predicted. "
                                  : " of work, which ranks frames and is no number of instructions. ",
          file);
    write_times(&page->worst.cost, file);
    if (page->worst.stats.bands) {
        fputs(" <b class=\"bad\">Pools are short</b> there: the tree is walked ", file);
        html_number(file, page->worst.stats.bands + 1.0, 0);
        fputs(" times.", file);
    }
    write_camera(&goal->worst, file);
    return true;
}

static bool write_erring(const struct page *page, FILE *file, struct error *err)
{
    const struct search_goal *goal = &page->worst.error.goals[0];
    if (!write_shot(file, page->worst_error.picture, "the view that errs most,", 1, err)) return false;
    fputs("<figcaption><b>Errs most</b>: ", file);
    html_number(file, goal->score, 0);
    fputs(" wrong pixels. ", file);
    write_times(&page->worst.error, file);
    write_camera(&goal->worst, file);
    if (!write_shot(file, page->worst_error.difference, "wrong pixels of the view that errs most,", 1, err))
        return false;
    fputs("<figcaption>Where it errs: ", file);
    write_counts(&page->worst_error, file);
    fputs(".</figcaption></figure>\n", file);
    return true;
}

bool page_worst_write(const struct page *page, FILE *file, struct error *err)
{
    html_section(file, "worst", "Worst frames");
    fputs(
        "<p>Searched in the scene's free space, not proved to be the worst. <code>limner render --camera</code> draws "
        "these cameras.</p>\n<div class=\"pair\">\n",
        file);
    if (!write_costly(page, file, err) || !write_erring(page, file, err)) return false;
    fputs("</div>\n", file);
    html_section_end(file);
    return true;
}
