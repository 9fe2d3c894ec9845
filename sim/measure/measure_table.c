/* SPDX-License-Identifier: MIT
 *
 * Markdown: accuracy first, then for each processor what each renderer costs and where that goes. */
#include "measure/measure_table.h"

#include "base/front.h"
#include "core/core.h"
#include "measure/shimmer.h"

#include <math.h>
#include <string.h>

enum { ROWS_MAX = 64 };

void measure_table_judge(struct measure_table *table)
{
    struct front_choice choices[ROWS_MAX];
    size_t dominator[ROWS_MAX];
    const size_t count = table->row_count < ROWS_MAX ? table->row_count : ROWS_MAX;
    for (size_t c = 0; c < table->cpu_count; c++) {
        for (size_t i = 0; i < count; i++)
            choices[i] = (struct front_choice){compare_wrong_percent(&table->rows[i].accuracy.pixels.total),
                                               table->rows[i].costs[c].mean};
        front_find(choices, count, dominator);
        for (size_t i = 0; i < count; i++)
            table->rows[i].dominated_by[c] = dominator[i] == FRONT_NONE ? NULL : table->rows[dominator[i]].core;
    }
}

/* Markdown ----------------------------------------------------------------------------------- */

static void print_accuracy(const struct measure_row *row, FILE *out)
{
    const struct accuracy *accuracy = &row->accuracy;
    fprintf(out, "| %s | %u | %.4f | %.4f (%zu) | %.2f | %zu | %zu | %.3f | %.3f | %zu of %zu |", row->core->name,
            (unsigned)row->core->sub_bits, compare_wrong_percent(&accuracy->pixels.total),
            compare_wrong_percent(&accuracy->pixels.worst), accuracy->pixels.worst_frame,
            compare_beyond_ppm(&accuracy->pixels.total), accuracy->pixels.total.holes, accuracy->pixels.total.order,
            accuracy_vertex_rms_px(accuracy), accuracy->vertex_max_px, accuracy->sides_wrong, accuracy->sides);
    if (accuracy->shimmer.known)
        fprintf(out, " %.1f, %.1f |\n", shimmer_percent(&accuracy->shimmer.turn),
                shimmer_percent(&accuracy->shimmer.walk));
    else
        fputs(" - |\n", out);
}

static void print_scales(const struct measure_scales *scales, FILE *out)
{
    fprintf(out, "\nScales: the model is %.6g m long", scales->longest_m);
    if (scales->smallest_m > 0.0)
        fprintf(out, ", its smallest surface %.3g m, 1 to %.0f", scales->smallest_m,
                scales->longest_m / scales->smallest_m);
    fprintf(out, ". Coordinates have %u bits, a unit is %.3g m.\n", scales->coordinate_bits, scales->unit_m);
}

static void print_accuracies(const struct measure_table *table, FILE *out)
{
    fputs("| precision | sub-pixel bits | wrong, % | worst frame (its number) | beyond 1 px, ppm | holes "
          "| of these order errors | vertex error rms, px | max | wrong sides of planes | shimmer, %: turn, walk |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|\n",
          out);
    for (size_t i = 0; i < table->row_count; i++)
        print_accuracy(&table->rows[i], out);
    const struct accuracy *first = &table->rows[0].accuracy;
    if (table->drawn) fprintf(out, "\nDrawn %s: an approximate order.\n", table->drawn);
    fprintf(out, "\nVertices: those of polygons seen, where the renderer put them, against the model's own in double "
                 "precision; left out are clipped ones and those that splitting made.\n");
    fprintf(out, "%s: %zu were compared, %zu made by splitting.\n", table->rows[0].core->name, first->vertices,
            first->vertices_without_source);
    fprintf(
        out,
        "\nShimmer: of the pixels that change from one frame to the next, those that have their colour back within %d "
        "frames; in turns of %g degrees a frame, and walks of %g mm a frame, of %d frames from %d of the cameras.\n",
        SHIMMER_WITHIN, SHIMMER_TURN_DEG, 1000.0 * SHIMMER_WALK_M, SHIMMER_STEPS, SHIMMER_STARTS);
    print_scales(&table->scales, out);
}

