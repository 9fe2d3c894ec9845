/* SPDX-License-Identifier: MIT
 *
 * A section of an object is a line ` NAME ADDRESS SIZE OBJECT`, broken after a long name. */
#include "measure/link_map.h"

#include "base/grow.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_MAX_B = 256 };

static const char START[] = "Linker script and memory map";

bool link_section_is(const struct link_section *section, const char *prefix)
{
    const size_t length = strlen(prefix);
    return strncmp(section->name, prefix, length) == 0 && (!section->name[length] || section->name[length] == '.');
}

static bool is_in_memory(const struct link_section *section)
{
    static const char *const prefixes[] = {".text",  ".rodata", ".srodata", ".data",
                                           ".sdata", ".bss",    ".sbss",    ".vectors"};
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++)
        if (link_section_is(section, prefixes[i])) return true;
    return false;
}

static void add(struct link_map *map, char *name, uint64_t start, uint64_t size_b, const char *object)
{
    const struct link_section section = {.name = name, .start = start, .size_b = size_b};
    if (!size_b || !is_in_memory(&section)) return;
    map->sections = grow(map->sections, map->count, &map->capacity, sizeof *map->sections);
    map->sections[map->count] = section;
    map->sections[map->count].name = strdup(name);
    map->sections[map->count++].object = strdup(object);
}

/* `name` holds the section's name from this line or the one before, and is empty if there is none. */
static void read_line(struct link_map *map, char *line, char name[NAME_MAX_B])
{
    uint64_t start, size_b;
    int at = 0;
    line[strcspn(line, "\n")] = '\0';
    if (line[0] == ' ' && line[1] == '.') {
        if (sscanf(line, " %255s%n", name, &at) != 1) return;
    } else if (line[0] != ' ') {
        name[0] = '\0';
    }
    line += at;
    at = 0;
    if (!*line) return;
    if (name[0] && sscanf(line, " 0x%" SCNx64 " 0x%" SCNx64 " %n", &start, &size_b, &at) == 2 && at && line[at])
        add(map, name, start, size_b, line + at);
    name[0] = '\0';
}

static int by_address(const void *a, const void *b)
{
    const struct link_section *first = a, *second = b;
    return (first->start > second->start) - (first->start < second->start);
}

bool link_map_read(const char *path, struct link_map *out, struct error *err)
{
    char *line = NULL, name[NAME_MAX_B] = "";
    size_t capacity = 0;
    bool begun = false;
    FILE *file = fopen(path, "r");
    *out = (struct link_map){0};
    if (!file) return error_set(err, "%s: %s", path, strerror(errno));
    while (getline(&line, &capacity, file) >= 0) {
        if (begun) read_line(out, line, name);
        begun |= strncmp(line, START, sizeof START - 1) == 0;
    }
    free(line);
    fclose(file);
    if (out->count == 0) return error_set(err, "%s: not a linker's map", path);
    qsort(out->sections, out->count, sizeof *out->sections, by_address);
    return true;
}

void link_map_free(struct link_map *map)
{
    for (size_t i = 0; i < map->count; i++) {
        free(map->sections[i].name);
        free(map->sections[i].object);
    }
    free(map->sections);
    *map = (struct link_map){0};
}
