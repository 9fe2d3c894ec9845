/* SPDX-License-Identifier: MIT
 *
 * An object file of the folder firmware/ or of a room in it is a stage; libgcc and the memory functions that compilers
 * call are helpers, charged to the stage that called them; all else (start-up, target) is left out. */
#include "measure/counts.h"

#include "base/grow.h"
#include "targets/count_check.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEP_B = 2 }; /* instructions of these processors are this long, or twice */

enum owner { OWNER_STAGE, OWNER_HELPER, OWNER_SCENE, OWNER_OTHER };

/* Whose -------------------------------------------------------------------------------------- */

static bool is_code(const struct link_section *section)
{
    return link_section_is(section, ".text") || link_section_is(section, ".vectors");
}

static const char *last_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* FOLDER/firmware/FILE or FOLDER/firmware/ROOM/FILE */
static bool is_in_firmware(const char *object)
{
    static const char folder[] = "firmware/";

    for (const char *at = object; (at = strstr(at, folder)) != NULL; at++) {
        const char *slash = strchr(at + sizeof folder - 1, '/');
        if ((at == object || at[-1] == '/') && (!slash || !strchr(slash + 1, '/'))) return true;
    }
    return false;
}

static enum owner owner_of(const struct link_section *section)
{
    if (is_in_firmware(section->object)) return OWNER_STAGE;
    if (strncmp(last_of(section->object), "libgcc.a(", 9) == 0) return OWNER_HELPER;
    if (link_section_is(section, ".text.memcpy") || link_section_is(section, ".text.memset")) return OWNER_HELPER;
    return strncmp(last_of(section->object), "model", 5) == 0 ? OWNER_SCENE : OWNER_OTHER; /* model_movers.o too */
}

/* Ranges ------------------------------------------------------------------------------------- */

struct range {
    const struct link_section *section;
    uint64_t start, end;
    bool is_entry;
    bool is_side; /* a part of the plane test */
};

struct ranges {
    struct range *items;
    size_t count, capacity;
};

static void add_range(struct ranges *ranges, const struct link_section *section, uint64_t start, uint64_t end)
{
    ranges->items = grow(ranges->items, ranges->count, &ranges->capacity, sizeof *ranges->items);
    ranges->items[ranges->count++] = (struct range){
        .section = section, .start = start, .end = end, .is_entry = start == section->start && end == start + STEP_B};
}

/* Whether the plane test may be inlined in a section's functions: WALK calls it. */
static bool has_inlined(const struct link_section *section)
{
    return strcmp(last_of(section->object), "walk.o") == 0;
}

static void add_section(struct ranges *ranges, const struct link_section *section)
{
    const uint64_t end = section->start + section->size_b;
    uint64_t at = section->start;
    if (owner_of(section) == OWNER_STAGE && section->size_b > STEP_B) {
        do {
            add_range(ranges, section, at, at + STEP_B);
            at += STEP_B;
        } while (has_inlined(section) && at + STEP_B < end);
    }
    add_range(ranges, section, at, end);
}

/* In the order of their addresses; the caller frees the items. */
static struct ranges ranges_of(const struct link_map *map)
{
    struct ranges ranges = {0};
    for (size_t i = 0; i < map->count; i++)
        if (is_code(&map->sections[i])) add_section(&ranges, &map->sections[i]);
    return ranges;
}

static const struct link_section *function_find(const struct link_map *map, const char *section_name)
{
    for (size_t i = 0; i < map->count; i++)
        if (strcmp(map->sections[i].name, section_name) == 0) return &map->sections[i];
    return NULL;
}

bool counts_write_ranges(const struct link_map *map, const char *path, struct error *err)
{
    const struct link_section *begin = function_find(map, ".text.frame_begin");
    const struct link_section *end = function_find(map, ".text.frame_end");
    if (!begin || !end) return error_set(err, "%s: the image has no marks around a frame", path);
    struct ranges ranges = ranges_of(map);
    FILE *file = fopen(path, "w");
    for (size_t i = 0; file && i < ranges.count; i++)
        fprintf(file, "%s %" PRIx64 " %" PRIx64 "\n",
                owner_of(ranges.items[i].section) == OWNER_HELPER ? "helper" : "range", ranges.items[i].start,
                ranges.items[i].end);
    if (file) fprintf(file, "begin %" PRIx64 "\nend %" PRIx64 "\n", begin->start, end->start);
    const bool ok = file && !ferror(file);
    free(ranges.items);
    return (file && fclose(file) == 0 && ok) || error_set(err, "%s: cannot be written", path);
}

/* Kernels ------------------------------------------------------------------------------------ */

/* Functions whose cost a call is asked for: a vertex that VIEW takes in is transformed, looked at and projected. */
enum kernel { KERNEL_VERTEX, KERNELS };

struct kernel_counts {
    uint64_t calls, instructions;
};

