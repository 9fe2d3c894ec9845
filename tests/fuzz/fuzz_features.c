/* SPDX-License-Identifier: MIT
 *
 * Any valid scene with glass, textures and visible sets, in any look, by two sets of means, of which none may show. */
#include "fuzz_scene.h"
#include "fuzz_show.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_subject subject = {0};
    struct fuzz_means means[2];
    struct fuzz_scene made;
    struct error err;

    const struct fuzz_look look = fuzz_look_from(&bytes);
    fuzz_means_both_from(&bytes, means);
    /* Which may show: it says how often polygons may be split, and whether glass has smooth edges. */
    if (look.method == LIM_NEWELL || look.antialias) means[1].memory = means[0].memory;
    fuzz_view_from(&bytes, &subject);
    if (look.method == LIM_CONVEX)
        fuzz_scene_make_chain(&made, &bytes);
    else
        fuzz_scene_make(&made, &bytes);
    fuzz_scene_add_extras(&made, &bytes);
    fuzz_scene_add_kinds(&made, &bytes);
    subject.scene = &made.scene;
    if (!lim_check(subject.scene, &err)) return "a valid scene was refused";
    return fuzz_show_both(&subject, &look, means);
}

const struct fuzz_target fuzz_features = {"features", run, NULL};
