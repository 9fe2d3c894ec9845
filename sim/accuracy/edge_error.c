/* SPDX-License-Identifier: MIT
 *
 * One picture of the reference after the other, each with its rays elsewhere in their pixels, is added up. */
#include "accuracy/edge_error.h"

#include "colour.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void make_opaque(struct edge_error *error)
{
    for (size_t word = 0; word < error->scene.polygon_words;) {
        const struct record record = record_at(&error->scene, word);
        if (record.flags & LIM_POLYGON_ALPHA)
            error->polygons[word + lim_record_alpha_at(error->polygons[word])] = LIM_OPAQUE;
        word += record.words;
    }
}

static void set_colours(struct edge_error *error, const struct compiled *scene)
{
    size_t word = 0;
    for (size_t f = 0; f < error->face_count; f++)
        error->colour_of_face[f] = error->scene.background;
    for (size_t p = 0; p < error->scene.polygon_count; p++) {
        const struct record record = record_at(&error->scene, word);
        error->colour_of_face[scene->faces[p]] = (uint16_t)error->polygons[word + record.colour_at];
        word += record.words;
    }
}

static bool allocate(struct edge_error *error, const struct compiled *scene, size_t pixel_count)
{
    error->scene = scene->scene;
    error->face_count = 1;
    for (size_t p = 0; p < scene->scene.polygon_count; p++)
        if (scene->faces[p] >= error->face_count) error->face_count = scene->faces[p] + 1u;
    error->polygons = malloc(scene->scene.polygon_words * sizeof error->polygons[0]);
    error->colour_of_face = calloc(error->face_count, sizeof error->colour_of_face[0]);
    error->first = calloc(pixel_count, sizeof error->first[0]);
    error->is_edge = calloc(pixel_count, sizeof error->is_edge[0]);
    error->sums = calloc(pixel_count, sizeof error->sums[0]);
    return error->polygons && error->colour_of_face && error->first && error->is_edge && error->sums;
}

bool edge_error_init(struct edge_error *out, const struct compiled *scene, const struct simulator_setup *setup,
                     struct error *err)
{
    struct simulator_setup plain = *setup;
    plain.panel = SIMULATOR_MEMORY;
    memset(out, 0, sizeof *out);
    bool ok = allocate(out, scene, (size_t)setup->w_px * setup->h_px) || error_set(err, "edges: out of memory");
    if (ok) {
        memcpy(out->polygons, scene->scene.polygons, scene->scene.polygon_words * sizeof out->polygons[0]);
        out->scene.polygons = out->polygons;
        out->scene.texture_count = 0;
        make_opaque(out);
        set_colours(out, scene);
    }
    for (int i = 0; ok && i < EDGE_ERROR_PICTURES; i++)
        ok = simulator_init(&out->pictures[i], &out->scene, &plain, err) &&
             simulator_set_antialias(&out->pictures[i], i == EDGE_ERROR_SMOOTH, err);
    if (!ok) edge_error_free(out);
    return ok;
}

static void widen(uint16_t rgb565, double out[3])
{
    out[0] = (rgb565 >> 11) * (255.0 / 31.0);
    out[1] = (rgb565 >> 5 & 63) * (255.0 / 63.0);
    out[2] = (rgb565 & 31) * (255.0 / 31.0);
}

/* What a ray ends at; a face of which the compiler has left nothing shows what is behind everything. */
static uint16_t colour_at(const struct edge_error *error, const struct reference *reference, size_t pixel)
{
    const uint32_t face = reference->faces[pixel];
    return face && face < error->face_count ? error->colour_of_face[face] : error->scene.background;
}

static void add_rays(struct edge_error *error, const struct reference *reference, size_t pixel_count, bool is_first)
{
    for (size_t i = 0; i < pixel_count; i++) {
        const uint16_t colour = colour_at(error, reference, i);
        double rgb[3];
        widen(colour, rgb);
        if (is_first) error->first[i] = colour;
        error->is_edge[i] = !is_first && (error->is_edge[i] || colour != error->first[i]);
        for (int c = 0; c < 3; c++)
            error->sums[i][c] = (is_first ? 0.0 : error->sums[i][c]) + rgb[c];
    }
}

static void draw_reference(struct edge_error *error, struct reference *reference, const struct viewpoint *viewpoint,
                           const struct lens *lens)
{
    for (int ray = 0; ray < EDGE_ERROR_LATTICE * EDGE_ERROR_LATTICE; ray++) {
        const double shift_px[2] = {(ray % EDGE_ERROR_LATTICE + 0.5) / EDGE_ERROR_LATTICE - 0.5,
                                    (ray / EDGE_ERROR_LATTICE + 0.5) / EDGE_ERROR_LATTICE - 0.5};
        reference_draw_shifted(reference, viewpoint, lens, shift_px);
        add_rays(error, reference, (size_t)reference->w_px * reference->h_px, ray == 0);
    }
}

static uint16_t rounded(const double sum[3])
{
    const double scale = 1.0 / (255.0 * EDGE_ERROR_LATTICE * EDGE_ERROR_LATTICE);
    return (uint16_t)(lround(sum[0] * scale * 31.0) << 11 | lround(sum[1] * scale * 63.0) << 5 |
                      lround(sum[2] * scale * 31.0));
}

static double pixel_error(const double sum[3], uint16_t shown)
{
    double rgb[3], error = 0.0;
    widen(shown, rgb);
    for (int c = 0; c < 3; c++)
        error += fabs(rgb[c] - sum[c] / (EDGE_ERROR_LATTICE * EDGE_ERROR_LATTICE)) / 3.0;
    return error;
}

bool edge_error_frame(struct edge_error *error, struct reference *reference, const struct viewpoint *viewpoint,
                      const struct lens *lens, const struct lim_camera *camera, struct edge_error_sum *sum,
                      struct error *err)
{
    const size_t pixel_count = simulator_pixel_count(&error->pictures[0]);
    for (int i = 0; i < EDGE_ERROR_PICTURES; i++)
        if (!simulator_frame(&error->pictures[i], camera, err)) return false;
    draw_reference(error, reference, viewpoint, lens);
    for (size_t p = 0; p < pixel_count; p++) {
        if (!error->is_edge[p]) continue;
        sum->pixels++;
        for (int i = 0; i < EDGE_ERROR_PICTURES; i++)
            sum->error[i] += pixel_error(error->sums[p], error->pictures[i].pixels[p]);
        sum->error[EDGE_ERROR_ROUNDED] += pixel_error(error->sums[p], rounded(error->sums[p]));
    }
    return true;
}

double edge_error_mean(const struct edge_error_sum *sum, enum edge_error_picture picture)
{
    return sum->pixels ? sum->error[picture] / (double)sum->pixels : 0.0;
}

void edge_error_free(struct edge_error *error)
{
    for (int i = 0; i < EDGE_ERROR_PICTURES; i++)
        simulator_free(&error->pictures[i]);
    free(error->polygons);
    free(error->colour_of_face);
    free(error->first);
    free(error->is_edge);
    free(error->sums);
    memset(error, 0, sizeof *error);
}
