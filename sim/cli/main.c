/* SPDX-License-Identifier: MIT
 *
 * The host program `limner`: hands its arguments to a subcommand. */
#include "agree.h"
#include "base/arguments.h"
#include "base/cache.h"
#include "base/deadline.h"
#include "base/ending.h"
#include "base/printable.h"
#include "base/streams.h"
#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/man_page.h"
#include "cli/options.h"
#include "cli/usage.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    bool reads_models; /* takes what all such take */
    bool has_limit;    /* takes --time-limit */
} COMMANDS[] = {{"compile", cmd_compile, true, true},   {"render", cmd_render, true, true},
                {"view", cmd_view, true, true},         {"measure", cmd_measure, true, true},
                {"compare", cmd_compare, true, true},   {"splitters", cmd_splitters, true, true},
                {"sweep", cmd_sweep, false, false},     {"play", cmd_play, true, true},
                {"devices", cmd_devices, false, false}, {"bridge", cmd_bridge, false, false},
                {"module", cmd_module, false, false},   {"card", cmd_card, false, false},
                {"decode", cmd_decode, false, true},    {"hashes", cmd_hashes, false, false},
                {"uf2", cmd_uf2, false, false},         {"espimage", cmd_espimage, false, false},
                {"boot2", cmd_boot2, false, false},     {"report-bug", cmd_report_bug, true, true},
                {"replay", cmd_replay, true, true},     {"export", cmd_export, true, true},
                {"worst", cmd_worst, true, true},       {"report", cmd_report, true, true},
                {"wad", cmd_wad, false, false},         {"walk", cmd_walk, true, true},
                {"formats", cmd_formats, false, false}};

static bool asks_for_help(const char *argument)
{
    return strcmp(argument, "help") == 0 || strcmp(argument, "--help") == 0 || strcmp(argument, "-h") == 0;
}

/* Where options may stand, perhaps with `all` behind; `limner COMMAND help` will do, too. */
static bool has_help_option(int argc, char **argv)
{
    if (argc == 3 && asks_for_help(argv[2])) return true;
    for (int i = 2; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (strcmp(argv[i], "--help") == 0) return true;
    return false;
}

static int no_command(const char *name)
{
    const char *nearest = usage_nearest_command(name);
    printable_print(stderr, "limner: no command '%s'%s%s%s; `limner help` lists them\n", name,
                    nearest ? ", is it " : "", nearest ? nearest : "", nearest ? "?" : "");
    return EXIT_FAILURE;
}

/* For `make install`. */
static int help_with(const char *name, bool all)
{
    if (strcmp(name, "--man") == 0) return man_page_print(stdout), EXIT_SUCCESS;
    if (strcmp(name, "--bash-completion") == 0) return completion_print(stdout), EXIT_SUCCESS;
    return usage_print_command(name, all, stdout) ? EXIT_SUCCESS : no_command(name);
}

/* The time runs from here. */
static bool begin_time(struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    double limit_s;
    if (!arguments_value(arguments, "--time-limit", &text, err) || !deadline_parse(text, &limit_s, err)) return false;
    deadline_begin(limit_s);
    return true;
}

static int run_command(const struct command *command, int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    if (usage_check_options(command->name, argv + 1, &err) &&
        (!command->reads_models || model_options_take(&arguments, &err)) &&
        (!command->has_limit || begin_time(&arguments, &err)))
        return command->run(arguments.count, arguments.items);
    fprintf(stderr, "limner: %s\n", err.text);
    return EXIT_FAILURE;
}

static int run(int argc, char **argv)
{
    if (argc < 2) {
        fputs("limner: no command; `limner help` lists them\n", stderr);
        return EXIT_FAILURE;
    }
    if (asks_for_help(argv[1]) && (argc == 2 || asks_for_help(argv[2]))) {
        usage_print(stdout);
        return EXIT_SUCCESS;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("limner %d.%d.%d\n", LIM_VERSION_MAJOR, LIM_VERSION_MINOR, LIM_VERSION_PATCH);
        return EXIT_SUCCESS;
    }
    const bool all = strcmp(argv[argc - 1], "all") == 0;
    if (asks_for_help(argv[1])) return help_with(argv[2], all);
    if (has_help_option(argc, argv)) return help_with(argv[1], all);
    for (size_t i = 0; i < sizeof COMMANDS / sizeof COMMANDS[0]; i++)
        if (strcmp(argv[1], COMMANDS[i].name) == 0) return run_command(&COMMANDS[i], argc - 1, argv + 1);
    return no_command(argv[1]);
}

int main(int argc, char **argv)
{
    streams_prepare();
    ending_prepare();
    cache_begin();
    const int status = run(argc, argv);
    if (status == 0) deadline_tell();
    return streams_end(status);
}
