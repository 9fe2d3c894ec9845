/* SPDX-License-Identifier: MIT
 *
 * Options are the words that begin with a dash where a line of the help names them. Values are those of a table, or the
 * words behind an option there that it takes. */
#include "cli/completion.h"

#include "cli/usage.h"
#include "compiler/compile_options.h"
#include "compiler/moving_compile.h"
#include "core/core.h"
#include "displays/display.h"
#include "export/esp_image.h"
#include "export/uf2.h"
#include "export/world.h"
#include "levels/level_moves.h"
#include "measure/measurement.h"
#include "model/model_orientation.h"
#include "scene/method.h"
#include "scene/tree_kind.h"

#include <stdbool.h>
#include <string.h>

enum { OPTION_MAX_B = 32, WORD_MAX_B = 32 };

static const char NAME_LETTERS[] = "abcdefghijklmnopqrstuvwxyz0123456789-";

/* Of a line, up to two blanks. */
static void put_options(const char *line, size_t length, FILE *out)
{
    for (size_t i = 0; i + 1 < length && strncmp(line + i, "  ", 2) != 0; i++) {
        if (line[i] != '-' || (i && line[i - 1] != ' ')) continue;
        const size_t name = strspn(line + i, NAME_LETTERS);
        fprintf(out, " %.*s", (int)name, line + i);
        i += name - 1;
    }
}

static void put_entry(const struct usage_entry *entry, FILE *out)
{
    for (const char *at = entry->text; *at;) {
        const size_t length = strcspn(at, "\n"), blanks = strspn(at, " ");
        if (blanks == 2) put_options(at + blanks, length - blanks, out);
        at += length + (at[length] == '\n');
    }
}

static void put_commands(FILE *out)
{
    for (size_t i = 0; usage_command_at(i); i++)
        fprintf(out, "%s ", usage_command_at(i)->name);
}

static void put_options_of_commands(FILE *out)
{
    for (size_t i = 0; usage_command_at(i); i++) {
        fprintf(out, "        %s) words='", usage_command_at(i)->name);
        for (size_t e = 0; usage_entry_at(e); e++)
            if (usage_entry_at(e)->commands >> i & 1) put_entry(usage_entry_at(e), out);
        fputs(" --help' ;;\n", out);
    }
}

/* The text behind "  --option " in the help, up to the next option; NULL: there is none. */
static const char *find_text(const char *option, size_t *length)
{
    char head[OPTION_MAX_B];
    snprintf(head, sizeof head, "  %s ", option);
    for (size_t e = 0; usage_entry_at(e); e++) {
        const char *text = usage_entry_at(e)->text, *at = strstr(text, head);
        if (!at || (at > text && at[-1] != '\n')) continue;
        at += strlen(head);
        const char *end = strstr(at, "\n  -");
        *length = end ? (size_t)(end - at) : strlen(at);
        return at;
    }
    return NULL;
}

/* The next word of letters, digits and dashes; false: there is none that is short enough. */
static bool next_word(const char **at, const char *end, char word[WORD_MAX_B])
{
    while (*at < end) {
        const size_t length = strspn(*at, NAME_LETTERS);
        if (length && length < WORD_MAX_B) {
            memcpy(word, *at, length);
            word[length] = '\0';
            *at += length;
            return true;
        }
        *at += length ? length : 1;
    }
    return false;
}

static bool has_word(const char *text, const char *end, const char *word)
{
    char other[WORD_MAX_B];
    while (next_word(&text, end, other))
        if (strcmp(other, word) == 0) return true;
    return false;
}

static bool is_world(const char *word)
{
    struct error ignored;
    return world_find(word, &ignored) != NULL;
}

static bool is_family(const char *word)
{
    struct error ignored;
    return uf2_family_find(word, &ignored) != NULL;
}

static bool is_chip(const char *word)
{
    struct error ignored;
    return esp_chip_find(word, &ignored) != NULL;
}

static bool is_processor(const char *word)
{
    return measure_cpu_find(word) != NULL;
}

static bool is_purpose(const char *word)
{
    struct error ignored;
    return measure_optimise_check(word, &ignored);
}

