/* SPDX-License-Identifier: MIT
 *
 * Any triangles as a mesh, by distance or with depths from any of them on, by two sets of means, of which none may
 * show. */
#include "fuzz_scene.h"
#include "fuzz_show.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

/* Meshes are drawn without outlines and smooth edges; and whole. */
static struct fuzz_look mesh_look_from(struct fuzz_bytes *bytes)
{
    struct fuzz_look look = fuzz_look_from(bytes);

    look.method = look.method & 1 ? LIM_MESH_DEPTH : LIM_MESH;
    look.wireframe = (struct lim_wireframe){0};
    look.antialias = false;
    return look;
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_subject subject = {0};
    struct fuzz_means means[2];
    struct fuzz_scene made;
    struct error err;

    const struct fuzz_look look = mesh_look_from(&bytes);
    fuzz_means_both_from(&bytes, means);
    means[0].page_px = means[1].page_px = 0;
    fuzz_view_from(&bytes, &subject);
    fuzz_scene_make_mesh(&made, &bytes);
    fuzz_scene_add_places(&made, &bytes);
    subject.scene = &made.scene;
    if (!lim_check(subject.scene, &err)) return "a valid mesh was refused";
    return fuzz_show_both(&subject, &look, means);
}

const struct fuzz_target fuzz_mesh = {"mesh", run, NULL};
