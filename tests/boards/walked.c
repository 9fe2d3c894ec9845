/* SPDX-License-Identifier: MIT
 *
 * The frames that a board must draw whose buttons were these: walked MODEL.lim [options of `limner render`] <BUTTONS;
 * with WALLS=no in the environment those of one that no wall stops.
 * In: a number a line, enum board_button, for each frame from the first. Out: a hash file. The steps are those of the
 * board's own code, the pixels the simulator's. */
#include "cli/options.h"
#include "pictures/hashes.h"
#include "scene/moving.h"
#include "walker.h"

#include <stdlib.h>
#include <string.h>

enum { FRAMES_MAX = 1000 };

struct walked {
    struct options options;
    struct compiled scene;
    struct moving moving;
    struct lens lens;
    struct camera_path path;
    struct simulator simulator;
    struct walker walker;
    struct lim_solid solid;
    lim_index *stack;
    uint64_t hashes[FRAMES_MAX];
    size_t count;
};

static bool draw(struct walked *walked, uint8_t buttons, struct error *err)
{
    struct lim_camera camera;

    if (walked->count == FRAMES_MAX) return error_set(err, "more than %d frames", FRAMES_MAX);
    if (!camera_path_to_camera(&walked->path, walked->count % walked->path.count, &walked->lens, &walked->scene.grid,
                               &camera, err))
        return false;
    walker_frame(&walked->walker, buttons, &camera);
    if (!simulator_frame(&walked->simulator, &camera, err)) return false;
    walked->hashes[walked->count++] = hash_pixels(walked->simulator.pixels, simulator_pixel_count(&walked->simulator));
    return true;
}

static bool meet_walls(struct walked *walked)
{
    const struct lim_scene *scene = &walked->scene.scene;
    const size_t mem_b = (scene->limits.depth + 1u) * sizeof *walked->stack;

    walked->stack = malloc(mem_b);
    walker_set_solid(&walked->walker, &walked->solid);
    return walked->stack && !lim_solid_init(&walked->solid, scene, walked->stack, mem_b);
}

static bool run(struct walked *walked, int argc, char **argv, struct error *err)
{
    struct options *options = &walked->options;
    unsigned buttons;

    if (!options_parse(argc, argv, OPTIONS_RENDER, &walked->options, err) ||
        !options_load(options, &walked->scene, &walked->moving, &walked->lens, &walked->path, err) ||
        !simulator_init_on(&walked->simulator, &walked->scene.scene, &options->setup, &options->panel, err))
        return false;
    const char *const walls = getenv("WALLS");
    if (!(walls && !strcmp(walls, "no")) && !meet_walls(walked)) return error_set(err, "the scene has no tree");
    while (scanf("%u", &buttons) == 1)
        if (!draw(walked, (uint8_t)buttons, err)) return false;
    return hashes_write(walked->hashes, walked->count, stdout) || error_set(err, "hashes cannot be written");
}

int main(int argc, char **argv)
{
    static struct walked walked;
    struct error err;
    const bool ok = run(&walked, argc, argv, &err);

    if (!ok) fprintf(stderr, "walked: %s\n", err.text);
    simulator_free(&walked.simulator);
    free(walked.stack);
    camera_path_free(&walked.path);
    moving_free(&walked.moving);
    compiled_free(&walked.scene);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
