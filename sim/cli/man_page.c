/* SPDX-License-Identifier: MIT
 *
 * Lines of the help become paragraphs: a heading a section, an option a tag, what is said of it running text. */
#include "cli/man_page.h"

#include "cli/fly.h"
#include "cli/usage.h"

#include <string.h>

enum { INDENT = 2 };

/* Hyphens stay what they are typed as; a line must not begin with what roff takes for a request. */
static void put_text(const char *text, size_t length, FILE *out)
{
    if (length && (text[0] == '.' || text[0] == '\'')) fputs("\\&", out);
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '\\')
            fputs("\\e", out);
        else if (text[i] == '-')
            fputs("\\-", out);
        else if (text[i] == '\'')
            fputs("\\(aq", out);
        else if (text[i] == '`')
            fputs("\\(ga", out);
        else
            fputc(text[i], out);
    }
}

static void put_line(const char *before, const char *text, size_t length, FILE *out)
{
    fputs(before, out);
    put_text(text, length, out);
    fputc('\n', out);
}

static size_t blanks_of(const char *text)
{
    return strspn(text, " ");
}

/* The option, up to two blanks or the line's end. */
static size_t tag_of(const char *text, size_t length)
{
    for (size_t i = 0; i + 1 < length; i++)
        if (text[i] == ' ' && text[i + 1] == ' ') return i;
    return length;
}

static void put_option(const char *text, size_t length, FILE *out)
{
    const size_t tag = tag_of(text, length);
    if (tag == length) {
        put_line(".PP\n", text, length, out);
        return;
    }
    fputs(".TP\n.B ", out);
    put_line("", text, tag, out);
    const size_t blanks = blanks_of(text + tag);
    put_line("", text + tag + blanks, length - tag - blanks, out);
}

static void put_help_line(const char *text, size_t length, FILE *out)
{
    const size_t blanks = blanks_of(text);
    if (blanks == 0)
        put_line(".PP\n", text, length, out);
    else if (blanks == INDENT)
        put_option(text + blanks, length - blanks, out);
    else
        put_line("", text + blanks, length - blanks, out);
}

static void put_entry(const struct usage_entry *entry, FILE *out)
{
    for (const char *at = entry->text; *at;) {
        const size_t length = strcspn(at, "\n");
        if (length) put_help_line(at, length, out);
        at += length + (at[length] == '\n');
    }
}

static void put_command(const struct usage_command *command, FILE *out)
{
    fprintf(out, ".TP\n.B limner ");
    put_text(command->name, strlen(command->name), out);
    fputc(' ', out);
    put_line("", command->arguments, strlen(command->arguments), out);
    put_line("", command->what, strlen(command->what), out);
}

static void put_options(FILE *out)
{
    fputs(".SH OPTIONS\nA paragraph says which commands take the options below it;\n.B limner\n.I COMMAND\n"
          ".B \\-\\-help\ntells those of one command.\n",
          out);
    for (size_t i = 0; usage_entry_at(i); i++)
        if (!usage_is_alone(usage_entry_at(i))) put_entry(usage_entry_at(i), out);
}

void man_page_print(FILE *out)
{
    fputs(".TH LIMNER 1 \"\" Limner \"User Commands\"\n.SH NAME\nlimner \\- 3D scenes for the displays of "
          "microcontrollers: compiler, simulator, measurements\n.SH SYNOPSIS\n.B limner\n.I COMMAND\n"
          ".RI [ OPTION ...\\&]\n.br\n.B limner help\n.SH COMMANDS\n",
          out);
    for (size_t i = 0; usage_command_at(i); i++)
        put_command(usage_command_at(i), out);
    put_options(out);
    put_line(".SH KEYS OF VIEW\n", FLY_HELP, strlen(FLY_HELP), out);
    fputs(".SH EXAMPLES\n.nf\n", out);
    for (size_t i = 0; usage_command_at(i); i++)
        put_line("", usage_command_at(i)->example, strlen(usage_command_at(i)->example), out);
    fputs(".fi\n.SH EXIT STATUS\n0, or 1 with one line on standard error that names the thing and the reason.\n", out);
}
