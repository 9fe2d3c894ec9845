/* SPDX-License-Identifier: MIT
 *
 * A table: an option, of what it is said, when it changes nothing, and why. The first reason that holds is told. */
#include "displays/idle_options.h"

#include "base/notice.h"

#include <string.h>

enum subject_kind { OF_PANEL, OF_SCENE };

struct subject {
    enum subject_kind kind;
    const char *name;
    const struct panel_choice *panel; /* OF_PANEL */
    const struct idle_scene *scene;   /* OF_SCENE */
};

static bool has_no_colours(const struct subject *subject)
{
    const unsigned colours = 1u << PANEL_RGB565 | 1u << PANEL_RGB444 | 1u << PANEL_RGB666 | 1u << PANEL_RGB666_LOW;
    return !(subject->panel->formats & colours);
}

static bool is_memory_lcd(const struct subject *subject)
{
    return subject->panel->family == &display_sharp;
}

static bool is_compiled(const struct subject *subject)
{
    return subject->scene->is_compiled;
}

static bool has_its_tree(const struct subject *subject)
{
    return subject->scene->is_compiled && !subject->scene->is_set;
}

static bool is_set(const struct subject *subject)
{
    return subject->scene->is_set;
}

static bool is_still(const struct subject *subject)
{
    return subject->scene->is_still;
}

static bool was_still(const struct subject *subject)
{
    return subject->scene->was_still;
}

static bool is_unlit(const struct subject *subject)
{
    return subject->scene->is_unlit;
}

static bool is_mesh(const struct subject *subject)
{
    return subject->scene->is_mesh;
}

static bool has_background(const struct subject *subject)
{
    return subject->scene->has_background;
}

static const struct idle_option {
    const char *name;
    enum subject_kind kind;
    bool (*is_idle)(const struct subject *subject);
    const char *before, *behind; /* round the subject's name */
} OPTIONS[] = {
    {"bgr", OF_PANEL, has_no_colours, "", " has no colours"},
    {"rgb", OF_PANEL, has_no_colours, "", " has no colours"},
    {"invert", OF_PANEL, is_memory_lcd, "", " shows its memory as it is"},
    {"no-invert", OF_PANEL, is_memory_lcd, "", " shows its memory as it is"},
    {"dc", OF_PANEL, is_memory_lcd, "", " has no data/command pin"},
    {"reset", OF_PANEL, is_memory_lcd, "", " has no reset pin"},
    {"splitter", OF_SCENE, is_compiled, "", " is compiled already"},
    {"splitter", OF_SCENE, is_set, "no plane divides the set of ", ""},
    {"splitter", OF_SCENE, is_mesh, "no plane divides the mesh of ", ""},
    {"tolerance", OF_SCENE, is_compiled, "", " is compiled already"},
    {"tolerance", OF_SCENE, is_mesh, "no plane divides the mesh of ", ""},
    {"tree", OF_SCENE, has_its_tree, "", " is compiled already"},
    {"mesh-leaves", OF_SCENE, is_compiled, "", " is compiled already"},
    {"mesh-leaves", OF_SCENE, is_set, "no tree holds the set of ", ""},
    {"mesh-leaves", OF_SCENE, is_mesh, "no tree holds the mesh of ", ""},
    {"coordinates", OF_SCENE, is_compiled, "", " is compiled already"},
    {"unlit", OF_SCENE, is_compiled, "", " is compiled already"},
    {"drop-small", OF_SCENE, is_compiled, "", " is compiled already"},
    {"background", OF_SCENE, is_compiled, "", " is compiled already"},
    {"background", OF_SCENE, has_background, "outlines have their own, of ", ""},
    {"fill", OF_SCENE, is_set, "", " is sorted, and not filled as it is found"},
    {"up", OF_SCENE, is_compiled, "", " is compiled already"},
    {"reverse-faces", OF_SCENE, is_compiled, "", " is compiled already"},
    {"two-sided", OF_SCENE, is_compiled, "", " is compiled already"},
    {"movers", OF_SCENE, was_still, "nothing moves in ", ""},
    {"mover-light", OF_SCENE, is_still, "nothing moves in ", ""},
    {"mover-light", OF_SCENE, is_unlit, "--unlit leaves nothing lit in ", ""},
    {"fps", OF_SCENE, is_still, "nothing moves in ", ""},
};
enum { OPTION_COUNT = sizeof OPTIONS / sizeof OPTIONS[0] };
_Static_assert(OPTION_COUNT <= 32, "a bit each");

void idle_options_add(struct idle_options *options, const char *name)
{
    const size_t length = strcspn(name, "=");
    for (size_t i = 0; i < OPTION_COUNT; i++)
        if (strlen(OPTIONS[i].name) == length && strncmp(OPTIONS[i].name, name, length) == 0)
            options->given |= UINT32_C(1) << i;
}

void idle_options_find(struct idle_options *out, int argc, char **argv)
{
    *out = (struct idle_options){0};
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (strncmp(argv[i], "--", 2) == 0) idle_options_add(out, argv[i] + 2);
}

/* An option of several rows is told of once. */
static bool is_told(const struct subject *subject, size_t row)
{
    for (size_t i = 0; i < row; i++)
        if (strcmp(OPTIONS[i].name, OPTIONS[row].name) == 0 && OPTIONS[i].is_idle(subject)) return true;
    return false;
}

static void note(const struct idle_options *options, const struct subject *subject)
{
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        const struct idle_option *option = &OPTIONS[i];
        const bool is_given = options->given >> i & 1;
        if (is_given && option->kind == subject->kind && option->is_idle(subject) && !is_told(subject, i))
            notice("--%s: %s%s%s; nothing changes", option->name, option->before, subject->name, option->behind);
    }
}

void idle_options_note_panel(const struct idle_options *options, const struct panel_choice *panel)
{
    note(options, &(struct subject){.kind = OF_PANEL, .name = panel->name, .panel = panel});
}

void idle_options_note_scene(const struct idle_options *options, const struct idle_scene *scene)
{
    note(options, &(struct subject){.kind = OF_SCENE, .name = scene->name, .scene = scene});
}
