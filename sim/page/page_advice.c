/* SPDX-License-Identifier: MIT
 *
 * What follows from the figures, each a rule with its numbers: what is dear first. */
#include "core/core.h"
#include "model/mapping.h"
#include "page/html.h"
#include "page/page.h"
#include "page/page_board.h"
#include "scene/mcu_mem.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

static const double MANY_SPLITS = 0.25, FEW_SEEN = 0.5, WRONG_BOUND_PERCENT = 0.05, HALF = 0.5, TENTH = 0.1;
enum { CYCLES_A_SECOND = 125000000, LINE_B = 512 };

struct advice {
    const struct page *page;
    FILE *file;
    size_t count;
};

/* A point of the list; the text is the page's own, but for what printf puts into it, which is escaped. */
__attribute__((format(printf, 2, 3))) static void say(struct advice *advice, const char *format, ...)
{
    char text[LINE_B];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fputs("<li>", advice->file);
    html_text(advice->file, text);
    fputs("</li>\n", advice->file);
    advice->count++;
}

static const struct page_row *this_row(const struct page *page)
{
    return &page->rows[page->this_row];
}

static double wrong_of(const struct page_row *row)
{
    return compare_wrong_percent(&row->accuracy.pixels.total);
}

static void say_of_pools(struct advice *advice)
{
    const struct page *page = advice->page;
    const struct page_row *larger = NULL;
    if (!page->worst.stats.bands) return;
    for (size_t i = 0; i < page->row_count; i++)
        if (page->rows[i].has_worst) larger = &page->rows[i];
    say(advice,
        "The worst view found walks the tree %lu times, because its pools are short there. If every frame has to be "
        "in time, compile with --worst, which makes them larger.",
        (unsigned long)page->worst.stats.bands + 1);
    if (larger)
        say(advice,
            "With --worst the scene takes %.1f KB of RAM instead of %.1f, and the worst view that it finds %.0f "
            "thousand %s instead of %.0f.",
            (double)page_ram_b(page, &larger->scene) / 1024.0, (double)page_ram_b(page, &page->scene) / 1024.0,
            larger->scene.report.worst.work / 1000.0, page_is_predicted(page) ? "instructions" : "of work",
            page->worst.cost.goals[0].score / 1000.0);
}

/* A mesh's order is approximate: it may spare much, and be wrong. */
static bool is_as_right(const struct page_row *row, const struct page_row *mine)
{
    return wrong_of(row) <= wrong_of(mine) * (1.0 + TENTH);
}

/* Of another row that spares something, and is as right. */
static void say_of_methods(struct advice *advice)
{
    const struct page *page = advice->page;
    const struct page_row *mine = this_row(page), *best = NULL;
    for (size_t i = 0; i < page->row_count; i++) {
        const struct page_row *row = &page->rows[i];
        if (row->core == mine->core && is_as_right(row, mine) &&
            row->instructions < mine->instructions * (1.0 - TENTH) && (!best || row->instructions < best->instructions))
            best = row;
    }
    if (best)
        say(advice,
            "%s takes %.0f thousand instructions a frame instead of %.0f, and %zu bytes of RAM instead of %zu: %s.",
            best->label, best->instructions / 1000.0, mine->instructions / 1000.0, page_ram_b(page, &best->scene),
            page_ram_b(page, &mine->scene), best->option);
}

static void say_of_splits(struct advice *advice)
{
    const struct compile_report *report = &advice->page->scene.report;
    if (report->tree != TREE_BSP || (double)report->splits < MANY_SPLITS * (double)report->polygons_in) return;
    if (report->choice.kind == CHOICE_MADE) {
        say(advice,
            "The tree splits %zu times on %zu polygons. Clusters and axis cuts were tried and spare less than a "
            "tenth; fewer polygons that reach through each other's planes would help.",
            report->splits, report->polygons_in);
        return;
    }
    say(advice, "The tree splits %zu times on %zu polygons: try --tree clusters, or --tree auto, which takes its time.",
        report->splits, report->polygons_in);
}

static void say_of_hidden(struct advice *advice)
{
    const struct page *page = advice->page;
    const struct portal_report *portals = &page->scene.report.portals;
    double reached = 0.0, seen = 0.0;
    for (size_t i = 0; i < page->view_count; i++) {
        reached += page->views[i].stats.polygons;
        seen += page->views[i].stats.polygons_seen;
    }
    if (!(reached > 0.0) || seen >= FEW_SEEN * reached || portals->kept) return;
    if (portals->tried)
        say(advice,
            "Of the polygons that frames reach %.0f %% are seen. Portals were tried: %.0f polygons reached instead "
            "of %.0f for %zu bytes of flash, which was not worth it; --portals on takes them all the same.",
            100.0 * seen / reached, (double)portals->polygons_after / (double)portals->cameras,
            (double)portals->polygons_before / (double)portals->cameras, portals->bytes);
    else
        say(advice,
            "Of the polygons that frames reach %.0f %% are seen: what is hidden costs most. --portals on stores what "
            "can be seen from where, if rooms divide the scene.",
            100.0 * seen / reached);
}

