/* SPDX-License-Identifier: MIT
 *
 * Small frames of the scenes in sim/scenes, in every profile and by every method, and with what firmware can do beside:
 * their pixels and what they took are as in tests/golden/golden_frames.expected. Other tests say which frames are
 * right; this one tells that a change which was to change none did. GOLDEN_FRAMES=write writes the file anew: what
 * changes in it is explained where it is committed. */
#include "core/core.h"
#include "golden_stage.h"
#include "rigs/cmocka_ready.h"
#include "scene/moving.h"

static void put_frames(struct simulator *simulator, struct golden_stage *stage, const struct golden_way *way)
{
    uint32_t hash = GOLDEN_HASH, sums[8] = {0};

    for (size_t frame = 0; frame < stage->path.count; frame++) {
        struct lim_camera camera;
        struct error err;
        if (stage->moving.count) moving_pose(&stage->moving, moving_time_s(&stage->moving, frame, GOLDEN_FRAMES));
        if (!camera_path_to_camera(&stage->path, frame, &stage->lens, &stage->scene.grid, &camera, &err) ||
            !simulator_frame(simulator, &camera, &err))
            fail_msg("%s", err.text);
        const struct lim_stats *stats = simulator_stats(simulator);
        const uint32_t taken[] = {
            stats->polygons, stats->polygons_seen, stats->vertices,       stats->clipped,
            stats->lines,    stats->boxes_out,     stats->pixels_painted, stats->retained_cells_max};
        for (size_t i = 0; i < sizeof taken / sizeof *taken; i++)
            sums[i] += taken[i];
        hash = golden_hash_frame(hash, simulator);
    }
    golden_put("%s %s %s: %08x", stage->name, simulator->core->name, way->name, hash);
    if (way->method != LIM_NEWELL) /* whose counts are for test_newell.c to bound */
        golden_put(", polygons %u, seen %u, vertices %u, clipped %u, lines %u, boxes out %u, pixels %u, cells %u",
                   sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], sums[6], sums[7]);
    golden_put("\n");
}

static void put_scene(struct golden_stage *stage)
{
    for (size_t k = 0; cores[k]; k++)
        for (const struct golden_way *way = golden_ways; way->name; way++) {
            struct simulator simulator;
            if (golden_begin(&simulator, stage, cores[k], way, GOLDEN_W_PX, GOLDEN_H_PX))
                put_frames(&simulator, stage, way);
            simulator_free(&simulator);
        }
}

static void frames_are_what_they_were(void **state)
{
    struct golden_stage stage;

    (void)state;
    for (size_t scene = 0; golden_open(&stage, scene); scene++) {
        put_scene(&stage);
        golden_close(&stage);
    }
    golden_compare("tests/golden/golden_frames.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(frames_are_what_they_were)};

    return cmocka_run_group_tests_name("golden_frames", tests, NULL, NULL);
}
