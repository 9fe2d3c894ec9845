/* SPDX-License-Identifier: MIT
 *
 * What is not known is a dash in the one and nothing in the other. */
#include "measure/compare_table.h"

#include "core/core.h"

bool compare_row_draws(const struct compare_row *row)
{
    return row->scene.image != NULL;
}

size_t compare_row_lines_b(const struct compare_table *table, const struct compare_row *row)
{
    const size_t line_b = (table->w_px + 1) / 2 * 4; /* each aligned for words */
    return row->method->draws == LIM_PAINTER ? table->h_px * line_b : line_b;
}

bool compare_row_is_right(const struct compare_table *table, const struct compare_row *row)
{
    return (row->accuracy.pixels.total.holes == 0 || table->core->sub_bits == 0) &&
           row->accuracy.unsettled.entries == 0;
}

static bool is_counted(const struct compare_table *table, const struct compare_row *row, size_t cpu)
{
    return !table->not_counted[cpu].text[0] && !row->not_counted[cpu].text[0];
}

static size_t open_px(const struct compare_counts *counts)
{
    return counts->holes - counts->order;
}

static double splits_a_frame(const struct accuracy *accuracy)
{
    return accuracy->pixels.frames ? (double)accuracy->splits / (double)accuracy->pixels.frames : 0.0;
}

/* Markdown ----------------------------------------------------------------------------------- */

