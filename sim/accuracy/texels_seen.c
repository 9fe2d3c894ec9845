/* SPDX-License-Identifier: MIT
 *
 * A pixel of size a at distance 1 covers a z^2 / |n . D| of a plane with the unit normal n, where the ray D, as long
 * along the view's axis as 1, meets it at depth z. */
#include "accuracy/texels_seen.h"

#include "base/deadline.h"
#include "base/vec3.h"

#include <math.h>

enum { SIDE_PX = 96 };

struct looking {
    const struct mesh *mesh;
    const struct model *model;
    struct reference reference;
    double pixel_area; /* of the display, at distance 1 */
    struct texels_seen *seen;
};

/* Texels of the finest level to a metre squared. */
static double density_of(const struct mapping *mapping, const struct texture *texture)
{
    double across[3];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] =
            mapping->gradient[0][j] * mapping->gradient[1][k] - mapping->gradient[0][k] * mapping->gradient[1][j];
    }
    return ldexp(sqrt(vec3_dot(across, across)), texture->w_bits + texture->h_bits);
}

double texel_level_at(const struct reference *reference, size_t pixel, const struct mapping *mapping,
                      const struct texture *texture, double pixel_area)
{
    const double depth_m = reference->depths_m[pixel];
    double point_m[3], along = 0;
    reference_point(reference, pixel, point_m);
    for (int i = 0; i < 3; i++)
        along += mapping->normal[i] * (point_m[i] - reference->view.eye_m[i]) / depth_m;
    const double area = pixel_area * depth_m * depth_m / fmax(fabs(along), 1e-6);
    return log2(area * density_of(mapping, texture)) / 2;
}

static unsigned level_at(const struct looking *looking, size_t pixel, const struct mapping *mapping,
                         const struct texture *texture)
{
    const double level = floor(texel_level_at(&looking->reference, pixel, mapping, texture, looking->pixel_area) + 0.5);
    return level > 0 ? (unsigned)fmin(level, texture->levels - 1) : 0;
}

/* Of the light on a face, squared, as errors are. */
static double brightness2(uint32_t colour)
{
    double sum = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        sum += pow((colour >> shift & 0xFF) / 255.0, 2) / 3;
    return sum;
}

static void add_pixel(struct looking *looking, size_t pixel)
{
    const uint32_t number = looking->reference.mappings[pixel], face = looking->reference.faces[pixel];
    if (!number || !face) return;
    const struct mapping *mapping = &looking->mesh->mappings[number];
    const struct texture *texture = &looking->mesh->textures[mapping->texture];
    const unsigned level = level_at(looking, pixel, mapping, texture);
    looking->seen[mapping->texture].pixels[level] += brightness2(looking->model->faces[face - 1].colour);
}

bool texels_seen_add(const struct mesh *mesh, const struct model *model, const struct camera_path *path,
                     const struct lens *lens, unsigned w_px, struct texels_seen *seen, struct error *err)
{
    struct looking looking = {.mesh = mesh, .model = model, .seen = seen, .pixel_area = pow(2 * lens->tan_x / w_px, 2)};
    if (!reference_init(&looking.reference, mesh, SIDE_PX, SIDE_PX, err)) return false;
    for (size_t i = 0; i < path->count && !deadline_passed(); i++) {
        reference_draw(&looking.reference, &path->frames[i], lens);
        for (size_t pixel = 0; looking.reference.mappings && pixel < (size_t)SIDE_PX * SIDE_PX; pixel++)
            add_pixel(&looking, pixel);
    }
    reference_free(&looking.reference);
    return true;
}
