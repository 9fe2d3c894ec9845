/* SPDX-License-Identifier: MIT
 *
 * What moves, where memory is so scarce that a band is one pixel. What closes nothing waits in any number there, so one
 * polygon is kept, and each that comes is compared with it as lines compare them (crowd.h). Of one colour a polygon
 * that is enough. Where samples are added, or layers mixed, as many walks find one after the other: dear, and needed
 * where hardly any memory is lent. */
#include "lines/overlaid.h"
#include "lines/paint.h"
#include "lines/smooth_line.h"
#include "movers/meet.h"
#include "movers/mover.h"
#include "movers/near_plane.h"
#include "orders/nearest.h"
#include "pixels/blend.h"
#include "pixels/texture.h"
#include "screen/edge.h"
#include "screen/polygon.h"
#include "view/view.h"

#if LIM_HAS_SPANS && LIM_HAS_MOVERS

/* Whether anything may be transparent. */
static bool pixel_mixes(const struct lim_nearest *nearest)
{
    const struct lim_movers *const movers = *nearest->movers;
    bool mixes = LIM_HAS_TRANSPARENT && nearest->pass->scene->limits.layers;

    for (uint16_t i = 0; i < movers->count && LIM_HAS_TRANSPARENT; i++)
        if (movers->movers[i].radius_q12 >= 0 && movers->instances[i].object->limits.layers) mixes = true;
    return mixes;
}

void lim_open_pixel(struct lim_nearest *nearest, const struct lim_rect *band)
{
    const bool is_one = band->x1 - band->x0 == 1 && band->y1 - band->y0 == 1 && lim_nearest_moves(nearest);
    const bool is_plain = !lim_is_antialiased(&nearest->pass->view);

    *nearest->by_pixel = *nearest->asked_pixel;
    if (is_one && is_plain && !*nearest->by_pixel && !pixel_mixes(nearest)) *nearest->by_pixel = LIM_BY_PIXEL_RETAINED;
    nearest->comes->met.owner = LIM_NONE;
    nearest->comes->number = nearest->found->number = 0;
}

static struct lim_near_row pixel_row_of(const struct lim_nearest *nearest, const struct lim_pixel_polygon *polygon)
{
    struct lim_near_plane plane;

    lim_near_plane_set(&plane, *nearest->movers, nearest->pass, &polygon->met);
    return lim_near_row_of(&plane, nearest->top);
}

/* As runs are compared on whole lines. */
static bool is_nearer_on_line(const struct lim_nearest *nearest, const struct lim_pixel_polygon *comes,
                              const struct lim_pixel_polygon *last)
{
    const struct lim_near_row a = pixel_row_of(nearest, last), b = pixel_row_of(nearest, comes);
    const struct lim_near_share both = {last->x0 > comes->x0 ? last->x0 : comes->x0,
                                        last->x1 < comes->x1 ? last->x1 : comes->x1};
    const struct lim_near_share nearer = lim_near_share(&a, &b, comes->met.owner < last->met.owner, both);
    const int32_t x = nearest->spans.open.x0;

    return nearer.x0 <= x && x < nearer.x1;
}

/* Whether the order in which two movers are drawn is right. */
static bool is_ordered(const struct lim_movers *movers, uint16_t first, uint16_t second)
{
    return first == second ? !lim_mover_is_loose(movers, first) : lim_mover_precedes(movers, first, second);
}

/* Whether the later of two in the walk is nearer at the pixel. */
static bool pixel_comes_nearer(const struct lim_nearest *nearest, const struct lim_pixel_polygon *comes,
                               const struct lim_pixel_polygon *last)
{
    struct lim_movers *const movers = *nearest->movers;

    if (last->met.owner >= LIM_STILL_MET || comes->met.owner == LIM_NONE) return false;
    if (comes->met.owner < LIM_STILL_MET && is_ordered(movers, last->met.owner, comes->met.owner)) return false;
    if (comes->met.owner == LIM_STILL_MET) {
        const enum lim_met met = lim_met_polygons(nearest->pass, movers, &last->met, &comes->met);
        if (met != LIM_MET_THROUGH) return met == LIM_MET_BEFORE;
    }
    return is_nearer_on_line(nearest, comes, last);
}