static bool is_profile(const char *word)
{
    return core_find(word) != NULL;
}

static bool is_light(const char *word)
{
    struct error ignored;
    bool light;
    return moving_light_parse(word, &light, &ignored);
}

static bool is_way_to_move(const char *word)
{
    struct error ignored;
    enum moving_mode mode;
    return moving_mode_parse(word, &mode, &ignored);
}

static bool is_doors(const char *word)
{
    struct error ignored;
    enum level_doors doors;
    return level_doors_parse(word, &doors, &ignored);
}

static bool is_portals(const char *word)
{
    struct error ignored;
    enum portals_wanted portals;
    return portals_parse(word, &portals, &ignored);
}

static bool is_up(const char *word)
{
    struct error ignored;
    struct orientation orientation;
    return orientation_parse(ORIENTATION_UP, word, &orientation, &ignored);
}

static const struct {
    const char *option;
    bool (*takes)(const char *word);
} TOLD[] = {
    {"--precision", is_profile},  {"--core", is_processor},  {"--mover-light", is_light},
    {"--movers", is_way_to_move}, {"--portals", is_portals}, {"--up", is_up},
    {"--for", is_world},          {"--family", is_family},   {"--chip", is_chip},
    {"--optimise", is_purpose},   {"--doors", is_doors},
};

/* Each once. */
static void put_told_values(FILE *out)
{
    for (size_t i = 0; i < sizeof TOLD / sizeof *TOLD; i++) {
        size_t length = 0;
        const char *const text = find_text(TOLD[i].option, &length);
        char word[WORD_MAX_B];
        fprintf(out, "    %s) words='", TOLD[i].option);
        for (const char *at = text; text && next_word(&at, text + length, word);)
            if (TOLD[i].takes(word) && !has_word(text, at - strlen(word), word)) fprintf(out, "%s ", word);
        fputs("' ;;\n", out);
    }
}

static void put_values(FILE *out)
{
    struct panel_choice panel;
    fputs("    --panel)\n        words='", out);
    for (size_t i = 0; panel_choice_at(i, &panel); i++)
        fprintf(out, "%s ", panel.name);
    fputs("'\n        case $command in render | view | report-bug) words+='memory framebuffer' ;; esac\n        ;;\n",
          out);
    fputs("    --method) words='", out);
    for (size_t i = 0; i < method_count; i++)
        fprintf(out, "%s ", methods[i].name);
    fputs("' ;;\n    --tree) words='", out);
    for (size_t i = 0; i < TREE_KINDS; i++)
        fprintf(out, "%s ", tree_names[i]);
    fputs("' ;;\n    --mesh-leaves) words='", out);
    for (size_t i = 0; i <= MESH_LEAVES_ALL; i++)
        fprintf(out, "%s ", mesh_leaves_names[i]);
    fputs("' ;;\n    --coordinates) words='auto 16 32' ;;\n", out);
    put_told_values(out);
}

void completion_print(FILE *out)
{
    fputs("# bash completion for limner; written by `limner help --bash-completion`\n"
          "_limner() {\n"
          "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} "
          "words= found\n"
          "    COMPREPLY=()\n"
          "    case $before in\n",
          out);
    put_values(out);
    fputs("    *)\n        case $COMP_CWORD:$command:$word in\n        1:* | 2:help:*) words='", out);
    put_commands(out);
    fputs("help' ;;\n        *:*:-*)\n        case $command in\n", out);
    put_options_of_commands(out);
    fputs("        esac ;;\n"
          "        esac\n"
          "        ;;\n"
          "    esac\n"
          "    if [[ $words ]]; then\n"
          "        found=$(compgen -W \"$words\" -- \"$word\")\n"
          "    else\n"
          "        found=$(compgen -f -- \"$word\")\n"
          "        compopt -o filenames 2>/dev/null\n"
          "    fi\n"
          "    [[ ! $found ]] || mapfile -t COMPREPLY <<<\"$found\"\n"
          "}\n"
          "complete -F _limner limner\n",
          out);
}
