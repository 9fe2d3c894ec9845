/* SPDX-License-Identifier: MIT
 *
 * See bsp_rig.h. */
#include "bsp_rig.h"

#include "cmocka_ready.h"

#include <string.h>

void bsp_rig_make(struct bsp_rig *rig, const struct mesh *mesh, enum tree_kind kind)
{
    const struct splitter *splitter = &splitters[0];
    const double tolerance = 0.5;

    for (size_t i = 0; i < splitter_count; i++)
        if (strcmp(splitters[i].name, "weighted-12") == 0) splitter = &splitters[i];
    *rig = (struct bsp_rig){0};
    for (size_t i = 0; i < mesh->point_count; i++)
        exact_add_m(&rig->points, mesh->points[i], &mesh->grid);
    coplanar_find(mesh, rig->points.approx, tolerance, &rig->coplanar);
    const struct tree_plan plan = {kind, splitter, tolerance, NULL};
    assert_true(bsp_build(&rig->bsp, mesh, &rig->coplanar, &plan, &rig->points));
    rig->all = rig->bsp.placed;
}

void bsp_rig_free(struct bsp_rig *rig)
{
    bsp_free(&rig->bsp);
    coplanar_free(&rig->coplanar);
    exact_free(&rig->points);
}
