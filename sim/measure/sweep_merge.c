/* SPDX-License-Identifier: MIT
 *
 * Columns are found by their names in the header. */
#include "measure/sweep_merge.h"

#include "base/front.h"
#include "base/grow.h"
#include "measure/result_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Lines --------------------------------------------------------------------------------------- */

static char *copy_of(const char *text, size_t length)
{
    char *copy = grow_zeroed(length + 1, 1);
    memcpy(copy, text, length);
    return copy;
}

/* Behind a field, its comma or the line's end not included; commas in quotes are the field's. */
static const char *field_end(const char *at)
{
    for (bool quoted = false; *at && *at != '\n' && (quoted || *at != ','); at++)
        quoted ^= *at == '"';
    return at;
}

/* Field number `index` of a line, the caller's. */
static char *field(const char *line, size_t index)
{
    for (const char *end = field_end(line);; line = end + 1, end = field_end(line)) {
        if (!index--) return copy_of(line, (size_t)(end - line));
        if (*end != ',') return copy_of("", 0);
    }
}

static size_t column(const char *header, const char *name)
{
    size_t index = 0;
    for (const char *end = field_end(header);; header = end + 1, end = field_end(header), index++)
        if ((strlen(name) == (size_t)(end - header) && strncmp(header, name, strlen(name)) == 0) || *end != ',')
            return index;
}

static double number(const char *header, const char *line, const char *name)
{
    char *text = field(line, column(header, name)), *end;
    const double value = strtod(text, &end);
    const bool is_one = end != text;
    free(text);
    return is_one ? value : NAN;
}

/* Rows ---------------------------------------------------------------------------------------- */

static void add_row(struct sweep *sweep, const struct result_file *result, const char *line)
{
    sweep->rows = grow(sweep->rows, sweep->count, &sweep->capacity, sizeof *sweep->rows);
    sweep->rows[sweep->count++] = (struct sweep_row){.model = copy_of(result->model, strlen(result->model)),
                                                     .method = copy_of(result->method, strlen(result->method)),
                                                     .precision = field(line, column(sweep->header, "precision")),
                                                     .core = field(line, column(sweep->header, "core")),
                                                     .wrong_percent = number(sweep->header, line, "wrong_percent"),
                                                     .instructions = number(sweep->header, line, "instructions"),
                                                     .line = copy_of(line, strcspn(line, "\n"))};
}

/* The first result says what the others must agree with. */
static bool agrees(struct sweep *sweep, const struct result_file *result, const char *path, struct error *err)
{
    const size_t header_b = strcspn(result->csv, "\n");
    if (!sweep->header) {
        sweep->header = copy_of(result->csv, header_b);
        sweep->version = copy_of(result->version, strlen(result->version));
    }
    if (strcmp(sweep->version, result->version) != 0)
        return error_set(err, "%s: measured by version %s, others by %s; run its job again", path, result->version,
                         sweep->version);
    return (strlen(sweep->header) == header_b && strncmp(sweep->header, result->csv, header_b) == 0) ||
           error_set(err, "%s: has other columns than the first result; run its job again", path);
}

bool sweep_add(struct sweep *sweep, const char *path, struct error *err)
{
    struct result_file result;
    if (!result_file_read(path, &result, err)) return false;
    const bool ok = agrees(sweep, &result, path, err) && result_file_check_inputs(&result, path, err);
    const char *line = ok ? strchr(result.csv, '\n') : NULL;
    for (line = line ? line + 1 : ""; *line; line = strchr(line, '\n') + 1)
        add_row(sweep, &result, line);
    result_file_free(&result);
    return ok;
}

/* Fronts --------------------------------------------------------------------------------------- */

/* Whether no other row that `rivals` allows is better. */
static bool is_on_front(const struct sweep_row *rows, size_t count, size_t at,
                        bool (*rivals)(const struct sweep_row *a, const struct sweep_row *b))
{
    const struct sweep_row *row = &rows[at];
    struct front_choice pair[2] = {{row->wrong_percent, row->instructions}};
    size_t dominator[2];
    if (isnan(row->instructions)) return false;
    for (size_t i = 0; i < count; i++) {
        if (i == at || isnan(rows[i].instructions) || !rivals(row, &rows[i])) continue;
        pair[1] = (struct front_choice){rows[i].wrong_percent, rows[i].instructions};
        front_find(pair, 2, dominator);
        if (dominator[0] != FRONT_NONE) return false;
    }
    return true;
}

