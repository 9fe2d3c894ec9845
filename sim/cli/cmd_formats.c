/* SPDX-License-Identifier: MIT
 *
 * `limner formats`: what is read of each format, and what becomes of the rest, in the words that are said then. A line
 * a feature, below its format; with --markdown a table, below which the words stand. */
#include "base/arguments.h"
#include "cli/commands.h"
#include "formats/read_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_format(enum read_format format)
{
    const struct read_row *row;
    printf("%s:\n", read_format_name(format));
    for (size_t i = 0; (row = read_row_at(i)); i++) {
        const struct read_cell *cell = &row->cells[format];
        if (cell->fate == READ_NONE) continue;
        printf("  %-22s %s%s%s\n", row->feature, read_fate_name(cell->fate), cell->words ? ": " : "",
               cell->words ? cell->words : "");
    }
}

/* Of all cells in their order, each once; they are numbered from 1. */
struct words {
    const char *items[64];
    size_t count;
};

static size_t number_of(struct words *words, const char *text)
{
    for (size_t i = 0; i < words->count; i++)
        if (strcmp(words->items[i], text) == 0) return i + 1;
    if (words->count < sizeof words->items / sizeof *words->items) words->items[words->count++] = text;
    return words->count;
}

static void print_cell(const struct read_cell *cell, struct words *words)
{
    printf(" %s", cell->fate == READ_NONE ? "-" : read_fate_name(cell->fate));
    if (cell->words) printf(" (%zu)", number_of(words, cell->words));
    printf(" |");
}

static void print_markdown(void)
{
    struct words words = {.count = 0};
    const struct read_row *row;
    printf("| |");
    for (int format = 0; format < READ_FORMATS; format++)
        printf(" %s |", read_format_name((enum read_format)format));
    printf("\n|---|");
    for (int format = 0; format < READ_FORMATS; format++)
        printf("---|");
    for (size_t i = 0; (row = read_row_at(i)); i++) {
        printf("\n| %s |", row->feature);
        for (int format = 0; format < READ_FORMATS; format++)
            print_cell(&row->cells[format], &words);
    }
    printf("\n\n");
    for (size_t i = 0; i < words.count; i++)
        printf("%zu. %s\n", i + 1, words.items[i]);
}

int cmd_formats(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    const bool is_markdown = arguments_flag(&arguments, "--markdown");
    if (arguments.count > 1) {
        fprintf(stderr, "limner: formats: '%s' is not understood\n", arguments.items[1]);
        return EXIT_FAILURE;
    }
    if (is_markdown) {
        print_markdown();
        return EXIT_SUCCESS;
    }
    for (int format = 0; format < READ_FORMATS; format++)
        print_format((enum read_format)format);
    return EXIT_SUCCESS;
}
