/* SPDX-License-Identifier: MIT
 *
 * `limner module`: a display's controller and glass, described as for `limner play` -> C that sets them up on a board.
 */
#include "cli/commands.h"
#include "displays/idle_options.h"
#include "displays/module_c.h"
#include "scene/scene_files.h"

#include <stdio.h>
#include <stdlib.h>

static bool module_run(struct arguments *arguments, struct error *err)
{
    struct module_choice choice;
    struct outputs outputs = {0};
    const char *path = NULL;
    struct idle_options idle;
    idle_options_find(&idle, arguments->count, arguments->items);
    if (!arguments_value(arguments, "-o", &path, err) || !module_choice_parse(&choice, arguments, err)) return false;
    if (arguments->count > 1) return error_set(err, "module: what is '%s'?", arguments->items[1]);
    if (!path) return error_set(err, "module: needs -o NAME, for NAME.c and NAME.h");
    if (!scene_files_finish(&outputs, module_c_put(&choice, path, &outputs, err), err)) return false;
    idle_options_note_panel(&idle, &choice.panel);
    return true;
}

int cmd_module(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    const bool ok = module_run(&arguments, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
