/* SPDX-License-Identifier: MIT
 *
 * Names that nearly are a command's or an option's: who writes --guf is asked for --gif. What options there are is read
 * off the help (usage.h). */
#include "base/choice.h"
#include "cli/usage.h"

#include <ctype.h>
#include <string.h>

enum { OPTIONS_MAX = 160, OPTION_B = 32 };

/* Of one command; each option with what follows it in the help's line. */
struct options_told {
    char names[OPTIONS_MAX][OPTION_B];
    bool takes_value[OPTIONS_MAX];
    size_t count;
};

static const char *command_name_at(const void *list, size_t index)
{
    const struct usage_command *command = usage_command_at(index);
    (void)list;
    return command ? command->name : NULL;
}

const char *usage_nearest_command(const char *name)
{
    return choice_nearest(command_name_at, NULL, name, strlen(name));
}

static const char *option_at(const void *list, size_t index)
{
    const struct options_told *told = list;
    return index < told->count ? told->names[index] : NULL;
}

/* "  --dc, --reset LINE  GPIO lines ...": what stands in two columns, before two blanks. */
static void take_line(struct options_told *told, const char *line, const char *end)
{
    const char *behind = line + 2;
    while (behind < end && !(behind[0] == ' ' && behind[1] == ' '))
        behind++;
    const size_t first = told->count;
    bool takes_value = false;
    for (const char *at = line + 2; at < behind;) {
        const size_t length = strcspn(at, " ,\n");
        if (strncmp(at, "--", 2) == 0 && length < OPTION_B && told->count < OPTIONS_MAX)
            memcpy(told->names[told->count++], at, length);
        else
            takes_value |= isupper((unsigned char)*at) || strchr(at, '|') == at + length;
        at += length;
        at += strspn(at, " ,\n");
    }
    for (size_t i = first; i < told->count; i++)
        told->takes_value[i] = takes_value;
}

static void take_entry(struct options_told *told, const char *text)
{
    while (*text) {
        const size_t length = strcspn(text, "\n");
        if (strncmp(text, "  -", 3) == 0) take_line(told, text, text + length);
        text += length + (text[length] == '\n');
    }
}

static void options_of(const char *command, struct options_told *told)
{
    const struct usage_entry *entry;
    size_t number = 0;
    *told = (struct options_told){.count = 0};
    while (usage_command_at(number) && strcmp(usage_command_at(number)->name, command) != 0)
        number++;
    for (size_t i = 0; (entry = usage_entry_at(i)); i++)
        if (entry->commands >> number & 1) take_entry(told, entry->text);
}

/* As getopt_long() takes it: beginnings will do. */
static bool is_told(const struct options_told *told, const char *given, size_t length)
{
    for (size_t i = 0; i < told->count; i++)
        if (strncmp(told->names[i], given, length) == 0) return true;
    return false;
}

static bool takes_next(const struct options_told *told, const char *given)
{
    for (size_t i = 0; i < told->count; i++)
        if (strcmp(told->names[i], given) == 0) return told->takes_value[i];
    return strcmp(given, "-o") == 0;
}

bool usage_check_options(const char *command, char *const *arguments, struct error *err)
{
    struct options_told told;
    options_of(command, &told);
    for (; *arguments && strcmp(*arguments, "--") != 0; arguments++) {
        const char *given = *arguments;
        const size_t length = strcspn(given, "=");
        if (takes_next(&told, given) && arguments[1]) {
            arguments++;
            continue;
        }
        if (strncmp(given, "--", 2) != 0 || is_told(&told, given, length)) continue;
        const char *nearest = choice_nearest(option_at, &told, given, length);
        if (nearest)
            return error_set(err, "%.*s: no such option here, is it %s? --help all lists those that there are",
                             (int)length, given, nearest);
    }
    return true;
}
