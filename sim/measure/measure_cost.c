/* SPDX-License-Identifier: MIT
 *
 * Scene and cameras become C, targets/count.sh makes an image of them and runs it, the counting plugin
 * watches. The frames' hashes must be the host's: what is counted is what was judged. */
#include "measure/measurement.h"

#include "base/child.h"
#include "base/choice.h"
#include "base/grow.h"
#include "cameras/cameras_c.h"
#include "core/core.h"
#include "measure/counts.h"
#include "pictures/hashes.h"
#include "render/caption.h"
#include "render/simulator.h"
#include "scene/moving.h"
#include "scene/scene_files.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if !defined(LIM_SOURCE_FOLDER) || !defined(LIM_COUNT_PLUGIN)
#error "LIM_SOURCE_FOLDER and LIM_COUNT_PLUGIN are set by the Makefile"
#endif

enum { PATH_MAX_B = 1024 };

/* Processors --------------------------------------------------------------------------------- */

#define ARM_TOOLS "arm-none-eabi-gcc", "gcc-arm-none-eabi", "qemu-system-arm", "qemu-system-arm"
#define RISCV_TOOLS "riscv64-unknown-elf-gcc", "gcc-riscv64-unknown-elf", "qemu-system-riscv32", "qemu-system-misc"

const struct measure_cpu measure_cpus[] = {{"m0plus", "Cortex-M0+", ARM_TOOLS},
                                           {"m3", "Cortex-M3", ARM_TOOLS},
                                           {"m4", "Cortex-M4F", ARM_TOOLS},
                                           {"m33", "Cortex-M33", ARM_TOOLS},
                                           {"rv32", "RV32IMC", RISCV_TOOLS}};
const size_t measure_cpu_count = sizeof measure_cpus / sizeof *measure_cpus;

static const char *name_at(const void *list, size_t index)
{
    const struct measure_cpu *of = list;
    return index < measure_cpu_count ? of[index].name : NULL;
}

const struct measure_cpu *measure_cpu_find(const char *name)
{
    for (size_t i = 0; i < measure_cpu_count; i++)
        if (choice_is(name, strlen(name), measure_cpus[i].name)) return &measure_cpus[i];
    return NULL;
}

static bool check_tool(const char *program, const char *package, struct error *err)
{
    return child_exists(program) ||
           error_set(err, "%s: not found; counting instructions needs Debian's package %s", program, package);
}

bool measure_cpu_parse(const char *name, const struct measure_cpu **out, struct error *err)
{
    size_t index;
    if (!choice_find(&(struct choice){"--core", "processor", name_at, measure_cpus}, name, &index, err)) return false;
    *out = &measure_cpus[index];
    return true;
}

bool measure_sources_check(struct error *err)
{
    if (access(LIM_SOURCE_FOLDER "/sim/targets/count.sh", R_OK) == 0 && access(LIM_COUNT_PLUGIN, R_OK) == 0)
        return true;
    return error_set(err, "counting instructions needs the source tree and the build that this program is from, %s",
                     LIM_SOURCE_FOLDER);
}

bool measure_cpu_check(const struct measure_cpu *cpu, struct error *err)
{
    return measure_sources_check(err) && check_tool(cpu->compiler, cpu->compiler_package, err) &&
           check_tool(cpu->emulator, cpu->emulator_package, err);
}

bool measure_optimise_check(const char *name, struct error *err)
{
    static const char *const names[] = {"speed", "balance", "size"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], name) == 0) return true;
    return error_set(err, "--optimise %s: speed, balance or size", name);
}

/* Steps -------------------------------------------------------------------------------------- */

/* One measurement under way. */
struct run {
    const struct measure_candidate *candidate;
    const struct measure_cpu *cpu;
    const struct measure_views *views;
    const char *folder;
};

static bool path_in(const struct run *run, const char *name, char path[PATH_MAX_B], struct error *err)
{
    return snprintf(path, PATH_MAX_B, "%s/%s", run->folder, name) < PATH_MAX_B ||
           error_set(err, "%.64s...: the path is too long", run->folder);
}

static bool write_scene(const struct run *run, struct error *err)
{
    char path[PATH_MAX_B];
    struct compiled scene = *run->candidate->scene; /* shares everything */
    scene.report.core = run->candidate->core;
    return path_in(run, "model", path, err) && c_source_write(&scene, path, err);
}

static bool write_cameras(const struct run *run, struct error *err)
{
    const struct measure_views *views = run->views;
    char path[PATH_MAX_B];
    if (!path_in(run, "cameras.h", path, err)) return false;
    FILE *file = fopen(path, "w");
    if (!file) return error_set(err, "%s: cannot be written", path);
    const struct moving *moving = run->candidate->scene->moving;
    double *times_s = moving ? grow_zeroed(views->path->count, sizeof *times_s) : NULL;
    for (size_t frame = 0; moving && frame < views->path->count; frame++)
        times_s[frame] = camera_path_time_s(views->path, frame, moving_length_s(moving));
    const bool ok = cameras_c_write(views->path, times_s, views->lens, &run->candidate->scene->grid, views->w_px,
                                    views->h_px, file, err);
    free(times_s);
    return (fclose(file) == 0 || error_set(err, "%s: cannot be written", path)) && ok;
}