static const char *const KERNEL_FUNCTIONS[KERNELS] = {".text.lim_view_remember"};

static enum kernel kernel_of(const struct link_section *section)
{
    enum kernel kernel = 0;
    while (kernel < KERNELS && !link_section_is(section, KERNEL_FUNCTIONS[kernel]))
        kernel++;
    return kernel;
}

static double ratio(uint64_t instructions, uint64_t calls)
{
    return calls ? (double)instructions / (double)calls : NAN;
}

static struct range *range_at(const struct ranges *ranges, uint64_t start)
{
    for (size_t i = 0; i < ranges->count; i++)
        if (ranges->items[i].start == start) return &ranges->items[i];
    return NULL;
}

/* What addr2line says of an address: the address, then, from the innermost function outwards, a line with the
 * function's name and one with FILE:LINE. The plane test is what comes from eye.h and eye.c; setting the eye,
 * once a frame, is not. */
static bool mark_sides(const struct ranges *ranges, const char *path, struct error *err)
{
    char line[1024];
    struct range *range = NULL;
    bool is_setting = false;
    FILE *file = fopen(path, "r");
    if (!file) return error_set(err, "%s: %s", path, strerror(errno));
    while (fgets(line, sizeof line, file)) {
        uint64_t start;
        const char *name = last_of(line);
        if (sscanf(line, "0x%" SCNx64, &start) == 1) {
            range = range_at(ranges, start);
            is_setting = false;
        }
        is_setting |= strncmp(line, "lim_eye_set", 11) == 0;
        if (range && (strncmp(name, "eye.c:", 6) == 0 || strncmp(name, "eye.h:", 6) == 0)) range->is_side = true;
        if (range && is_setting) range->is_side = false;
    }
    fclose(file);
    return true;
}

/* Frames ------------------------------------------------------------------------------------- */

/* Sums while the frames are read. */
struct folding {
    const struct counts_run *run;
    struct ranges ranges;
    struct cost *cost;
    size_t *stage_of; /* of each range; COST_STAGES_MAX: none */
    struct kernel_counts kernels[KERNELS];
    uint64_t side_instructions;
};

static size_t stage_index(struct cost *cost, const struct link_section *section)
{
    const char *name = last_of(section->object);
    const int length = (int)strcspn(name, ".");
    for (size_t i = 0; i < cost->stage_count; i++)
        if (strlen(cost->stages[i].name) == (size_t)length && strncmp(cost->stages[i].name, name, (size_t)length) == 0)
            return i;
    if (cost->stage_count == COST_STAGES_MAX) return COST_STAGES_MAX;
    snprintf(cost->stages[cost->stage_count].name, COST_NAME_B, "%.*s", length, name);
    return cost->stage_count++;
}

static bool find_stages(struct folding *folding, struct error *err)
{
    for (size_t i = 0; i < folding->ranges.count; i++) {
        const struct link_section *section = folding->ranges.items[i].section;
        folding->stage_of[i] = COST_STAGES_MAX;
        if (owner_of(section) != OWNER_STAGE) continue;
        folding->stage_of[i] = stage_index(folding->cost, section);
        if (folding->stage_of[i] == COST_STAGES_MAX)
            return error_set(err, "the renderer has more than %d source files", COST_STAGES_MAX);
    }
    return true;
}

/* The compiler may move what is rarely run into a function of its own. */
static bool is_part(const struct link_section *section)
{
    return strstr(section->name, ".part.") || strstr(section->name, ".cold");
}

static void fold_kernels(struct folding *folding, const struct range *range, uint64_t own, uint64_t helpers)
{
    const enum kernel kernel = kernel_of(range->section);
    if (range->is_side) folding->side_instructions += own + helpers;
    if (kernel == KERNELS) return;
    folding->kernels[kernel].instructions += own + helpers;
    if (range->is_entry && !is_part(range->section)) folding->kernels[kernel].calls += own;
}

/* Means are sums until the last frame. numbers: own and helpers of each range. */
static void fold_frame(struct folding *folding, const uint64_t *numbers)
{
    struct cost *cost = folding->cost;
    uint64_t stages[COST_STAGES_MAX] = {0}, total = 0;
    for (size_t i = 0; i < folding->ranges.count; i++) {
        const size_t stage = folding->stage_of[i];
        const uint64_t own = numbers[2 * i], helpers = numbers[2 * i + 1];
        if (stage == COST_STAGES_MAX) continue;
        stages[stage] += own + helpers;
        total += own + helpers;
        cost->stages[stage].library += (double)helpers;
        fold_kernels(folding, &folding->ranges.items[i], own, helpers);
    }
    for (size_t s = 0; s < cost->stage_count; s++) {
        cost->stages[s].mean += (double)stages[s];
        if (stages[s] > cost->stages[s].worst) cost->stages[s].worst = stages[s];
    }
    cost->mean += (double)total;
    if (total > cost->worst) cost->worst_frame = cost->frames;
    if (total > cost->worst) cost->worst = total;
    cost->frames++;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct cost_stage *)a)->name, ((const struct cost_stage *)b)->name);
}

