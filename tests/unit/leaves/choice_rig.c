/* SPDX-License-Identifier: MIT */
#include "unit/leaves/choice_rig.h"

#include "accuracy/predict.h"
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"

struct compile_options choice_rig_options(void)
{
    return (struct compile_options){.tolerance_units = 0.5, .splitter = "weighted-12", .choose_order = true};
}

struct compiled choice_rig_compile(const struct mesh *mesh, const struct compile_options *options)
{
    struct compiled scene;
    struct error err;
    if (!compile_mesh(mesh, options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

struct reference choice_rig_reference(const struct mesh *mesh)
{
    struct reference reference = {0};
    struct error err;
    if (!reference_init(&reference, mesh, PREDICT_SIDE_PX, PREDICT_SIDE_PX, &err)) fail_msg("%s", err.text);
    return reference;
}

void choice_rig_assert_open(const struct mesh *mesh, choice_rig_is_tried *is_tried)
{
    struct compile_options options = choice_rig_options();
    assert_true(is_tried(mesh, &options));
    options.core = &core_exact;
    assert_false(is_tried(mesh, &options));
    options = choice_rig_options();
    options.method = method_parse("nearest", NULL);
    assert_false(is_tried(mesh, &options));
    options = choice_rig_options();
    options.tree = TREE_BSP;
    assert_false(is_tried(mesh, &options));
    options = choice_rig_options();
    options.wireframe = true;
    assert_false(is_tried(mesh, &options));
    options = choice_rig_options();
    options.choose_order = false;
    assert_false(is_tried(mesh, &options));
}
