/* SPDX-License-Identifier: MIT
 *
 * limner export MODEL... --for WORLD -o FOLDER: a folder that a toolchain takes as it is: the renderer, cut to what the
 * scenes require, the scenes, a display's driver, an example. It takes what `limner compile` takes, and what describes
 * a display. */
#include "base/printable.h"
#include "cli/commands.h"
#include "cli/compile_request.h"
#include "displays/idle_port.h"
#include "export/export.h"
#include "export/export_folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ARGUMENTS_MORE = 3 };

struct export_request {
    const struct world *world;
    char folder[C_PATH_MAX_B], *command; /* as it was typed; to be freed */
    struct c_name name;
    char path[C_PATH_MAX_B]; /* of the files, without suffix */
    struct module_choice module;
    bool has_module;
    struct compile_request compile;
};

/* What CMake takes in the name of a target. */
#define COMPONENT_LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.+-_"

/* As it was typed, for the page of the folder; words that a shell would take apart are quoted. */
static char *tell_command(int argc, char **argv)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=%+";
    char *command = NULL;
    size_t command_b;
    FILE *memory = open_memstream(&command, &command_b);
    if (!memory) return NULL;
    fputs("limner", memory);
    for (int i = 0; i < argc; i++) {
        const char *word = argv[i], *quote = *word && strspn(word, plain) == strlen(word) ? "" : "'";
        fprintf(memory, " %s", quote);
        for (; *word; word++)
            fprintf(memory, *word == '\'' ? "'\\''" : "%c", *word);
        fputs(quote, memory);
    }
    fclose(memory);
    return printable(command);
}

/* Names that another file, a header of C's, a system's or Arduino's library, or a target of CMake's or the Pico SDK's
 * has already. */
static bool is_taken(const char *name)
{
    static const char *const starts[] = {"limner", "pico_", "hardware_", NULL};
    static const char *const taken[] = {
        "all",        "all_build",     "alloca",    "arduino", "assert", "clean",   "complex", "ctype",
        "edit_cache", "errno",         "features",  "fenv",    "float",  "help",    "install", "inttypes",
        "iso646",     "limits",        "locale",    "main",    "malloc", "math",    "package", "pico",
        "preinstall", "rebuild_cache", "run_tests", "setjmp",  "signal", "spi",     "stdarg",  "stdbool",
        "stddef",     "stdint",        "stdio",     "stdlib",  "string", "strings", "test",    "tgmath",
        "threads",    "time",          "uchar",     "unistd",  "wchar",  "wctype",  "wire",    "zero_check"};
    for (size_t i = 0; starts[i]; i++)
        if (strncasecmp(name, starts[i], strlen(starts[i])) == 0) return true;
    for (size_t i = 0; i < sizeof taken / sizeof *taken; i++)
        if (strcasecmp(name, taken[i]) == 0) return true;
    return false;
}

/* Where the files are, without suffix, and what they are called in C, CMake and Arduino. */
static bool name_all(struct export_request *out, struct error *err)
{
    struct c_name name;
    if (!c_name_init(&name, out->folder, err)) return false;
    if (snprintf(out->path, sizeof out->path, "%s/%s%s%s", out->folder, out->world->source,
                 is_taken(name.symbol) ? "scene_" : "", name.symbol) >= C_PATH_MAX_B)
        return error_set(err, "%s: the path is too long", out->folder);
    if (!c_name_init(&out->name, out->path, err)) return false;
    if (strcmp(out->name.symbol, name.file) != 0)
        printable_print(stderr, "limner: %s: is called %s in the folder's files\n", name.file, out->name.symbol);
    return true;
}

/* Without slashes at its end. */
static bool take_folder(struct export_request *out, const char *folder, struct error *err)
{
    if (!folder) return error_set(err, "export: needs -o FOLDER");
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/')
        length--;
    if (length >= C_PATH_MAX_B) return error_set(err, "%s: the path is too long", folder);
    snprintf(out->folder, sizeof out->folder, "%.*s", (int)length, folder);
    const char *last = strrchr(out->folder, '/') ? strrchr(out->folder, '/') + 1 : out->folder;
    if (!*last || strcmp(last, ".") == 0 || strcmp(last, "..") == 0)
        return error_set(err, "-o %s: gives the export no name; name the folder itself", folder);
    if (strcmp(out->world->name, "idf") == 0 && last[strspn(last, COMPONENT_LETTERS)])
        return error_set(
            err, "-o %s: ESP-IDF calls a component by its folder: letters, digits and . + - _ alone, please", folder);
    return name_all(out, err);
}

static bool is_abbreviated(const char *item, const char *option)
{
    const size_t length = strcspn(item, "=");
    return length > 3 && length < strlen(option) && strncmp(item, option, length) == 0;
}

