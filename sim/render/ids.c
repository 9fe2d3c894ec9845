/* SPDX-License-Identifier: MIT
 *
 * The copied scene shares everything with the original but the polygon records. */
#include "render/ids.h"

#include "colour.h"
#include "scene/records.h"

#include <stdlib.h>
#include <string.h>

enum { COLOUR_BITS = 16 };

/* Numbers the records of a scene in that copy of them. What is transparent becomes opaque: a pixel has the number of
 * the nearest polygon, whatever shines through it. A colour has room for the number's bits from `shift` on. */
static void number_records(const struct lim_scene *scene, lim_index *polygons, size_t number, unsigned shift)
{
    for (size_t word = 0; word < scene->polygon_words; number++) {
        const struct record record = record_at(scene, word);
        polygons[word + record.colour_at] = (lim_index)(number >> shift & UINT16_MAX);
        if (record.flags & LIM_POLYGON_ALPHA) polygons[word + lim_record_alpha_at(polygons[word])] = LIM_OPAQUE;
        word += record.words;
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
    number_records(original, ids->polygons, 1, 0);
    ids->colours = original->polygon_count;
    ids->face_of_colour[0] = 0;
    memcpy(ids->face_of_colour + 1, scene->faces, original->polygon_count * sizeof ids->face_of_colour[0]);
    ids->scene.polygons = ids->polygons;
    ids->scene.background = 0;
    ids->scene.texture_count = 0; /* flat, so that a pixel is a number */
    *ids->scene.uvs = NULL;
    return true;
}

bool ids_init(struct ids *ids, const struct compiled *scene, const struct simulator_setup *setup, struct error *err)
{
    struct simulator_setup plain = *setup;
    if (plain.panel != SIMULATOR_FRAMEBUFFER) plain.panel = SIMULATOR_MEMORY;
    memset(ids, 0, sizeof *ids);
    ids->faces = calloc((size_t)setup->w_px * setup->h_px, sizeof ids->faces[0]);
    ids->numbers = calloc((size_t)setup->w_px * setup->h_px, sizeof ids->numbers[0]);
    bool ok = ids->faces && ids->numbers && copy_scene(ids, scene);
    if (!ok) error_set(err, "face numbers: out of memory");
    ok = ok && simulator_init(&ids->simulator, &ids->scene, &plain, err);
    if (!ok) ids_free(ids);
    return ok;
}

static bool copy_object(struct ids *ids, size_t index)
{
    const struct compiled *scene = &ids->moving->objects[index].scene;
    const struct lim_scene *original = &scene->scene;
    const size_t words_b = original->polygon_words * sizeof *ids->polygons;
    lim_index *polygons = ids->object_polygons[index] = malloc(words_b);
    if (!polygons) return false;
    memcpy(polygons, original->polygons, words_b);
    number_records(original, polygons, ids->colours + 1, 0);
    memcpy(ids->face_of_colour + ids->colours + 1, scene->faces,
           original->polygon_count * sizeof ids->face_of_colour[0]);
    ids->colours += original->polygon_count;
    ids->objects[index] = *original;
    ids->objects[index].polygons = polygons;
    ids->objects[index].texture_count = 0; /* as of the scene */
    return true;
}

bool ids_set_movers(struct ids *ids, const struct moving *moving, struct error *err)
{
    size_t colours = ids->colours;
    for (size_t i = 0; i < moving->count; i++)
        colours += moving->objects[i].scene.scene.polygon_count;
    if (colours > UINT16_MAX)
        return error_set(err, "face numbers: %zu polygons in scene and objects, 65535 are the most", colours);
    ids->moving = moving;
    uint32_t *faces = realloc(ids->face_of_colour, (colours + 1) * sizeof *faces);
    if (faces) ids->face_of_colour = faces;
    ids->objects = calloc(moving->count, sizeof *ids->objects);
    ids->object_polygons = calloc(moving->count, sizeof *ids->object_polygons);
    ids->instances = calloc(moving->count, sizeof *ids->instances);
    bool ok = faces && ids->objects && ids->object_polygons && ids->instances;
    for (size_t i = 0; ok && i < moving->count; i++)
        ok = copy_object(ids, i);
    if (!ok) return error_set(err, "face numbers: out of memory");
    return simulator_set_movers(&ids->simulator, ids->instances, moving->count, &moving->limits, err);
}

/* The same places, other objects. */
static void place_copies(struct ids *ids)
{
    for (size_t i = 0; ids->moving && i < ids->moving->count; i++) {
        ids->instances[i] = ids->moving->instances[i];
        ids->instances[i].object = &ids->objects[i];
    }
}

/* A pixel that nothing is written to holds a number that no record has: what the last frame left does not count. */
static bool draw(struct ids *ids, const struct lim_camera *camera, unsigned shift, struct error *err)
{
    memset(ids->simulator.lines, 0xFF, ids->simulator.target.h_px * ids->simulator.line_b);
    if (!simulator_frame(&ids->simulator, camera, err)) return false;
    const size_t pixel_count = simulator_pixel_count(&ids->simulator);
    for (size_t i = 0; i < pixel_count; i++)
        ids->numbers[i] |= (uint32_t)ids->simulator.pixels[i] << shift;
    return true;
}

/* More records than colours: the same frame once more, for the numbers' upper bits. */
static bool draw_upper_bits(struct ids *ids, const struct lim_camera *camera, struct error *err)
{
    number_records(&ids->scene, ids->polygons, 1, COLOUR_BITS);
    const bool ok = draw(ids, camera, COLOUR_BITS, err);
    number_records(&ids->scene, ids->polygons, 1, 0);
    return ok;
}

bool ids_frame(struct ids *ids, const struct lim_camera *camera, struct error *err)
{
    const size_t pixel_count = simulator_pixel_count(&ids->simulator);
    place_copies(ids);
    memset(ids->numbers, 0, pixel_count * sizeof *ids->numbers);
    if (!draw(ids, camera, 0, err)) return false;
    if (ids->colours > UINT16_MAX && !draw_upper_bits(ids, camera, err)) return false;
    for (size_t i = 0; i < pixel_count; i++) {
        const uint32_t number = ids->numbers[i];
        if (number > ids->colours)
            return error_set(err, "face numbers: pixel %zu holds %lu, there are %zu polygons", i, (unsigned long)number,
                             ids->colours);
        ids->faces[i] = ids->face_of_colour[number];
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
    for (size_t i = 0; ids->object_polygons && i < ids->moving->count; i++)
        free(ids->object_polygons[i]);
    free(ids->object_polygons);
    free(ids->objects);
    free(ids->instances);
    free(ids->polygons);
    free(ids->face_of_colour);
    free(ids->faces);
    free(ids->numbers);
    memset(ids, 0, sizeof *ids);
}