static bool pixel_is_nearer(const struct lim_nearest *nearest, const struct lim_pixel_polygon *a,
                            const struct lim_pixel_polygon *b)
{
    if (a->number == b->number) return false;
    return a->number < b->number ? !pixel_comes_nearer(nearest, b, a) : pixel_comes_nearer(nearest, a, b);
}

static void set_run_of_line(struct lim_nearest *nearest, const struct lim_point *at, uint8_t n, uint8_t first)
{
    const int16_t w_px = (int16_t)nearest->pass->target.w_px;
    struct lim_edge_pair pair;

    lim_edge_begin(&pair, n, first);
    lim_edge_advance(&pair, at, n, (int16_t)nearest->top);
    const int16_t x0 = lim_edge_x(&pair.left), x1 = lim_edge_x(&pair.right);
    nearest->comes->x0 = x0 > 0 ? x0 : 0;
    nearest->comes->x1 = x1 < w_px ? x1 : w_px;
}

bool lim_wins_pixel(struct lim_nearest *nearest, const struct lim_point *at, uint8_t n, uint8_t first)
{
    struct lim_pixel_polygon *const last = nearest->found;

    if (*nearest->by_pixel != LIM_BY_PIXEL_RETAINED) return true;
    set_run_of_line(nearest, at, n, first);
    if (nearest->retained.used && !pixel_comes_nearer(nearest, nearest->comes, last)) return false;
    *last = *nearest->comes;
    nearest->retained.used = 0;
    nearest->spans.lines[nearest->top].retained = LIM_NONE;
    return true;
}

