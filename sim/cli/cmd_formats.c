/* SPDX-License-Identifier: MIT
 *
 * `limner formats`: what is read of each format, and what becomes of the rest, in the words that are said then. A line
 * a feature, below its format, and glTF's extensions; with --markdown tables, below which the words stand. */
#include "base/arguments.h"
#include "cli/commands.h"
#include "formats/read_table.h"
#include "gltf/gltf_extensions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char EXTENSIONS[] = "glTF extensions";

/* false: there are no more. */
static bool extension_at(size_t index, const char **name, struct read_cell *cell)
{
    bool is_drawn;
    *name = gltf_extension_at(index, &is_drawn, &cell->words);
    cell->fate = is_drawn ? READ_DRAWN : READ_LEFT_OUT;
    return *name != NULL;
}

static void print_line(const char *feature, const struct read_cell *cell)
{
    if (cell->fate == READ_NONE) return;
    printf("  %-36s %s%s%s\n", feature, read_fate_name(cell->fate), cell->words ? ": " : "",
           cell->words ? cell->words : "");
}

static void print_lines(void)
{
    const struct read_row *row;
    const char *name;
    struct read_cell cell;
    for (int format = 0; format < READ_FORMATS; format++) {
        printf("%s:\n", read_format_name((enum read_format)format));
        for (size_t i = 0; (row = read_row_at(i)); i++)
            print_line(row->feature, &row->cells[format]);
    }
    printf("%s:\n", EXTENSIONS);
    for (size_t i = 0; extension_at(i, &name, &cell); i++)
        print_line(name, &cell);
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

static void print_features(struct words *words)
{
    const struct read_row *row;
    printf("| feature |");
    for (int format = 0; format < READ_FORMATS; format++)
        printf(" %s |", read_format_name((enum read_format)format));
    printf("\n|---|");
    for (int format = 0; format < READ_FORMATS; format++)
        printf("---|");
    for (size_t i = 0; (row = read_row_at(i)); i++) {
        printf("\n| %s |", row->feature);
        for (int format = 0; format < READ_FORMATS; format++)
            print_cell(&row->cells[format], words);
    }
    printf("\n\n");
}

/* Those of one fate and the same words, in one line. */
static void print_extensions(struct words *words)
{
    const char *name, *first;
    struct read_cell cell, other;
    printf("%s:\n\n", EXTENSIONS);
    for (size_t i = 0; extension_at(i, &first, &cell); i++) {
        bool is_told = false;
        for (size_t k = 0; k < i && extension_at(k, &name, &other); k++)
            is_told |= other.fate == cell.fate && other.words == cell.words;
        if (is_told) continue;
        printf("- %s", read_fate_name(cell.fate));
        if (cell.words) printf(" (%zu)", number_of(words, cell.words));
        printf(": `%s`", first);
        for (size_t k = i + 1; extension_at(k, &name, &other); k++)
            if (other.fate == cell.fate && other.words == cell.words) printf(", `%s`", name);
        printf("\n");
    }
    printf("\n");
}

static void print_markdown(void)
{
    struct words words = {.count = 0};
    print_features(&words);
    print_extensions(&words);
    for (size_t i = 0; i < words.count; i++)
        printf("%zu. %s\n", i + 1, words.items[i]);
}

int cmd_formats(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    const bool is_markdown = arguments_flag(&arguments, "--markdown");
    if (arguments.count > 1) {
        fprintf(stderr, "limner: formats: takes --markdown alone, what is '%s'?\n", arguments.items[1]);
        return EXIT_FAILURE;
    }
    if (is_markdown)
        print_markdown();
    else
        print_lines();
    return EXIT_SUCCESS;
}
