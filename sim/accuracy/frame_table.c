/* SPDX-License-Identifier: MIT
 *
 * One table of columns, each a name, a format and where the number comes from; mean and worst
 * follow from it. */
#include "accuracy/frame_table.h"

#include "render/frame_cost.h"

struct column {
    const char *name;
    int width, decimals;
    double (*value)(const struct frame_row *row);
};

#define STATS_VALUE(field)                                                                                             \
    static double stats_##field(const struct frame_row *row)                                                           \
    {                                                                                                                  \
        return row->stats.field;                                                                                       \
    }
STATS_VALUE(nodes)
STATS_VALUE(records)
STATS_VALUE(boxes)
STATS_VALUE(boxes_out)
STATS_VALUE(polygons)
STATS_VALUE(polygons_seen)
STATS_VALUE(vertices)
STATS_VALUE(clipped)
STATS_VALUE(non_monotone)
STATS_VALUE(lines)
STATS_VALUE(pixels_deep)
STATS_VALUE(bands)
STATS_VALUE(retained_cells_max)
STATS_VALUE(gaps_max)
STATS_VALUE(active_max)

static double overdraw(const struct frame_row *row)
{
    const double written = (double)row->stats.pixels_painted + row->stats.pixels_background;
    return row->pixels ? written / (double)row->pixels : 1.0;
}

static double bus_b(const struct frame_row *row)
{
    return (double)row->bus_b;
}

static double wrong_percent(const struct frame_row *row)
{
    return compare_wrong_percent(&row->compare);
}

static double wrong_pixels(const struct frame_row *row)
{
    return (double)row->compare.wrong;
}

static double beyond_pixels(const struct frame_row *row)
{
    return (double)row->compare.beyond;
}

static double hole_pixels(const struct frame_row *row)
{
    return (double)row->compare.holes;
}

static const struct column STATS_COLUMNS[] = {
    {"nodes", 7, 0, stats_nodes},
    {"records", 7, 0, stats_records},
    {"boxes", 7, 0, stats_boxes},
    {"out", 6, 0, stats_boxes_out},
    {"polygons", 8, 0, stats_polygons},
    {"seen", 6, 0, stats_polygons_seen},
    {"vertices", 8, 0, stats_vertices},
    {"clipped", 7, 0, stats_clipped},
    {"non-mono", 8, 0, stats_non_monotone},
    {"lines", 7, 0, stats_lines},
    {"overdraw", 8, 3, overdraw},
    {"deep_px", 7, 0, stats_pixels_deep},
    {"bands", 5, 0, stats_bands},
    {"retained", 8, 0, stats_retained_cells_max},
    {"gaps", 6, 0, stats_gaps_max},
    {"active", 6, 0, stats_active_max},
    {"bus_b", 8, 0, bus_b},
};

#define DELTA_VALUE(field)                                                                                             \
    static double delta_##field(const struct frame_row *row)                                                           \
    {                                                                                                                  \
        return row->stats.delta.field;                                                                                 \
    }
DELTA_VALUE(pixels)
DELTA_VALUE(windows)
DELTA_VALUE(runs_max)
DELTA_VALUE(lines_whole)

static const struct column DELTA_COLUMNS[] = {
    {"sent_px", 8, 0, delta_pixels},    {"windows", 8, 0, delta_windows}, {"runs", 6, 0, delta_runs_max},
    {"whole", 6, 0, delta_lines_whole}, {"bus_b", 8, 0, bus_b},
};

#define NEWELL_VALUE(name, field)                                                                                      \
    static double newell_##name(const struct frame_row *row)                                                           \
    {                                                                                                                  \
        return row->stats.newell.field;                                                                                \
    }
STATS_VALUE(sorted)
NEWELL_VALUE(comparisons, comparisons)
NEWELL_VALUE(x, decided[LIM_TEST_X])
NEWELL_VALUE(y, decided[LIM_TEST_Y])
NEWELL_VALUE(p_behind, decided[LIM_TEST_P_BEHIND])
NEWELL_VALUE(q_in_front, decided[LIM_TEST_Q_IN_FRONT])
NEWELL_VALUE(apart, decided[LIM_TEST_APART])
NEWELL_VALUE(q_behind, decided[LIM_TEST_Q_BEHIND])
NEWELL_VALUE(p_in_front, decided[LIM_TEST_P_IN_FRONT])
NEWELL_VALUE(swaps, swaps)
NEWELL_VALUE(splits, splits)
NEWELL_VALUE(p_part, decided[LIM_TEST_P_PART])
NEWELL_VALUE(p_rest, decided[LIM_TEST_P_REST])
NEWELL_VALUE(divisions, divisions)
NEWELL_VALUE(forced, forced)