/* The samples of the pixel that no nearer polygon has. */
void lim_collect_samples_of_pixel(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
{
    struct lim_pixel_polygon *const comes = nearest->comes, *const last = nearest->found;
    const int16_t w_px = (int16_t)nearest->pass->target.w_px;
    struct lim_strip strip;

    if (!LIM_HAS_ANTIALIAS) return;
    *comes->samples = lim_smooth_see_pixel(&nearest->paint, polygon, nearest->spans.open.x0, nearest->top, &strip);
    if (!*comes->samples) return;
    comes->x0 = lim_strip_first_px(&strip);
    comes->x1 = lim_strip_end_px(&strip);
    if (comes->x0 < 0) comes->x0 = 0;
    if (comes->x1 > w_px) comes->x1 = w_px;
    if (*last->samples && !pixel_comes_nearer(nearest, comes, last)) return;
    *comes->share = lim_smooth_share_there(&nearest->paint, polygon, nearest->spans.open.x0, nearest->top, &strip);
    *last = *comes;
}

/* A texel's colour comes by way of the line; a clear one's is what lies there. */
static uint16_t colour_there(const struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
{
    const uint16_t x = nearest->spans.open.x0, behind = nearest->pixels[0][x];
    struct lim_gradients gradients;

    if (!LIM_HAS_TEXTURE || lim_screen_texture(polygon) == LIM_NONE) return polygon->colour;
    lim_texture_set(nearest->pass->texturing, lim_screen_texture(polygon), polygon->at, polygon->n, &gradients);
    const struct lim_textured_span span = {nearest->pass->texturing, &gradients, (int16_t)nearest->top,
                                           nearest->comes->x0, nearest->comes->x1};
    lim_texture_fill(&span, nearest->pixels[0], x, (uint16_t)(x + 1), lim_stats_of(nearest->pass));
    const uint16_t colour = nearest->pixels[0][x];
    nearest->pixels[0][x] = behind;
    return colour;
}

void lim_collect_look_of_pixel(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon)
{
    struct lim_pixel_polygon *const comes = nearest->comes, *const found = nearest->found;
    const int16_t x = (int16_t)nearest->spans.open.x0;
    const bool is_layer = lim_alpha_of(polygon) != LIM_OPAQUE, wants_layer = *nearest->by_pixel == LIM_BY_PIXEL_LAYERS;

    set_run_of_line(nearest, polygon->at, polygon->n, polygon->shape.first);
    if (x < comes->x0 || x >= comes->x1) return;
    comes->number = ++*nearest->numbered;
    if (is_layer != wants_layer) return;
    if (wants_layer && nearest->last->number && !pixel_is_nearer(nearest, comes, nearest->last)) return;
    if (found->number && pixel_is_nearer(nearest, comes, found) == wants_layer) return;
    comes->alpha =
        LIM_HAS_TEXTURE && lim_screen_texture(polygon) != LIM_NONE ? (uint8_t)LIM_OPAQUE : lim_alpha_of(polygon);
    comes->colour = colour_there(nearest, polygon);
    *found = *comes;
}

/* The next one that is found; 0: there is none. */
static uint16_t find_next(struct lim_nearest *nearest, const struct lim_rect *band, enum lim_by_pixel how)
{
    *nearest->asked_pixel = (uint8_t)how;
    *nearest->numbered = 0;
    (void)lim_collect(nearest, band);
    *nearest->asked_pixel = LIM_BY_PIXEL_NOT;
    return nearest->found->number;
}

static LIM_IF_CALLED int draw_mixed_pixel(struct lim_nearest *nearest, const struct lim_rect *band)
{
    const struct lim_target *const target = &nearest->pass->target;
    const uint16_t x = band->x0, y = band->y0;
    uint16_t *const line = lim_paint_lend(&nearest->paint, y);

    if (!line) return LIM_ERR_TARGET;
    nearest->pixels[0] = line;
    line[x] = nearest->paint.background;
    if (find_next(nearest, band, LIM_BY_PIXEL_OPAQUE)) line[x] = nearest->found->colour;
    *nearest->last = *nearest->found;
    /* As many as have come at most: what has no order to the last unit shall not go round in a circle. */
    for (uint16_t left = *nearest->numbered; left && find_next(nearest, band, LIM_BY_PIXEL_LAYERS); left--) {
        lim_blend(line, x, 1, nearest->found->colour, nearest->found->alpha);
        *nearest->last = *nearest->found;
    }
    lim_overlay_line(nearest->pass, line, y, x, (uint16_t)(x + 1));
    return target->done(target->ctx, y, x, 1);
}

/* Each time the nearest that has samples of it that are open; 16 times at most. */
static LIM_IF_CALLED int draw_samples_of_pixel(struct lim_nearest *nearest, const struct lim_rect *band)
{
    const struct lim_pixel_polygon *const found = nearest->found;
    const int err = lim_smooth_begin_line(&nearest->paint, band->y0);

    if (err) return err;
    do {
        *nearest->found->samples = 0;
        (void)find_next(nearest, band, LIM_BY_PIXEL_SAMPLES);
        lim_smooth_add_to_pixel(&nearest->paint, &nearest->spans, band->x0, *found->samples, *found->share);
    } while (*found->samples);
    return lim_smooth_end_pixel(&nearest->paint, &nearest->spans, band->x0, band->y0);
}

int lim_draw_pixel(struct lim_nearest *nearest, const struct lim_rect *band)
{
    const bool antialiased = lim_is_antialiased(&nearest->pass->view);

    if (LIM_HAS_ANTIALIAS && antialiased && !pixel_mixes(nearest)) return draw_samples_of_pixel(nearest, band);
    if (!LIM_HAS_TRANSPARENT) return LIM_ERR_MEMORY; /* not reached: what is opaque is retained */
    if (LIM_HAS_ANTIALIAS) lim_nearest_set_antialiased(nearest, false);
    const int err = draw_mixed_pixel(nearest, band);
    if (LIM_HAS_ANTIALIAS) lim_nearest_set_antialiased(nearest, antialiased);
    return err;
}

#endif