static void print_head(const struct compare_table *table, FILE *out)
{
    fprintf(out, "# %s, %ux%u pixels, profile %s\n\n", table->scene, table->w_px, table->h_px, table->core->name);
    fputs("| method | kind | wrong, % | worst frame (its number) | order errors | holes | splits | nodes |", out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        fprintf(out, " %s: instructions a frame |", table->cpus[cpu]->title);
    fputs(" RAM, bytes | flash, bytes | of these, scene |\n|---|---|---|---|---|---|---|---|---|---|---|", out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        fputs("---|", out);
    fputc('\n', out);
}

/* Of the first processor that was counted. */
static void print_memory(const struct compare_table *table, const struct compare_row *row, FILE *out)
{
    const size_t scene_b = row->scene.report.flash_b;
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++) {
        const struct cost *cost = &row->costs[cpu];
        if (!is_counted(table, row, cpu)) continue;
        fprintf(out, " %zu | %zu | %zu |\n", cost_ram_b(cost) + compare_row_lines_b(table, row),
                cost_flash_b(cost) + cost->scene_b, cost->scene_b);
        return;
    }
    fprintf(out, " - | - | %zu |\n", scene_b);
}

static void print_splits(const struct compare_row *row, FILE *out)
{
    if (row->accuracy.splits)
        fprintf(out, " %.1f a frame |", splits_a_frame(&row->accuracy));
    else
        fprintf(out, " %zu |", row->scene.report.splits);
}

static void print_row(const struct compare_table *table, const struct compare_row *row, FILE *out)
{
    const struct comparison *pixels = &row->accuracy.pixels;
    fprintf(out, "| %s | %s | %.4f | %.4f (%zu) | %zu | %zu |", row->method->name,
            row->method->exact ? "exact" : "approximate", compare_wrong_percent(&pixels->total),
            compare_wrong_percent(&pixels->worst), pixels->worst_frame, pixels->total.order, open_px(&pixels->total));
    print_splits(row, out);
    fprintf(out, " %u |", (unsigned)row->scene.scene.node_count);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        if (is_counted(table, row, cpu))
            fprintf(out, " %.0f |", row->costs[cpu].mean);
        else
            fputs(" - |", out);
    print_memory(table, row, out);
}

/* A row of dashes; the reason is below the table. */
static void print_absent(const struct compare_table *table, const struct compare_row *row, FILE *out)
{
    fprintf(out, "| %s | %s |", row->method->name, row->method->exact ? "exact" : "approximate");
    for (size_t i = 0; i < 9 + table->cpu_count; i++)
        fputs(" - |", out);
    fputc('\n', out);
}

static void print_notes(const struct compare_table *table, FILE *out)
{
    for (size_t i = 0; i < method_count; i++) {
        const struct compare_row *row = &table->rows[i];
        if (!compare_row_draws(row)) fprintf(out, "%s: %s\n", row->method->name, row->why_not.text);
        if (row->accuracy.unsettled.entries) unsettled_print(&row->accuracy.unsettled, row->method->name, out);
        if (compare_row_draws(row) && row->method->exact && !compare_row_is_right(table, row))
            fprintf(out, "%s: wrong, and it should be exact\n", row->method->name);
        for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
            if (row->not_counted[cpu].text[0])
                fprintf(out, "%s: not counted: %s\n", row->method->name, row->not_counted[cpu].text);
    }
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        if (table->not_counted[cpu].text[0])
            fprintf(out, "%s: not counted: %s\n", table->cpus[cpu]->title, table->not_counted[cpu].text);
}

void compare_table_markdown(const struct compare_table *table, FILE *out)
{
    print_head(table, out);
    for (size_t i = 0; i < method_count; i++)
        if (compare_row_draws(&table->rows[i]))
            print_row(table, &table->rows[i], out);
        else
            print_absent(table, &table->rows[i], out);
    fprintf(out, "\nPixels: %zu frames against the reference in double precision.", table->frames);
    if (table->cost_frames) fprintf(out, " Instructions: %zu frames.", table->cost_frames);
    fputs(" Order errors: pixels that show\na face farther than all that an edge a pixel off explains; holes: the "
          "background instead. RAM includes the lines that the target lends.\n\n",
          out);
    print_notes(table, out);
}

/* CSV ---------------------------------------------------------------------------------------- */

/* RFC 4180: in quotes, quotes doubled. */
static void print_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"') fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

static void csv_head(const struct compare_table *table, FILE *out)
{
    fputs("scene,w_px,h_px,precision,method,exact,frames,wrong_percent,worst_frame_percent,worst_frame,beyond_ppm,"
          "order_errors,holes,splits,splits_a_frame,forced,nodes,polygons,scene_b,lines_b,cost_frames",
          out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++) {
        const char *name = table->cpus[cpu]->name;
        fprintf(out, ",%s_instructions,%s_worst_instructions,%s_ram_b,%s_flash_b", name, name, name, name);
    }
    fputs(",why_not\n", out);
}

static void csv_pixels(const struct compare_table *table, const struct compare_row *row, FILE *out)
{
    const struct comparison *pixels = &row->accuracy.pixels;
    fprintf(out, ",%zu,%.6f,%.6f,%zu,%.3f,%zu,%zu", pixels->frames, compare_wrong_percent(&pixels->total),
            compare_wrong_percent(&pixels->worst), pixels->worst_frame, compare_beyond_ppm(&pixels->total),
            pixels->total.order, open_px(&pixels->total));
    fprintf(out, ",%zu,%.2f,%zu,%u,%u,%zu,%zu,%zu", row->scene.report.splits, splits_a_frame(&row->accuracy),
            row->accuracy.unsettled.entries, (unsigned)row->scene.scene.node_count,
            (unsigned)row->scene.scene.polygon_count, row->scene.report.flash_b, compare_row_lines_b(table, row),
            table->cost_frames);
}

static void csv_row(const struct compare_table *table, const struct compare_row *row, FILE *out)
{
    const bool draws = compare_row_draws(row);
    print_text(table->scene, out);
    fprintf(out, ",%u,%u,%s,%s,%d", table->w_px, table->h_px, table->core->name, row->method->name, row->method->exact);
    if (draws)
        csv_pixels(table, row, out);
    else
        fputs(",,,,,,,,,,,,,,,", out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++) {
        const struct cost *cost = &row->costs[cpu];
        if (draws && is_counted(table, row, cpu))
            fprintf(out, ",%.1f,%llu,%zu,%zu", cost->mean, (unsigned long long)cost->worst,
                    cost_ram_b(cost) + compare_row_lines_b(table, row), cost_flash_b(cost) + cost->scene_b);
        else
            fputs(",,,,", out);
    }
    fputc(',', out);
    print_text(row->why_not.text, out);
    fputc('\n', out);
}

void compare_table_csv(const struct compare_table *table, FILE *out)
{
    csv_head(table, out);
    for (size_t i = 0; i < method_count; i++)
        csv_row(table, &table->rows[i], out);
}
