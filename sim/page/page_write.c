/* SPDX-License-Identifier: MIT
 *
 * Head, style, what matters most in figures, and the sections in their order. The page loads nothing, and needs no
 * script. */
#include "core/core.h"
#include "page/html.h"
#include "page/page.h"

static const char STYLE[] =
    ":root{--ink:#1c2430;--soft:#5a6675;--line:#dfe4ea;--page:#f6f7f9;--card:#fff;--mark:#2563a8;--bar:#cfe0f3;"
    "--good:#1d7a4f;--bad:#b3401f}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6eaf0;--soft:#9aa7b6;--line:#313a46;--page:#14181e;--card:#1c222a;"
    "--mark:#7db4f0;--bar:#2b4562;--good:#6fce9f;--bad:#f0936f}}\n"
    "*{box-sizing:border-box}\n"
    "body{margin:0;background:var(--page);color:var(--ink);font:16px/1.5 system-ui,-apple-system,'Segoe UI',Roboto,"
    "'DejaVu Sans',sans-serif}\n"
    "main,header,footer{max-width:1120px;margin:0 auto;padding:0 20px}\n"
    "header{padding-top:36px}h1{font-size:30px;line-height:1.2;margin:0 0 4px;overflow-wrap:anywhere}\n"
    "h2{font-size:20px;margin:0 0 10px}h3{font-size:16px;margin:22px 0 6px}\n"
    "p{margin:0 0 12px;max-width:78ch}.soft,figcaption{color:var(--soft)}figcaption{font-size:13px;line-height:1.35}\n"
    "section{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:22px 24px;margin:18px 0}\n"
    ".cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(136px,1fr));gap:10px;margin:22px 0 0}\n"
    ".cards div{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:12px 14px}\n"
    ".cards b{display:block;font-size:22px;line-height:1.2;font-weight:600;font-variant-numeric:tabular-nums}\n"
    ".cards span{font-size:13px;color:var(--soft);display:block;line-height:1.35;margin-top:2px}\n"
    "nav{margin:18px 0 0;font-size:14px;display:flex;flex-wrap:wrap;gap:4px 16px}\n"
    "a{color:var(--mark);text-decoration:none}a:hover{text-decoration:underline}\n"
    ".shots{display:grid;grid-template-columns:repeat(auto-fill,minmax(150px,1fr));gap:12px}\n"
    ".pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,240px),1fr));gap:16px;align-items:start}"
    "\n"
    "figure{margin:0}img{display:block;width:100%;height:auto;image-rendering:pixelated;border-radius:6px;"
    "background:#000}figcaption{margin-top:5px}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:14px}\n"
    "th,td{padding:5px 10px;border-bottom:1px solid var(--line);text-align:right;vertical-align:top}\n"
    "td{font-variant-numeric:tabular-nums;white-space:nowrap}th{font-weight:500;text-align:left}\n"
    "thead th{color:var(--soft);font-size:13px;text-align:right;vertical-align:bottom}"
    "thead th:first-child,thead th.word,td.word{text-align:left;white-space:normal}\n"
    "td.bar{width:26%;background:linear-gradient(var(--bar),var(--bar)) no-repeat 0 9px}\n"
    "tr.this th,tr.this td{font-weight:700}tr.sum th,tr.sum td{border-top:2px solid var(--line);font-weight:600}\n"
    "code{font:13px/1.4 ui-monospace,'DejaVu Sans Mono',Consolas,monospace;overflow-wrap:anywhere}td "
    "code{white-space:nowrap}\n"
    "ol,ul{margin:0;padding-left:22px}li{margin:0 0 "
    "10px;max-width:78ch}.good{color:var(--good)}.bad{color:var(--bad)}\n"
    "svg{display:block;width:100%;height:auto;max-width:620px}svg text{fill:var(--soft);font-size:12px}\n"
    "svg .ink{fill:var(--ink)}svg .dot{fill:var(--card);stroke:var(--mark);stroke-width:2}svg .on{fill:var(--mark)}"
    "svg line,svg path{stroke:var(--line);fill:none}svg rect{fill:var(--bar)}\n"
    "footer{color:var(--soft);font-size:13px;padding-top:6px;padding-bottom:40px}\n"
    "@media(max-width:560px){section{padding:16px 14px}h1{font-size:24px}th,td{padding:5px 6px}}\n"
    "@media print{body{background:#fff}section{break-inside:avoid}}\n";