static const struct column NEWELL_COLUMNS[] = {
    {"sorted", 7, 0, stats_sorted},
    {"compared", 9, 0, newell_comparisons},
    {"1:x", 8, 0, newell_x},
    {"2:y", 8, 0, newell_y},
    {"3:P_behind", 10, 0, newell_p_behind},
    {"4:Q_front", 9, 0, newell_q_in_front},
    {"5:apart", 8, 0, newell_apart},
    {"6:part", 7, 0, newell_p_part},
    {"3':Q_behind", 11, 0, newell_q_behind},
    {"4':P_front", 10, 0, newell_p_in_front},
    {"6':rest", 8, 0, newell_p_rest},
    {"swaps", 6, 0, newell_swaps},
    {"splits", 6, 0, newell_splits},
    {"divided", 7, 0, newell_divisions},
    {"forced", 6, 0, newell_forced},
};

#define MOVER_VALUE(field)                                                                                             \
    static double mover_##field(const struct frame_row *row)                                                           \
    {                                                                                                                  \
        return row->stats.movers.field;                                                                                \
    }
MOVER_VALUE(left_out)
MOVER_VALUE(hidden)
MOVER_VALUE(crowded)
MOVER_VALUE(comparisons)
MOVER_VALUE(cuts)

static const struct column MOVER_COLUMNS[] = {
    {"left_out", 8, 0, mover_left_out},    {"hidden", 7, 0, mover_hidden}, {"crowded", 7, 0, mover_crowded},
    {"compared", 9, 0, mover_comparisons}, {"cuts", 7, 0, mover_cuts},
};

static const struct column COMPARE_COLUMNS[] = {
    {"wrong_px", 8, 0, wrong_pixels},
    {"wrong_%", 8, 4, wrong_percent},
    {"beyond_px", 9, 0, beyond_pixels},
    {"holes_px", 8, 0, hole_pixels},
};

static double edge_pixels(const struct frame_row *row)
{
    return (double)row->edges.pixels;
}

static double aliased_error(const struct frame_row *row)
{
    return edge_error_mean(&row->edges, EDGE_ERROR_ALIASED);
}

static double smooth_error(const struct frame_row *row)
{
    return edge_error_mean(&row->edges, EDGE_ERROR_SMOOTH);
}

static double rounding_error(const struct frame_row *row)
{
    return edge_error_mean(&row->edges, EDGE_ERROR_ROUNDED);
}

static const struct column EDGE_COLUMNS[] = {{"edge_px", 8, 0, edge_pixels},
                                             {"aliased", 8, 3, aliased_error},
                                             {"antialiased", 11, 3, smooth_error},
                                             {"rounding", 8, 3, rounding_error}};

static double column_mean(const struct column *column, const struct frame_row *rows, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++)
        sum += column->value(&rows[i]);
    return sum / (double)count;
}

static double column_worst(const struct column *column, const struct frame_row *rows, size_t count)
{
    double worst = column->value(&rows[0]);
    for (size_t i = 1; i < count; i++)
        if (column->value(&rows[i]) > worst) worst = column->value(&rows[i]);
    return worst;
}

static void print_table(const struct column *columns, size_t column_count, const struct frame_rows *of, FILE *out)
{
    const struct frame_row *rows = of->rows;
    const size_t count = of->count;
    fprintf(out, "%5s", "frame");
    for (size_t c = 0; c < column_count; c++)
        fprintf(out, " %*s", columns[c].width, columns[c].name);
    for (size_t i = 0; i < count && !of->is_brief; i++) {
        fprintf(out, "\n%5zu", i);
        for (size_t c = 0; c < column_count; c++)
            fprintf(out, " %*.*f", columns[c].width, columns[c].decimals, columns[c].value(&rows[i]));
    }
    fprintf(out, "\n%5s", "mean");
    for (size_t c = 0; c < column_count; c++) {
        int decimals = columns[c].decimals ? columns[c].decimals : 1;
        fprintf(out, " %*.*f", columns[c].width, decimals, column_mean(&columns[c], rows, count));
    }
    fprintf(out, "\n%5s", "worst");
    for (size_t c = 0; c < column_count; c++)
        fprintf(out, " %*.*f", columns[c].width, columns[c].decimals, column_worst(&columns[c], rows, count));
    fputc('\n', out);
}

