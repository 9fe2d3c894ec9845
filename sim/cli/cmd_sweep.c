/* SPDX-License-Identifier: MIT
 *
 * `limner sweep MODEL... -o DIR`: plans a `limner measure` for each model and setting, as a file of commands that
 * others run: a shell, GNU parallel, Slurm. `limner sweep --merge DIR` joins what these have written. */
#include "base/arguments.h"
#include "base/child.h"
#include "base/grow.h"
#include "cli/commands.h"
#include "measure/measure_request.h"
#include "measure/sweep_results.h"
#include "outputs/outputs.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_MAX_B = 1024, SETTINGS_MAX = 64, WORD_B = 32, MORE_WORDS = 8 };
static const char PROFILES[] = "draft,fast,fine,exact", METHOD_AUTO[] = "auto";

struct sweeping {
    const char *folder;
    char program[CHILD_PATH_B];
    char **options, **models;
    size_t option_count, model_count;
    char precisions[SETTINGS_MAX][WORD_B], methods[SETTINGS_MAX][WORD_B];
    size_t precision_count, method_count;
    size_t number; /* of jobs so far */
    struct outputs outputs;
    FILE *jobs, *results;
};

/* The command line ------------------------------------------------------------------------------- */

static bool parse_list(const char *option, const char *text, char names[SETTINGS_MAX][WORD_B], size_t *count,
                       struct error *err)
{
    for (*count = 0;; text++) {
        const size_t length = strcspn(text, ",");
        if (!length || length >= WORD_B) return error_set(err, "%s: names, divided by commas", option);
        if (*count == SETTINGS_MAX) return error_set(err, "%s: %d names at most", option, SETTINGS_MAX);
        snprintf(names[(*count)++], WORD_B, "%.*s", (int)length, text);
        text += length;
        if (!*text) return true;
    }
}

static bool find_program(struct sweeping *sweeping, struct error *err)
{
    return child_own_path(sweeping->program) ||
           error_set(err, "sweep: cannot find out where this program is: %s", strerror(errno));
}

/* -o, which getopt would take for an option of measure. */
static bool take_folder(struct arguments *arguments, const char **folder, struct error *err)
{
    for (int i = 1; i < arguments->count; i++) {
        if (strcmp(arguments->items[i], "-o") != 0) continue;
        if (i + 1 == arguments->count) return error_set(err, "-o: needs a value");
        *folder = arguments->items[i + 1];
        memmove(&arguments->items[i], &arguments->items[i + 2],
                (size_t)(arguments->count - i - 1) * sizeof *arguments->items);
        arguments->count -= 2;
        break;
    }
    return (*folder && **folder) || error_set(err, "sweep: needs -o DIR, where jobs and their results go");
}

static bool parse(struct sweeping *sweeping, struct arguments *arguments, struct error *err)
{
    const char *precisions = PROFILES, *listed = METHOD_AUTO;
    int words_from;
    if (!arguments_value(arguments, "--precision", &precisions, err) ||
        !arguments_value(arguments, "--method", &listed, err) ||
        !measure_request_order(arguments->count, arguments->items, &words_from, err) ||
        !take_folder(arguments, &sweeping->folder, err) ||
        !parse_list("--precision", precisions, sweeping->precisions, &sweeping->precision_count, err) ||
        !parse_list("--method", listed, sweeping->methods, &sweeping->method_count, err) ||
        !measure_request_order(arguments->count, arguments->items, &words_from, err))
        return false;
    sweeping->options = arguments->items + 1;
    sweeping->option_count = (size_t)(words_from - 1);
    sweeping->models = arguments->items + words_from;
    sweeping->model_count = (size_t)(arguments->count - words_from);
    return (sweeping->model_count || error_set(err, "sweep: needs a model")) && find_program(sweeping, err);
}

/* Jobs ------------------------------------------------------------------------------------------- */

/* One word of a shell. */
static void write_word(const char *word, FILE *out)
{
    fputs(" '", out);
    for (; *word; word++)
        if (*word == '\'')
            fputs("'\\''", out);
        else
            fputc(*word, out);
    fputc('\'', out);
}

/* What measure would refuse is refused before there are jobs. */
static bool check_job(char **words, size_t count, struct error *err)
{
    struct measure_request request;
    char **argv = grow_zeroed(count + 1, sizeof *argv);
    memcpy(argv, words, count * sizeof *argv); /* the parser changes their order */
    const bool ok = measure_request_parse((int)count, argv, MEASURE_PRECISIONS, &request, err);
    compile_options_free(&request.compile);
    free(argv);
    return ok;
}

/* The words of a job's command line behind the program's name; there is room for MORE_WORDS beside the options. */
static size_t name_words(const struct sweeping *sweeping, char *model, char *method, char *precision, char *result,
                         char **words)
{
    size_t count = 0;
    words[count++] = "measure";
    for (size_t i = 0; i < sweeping->option_count; i++)
        words[count++] = sweeping->options[i];
    words[count++] = "--precision";
    words[count++] = precision;
    if (strcmp(method, METHOD_AUTO) != 0) {
        words[count++] = "--method";
        words[count++] = method;
    }
    words[count++] = "--result";
    words[count++] = result;
    words[count++] = model;
    return count;
}