static void write_head(const struct page *page, FILE *file)
{
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
          file);
    html_text(file, page->request.name);
    fprintf(file, " - Limner</title>\n<style>\n%s</style>\n</head>\n<body>\n", STYLE);
}

static void write_card(FILE *file, double number, int decimals, const char *unit, const char *what)
{
    fputs("<div><b>", file);
    html_number(file, number, decimals);
    fprintf(file, "%s</b><span>%s</span></div>\n", unit, what);
}

/* What is asked first. */
static void write_cards(const struct page *page, FILE *file)
{
    const struct page_row *row = &page->rows[page->this_row];
    const bool is_counted = page->request.cpu_count > 0;
    const struct search_goal *cost = &page->worst.cost.goals[0], *error = &page->worst.error.goals[0];
    fputs("<div class=\"cards\">\n", file);
    write_card(file, (double)page->scene.scene.polygon_count, 0, "", "polygons in the scene");
    write_card(file, (double)page->scene.report.flash_b / 1024.0, 1, " KB", "of flash for the scene");
    write_card(file, (double)page_ram_b(page, &page->scene) / 1024.0, 1, " KB", "of RAM for it and its pixels");
    write_card(file, row->instructions / 1000.0, 0, is_counted || page_is_predicted(page) ? " k" : "",
               is_counted                ? "instructions a frame, counted"
               : page_is_predicted(page) ? "instructions a frame, predicted (Cortex-M0+)"
                                         : "instructions a frame: not predicted; --core counts them");
    write_card(file, compare_wrong_percent(&row->accuracy.pixels.total), 4, " %", "of pixels wrong in these views");
    write_card(file, cost->mean > 0.0 ? cost->score / cost->mean : 0.0, 1, "&#215;",
               "the mean cost, in the worst view found");
    write_card(file, 100.0 * error->score / ((double)page->request.w_px * page->request.h_px), 3, " %",
               "wrong in the view that errs most");
    fputs("</div>\n", file);
}

static void write_header(const struct page *page, FILE *file)
{
    const struct measure_request *request = &page->request;
    fputs("<header>\n<h1>", file);
    html_text(file, request->name);
    fprintf(file, "</h1>\n<p class=\"soft\">%u&#215;%u pixels, profile %s, drawn %s, tree %s.</p>\n", request->w_px,
            request->h_px, request->cores[0]->name, method_title(page->scene.report.draws),
            tree_names[page->scene.report.tree]);
    write_cards(page, file);
    fputs("<nav><a href=\"#next\">What to do next</a><a href=\"#views\">Views</a><a href=\"#worst\">Worst frames</a>"
          "<a href=\"#cost\">Cost</a><a href=\"#memory\">Memory</a><a href=\"#tree\">Tree</a>"
          "<a href=\"#front\">Choices</a></nav>\n</header>\n",
          file);
}

bool page_write(const struct page *page, FILE *file, struct error *err)
{
    write_head(page, file);
    write_header(page, file);
    fputs("<main>\n", file);
    page_advice_write(page, file);
    if (!page_views_write(page, file, err) || !page_worst_write(page, file, err)) return false;
    page_cost_write(page, file);
    page_memory_write(page, file);
    page_tree_write(page, file);
    page_front_write(page, file);
    fprintf(file,
            "</main>\n<footer>Written by <code>limner report</code> %d.%d.%d. An instruction is not a cycle: flash, "
            "multipliers and branches differ from chip to chip.</footer>\n</body>\n</html>\n",
            LIM_VERSION_MAJOR, LIM_VERSION_MINOR, LIM_VERSION_PATCH);
    return true;
}
