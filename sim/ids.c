/* SPDX-License-Identifier: MIT
 *
 * The copied scene shares everything with the original but the polygon records. */
#include "ids.h"

#include <stdlib.h>
#include <string.h>

/* Records follow each other without gaps: SCENE.md. What is transparent becomes opaque: a pixel has the number of the
 * nearest polygon, whatever shines through it. */
static void number_records(struct ids *ids)
{
    uint16_t colour = 1;
    for (size_t word = 0; word < ids->scene.polygon_words; colour++) {
        const uint16_t head = ids->polygons[word];
        ids->polygons[word + 1] = colour;
        if (head & LIM_POLYGON_ALPHA) ids->polygons[word + lim_record_alpha_at(head)] = LIM_OPAQUE;
        word += lim_record_words(head);
    }
}

static bool copy_scene(struct ids *ids, const struct compiled *scene)
{
    const struct lim_scene *original = &scene->scene;
    ids->scene = *original;
    ids->polygons = malloc(original->polygon_words * sizeof ids->polygons[0]);
    ids->face_of_colour = malloc((original->polygon_count + 1u) * sizeof ids->face_of_colour[0]);
    if (!ids->polygons || !ids->face_of_colour) return false;
    memcpy(ids->polygons, original->polygons, original->polygon_words * sizeof ids->polygons[0]);
    number_records(ids);
    ids->face_of_colour[0] = 0;
    memcpy(ids->face_of_colour + 1, scene->faces, original->polygon_count * sizeof ids->face_of_colour[0]);
    ids->scene.polygons = ids->polygons;
    ids->scene.background = 0;
    ids->scene.texture_count = 0; /* flat, so that a pixel is a number */
    return true;
}

bool ids_init(struct ids *ids, const struct compiled *scene, const struct simulator_setup *setup, struct error *err)
{
    struct simulator_setup plain = *setup;
    plain.panel = SIMULATOR_MEMORY;
    memset(ids, 0, sizeof *ids);
    ids->faces = calloc((size_t)setup->w_px * setup->h_px, sizeof ids->faces[0]);
    bool ok = ids->faces && copy_scene(ids, scene);
    if (!ok) error_set(err, "face numbers: out of memory");
    ok = ok && simulator_init(&ids->simulator, &ids->scene, &plain, err);
    if (!ok) ids_free(ids);
    return ok;
}

bool ids_frame(struct ids *ids, const struct lim_camera *camera, struct error *err)
{
    if (!simulator_frame(&ids->simulator, camera, err)) return false;
    const size_t pixel_count = simulator_pixel_count(&ids->simulator);
    for (size_t i = 0; i < pixel_count; i++) {
        uint16_t colour = ids->simulator.pixels[i];
        if (colour > ids->scene.polygon_count)
            return error_set(err, "face numbers: pixel %zu holds %u, there are %u polygons", i, colour,
                             ids->scene.polygon_count);
        ids->faces[i] = ids->face_of_colour[colour];
    }
    return true;
}

bool ids_write(const struct ids *ids, FILE *file)
{
    const size_t pixel_count = simulator_pixel_count(&ids->simulator);
    for (size_t i = 0; i < pixel_count; i++) {
        uint32_t face = ids->faces[i];
        const uint8_t bytes[4] = {(uint8_t)face, (uint8_t)(face >> 8), (uint8_t)(face >> 16), (uint8_t)(face >> 24)};
        if (fwrite(bytes, 1, sizeof bytes, file) != sizeof bytes) return false;
    }
    return true;
}

void ids_free(struct ids *ids)
{
    simulator_free(&ids->simulator);
    free(ids->polygons);
    free(ids->face_of_colour);
    free(ids->faces);
    memset(ids, 0, sizeof *ids);
}