static bool are_of_one_core(const struct sweep_row *a, const struct sweep_row *b)
{
    return strcmp(a->core, b->core) == 0;
}

static bool are_of_one_model(const struct sweep_row *a, const struct sweep_row *b)
{
    return are_of_one_core(a, b) && strcmp(a->model, b->model) == 0;
}

static bool have_one_setting(const struct sweep_row *a, const struct sweep_row *b)
{
    return are_of_one_core(a, b) && strcmp(a->method, b->method) == 0 && strcmp(a->precision, b->precision) == 0;
}

/* RFC 4180. */
static void write_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"') fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

void sweep_write(const struct sweep *sweep, FILE *out)
{
    fprintf(out, "model,method,on_models_front,%s\n", sweep->header);
    for (size_t i = 0; i < sweep->count; i++) {
        const struct sweep_row *row = &sweep->rows[i];
        write_text(row->model, out);
        fprintf(out, ",%s,", row->method);
        if (!isnan(row->instructions))
            fputc(is_on_front(sweep->rows, sweep->count, i, are_of_one_model) ? '1' : '0', out);
        fprintf(out, ",%s\n", row->line);
    }
}

/* The means of a setting; line: none. */
static struct sweep_row mean_of(const struct sweep *sweep, const struct sweep_row *setting)
{
    struct sweep_row mean = *setting;
    size_t count = 0;
    mean.wrong_percent = mean.instructions = 0.0;
    for (size_t i = 0; i < sweep->count; i++) {
        if (!have_one_setting(&sweep->rows[i], setting)) continue;
        mean.wrong_percent += sweep->rows[i].wrong_percent;
        mean.instructions += sweep->rows[i].instructions;
        count++;
    }
    mean.wrong_percent /= (double)count;
    mean.instructions /= (double)count;
    return mean;
}

static bool has_row(const struct sweep_row *rows, size_t count, const struct sweep_row *setting)
{
    for (size_t i = 0; i < count; i++)
        if (have_one_setting(&rows[i], setting)) return true;
    return false;
}

bool sweep_write_front(const struct sweep *sweep, FILE *out)
{
    struct sweep_row *means = grow_zeroed(sweep->count, sizeof *means);
    size_t count = 0;
    for (size_t i = 0; i < sweep->count; i++)
        if (!isnan(sweep->rows[i].instructions) && !has_row(means, count, &sweep->rows[i]))
            means[count++] = mean_of(sweep, &sweep->rows[i]);
    fputs("core,precision,wrong_percent,instructions,on_front\n", out);
    for (size_t i = 0; i < count; i++)
        fprintf(out, "%s,%s %s,%.6f,%.1f,%d\n", means[i].core, means[i].method, means[i].precision,
                means[i].wrong_percent, means[i].instructions, is_on_front(means, count, i, are_of_one_core));
    free(means);
    return count > 0;
}

size_t sweep_cores(const struct sweep *sweep, const char **found, size_t most)
{
    size_t count = 0;
    for (size_t i = 0; i < sweep->count; i++) {
        size_t k = 0;
        while (k < count && strcmp(found[k], sweep->rows[i].core) != 0)
            k++;
        if (k == count && count < most && *sweep->rows[i].core) found[count++] = sweep->rows[i].core;
    }
    return count;
}

void sweep_free(struct sweep *sweep)
{
    for (size_t i = 0; i < sweep->count; i++) {
        free(sweep->rows[i].model);
        free(sweep->rows[i].method);
        free(sweep->rows[i].precision);
        free(sweep->rows[i].core);
        free(sweep->rows[i].line);
    }
    free(sweep->rows);
    free(sweep->header);
    free(sweep->version);
    *sweep = (struct sweep){0};
}
