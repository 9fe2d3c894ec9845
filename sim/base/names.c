/* SPDX-License-Identifier: MIT */
#include "base/names.h"

#include "base/grow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_KEPT = 64, MOST_TOLD = 4 };

struct name_end name_end(const char *name)
{
    struct name_end out;
    const size_t length = strlen(name);
    const char *end = name;
    if (length >= sizeof out.text) end += length - sizeof out.text + sizeof "...";
    while (end > name && ((unsigned char)*end & 0xC0) == 0x80)
        end++; /* within a letter of UTF-8 */
    snprintf(out.text, sizeof out.text, "%s%s", end > name ? "..." : "", end);
    return out;
}

bool names_have(const struct names *names, const char *name, size_t length)
{
    for (size_t i = 0; i < names->item_count; i++)
        if (strlen(names->items[i]) == length && memcmp(names->items[i], name, length) == 0) return true;
    return false;
}

void names_add(struct names *names, const char *name, size_t length)
{
    names->mentions++;
    if (names->item_count == MOST_KEPT || names_have(names, name, length)) return;
    char *copy = grow_zeroed(length + 1, 1);
    memcpy(copy, name, length);
    names->items = grow(names->items, names->item_count, &names->capacity, sizeof *names->items);
    names->items[names->item_count++] = copy;
}

const char *names_list(const struct names *names, char *out, size_t out_b)
{
    const size_t told = names->item_count < MOST_TOLD ? names->item_count : MOST_TOLD;
    size_t used = 0;
    *out = '\0';
    for (size_t i = 0; i < told && used < out_b; i++)
        used += (size_t)snprintf(out + used, out_b - used, "%s'%s'", i ? ", " : "", name_end(names->items[i]).text);
    if (names->item_count == MOST_KEPT && used < out_b)
        snprintf(out + used, out_b - used, " and many more");
    else if (names->item_count > told && used < out_b)
        snprintf(out + used, out_b - used, " and %zu more", names->item_count - told);
    return out;
}

void names_free(struct names *names)
{
    for (size_t i = 0; i < names->item_count; i++)
        free(names->items[i]);
    free(names->items);
    *names = (struct names){0};
}
