/* SPDX-License-Identifier: MIT
 *
 * `limner wad FILE.wad`: the maps of a WAD, a line each: what they consist of, or why they cannot be read. */
#include "base/printable.h"
#include "cli/commands.h"
#include "levels/level.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *format_of(const struct wad *wad)
{
    return memcmp(wad->files[wad->file_count - 1].bytes, "IWAD", 4) == 0 ? "an IWAD" : "a PWAD";
}

/* Later ones of the same name take its place. */
static bool is_last(const struct wad *wad, size_t lump)
{
    for (size_t i = lump + 1; i < wad->lump_count; i++)
        if (level_begins_at(wad, i) && strcmp(wad->lumps[i].name, wad->lumps[lump].name) == 0) return false;
    return true;
}

static void print_map(const struct wad *wad, const char *name)
{
    struct level level;
    struct error err;
    if (level_read(wad, name, &level, &err))
        printable_print(stdout, "%-8s %5zu %8zu %7zu %6zu\n", name, level.line_count, level.vertex_count,
                        level.sector_count, level.thing_count);
    else
        printable_print(stdout, "%-8s %s\n", name, err.text);
    level_free(&level);
}

static bool list(const char *paths, struct error *err)
{
    struct wad wad;
    size_t maps = 0;
    if (!wad_open(paths, &wad, err)) return false;
    for (size_t i = 0; i < wad.lump_count; i++) {
        if (!level_begins_at(&wad, i) || !is_last(&wad, i)) continue;
        if (!maps++) {
            printable_print(stdout, "%s: %s\n", paths, format_of(&wad));
            printf("%-8s %5s %8s %7s %6s\n", "map", "lines", "vertices", "sectors", "things");
        }
        print_map(&wad, wad.lumps[i].name);
    }
    wad_close(&wad);
    return maps > 0 || error_set(err, "%s: there are no maps in it", paths);
}

int cmd_wad(int argc, char **argv)
{
    struct error err;
    bool ok = argc == 2 || error_set(&err, "wad: needs one WAD, or IWAD.wad+PWAD.wad");
    if (ok && argv[1][0] == '-') ok = error_no_option(&err, argv[1]);
    ok = ok && list(argv[1], &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