void frame_table_print_stats(const struct frame_rows *rows, FILE *out)
{
    print_table(STATS_COLUMNS, sizeof STATS_COLUMNS / sizeof STATS_COLUMNS[0], rows, out);
}

/* The first frame is whole. */
void frame_table_print_delta(const struct frame_rows *of, FILE *out)
{
    const struct frame_row *rows = of->rows;
    const size_t count = of->count;
    const struct column bytes = {"bus_b", 8, 0, bus_b};
    print_table(DELTA_COLUMNS, sizeof DELTA_COLUMNS / sizeof DELTA_COLUMNS[0], of, out);
    if (count < 2 || !rows[0].bus_b) return;
    fprintf(out, "delta: %.2f %% of the first frame's bytes, which is whole; worst %.2f %%\n",
            100.0 * column_mean(&bytes, rows + 1, count - 1) / (double)rows[0].bus_b,
            100.0 * column_worst(&bytes, rows + 1, count - 1) / (double)rows[0].bus_b);
}

void frame_table_print_movers(const struct frame_rows *rows, FILE *out)
{
    print_table(MOVER_COLUMNS, sizeof MOVER_COLUMNS / sizeof MOVER_COLUMNS[0], rows, out);
}

void frame_table_print_predicted(const struct frame_rows *of, const struct lim_target *target, FILE *out)
{
    const struct frame_row *rows = of->rows;
    const size_t count = of->count;
    double sum = 0.0, worst = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double cost = frame_cost_m0plus(&rows[i].stats, target);
        sum += cost;
        if (cost > worst) worst = cost;
    }
    if (count)
        fprintf(out, "predicted for Cortex-M0+, profile fast: %.0f instructions a frame\n  in the worst: %.0f\n",
                sum / (double)count, worst);
}

void frame_table_print_newell(const struct frame_rows *rows, FILE *out)
{
    print_table(NEWELL_COLUMNS, sizeof NEWELL_COLUMNS / sizeof NEWELL_COLUMNS[0], rows, out);
}

void frame_table_print_compare(const struct frame_rows *of, FILE *out)
{
    const struct frame_row *rows = of->rows;
    const size_t count = of->count;
    struct comparison sum = {0};
    for (size_t i = 0; i < count; i++)
        comparison_add(&sum, &rows[i].compare);
    print_table(COMPARE_COLUMNS, sizeof COMPARE_COLUMNS / sizeof COMPARE_COLUMNS[0], of, out);
    fprintf(out,
            "compared with the reference: %zu frames, wrong %.4f %% (worst %.4f %%, frame %zu), "
            "beyond a one-pixel shift %.2f ppm, holes %zu\n",
            count, compare_wrong_percent(&sum.total), compare_wrong_percent(&sum.worst), sum.worst_frame,
            compare_beyond_ppm(&sum.total), sum.total.holes);
}

void frame_table_print_edges(const struct frame_rows *of, FILE *out)
{
    const struct frame_row *rows = of->rows;
    const size_t count = of->count;
    struct edge_error_sum sum = {0};
    for (size_t i = 0; i < count; i++) {
        sum.pixels += rows[i].edges.pixels;
        for (int picture = 0; picture < EDGE_ERRORS; picture++)
            sum.error[picture] += rows[i].edges.error[picture];
    }
    const double aliased = edge_error_mean(&sum, EDGE_ERROR_ALIASED), smooth = edge_error_mean(&sum, EDGE_ERROR_SMOOTH);
    print_table(EDGE_COLUMNS, sizeof EDGE_COLUMNS / sizeof EDGE_COLUMNS[0], of, out);
    fprintf(out,
            "edges against %d rays a pixel in double precision: %zu pixels, mean absolute error %.3f of 255 aliased, "
            "%.3f antialiased: %.1f %% (%.3f is the panel's rounding)\n",
            EDGE_ERROR_LATTICE * EDGE_ERROR_LATTICE, sum.pixels, aliased, smooth,
            aliased > 0.0 ? 100.0 * smooth / aliased : 0.0, edge_error_mean(&sum, EDGE_ERROR_ROUNDED));
}
