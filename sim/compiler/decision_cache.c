/* SPDX-License-Identifier: MIT
 *
 * An entry is a report, a grid and an image, as this program has them in memory; the cache knows them by this build. */
#include "compiler/decision_cache.h"

#include "base/grow.h"
#include "model/original.h"
#include "scene/lim_image.h"

#include <stdlib.h>
#include <string.h>

struct entry {
    struct compile_report report; /* its pointers are nothing */
    struct grid grid;
    uint64_t image_b;
};

/* What leads elsewhere, and what whoever asks for the scene sets. */
static void forget_pointers(struct compile_report *report)
{
    report->path = (struct path_report){0};
    report->core = NULL;
    report->notes = NULL;
}

bool decision_cache_find(const uint8_t key[CACHE_KEY_B], const struct mesh *mesh, const struct compile_options *options,
                         struct compiled *out)
{
    size_t n_b;
    struct entry entry;
    uint8_t *bytes = cache_find(key, &n_b);
    if (!bytes) return false;
    const bool ok = n_b >= sizeof entry + sizeof(struct lim_file_header) &&
                    (memcpy(&entry, bytes, sizeof entry), entry.image_b == n_b - sizeof entry);
    if (ok) {
        uint8_t *image = grow_zeroed(entry.image_b, 1);
        memcpy(image, bytes + sizeof entry, entry.image_b);
        *out = (struct compiled){.report = entry.report, .grid = entry.grid};
        lim_image_bind(image, out);
        out->report.path = (struct path_report){options->path.name, options->path.frames, options->path.count};
        out->original = mesh->original ? original_share(mesh->original) : NULL;
    }
    free(bytes);
    return ok;
}

void decision_cache_keep(const uint8_t key[CACHE_KEY_B], const struct compiled *scene)
{
    if (!cache_is_open() || scene->report.note_count || scene->moving) return;
    const size_t n_b = sizeof(struct entry) + scene->image_b;
    uint8_t *bytes = grow_zeroed(n_b, 1);
    struct entry *entry = grow_zeroed(1, sizeof *entry);
    *entry = (struct entry){.report = scene->report, .grid = scene->grid, .image_b = scene->image_b};
    forget_pointers(&entry->report);
    memcpy(bytes, entry, sizeof *entry);
    memcpy(bytes + sizeof *entry, scene->image, scene->image_b);
    cache_keep(key, bytes, n_b);
    free(entry);
    free(bytes);
}
