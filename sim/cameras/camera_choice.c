/* SPDX-License-Identifier: MIT
 *
 * A word before the first colon tells random cameras from files. */
#include "cameras/camera_choice.h"

#include "base/parse.h"
#include "cameras/gltf_cameras.h"
#include "cameras/level_path_cameras.h"
#include "cameras/random_path.h"
#include "levels/level_path.h"

#include <stdio.h>
#include <string.h>

enum { RANDOM_MAX = 10000 };
static const char *const WORDS[CAMERA_KINDS] = {
    [CAMERA_ANYWHERE] = "random:", [CAMERA_NEAR] = "near:", [CAMERA_GRAZING] = "grazing:"};

static bool parse_part(const char *name, const char *from, size_t length, uint32_t least, uint32_t most, uint32_t *out,
                       struct error *err)
{
    char text[16];
    if (length >= sizeof text) return error_set(err, "%s: too long: %.32s", name, from);
    snprintf(text, sizeof text, "%.*s", (int)length, from);
    return parse_whole(name, text, least, most, out, err);
}

bool camera_choice_parse(const char *text, struct camera_choice *out, struct error *err)
{
    char seed_name[32], frames_name[40];
    *out = (struct camera_choice){.text = text, .takes_times = true};
    while (out->kind < CAMERA_KINDS && strncmp(text, WORDS[out->kind], strlen(WORDS[out->kind])) != 0)
        out->kind++;
    if (out->kind == CAMERA_KINDS) return true;
    snprintf(seed_name, sizeof seed_name, "--camera %sSEED", WORDS[out->kind]);
    snprintf(frames_name, sizeof frames_name, "%s:FRAMES", seed_name);
    const char *seed = strchr(text, ':') + 1, *colon = strchr(seed, ':');
    uint32_t count = CAMERA_CHOICE_RANDOM;
    if (!parse_part(seed_name, seed, strcspn(seed, ":"), 0, UINT32_MAX, &out->seed, err)) return false;
    if (colon && !parse_part(frames_name, colon + 1, strlen(colon + 1), 1, RANDOM_MAX, &count, err)) return false;
    out->random_count = count;
    return true;
}

bool camera_choice_read(const struct camera_choice *choice, struct camera_path *out, struct error *err)
{
    if (!choice->text || choice->random_count > 0) return true;
    if (level_path_parse(choice->text, NULL)) return level_path_cameras(choice->text, 0, out, err);
    if (gltf_cameras_are_named(choice->text))
        return gltf_cameras_read(choice->text, choice->z_is_up, choice->fov_deg, out, err);
    return camera_path_read(choice->text, out, err) && (choice->takes_times || camera_path_is_timeless(out, err));
}

bool camera_choice_plan(const struct camera_choice *choice, const struct compiled *scene, const struct lens *lens,
                        size_t orbit_frames, struct camera_path *path, struct error *err)
{
    if (path->count > 0) return true;
    if (choice->random_count > 0 && choice->kind == CAMERA_NEAR)
        return near_path(scene, lens, choice->text, choice->seed, choice->random_count, path, err);
    if (choice->random_count > 0 && choice->kind == CAMERA_GRAZING)
        return grazing_path(scene, lens, choice->text, choice->seed, choice->random_count, path, err);
    if (choice->random_count > 0)
        return random_path(scene, choice->text, choice->seed, choice->random_count, path, err);
    if (choice->level && orbit_frames) return level_path_cameras(choice->level, orbit_frames, path, err);
    return camera_path_orbit(scene, lens, orbit_frames, path, err);
}