/* A display that was described, or the commonest one of the world unless pixels are asked for by their size alone. */
static bool take_module(struct export_request *out, struct arguments *arguments, struct error *err)
{
    static char option[] = "--panel";
    char usual[32];
    bool is_sized = false;
    for (int i = 1; i < arguments->count; i++) {
        if (is_abbreviated(arguments->items[i], "--panel") || is_abbreviated(arguments->items[i], "--size"))
            return error_set(err, "%s: write --panel and --size in full, please", arguments->items[i]);
        if (strncmp(arguments->items[i], "--panel", 7) == 0) out->has_module = true;
        if (strncmp(arguments->items[i], "--size", 6) == 0) is_sized = true;
    }
    if (!out->has_module && (is_sized || !out->world->panel)) return true;
    if (!out->has_module) {
        snprintf(usual, sizeof usual, "%s", out->world->panel);
        arguments->items[arguments->count++] = option;
        arguments->items[arguments->count++] = usual;
        out->has_module = true;
    }
    return module_choice_parse(&out->module, arguments, err);
}

/* The target's sides, and what its glass and its pixels ask of the renderer. */
static bool fit_to_module(struct export_request *out, struct error *err)
{
    struct display display;
    if (!out->has_module && (out->compile.compile.delta || out->compile.compile.fill))
        fprintf(stderr,
                "limner: %s: is for a struct lim_target of yours; the example, without --panel, has no use for it\n",
                out->compile.compile.delta ? "--delta" : "--fill");
    if (!out->has_module) return true;
    if (!idle_display_setup(&display, &out->module, err)) return false;
    const struct panel *panel = display.panel;
    if (out->compile.compile.fill && (panel->format != PANEL_GREY4 || panel->w_px % 8 != 0 || panel->visible))
        return error_set(err, "--fill: %s does not keep pictures so; displays with 16 greys do",
                         out->module.panel.name);
    out->compile.compile.w_px = panel->w_px;
    out->compile.compile.h_px = panel->h_px;
    out->compile.compile.round |= panel->visible != NULL;
    out->compile.compile.mono = panel_choice_is_mono(&out->module.panel);
    return true;
}

static bool parse(struct arguments *arguments, struct export_request *out, struct error *err)
{
    const char *world = NULL, *folder = NULL;
    if (!arguments_value(arguments, "--for", &world, err) || !arguments_value(arguments, "-o", &folder, err))
        return false;
    if (!world) return error_set(err, "export: needs --for WORLD: arduino, idf, pico, cmake or plain");
    out->world = world_find(world, err);
    if (!out->world || !take_folder(out, folder, err) || !take_module(out, arguments, err)) return false;
    if (!compile_request_parse(arguments->count, arguments->items, &out->compile, err)) return false;
    out->compile.name = out->path;
    return fit_to_module(out, err);
}

/* File names are those of C, which no toolchain minds. */
static bool name_files(const struct export_request *request, struct compile_result *result, struct error *err)
{
    for (size_t i = 0; i < result->count; i++) {
        struct c_name name;
        char path[2 * C_PATH_MAX_B];
        if (!c_name_init(&name, result->names[i], err)) return false;
        if (strcmp(name.symbol, name.file) != 0)
            printable_print(stderr, "limner: %s: is called %s in the folder's files\n", name.file, name.symbol);
        if (snprintf(path, sizeof path, "%s/%s%s", request->folder, request->world->source, name.symbol) >=
            C_PATH_MAX_B)
            return error_set(err, "%s: the path is too long", request->folder);
        strcpy(result->names[i], path);
    }
    return true;
}

static bool write_folder(const struct export_plan *plan, struct export_folder *folder, struct error *err)
{
    struct outputs outputs = {0};
    const bool ok = export_put(plan, &outputs, err) && export_folder_list(folder, &outputs, err);
    if (!scene_files_finish(&outputs, ok, err)) return false;
    export_folder_tidy(folder);
    return true;
}

static bool run(struct export_request *request, struct error *err)
{
    unsigned w_px = request->compile.compile.w_px, h_px = request->compile.compile.h_px;
    if (request->has_module) module_choice_picture(&request->module.module, &w_px, &h_px);
    struct export_folder folder;
    struct compile_result result = {0};
    bool ok = export_folder_open(&folder, request->folder, err) &&
              compile_request_run(&request->compile, &result, err) && name_files(request, &result, err);
    const struct export_plan plan = {.world = request->world,
                                     .folder = request->folder,
                                     .name = &request->name,
                                     .scenes = result.named,
                                     .count = result.count,
                                     .module = request->has_module ? &request->module : NULL,
                                     .w_px = w_px,
                                     .h_px = h_px,
                                     .near_m = request->compile.compile.near_m,
                                     .command = request->command};
    ok = ok && write_folder(&plan, &folder, err);
    if (ok) compile_result_report(&request->compile, &result);
    if (ok) export_report(&plan);
    compile_result_free(&result);
    export_folder_free(&folder);
    return ok;
}

int cmd_export(int argc, char **argv)
{
    struct error err;
    struct export_request request = {.world = NULL};
    char **items = calloc((size_t)argc + ARGUMENTS_MORE, sizeof *items);
    request.command = tell_command(argc, argv);
    if (!items || !request.command) {
        fputs("limner: export: out of memory\n", stderr);
        return EXIT_FAILURE;
    }
    memcpy(items, argv, (size_t)argc * sizeof *items);
    struct arguments arguments = {items, argc};
    const bool ok = parse(&arguments, &request, &err) && run(&request, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    compile_options_free(&request.compile.compile);
    free(request.command);
    free(items);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
