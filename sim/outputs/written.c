/* SPDX-License-Identifier: MIT */
#include "outputs/written.h"

#include "base/printable.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { FEWEST_OF_A_SERIES = 3 };

struct line {
    char *text;
    size_t used;
};

static void put(struct line *line, const char *text)
{
    for (; *text && line->used + 1 < WRITTEN_B; text++)
        line->text[line->used++] = *text;
    if (*text) memcpy(line->text + WRITTEN_B - 4, "...", 3);
    line->text[line->used] = '\0';
}

static bool differ_in_numbers(const char *a, const char *b)
{
    for (;;) {
        a += strspn(a, "0123456789");
        b += strspn(b, "0123456789");
        if (*a != *b) return false;
        if (!*a) return true;
        a++, b++;
    }
}

/* How many of them, from the first, are a series; 1 if it is none. */
static size_t series_of(const char *const *paths, size_t count)
{
    size_t length = 1;
    while (length < count && differ_in_numbers(paths[0], paths[length]))
        length++;
    return length < FEWEST_OF_A_SERIES ? 1 : length;
}

static void put_item(struct line *line, const char *const *paths, size_t series)
{
    char more[32];
    put(line, paths[0]);
    if (series == 1) return;
    snprintf(more, sizeof more, " (%zu files)", series);
    put(line, " to ");
    put(line, paths[series - 1]);
    put(line, more);
}

void written_text(const char *const *paths, size_t count, char text[WRITTEN_B])
{
    struct line line = {text, 0};
    const char *before = "wrote ";
    *text = '\0';
    for (size_t i = 0; i < count;) {
        const size_t series = series_of(paths + i, count - i);
        const bool is_last = i + series == count;
        put(&line, i > 0 && is_last ? " and " : before);
        put_item(&line, paths + i, series);
        before = ", ";
        i += series;
    }
    printable(text);
}

void written_say(const char *text)
{
    if (*text && isatty(STDOUT_FILENO)) puts(text);
}