/* The first precision behind this one that halves what is wrong. */
static void say_of_errors(struct advice *advice)
{
    const struct page *page = advice->page;
    const struct page_row *mine = this_row(page);
    const double wrong = wrong_of(mine);
    size_t holes = mine->accuracy.pixels.total.holes;
    if (holes)
        say(advice,
            "%zu pixels of these views are holes, through which something shows that should be hidden: see the red "
            "ones. A finer precision, or corners that meet in the model, close them.",
            holes);
    if (wrong < WRONG_BOUND_PERCENT && mine->accuracy.pixels.worst.wrong * 1000 < mine->accuracy.pixels.worst.pixels)
        return;
    for (size_t i = page->this_row + 1; i < page->row_count; i++) {
        const struct page_row *row = &page->rows[i];
        if (row->core == mine->core || wrong_of(row) > HALF * wrong) continue;
        say(advice, "%.4f %% of the pixels are wrong; precision %s has %.4f %%.", wrong, row->core->name,
            wrong_of(row));
        return;
    }
}

static void say_of_boards(struct advice *advice)
{
    const struct page *page = advice->page;
    for (size_t i = 0; i < page_board_count; i++) {
        const enum page_fit fit = page_board_fit(page, &page_boards[i]);
        if (fit == PAGE_FITS) continue;
        say(advice, "%s: %s. %s", page_boards[i].title,
            fit == PAGE_NO_FLASH ? "the scene is larger than its flash"
            : fit == PAGE_NO_RAM ? "it has too little RAM"
                                 : "it has too little RAM for these pools, so that some frames take longer",
            fit == PAGE_NO_FLASH ? "Fewer polygons or smaller textures, or another board."
            : fit == PAGE_NO_RAM ? "A smaller picture (--size), a method with less, or another board."
                                 : "A smaller picture (--size) takes fewer lines and cells.");
        if (fit != PAGE_FITS_SLOWLY) continue;
        break; /* the others are larger, or in the table */
    }
}

static void say_of_pixels(struct advice *advice)
{
    const struct page *page = advice->page;
    const size_t pixels_b = (size_t)page->request.w_px * page->request.h_px * 2;
    if (pixels_b <= (size_t)32 << 10 && !page->scene.report.framebuffer && !page->scene.moving &&
        !page->scene.scene.texture_count && page->scene.report.draws != LIM_CONVEX)
        say(advice,
            "All pixels take %zu bytes. A board with that RAM draws with fewer instructions into a framebuffer: "
            "--framebuffer.",
            pixels_b);
}

/* What was mended on the way in. */
static void say_of_model(struct advice *advice)
{
    const struct mesh_counts *counts = &advice->page->source.mesh.counts;
    const size_t bent = counts->non_planar + counts->bent;
    if (counts->zero_area)
        say(advice, "%zu of %zu faces have no area and are dropped: a clean-up in the modeller takes them out.",
            counts->zero_area, counts->faces);
    if (bent * 10 > counts->faces)
        say(advice,
            "%zu of %zu faces were cut into triangles, as they or their textures are not flat: flat ones cost less.",
            bent, counts->faces);
    for (enum unmapped kind = 0; kind < UNMAPPED_KINDS; kind++)
        if (counts->unmapped[kind])
            say(advice, "%zu faces %s; they are drawn in its mean colour.", counts->unmapped[kind],
                unmapped_words(kind));
}

static void say_speed(struct advice *advice)
{
    const struct page_row *row = this_row(advice->page);
    if (isnan(row->instructions) || !(row->instructions > 0.0)) return;
    say(advice,
        "At 125 MHz, an instruction a cycle, the processor alone would draw %.0f frames a second in the mean, %s; "
        "what the display's bus takes comes to that.",
        CYCLES_A_SECOND / row->instructions, advice->page->request.cpu_count ? "by count" : "by prediction");
}

void page_advice_write(const struct page *page, FILE *file)
{
    struct advice advice = {page, file, 0};
    html_section(file, "next", "What to do next");
    fputs("<ul>\n", file);
    say_of_pools(&advice);
    say_of_methods(&advice);
    say_of_splits(&advice);
    say_of_hidden(&advice);
    say_of_errors(&advice);
    say_of_boards(&advice);
    say_of_pixels(&advice);
    say_of_model(&advice);
    if (!advice.count) say(&advice, "Nothing stands out: no splits, pools or errors worth a change.");
    say_speed(&advice);
    fputs("</ul>\n", file);
    html_section_end(file);
}
