/* SPDX-License-Identifier: MIT
 *
 * Bytes by part, and the boards that have them. */
#include "page/html.h"
#include "page/page.h"
#include "page/page_board.h"
#include "scene/mcu_mem.h"
#include "scene/mem_parts.h"
#include "scene/moving.h"

static void begin_table(FILE *file, const char *first)
{
    fprintf(file,
            "<div class=\"wide\"><table>\n<thead><tr><th>%s</th><th>how many</th><th>bytes</th><th></th></tr></thead>\n"
            "<tbody>\n",
            first);
}

/* Half of all of it fills the bar. */
static void write_part(FILE *file, const char *name, size_t count, size_t size_b, size_t all_b)
{
    if (!size_b) return;
    html_row_begin(file, name);
    if (count)
        html_cell(file, (double)count, 0);
    else
        fputs("<td></td>", file);
    html_cell(file, (double)size_b, 0);
    html_bar(file, 2.0 * (double)size_b / (double)all_b);
    html_row_end(file);
}

static void end_table(FILE *file, size_t all_b)
{
    fputs("<tr class=\"sum\"><th scope=\"row\">in all</th><td></td>", file);
    html_cell(file, (double)all_b, 0);
    fputs("<td></td></tr>\n</tbody></table></div>\n", file);
}

static void write_flash(const struct page *page, FILE *file)
{
    const struct compiled *scene = &page->scene;
    const size_t all_b = page_flash_b(page);
    struct mem_part parts[FLASH_PARTS_MAX];
    const size_t count = flash_parts(scene, parts);
    size_t sum_b = 0;
    begin_table(file, "flash, by array");
    for (size_t i = 0; i < count; i++) {
        write_part(file, parts[i].name, parts[i].count, parts[i].size_b, all_b);
        sum_b += parts[i].size_b;
    }
    write_part(file, "what names them, and the rest", 0, scene->report.flash_b - sum_b, all_b);
    if (scene->moving) write_part(file, "what moves", scene->moving->count, all_b - scene->report.flash_b, all_b);
    end_table(file, all_b);
    if (!scene->scene.texture_count) return;
    fputs("<p class=\"soft\">Textures take ", file);
    html_number(file, (double)texture_memory_b(&scene->scene), 0);
    fputs(" bytes of it, palettes included; <code>--texture-budget KB</code> makes them fit.</p>\n", file);
}

static void write_ram(const struct page *page, FILE *file)
{
    const struct compiled *scene = &page->scene;
    const size_t all_b = page_ram_b(page, scene);
    struct mem_part parts[RAM_PARTS_MAX];
    const size_t count = ram_parts(scene, parts);
    begin_table(file, "RAM, by pool");
    for (size_t i = 0; i < count; i++)
        write_part(file, parts[i].name, parts[i].count, parts[i].size_b, all_b);
    if (scene->moving)
        write_part(file, "what moves", scene->moving->count, mcu_movers_mem_b(scene, scene->moving), all_b);
    const size_t pixels_b = page_pixels_b(page, scene);
    write_part(file, pixels_b > 4 * (size_t)page->request.w_px ? "all pixels" : "a line of pixels", 0, pixels_b, all_b);
    end_table(file, all_b);
    fputs("<p class=\"soft\">With ", file);
    html_number(file, (double)(all_b - mcu_mem_b(scene) + mcu_mem_min_b(scene)), 0);
    fputs(" bytes, the least, frames are the same and take more walks of the tree.</p>\n", file);
}

static void write_boards(const struct page *page, FILE *file)
{
    static const char *const words[] = {[PAGE_FITS] = "<span class=\"good\">fits</span>",
                                        [PAGE_FITS_SLOWLY] = "fits with shorter pools: the same frames for more time",
                                        [PAGE_NO_RAM] = "<span class=\"bad\">too little RAM</span>",
                                        [PAGE_NO_FLASH] = "<span class=\"bad\">too little flash</span>"};
    fprintf(
        file,
        "<h3>Boards</h3>\n<p class=\"soft\">With %d KB of flash for renderer and driver and %d KB of RAM for these and "
        "the stack, about; <code>make BOARD=NAME</code> says exactly.</p>\n"
        "<div class=\"wide\"><table>\n<thead><tr><th>board</th><th>RAM, KB</th><th>flash, KB</th><th "
        "class=\"word\">this scene</th>"
        "</tr></thead>\n<tbody>\n",
        PAGE_BOARD_CODE_B >> 10, PAGE_BOARD_RAM_B >> 10);
    for (size_t i = 0; i < page_board_count; i++) {
        const struct page_board *board = &page_boards[i];
        html_row_begin(file, board->title);
        html_cell(file, (double)board->ram_b / 1024.0, 1);
        if (board->flash_b)
            html_cell(file, (double)board->flash_b / 1024.0, 0);
        else
            fputs("<td></td>", file);
        fprintf(file, "<td class=\"word\">%s</td>", words[page_board_fit(page, board)]);
        html_row_end(file);
    }
    fputs("</tbody></table></div>\n", file);
}

void page_memory_write(const struct page *page, FILE *file)
{
    html_section(file, "memory", "Memory");
    fputs("<div class=\"pair\"><div>\n", file);
    write_flash(page, file);
    fputs("</div><div>\n", file);
    write_ram(page, file);
    fputs("</div></div>\n", file);
    write_boards(page, file);
    html_section_end(file);
}
