/* SPDX-License-Identifier: MIT
 *
 * Looks into the stages for measurements, by their own functions. */
#include "inspect.h"

#include "eye.h"
#include "limner.h"
#include "orders/nearest.h"
#include "pixels/texture.h"
#include "screen/edge.h"
#include "screen/polygon.h"
#include "screen/project.h"
#include "view/pass.h"
#include "view/view.h"

bool lim_inspect_vertex(struct lim *lim, lim_index vertex, struct lim_point *at)
{
    if (LIM_IS_MESH(&lim->pass.target)) {
        *at = lim->mesh->points[vertex];
        return lim->mesh->nearness[vertex] > 0;
    }
    const struct lim_view_cached *seen = lim_view_vertex(&lim->pass.view, lim->pass.scene, vertex);

    *at = seen->at;
    return !(seen->codes & LIM_VIEW_GUARD);
}

void lim_inspect_count_as(struct lim *lim, const struct lim_counted *counted, size_t counted_b)
{
    if (LIM_HAS_SPANS) lim_nearest_count_as(lim->nearest, counted, counted_b);
}

int8_t lim_inspect_side(const struct lim_scene *scene, const struct lim_plane_ref *ref, const struct lim_camera *camera)
{
    struct lim_eye eye;

    if (!lim_eye_begin(&eye, scene, camera)) return 0;
    const int32_t side = lim_eye_side(&eye, ref);
    return (int8_t)((side > 0) - (side < 0));
}

#if LIM_HAS_TEXTURE

/* v in the picture's own height. */
static uint32_t own_place(const struct lim_gradients *gradients, uint32_t place)
{
    const uint8_t wider_bits = (uint8_t)(gradients->texture->w_bits - gradients->texture->h_bits);

    return (place & 0xFFFF0000u) | (uint16_t)(place << wider_bits);
}

static void take_line(const struct lim_pass *pass, const struct lim_textured_span *span, lim_inspect_texel *take,
                      void *ctx)
{
    const int16_t end = (int16_t)lim_texture_lesser(span->right, pass->target.w_px);
    const int16_t first = (int16_t)(span->left > 0 ? span->left : 0);
    struct lim_texture_line line;

    if (first >= end) return;
    lim_texture_line_begin(&line, span, first);
    for (int16_t x = first; x < end; x++) {
        if (x == line.end) lim_texture_line_next(&line);
        const struct lim_inspected_texel texel = {.place = own_place(span->gradients, lim_texture_place(&line, x)),
                                                  .x_px = (uint16_t)x,
                                                  .y_px = (uint16_t)span->y,
                                                  .level = span->gradients->level.number,
                                                  .divided = !span->gradients->is_even && x == line.x};
        take(ctx, &texel);
    }
}

/* Of one that is not non-monotone. */
static void take_polygon(const struct lim *lim, const struct lim_screen_polygon *polygon, lim_inspect_texel *take,
                         void *ctx)
{
    const int16_t h_px = (int16_t)lim->pass.target.h_px;
    const int16_t bottom = polygon->shape.bottom < h_px ? polygon->shape.bottom : h_px;
    struct lim_gradients gradients;
    struct lim_edge_pair pair;

    lim_texture_set(lim->pass.texturing, lim_screen_texture(polygon), polygon->at, polygon->n, &gradients);
    lim_edge_begin(&pair, polygon->n, polygon->shape.first);
    for (int16_t y = polygon->shape.top > 0 ? polygon->shape.top : 0; y < bottom; y++) {
        lim_edge_advance(&pair, polygon->at, polygon->n, y);
        const struct lim_textured_span span = {lim->pass.texturing, &gradients, y, lim_edge_x(&pair.left),
                                               lim_edge_x(&pair.right)};
        take_line(&lim->pass, &span, take, ctx);
    }
}

static inline bool shows_sky(const struct lim_scene *scene, const LIM_FLASH lim_index *record)
{
    const lim_index texture = record[lim_record_words(record[0]) - LIM_POLYGON_TEXTURE_WORDS];

    return lim_texture_is_sky(&scene->textures[texture]);
}

void lim_inspect_texels(struct lim *lim, lim_index record, lim_inspect_texel *take, void *ctx)
{
    struct lim_pass *const pass = &lim->pass;
    const struct lim_rect screen = {0, 0, pass->target.w_px, pass->target.h_px};
    struct lim_screen_polygon polygon, triangle;

    if (!lim_project(&polygon, &pass->view, pass->scene, &pass->scene->polygons[record], &screen, NULL)) return;
    if (lim_screen_texture(&polygon) == LIM_NONE) return;
    if (shows_sky(pass->scene, &pass->scene->polygons[record])) return;
    if (!polygon.shape.non_monotone) take_polygon(lim, &polygon, take, ctx);
    for (uint8_t k = 1; polygon.shape.non_monotone && k + 1 < polygon.n; k++) {
        lim_project_fan(&polygon, k, &triangle);
        take_polygon(lim, &triangle, take, ctx);
    }
}

#endif
