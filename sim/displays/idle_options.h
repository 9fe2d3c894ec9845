/* SPDX-License-Identifier: MIT
 *
 * Options that a command takes, and that change nothing for this panel or this scene: each is told by a notice, so that
 * nobody looks for what it did. What contradicts itself is refused elsewhere. */
#ifndef SIM_IDLE_OPTIONS_H
#define SIM_IDLE_OPTIONS_H

#include "displays/display.h"

#include <stdbool.h>
#include <stdint.h>

/* Which of the options known here were given. All zero: none. */
struct idle_options {
    uint32_t given;
};

/* A name without dashes; others than those known here are passed over. */
void idle_options_add(struct idle_options *options, const char *name);

/* All of a command line, before anybody takes them out: `--name`, `--name=VALUE`. */
void idle_options_find(struct idle_options *out, int argc, char **argv);

void idle_options_note_panel(const struct idle_options *options, const struct panel_choice *panel);

struct idle_scene {
    const char *name;
    bool is_compiled;    /* before, into a .lim file */
    bool is_set;         /* without a tree */
    bool is_mesh;        /* without a tree */
    bool is_still;       /* nothing is drawn moving */
    bool was_still;      /* nor has the file anything that could move */
    bool is_unlit;       /* without light */
    bool has_background; /* drawn as outlines in two colours */
};

void idle_options_note_scene(const struct idle_options *options, const struct idle_scene *scene);

#endif