static bool run_step(const struct run *run, const char *step, struct error *err)
{
    char log[PATH_MAX_B], task[128];
    const char *const optimise = run->views->optimise;
    const char *const argv[] = {"sh",
                                "sim/targets/count.sh",
                                step,
                                run->cpu->name,
                                run->folder,
                                LIM_COUNT_PLUGIN,
                                optimise ? optimise : "speed",
                                NULL};
    const struct child child = {.argv = argv, .folder = LIM_SOURCE_FOLDER, .log_path = log};
    snprintf(task, sizeof task, "%s, %s, %s", run->cpu->title, run->candidate->core->name, step);
    return path_in(run, "log", log, err) && child_run(&child, task, err);
}

/* Hashes of the frames, and the number of nodes that they visit, each of which is a plane test. */
static bool host_frames(const struct run *run, uint64_t *hashes, uint64_t *nodes, struct error *err)
{
    const struct measure_views *views = run->views;
    const struct compiled *scene = run->candidate->scene;
    const struct simulator_setup setup = {views->w_px, views->h_px, scene->report.draws, measure_panel(scene),
                                          run->candidate->core};
    struct simulator simulator;
    struct caption caption;
    if (!simulator_init(&simulator, &scene->scene, &setup, err)) return false;
    bool ok = simulator_add_movers(&simulator, scene, err) &&
              simulator_set_antialias(&simulator, scene->report.antialias, err);
    for (size_t frame = 0; ok && frame < views->path->count; frame++) {
        struct lim_camera camera;
        if (scene->moving)
            moving_pose(scene->moving, camera_path_time_s(views->path, frame, moving_length_s(scene->moving)));
        if (scene->report.overlay) caption_set(&caption, "frame #", frame, &simulator);
        ok = camera_path_to_camera(views->path, frame, views->lens, &scene->grid, &camera, err) &&
             simulator_frame(&simulator, &camera, err);
        if (!ok) break;
        hashes[frame] = hash_pixels(simulator.pixels, simulator_pixel_count(&simulator));
        *nodes += simulator_stats(&simulator)->nodes;
    }
    simulator_free(&simulator);
    return ok;
}

static bool check_frames(const struct run *run, uint64_t *nodes, struct error *err)
{
    char path[PATH_MAX_B];
    const size_t count = run->views->path->count;
    uint64_t *hashes = calloc(count, sizeof *hashes);
    const bool ok = (hashes || error_set(err, "frame hashes: out of memory")) && path_in(run, "hashes", path, err) &&
                    host_frames(run, hashes, nodes, err) && hashes_check(hashes, count, path, err);
    free(hashes);
    if (ok) return true;
    const struct error reason = *err;
    return error_set(err, "%s does not draw what this program draws (is it older than its source tree?): %.300s",
                     run->cpu->title, reason.text);
}

static bool count_image(const struct run *run, const struct link_map *map, struct cost *out, struct error *err)
{
    char ranges[PATH_MAX_B], counts[PATH_MAX_B], inlined[PATH_MAX_B];
    struct counts_run counted = {counts, inlined, run->views->path->count, 0};
    return path_in(run, "ranges", ranges, err) && path_in(run, "counts", counts, err) &&
           path_in(run, "inlined", inlined, err) && counts_write_ranges(map, ranges, err) &&
           run_step(run, "run", err) && check_frames(run, &counted.sides, err) && counts_read(map, &counted, out, err);
}

bool measure_cost(const struct measure_candidate *candidate, const struct measure_cpu *cpu,
                  const struct measure_views *views, const char *folder, struct cost *out, struct error *err)
{
    const struct run run = {candidate, cpu, views, folder};
    struct link_map map = {0};
    char path[PATH_MAX_B];
    *out = (struct cost){.vertex = NAN, .side = NAN};
    bool ok = measure_cpu_check(cpu, err) && write_scene(&run, err) && write_cameras(&run, err) &&
              run_step(&run, "build", err) && path_in(&run, "image.map", path, err) && link_map_read(path, &map, err) &&
              count_image(&run, &map, out, err);
    if (ok) counts_memory(&map, out);
    link_map_free(&map);
    return ok;
}

size_t cost_ram_b(const struct cost *cost)
{
    return cost->state_b + cost->pools_b + cost->static_b;
}

size_t cost_flash_b(const struct cost *cost)
{
    return cost->code_b + cost->library_b;
}
