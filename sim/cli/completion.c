/* SPDX-License-Identifier: MIT
 *
 * Options are the words that begin with a dash where a line of the help names them. */
#include "cli/completion.h"

#include "cli/usage_table.h"
#include "displays/display.h"
#include "scene/method.h"
#include "scene/tree_kind.h"

#include <stdbool.h>
#include <string.h>

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
    fputs("' ;;\n    --precision) words='draft fast fine exact' ;;\n    --up) words='y z' ;;\n", out);
}

void completion_print(FILE *out)
{
    fputs("# bash completion for limner; written by `limner help --bash-completion`\n"
          "_limner() {\n"
          "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} "
          "words=\n"
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
          "        mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
          "    else\n"
          "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
          "        compopt -o filenames 2>/dev/null\n"
          "    fi\n"
          "}\n"
          "complete -F _limner limner\n",
          out);
}