static void write_command(const struct sweeping *sweeping, char **words, size_t count)
{
    write_word(sweeping->program, sweeping->jobs);
    for (size_t i = 0; i < count; i++)
        write_word(words[i], sweeping->jobs);
    fputs(" >/dev/null\n", sweeping->jobs);
}

static bool write_job(struct sweeping *sweeping, char *model, char *method, char *precision, struct error *err)
{
    char result[PATH_MAX_B], name[32];
    snprintf(name, sizeof name, "results/%06zu", ++sweeping->number);
    if (snprintf(result, sizeof result, "%s/%s", sweeping->folder, name) >= PATH_MAX_B)
        return error_set(err, "-o '%.64s...': the path is too long", sweeping->folder);
    if (strpbrk(model, "\n")) return error_set(err, "sweep: a model's name has a line's end, and jobs are lines");
    char **words = grow_zeroed(sweeping->option_count + MORE_WORDS, sizeof *words);
    const size_t count = name_words(sweeping, model, method, precision, result, words);
    const bool ok = check_job(words, count, err);
    if (ok) write_command(sweeping, words, count);
    if (ok) fprintf(sweeping->results, "%s\n", name);
    free(words);
    return ok;
}

static bool write_jobs(struct sweeping *sweeping, struct error *err)
{
    for (size_t m = 0; m < sweeping->model_count; m++)
        for (size_t i = 0; i < sweeping->method_count; i++)
            for (size_t k = 0; k < sweeping->precision_count; k++)
                if (!write_job(sweeping, sweeping->models[m], sweeping->methods[i], sweeping->precisions[k], err))
                    return false;
    return true;
}

static FILE *open_in(struct outputs *outputs, const char *folder, const char *name, char path[PATH_MAX_B],
                     struct error *err)
{
    if (snprintf(path, PATH_MAX_B, "%s/%s", folder, name) < PATH_MAX_B) return outputs_open(outputs, path, err);
    error_set(err, "-o '%.64s...': the path is too long", folder);
    return NULL;
}

/* Jobs of an array, each a line of the list. */
static bool write_array(struct sweeping *sweeping, struct error *err)
{
    char path[PATH_MAX_B];
    FILE *file = open_in(&sweeping->outputs, sweeping->folder, "slurm.sh", path, err);
    if (!file) return false;
    fprintf(file, "#!/bin/sh\n#SBATCH --job-name=limner-sweep\n#SBATCH --array=1-%zu\n#SBATCH --output=/dev/null\n",
            sweeping->number);
    fputs("line=$(sed -n \"${SLURM_ARRAY_TASK_ID}p\"", file);
    char jobs[PATH_MAX_B];
    snprintf(jobs, sizeof jobs, "%s/jobs", sweeping->folder);
    write_word(jobs, file);
    fputs(") && eval \"$line\"\n", file);
    return outputs_close(file, path, err);
}

static bool plan(struct sweeping *sweeping, struct error *err)
{
    char jobs_path[PATH_MAX_B], results_path[PATH_MAX_B];
    sweeping->jobs = open_in(&sweeping->outputs, sweeping->folder, "jobs", jobs_path, err);
    if (sweeping->jobs)
        sweeping->results = open_in(&sweeping->outputs, sweeping->folder, "results.list", results_path, err);
    bool ok = sweeping->results && write_jobs(sweeping, err);
    if (sweeping->jobs) ok = outputs_close(sweeping->jobs, jobs_path, ok ? err : &(struct error){0}) && ok;
    if (sweeping->results) ok = outputs_close(sweeping->results, results_path, ok ? err : &(struct error){0}) && ok;
    return ok && write_array(sweeping, err) && outputs_keep(&sweeping->outputs, err);
}

static void print_plan(const struct sweeping *sweeping)
{
    const char *folder = sweeping->folder;
    printf("%zu jobs. From this folder, any of these runs them:\n", sweeping->number);
    printf("    sh %s/jobs\n", folder);
    printf("    parallel --joblog %s/joblog --resume-failed <%s/jobs\n", folder, folder);
    printf("    sbatch %s/slurm.sh\n", folder);
    printf("Then: limner sweep --merge %s\n", folder);
}

/* All of it ---------------------------------------------------------------------------------------- */

static bool run(struct arguments *arguments, struct error *err)
{
    struct sweeping sweeping = {0};
    const char *merged = NULL;
    if (!arguments_value(arguments, "--merge", &merged, err)) return false;
    if (merged)
        return arguments->count == 1
                   ? sweep_results_join(merged, err)
                   : error_set(err, "sweep --merge: takes nothing else, what is '%s'?", arguments->items[1]);
    const bool ok = parse(&sweeping, arguments, err) && plan(&sweeping, err);
    outputs_discard(&sweeping.outputs);
    if (ok) print_plan(&sweeping);
    return ok;
}

int cmd_sweep(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    if (run(&arguments, &err)) return EXIT_SUCCESS;
    fprintf(stderr, "limner: %s\n", err.text);
    return EXIT_FAILURE;
}