static void finish(struct folding *folding)
{
    struct cost *cost = folding->cost;
    const double frames = (double)cost->frames;
    size_t used = 0;
    for (size_t s = 0; s < cost->stage_count; s++) {
        if (!cost->stages[s].worst) continue;
        cost->stages[used] = cost->stages[s];
        cost->stages[used].mean /= frames;
        cost->stages[used++].library /= frames;
    }
    cost->stage_count = used;
    qsort(cost->stages, used, sizeof *cost->stages, by_name);
    cost->mean /= frames;
    const struct kernel_counts *vertex = &folding->kernels[KERNEL_VERTEX];
    cost->vertex = ratio(vertex->instructions, vertex->calls);
    cost->side = ratio(folding->side_instructions, folding->run->sides);
}

/* Files -------------------------------------------------------------------------------------- */

static bool read_frame(FILE *file, uint64_t *numbers, size_t count)
{
    char word[8];
    bool ok = fscanf(file, "%7s", word) == 1 && strcmp(word, "frame") == 0;
    for (size_t i = 0; ok && i < count; i++)
        ok = fscanf(file, "%" SCNu64, &numbers[i]) == 1;
    return ok;
}

static bool check_loop(const struct folding *folding, const uint64_t *numbers, struct error *err)
{
    uint64_t counted = 0;
    for (size_t i = 0; i < folding->ranges.count; i++)
        if (link_section_is(folding->ranges.items[i].section, ".text.count_check_loop")) counted += numbers[2 * i];
    return counted == COUNT_CHECK_INSTRUCTIONS ||
           error_set(err, "the counter is wrong: a loop of %d instructions counts as %" PRIu64,
                     (int)COUNT_CHECK_INSTRUCTIONS, counted);
}

static bool read_frames(FILE *file, struct folding *folding, uint64_t *numbers, struct error *err)
{
    const size_t number_count = 2 * (folding->ranges.count + 1); /* all other addresses come last */
    const size_t frames = folding->run->frames;
    const char *path = folding->run->counts_path;
    char word[8];
    if (!read_frame(file, numbers, number_count)) return error_set(err, "%s: nothing was counted", path);
    if (!check_loop(folding, numbers, err) || !find_stages(folding, err)) return false;
    for (size_t frame = 0; frame < frames; frame++) {
        if (!read_frame(file, numbers, number_count))
            return error_set(err, "%s: only %zu of %zu frames were counted", path, frame, frames);
        fold_frame(folding, numbers);
    }
    if (fscanf(file, "%7s", word) == 1 && strcmp(word, "done") == 0) return true;
    return error_set(err, "%s: does not end after %zu frames", path, frames);
}

bool counts_read(const struct link_map *map, const struct counts_run *run, struct cost *out, struct error *err)
{
    FILE *file = fopen(run->counts_path, "r");
    if (!file) return error_set(err, "%s: %s", run->counts_path, strerror(errno));
    struct folding folding = {.run = run, .cost = out, .ranges = ranges_of(map)};
    folding.stage_of = grow_zeroed(folding.ranges.count + 1, sizeof *folding.stage_of);
    uint64_t *numbers = grow_zeroed(2 * (folding.ranges.count + 1), sizeof *numbers);
    const bool ok = mark_sides(&folding.ranges, run->inlined_path, err) && read_frames(file, &folding, numbers, err);
    if (ok) finish(&folding);
    free(numbers);
    free(folding.stage_of);
    free(folding.ranges.items);
    fclose(file);
    return ok;
}

/* Memory ------------------------------------------------------------------------------------- */

static bool is_variable(const struct link_section *section)
{
    return link_section_is(section, ".bss") || link_section_is(section, ".sbss") || link_section_is(section, ".data") ||
           link_section_is(section, ".sdata");
}

void counts_memory(const struct link_map *map, struct cost *out)
{
    for (size_t i = 0; i < map->count; i++) {
        const struct link_section *section = &map->sections[i];
        const size_t size_b = (size_t)section->size_b;
        const enum owner owner = owner_of(section);
        if (strcmp(section->name, ".bss.lim") == 0) out->state_b += size_b;
        if (strcmp(section->name, ".bss.mem") == 0 || strcmp(section->name, ".bss.mover_mem") == 0)
            out->pools_b += size_b;
        if (is_variable(section)) {
            if (owner == OWNER_STAGE) out->static_b += size_b;
            continue;
        }
        if (owner == OWNER_STAGE) out->code_b += size_b;
        if (owner == OWNER_HELPER) out->library_b += size_b;
        if (owner == OWNER_SCENE) out->scene_b += size_b;
    }
}
