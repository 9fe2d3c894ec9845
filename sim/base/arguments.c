/* SPDX-License-Identifier: MIT
 *
 * The first item is the command's name, and after `--` nothing is an option. */
#include "base/arguments.h"

#include <string.h>

static void drop(struct arguments *arguments, int at, int count)
{
    memmove(&arguments->items[at], &arguments->items[at + count],
            (size_t)(arguments->count - at - count + 1) * sizeof arguments->items[0]);
    arguments->count -= count;
}

static bool ends_options(const char *item)
{
    return strcmp(item, "--") == 0;
}

/* An empty one is a variable of the shell that nobody has set: as a line's name it would be that of all without one. */
static bool check_value(const char *name, const char *value, struct error *err)
{
    return (value && value[0]) || error_set(err, "%s: needs a value", name);
}

/* Whether the item is the option. *value: what stands behind its `=`, or NULL. */
static bool is_option(const char *item, const char *name, const char **value)
{
    const size_t length = strlen(name);
    if (strncmp(item, name, length) != 0 || (item[length] && item[length] != '=')) return false;
    *value = item[length] ? item + length + 1 : NULL;
    return true;
}

bool arguments_value(struct arguments *arguments, const char *name, const char **value, struct error *err)
{
    const char *own;
    for (int i = 1; i < arguments->count && !ends_options(arguments->items[i]);) {
        if (!is_option(arguments->items[i], name, &own)) {
            i++;
            continue;
        }
        *value = own ? own : arguments->items[i + 1];
        if (!check_value(name, *value, err)) return false;
        drop(arguments, i, own ? 1 : 2);
    }
    return true;
}

bool arguments_flag(struct arguments *arguments, const char *name)
{
    bool found = false;
    for (int i = 1; i < arguments->count && !ends_options(arguments->items[i]);) {
        const bool is_it = strcmp(arguments->items[i], name) == 0;
        if (is_it) drop(arguments, i, 1);
        if (is_it) found = true;
        if (!is_it) i++;
    }
    return found;
}

bool arguments_optional(struct arguments *arguments, const char *name, bool (*is_value)(const char *word),
                        const char **value)
{
    const char *own;
    bool found = false;
    for (int i = 1; i < arguments->count && !ends_options(arguments->items[i]);) {
        if (!is_option(arguments->items[i], name, &own)) {
            i++;
            continue;
        }
        const char *next = arguments->items[i + 1];
        const bool takes_next = !own && next && is_value(next);
        if (own || takes_next) *value = own ? own : next;
        drop(arguments, i, takes_next ? 2 : 1);
        found = true;
    }
    return found;
}

bool arguments_either(struct arguments *arguments, const char *yes, const char *no, bool *on, struct error *err)
{
    const bool is_yes = arguments_flag(arguments, yes), is_no = arguments_flag(arguments, no);
    if (is_yes && is_no) return error_set(err, "%s, %s: only one of them", yes, no);
    if (is_yes || is_no) *on = is_yes;
    return true;
}
