/* SPDX-License-Identifier: MIT */
#include "render/portal_best.h"

#include "base/grow.h"
#include "portals/pvs.h"
#include "scene/records.h"

#include <stdlib.h>
#include <string.h>

/* Records have numbers in their order in the scene, nodes name the words that their runs begin at. */
static void note_run(struct portal_best *best, const uint32_t *number_at, lim_index run, lim_index box)
{
    if (run == LIM_NO_INDEX) return;
    const lim_index *polygons = best->compiled->scene.polygons;
    for (size_t word = run;; word += lim_record_words(polygons[word])) {
        best->box_of_record[number_at[word]] = box;
        if (polygons[word] & LIM_POLYGON_LAST) return;
    }
}

static void records_find(struct portal_best *best)
{
    const struct lim_scene *scene = &best->compiled->scene;
    uint32_t *number_at = grow_zeroed(scene->polygon_words, sizeof *number_at), number = 0;
    for (size_t word = 0; word < scene->polygon_words; word += record_at(scene, word).words)
        number_at[word] = number++;
    best->box_of_record = grow_zeroed(scene->polygon_count, sizeof *best->box_of_record);
    for (size_t i = 0; i < scene->node_count; i++) {
        note_run(best, number_at, scene->nodes[i].front_run, best->boxes.of_node[i]);
        note_run(best, number_at, scene->nodes[i].back_run, best->boxes.of_node[i]);
    }
    free(number_at);
}

bool portal_best_init(struct portal_best *best, const struct compiled *scene, const struct simulator_setup *setup,
                      struct error *err)
{
    *best = (struct portal_best){.scene = scene->scene, .compiled = scene};
    if (!ids_init(&best->ids, scene, setup, err)) return false;
    boxes_find(&best->boxes, &scene->scene);
    records_find(best);
    const size_t packed_b = 2 * best->boxes.bits_b;
    best->bits = grow_zeroed(best->boxes.bits_b, 1);
    best->packed = grow_zeroed(packed_b, 1);
    best->scene.places = &best->place; /* cell 0, and all that follow */
    best->scene.place_count = 1;
    best->scene.pvs = best->packed;
    best->scene.pvs_bytes = (uint16_t)(packed_b < UINT16_MAX ? packed_b : UINT16_MAX);
    return true;
}

void portal_best_free(struct portal_best *best)
{
    ids_free(&best->ids);
    boxes_free(&best->boxes);
    free(best->box_of_record);
    free(best->bits);
    free(best->packed);
}

bool portal_best_see(struct portal_best *best, const struct lim_camera *camera, struct error *err)
{
    if (!ids_frame(&best->ids, camera, err)) return false;
    const size_t pixel_count = simulator_pixel_count(&best->ids.simulator);
    memset(best->bits, 0, best->boxes.bits_b);
    for (size_t i = 0; i < pixel_count; i++)
        if (best->ids.numbers[i]) boxes_show(&best->boxes, best->box_of_record[best->ids.numbers[i] - 1], best->bits);
    memset(best->packed, 0, 2 * best->boxes.bits_b);
    pvs_pack(best->bits, best->boxes.bits_b, best->packed);
    return true;
}