static void print_number(const char *format, double number, FILE *out)
{
    if (isnan(number))
        fputs(" - |", out);
    else
        fprintf(out, format, number);
}

static void print_texel_row(const struct measure_table *table, const struct measure_row *row, FILE *out)
{
    const struct accuracy *accuracy = &row->accuracy;
    const bool knows_places = accuracy->texel_pixels > 0;
    fprintf(out, "| %s |", row->core->name);
    print_number(" %.3f |", knows_places ? accuracy->texel_mean : NAN, out);
    print_number(" %.2f |", knows_places ? accuracy->texel_p99 : NAN, out);
    print_number(" %.3f |", knows_places ? accuracy->texel_mean_finest : NAN, out);
    fprintf(out, " %.0f | %.3f | %.4f | %.2f |", accuracy->divisions, accuracy->texel_rms, accuracy->texel_far_percent,
            accuracy->texel_level_percent);
    print_number(" %.0f |", accuracy->texel_straight_percent, out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        fprintf(out, " %.0f |", row->costs[cpu].mean);
    fputc('\n', out);
}

/* Only scenes with textures have such a table. */
static void print_texels(const struct measure_table *table, FILE *out)
{
    const struct accuracy *first = &table->rows[0].accuracy;
    if (!first->texels_painted) return;
    fputs(
        "\n| precision | texel error mean | 99 of 100 | mean, of the whole picture | divisions a frame | rms | off by "
        "more than one, % | at another level, % | of the squares straight pieces', % |",
        out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        fprintf(out, " instructions a frame, %s |", table->cpus[cpu]->title);
    fputs("\n|---|---|---|---|---|---|---|---|---|", out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        fputs("---|", out);
    fputc('\n', out);
    for (size_t i = 0; i < table->row_count; i++)
        print_texel_row(table, &table->rows[i], out);
    fprintf(
        out,
        "\nTexels shown, at the pixels' centres, against the model's own faces in double precision: distances in "
        "texels of the level of detail shown, and of the whole picture; %zu pixels. Off by more than one is a pixel "
        "that shows neither the true texel nor one next to it; levels are compared with the nearest. Straight "
        "pieces lie between divisions: their share is what none that is straight would spare. Of a mesh no places "
        "are known: its rms is how far true ones are from the texels shown.\n",
        first->texels_painted);
}

static void print_texture_memory(const struct measure_table *table, FILE *out)
{
    if (table->rows[0].accuracy.textures_b)
        fprintf(out, "\nTextures take %zu bytes of the scene's flash.\n", table->rows[0].accuracy.textures_b);
}

static void print_kernel(double instructions, FILE *out)
{
    if (isnan(instructions))
        fputs(" - |", out);
    else
        fprintf(out, " %.1f |", instructions);
}

static void print_cost(const struct measure_row *row, size_t cpu, FILE *out)
{
    const struct cost *cost = &row->costs[cpu];
    const struct core *better = row->dominated_by[cpu];
    fprintf(out, "| %s | %.4f | %.0f | %llu (%zu) |", row->core->name,
            compare_wrong_percent(&row->accuracy.pixels.total), cost->mean, (unsigned long long)cost->worst,
            cost->worst_frame);
    print_kernel(cost->vertex, out);
    print_kernel(cost->side, out);
    fprintf(out, " %zu | %zu + %zu + %zu | %zu | %zu | %zu | %s%s |\n", cost_ram_b(cost), cost->state_b, cost->pools_b,
            cost->static_b, cost->code_b, cost->library_b, cost->scene_b, better ? "dominated by " : "front",
            better ? better->name : "");
}

static const struct cost_stage *stage_find(const struct cost *cost, const char *name)
{
    for (size_t s = 0; s < cost->stage_count; s++)
        if (strcmp(cost->stages[s].name, name) == 0) return &cost->stages[s];
    return NULL;
}

/* Whether an earlier row has the stage too, and has printed it. */
static bool is_printed(const struct measure_table *table, size_t cpu, size_t row, const char *name)
{
    for (size_t i = 0; i < row; i++)
        if (stage_find(&table->rows[i].costs[cpu], name)) return true;
    return false;
}

static void print_stage(const struct measure_table *table, size_t cpu, const char *name, FILE *out)
{
    fprintf(out, "| %s |", name);
    for (size_t i = 0; i < table->row_count; i++) {
        const struct cost_stage *stage = stage_find(&table->rows[i].costs[cpu], name);
        if (stage)
            fprintf(out, " %.0f (%.0f) |", stage->mean, stage->library);
        else
            fputs(" - |", out);
    }
    fputc('\n', out);
}

static void print_stages(const struct measure_table *table, size_t cpu, FILE *out)
{
    fputs("\nBy stage, instructions a frame (of these, the compiler's support library):\n\n| stage |", out);
    for (size_t i = 0; i < table->row_count; i++)
        fprintf(out, " %s |", table->rows[i].core->name);
    fputs("\n|---|", out);
    for (size_t i = 0; i < table->row_count; i++)
        fputs("---|", out);
    fputc('\n', out);
    for (size_t i = 0; i < table->row_count; i++)
        for (size_t s = 0; s < table->rows[i].costs[cpu].stage_count; s++)
            if (!is_printed(table, cpu, i, table->rows[i].costs[cpu].stages[s].name))
                print_stage(table, cpu, table->rows[i].costs[cpu].stages[s].name, out);
}

void measure_table_markdown(const struct measure_table *table, FILE *out)
{
    fprintf(out, "# %s, %ux%u pixels, %zu frames\n\n", table->scene, table->w_px, table->h_px,
            table->rows[0].accuracy.pixels.frames);
    print_accuracies(table, out);
    measure_refusals_print(&table->refused, "\n", out);
    print_texels(table, out);
    print_texture_memory(table, out);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++) {
        fprintf(out, "\n## %s%s%s\n\n", table->cpus[cpu]->title, table->optimise ? ", code for " : "",
                table->optimise ? table->optimise : "");
        fputs("| precision | wrong, % | instructions a frame | worst frame (its number) | a vertex | a plane test "
              "| RAM, bytes | state + pools + variables | flash: code | support library | scene | choice |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
              out);
        for (size_t i = 0; i < table->row_count; i++)
            print_cost(&table->rows[i], cpu, out);
        print_stages(table, cpu, out);
    }
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

static void csv_accuracy(const struct measure_table *table, const struct measure_row *row, FILE *out)
{
    const struct accuracy *accuracy = &row->accuracy;
    const struct comparison *pixels = &accuracy->pixels;
    print_text(table->scene, out);
    fprintf(out, ",%u,%u,%zu,%s,%u,%.6f,%.6f,%zu,%.3f,%zu,%.5f,%.5f,%zu,%zu,%zu,%zu", table->w_px, table->h_px,
            pixels->frames, row->core->name, (unsigned)row->core->sub_bits, compare_wrong_percent(&pixels->total),
            compare_wrong_percent(&pixels->worst), pixels->worst_frame, compare_beyond_ppm(&pixels->total),
            pixels->total.holes, accuracy_vertex_rms_px(accuracy), accuracy->vertex_max_px, accuracy->vertices,
            accuracy->vertices_without_source, accuracy->sides, accuracy->sides_wrong);
}

static void csv_number(double number, FILE *out)
{
    if (isnan(number))
        fputc(',', out);
    else
        fprintf(out, ",%.2f", number);
}

static void csv_cost(const struct measure_row *row, size_t cpu, const char *name, FILE *out)
{
    const struct cost *cost = &row->costs[cpu];
    const struct core *better = row->dominated_by[cpu];
    fprintf(out, ",%s,%.1f,%llu,%zu", name, cost->mean, (unsigned long long)cost->worst, cost->worst_frame);
    csv_number(cost->vertex, out);
    csv_number(cost->side, out);
    fprintf(out, ",%zu,%zu,%zu,%zu,%zu,%zu,%d,%s", cost->state_b, cost->pools_b, cost->static_b, cost->code_b,
            cost->library_b, cost->scene_b, better == NULL, better ? better->name : "");
}

/* Columns of accuracy that came later than those of cost. */
static void csv_later(const struct measure_row *row, const struct measure_scales *scales, FILE *out)
{
    const struct accuracy *accuracy = &row->accuracy;
    fprintf(out, ",%zu,%zu", accuracy->pixels.total.order, accuracy->textures_b);
    if (accuracy->texels_painted)
        fprintf(out, ",%.5f,%.5f,%.4f,", accuracy->texel_rms, accuracy->texel_far_percent,
                accuracy->texel_level_percent);
    else
        fputs(",,,,", out);
    if (accuracy->texels_painted && !isnan(accuracy->texel_straight_percent))
        fprintf(out, "%.2f", accuracy->texel_straight_percent);
    fprintf(out, ",%u,%.9g,%.9g,", scales->coordinate_bits, scales->unit_m, scales->longest_m);
    if (scales->smallest_m > 0.0) fprintf(out, "%.9g", scales->smallest_m);
    if (accuracy->shimmer.known)
        fprintf(out, ",%.4f,%.4f\n", shimmer_percent(&accuracy->shimmer.turn),
                shimmer_percent(&accuracy->shimmer.walk));
    else
        fputs(",,\n", out);
}

void measure_table_csv(const struct measure_table *table, FILE *out)
{
    fputs("scene,w_px,h_px,frames,precision,sub_bits,wrong_percent,worst_frame_percent,worst_frame,beyond_ppm,holes,"
          "vertex_rms_px,vertex_max_px,vertices,vertices_without_source,sides,sides_wrong,"
          "core,instructions,worst_instructions,worst_instructions_frame,a_vertex,a_plane_test,"
          "state_b,pools_b,static_b,code_b,library_b,scene_b,on_front,dominated_by,order_errors,textures_b,"
          "texel_rms,texel_far_percent,texel_level_percent,texel_straight_percent,coordinate_bits,unit_m,longest_m,"
          "smallest_m,shimmer_turn_percent,shimmer_walk_percent\n",
          out);
    for (size_t i = 0; i < table->row_count; i++) {
        for (size_t cpu = 0; cpu < table->cpu_count; cpu++) {
            csv_accuracy(table, &table->rows[i], out);
            csv_cost(&table->rows[i], cpu, table->cpus[cpu]->name, out);
            csv_later(&table->rows[i], &table->scales, out);
        }
        if (table->cpu_count) continue;
        csv_accuracy(table, &table->rows[i], out);
        fputs(",,,,,,,,,,,,,,", out);
        csv_later(&table->rows[i], &table->scales, out);
    }
}

void measure_table_stages_csv(const struct measure_table *table, FILE *out)
{
    fputs("scene,precision,core,stage,instructions,library,worst\n", out);
    for (size_t i = 0; i < table->row_count; i++)
        for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
            for (size_t s = 0; s < table->rows[i].costs[cpu].stage_count; s++) {
                const struct cost_stage *stage = &table->rows[i].costs[cpu].stages[s];
                print_text(table->scene, out);
                fprintf(out, ",%s,%s,%s,%.1f,%.1f,%llu\n", table->rows[i].core->name, table->cpus[cpu]->name,
                        stage->name, stage->mean, stage->library, (unsigned long long)stage->worst);
            }
}
