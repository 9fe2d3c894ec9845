/* SPDX-License-Identifier: MIT
 *
 * golden_state() for the profile that LIM_PROFILE names. What has no padding is taken as bytes. */
#ifndef TESTS_GOLDEN_STATE_OF_H
#define TESTS_GOLDEN_STATE_OF_H

#include "golden_state.h"
#include "limner.h"
#include "lines/retain.h"
#include "movers/meet.h"
#include "screen/polygon.h"
#include "view/view.h"

static uint32_t add(uint32_t hash, int64_t value)
{
    return golden_hash(hash, &value, sizeof value);
}

static uint32_t add_three(uint32_t hash, const int32_t v[3])
{
    return golden_hash(hash, v, 3 * sizeof *v);
}

/* VIEW --------------------------------------------------------------------------------------- */

static uint32_t add_rows(uint32_t hash, const struct lim_rows *rows)
{
    hash = add(add(add(hash, rows->tele_bits), rows->near_qv), rows->far_units);
    for (int i = 0; i < 3; i++) {
        hash = add(hash, rows->row[i].shift_qv);
        for (int k = 0; k < 3; k++) {
            hash = add(hash, rows->row[i].n_qv[k]);
#if LIM_HAS_LIMBS
            hash = add(hash, rows->row[i].low_qv15[k]);
#endif
        }
    }
    return hash;
}

static uint32_t add_vertices(uint32_t hash, const struct lim_view_cached *cache)
{
    for (int i = 0; i < LIM_VIEW_CACHE_ENTRIES; i++) {
        if (cache[i].vertex == (lim_index)LIM_NO_INDEX) continue;
        hash = add(add(hash, cache[i].vertex), cache[i].codes);
        if (!(cache[i].codes & LIM_VIEW_GUARD)) hash = add(add(hash, cache[i].at.x), cache[i].at.y);
    }
    return hash;
}

static uint32_t add_eye(uint32_t hash, const struct lim_eye *eye)
{
    hash = add(add(add_three(hash, eye->at_q8), eye->near_end), eye->shift);
    for (int i = 0; i < 3; i++)
        hash = add(hash, eye->reduced[i]);
    return add(add(hash, eye->slack_rest), eye->large_slack);
}

static uint32_t add_cull(uint32_t hash, const struct lim_cull *cull)
{
    for (int side = 0; side < 4; side++) {
        for (int i = 0; i < 3; i++)
            hash = add(hash, cull->sides[side].n[i]);
        hash = add(hash, cull->sides[side].offset);
    }
    return hash;
}

/* Movers and sorted polygons ----------------------------------------------------------------- */

static uint32_t add_mover(uint32_t hash, const struct lim_mover *mover, bool lit)
{
    hash = add(hash, mover->radius_q12);
    if (mover->radius_q12 < 0) return hash;
    if (mover->view.rows.near_qv) hash = add_rows(hash, &mover->view.rows); /* they were asked for */
    hash = add_three(add_eye(hash, &mover->eye), mover->centre_q12);
    for (int i = 0; lit && i < 3; i++)
        hash = add(hash, mover->to_q14[i]);
    return hash;
}

static uint32_t add_movers(uint32_t hash, const struct lim_movers *movers, uint16_t count)
{
    hash = add_three(add_three(hash, movers->ahead_q28), movers->camera.eye_q8);
    for (uint16_t i = 0; i < count && i < movers->most; i++)
        hash = add_mover(hash, &movers->movers[i], movers->light->on);
    return hash;
}

static uint32_t add_polygon(uint32_t hash, const struct lim_newell_polygon *polygon)
{
    hash = golden_hash(add(hash, polygon->near_qv), &polygon->rect, sizeof polygon->rect);
    hash = add(add(hash, polygon->node), polygon->cuts);
    return add(hash, polygon->eye_in_front | polygon->swapped << 1 | polygon->last << 2);
}

static uint32_t add_sorted(uint32_t hash, const struct lim_sorter *sorter, bool with_pieces)
{
    hash = add(add(hash, sorter->size), sorter->used);
    for (uint16_t i = 0; i < sorter->used; i++) {
        hash = add(add(add(hash, sorter->list[i].far_qv), sorter->list[i].record), sorter->list[i].next);
        if (with_pieces) hash = add_polygon(hash, &sorter->newell->polygons[i]);
    }
    if (!with_pieces) return hash;
    hash = add(add(hash, sorter->newell->cut_size), sorter->newell->cuts_used);
    return golden_hash(hash, sorter->newell->cuts, sorter->newell->cuts_used * sizeof *sorter->newell->cuts);
}

/* Textures and edges ------------------------------------------------------------------------- */

static uint32_t add_shorts(uint32_t hash, const int16_t *values)
{
    for (int i = 0; i < LIM_TEXTURE_AXES; i++)
        hash = add(hash, values[i]);
    return hash;
}

static uint32_t add_texturing(uint32_t hash, const struct lim_texturing *texturing)
{
    for (int i = 0; i < 3; i++) {
        hash = add_shorts(add_shorts(hash, texturing->axes[i].high_q14), texturing->axes[i].low_q30);
        hash = add(hash, texturing->axis_bits[i]);
    }
    hash = add_shorts(add_shorts(hash, texturing->eye_high), texturing->eye_low_q8);
    return add(add(hash, texturing->far_bits), texturing->level_q4);
}

static uint32_t add_planes(uint32_t hash, const struct lim_texture_planes *planes)
{
    hash = golden_hash(hash, &planes->depth, sizeof planes->depth);
    hash = golden_hash(hash, planes->uv, sizeof planes->uv);
    hash = add(hash, (int32_t)planes->eye_place);
    return add(add(add(hash, planes->depth_min), planes->level_q4), planes->even_q4);
}

static uint32_t add_gradients(uint32_t hash, const struct lim_gradients *gradients)
{
    if (!gradients->texture) return hash;
    hash = add(add(hash, gradients->level.number), gradients->is_even);
    if (gradients->is_even) return golden_hash(hash, &gradients->even, sizeof gradients->even);
    return add_planes(add(add(add(hash, gradients->shift), gradients->slope_zeros), gradients->pace),
                      &gradients->planes);
}

static uint32_t add_edge(uint32_t hash, const struct lim_edge *edge)
{
    return add(add(add(add(add(hash, edge->at), edge->step), edge->end), edge->next), edge->step_vertex);
}

/* Of a frame in one band, if their memory was used for nothing else since. Edges need not be whole: one of a single
 * line has no step. */
static uint32_t add_actives(uint32_t hash, const struct lim_actives *actives, const struct lim_retained *retained)
{
    for (const struct lim_active *active = actives->free; active; active = active->next) {
        hash = add(add(hash, active->polygon), active->bottom);
        if (lim_retained_has_texture(&retained->cells[active->polygon])) hash = add_gradients(hash, active->gradients);
    }
    return hash;
}

static uint32_t add_crossings(uint32_t hash, const struct lim_convex *convex, bool textured)
{
    for (uint16_t i = 0; i < convex->pool_used; i++) {
        const struct lim_crossing *crossing = &convex->pool[i];
        if (textured && lim_screen_texture(&crossing->polygon) != LIM_NONE)
            hash = add_gradients(hash, crossing->gradients);
        hash = add_edge(add_edge(hash, &crossing->pair.left), &crossing->pair.right);
        for (uint8_t k = 0; k < crossing->polygon.n; k++)
            hash = add(add(hash, crossing->polygon.at[k].x), crossing->polygon.at[k].y);
    }
    return hash;
}

/* In wireframe each has a bit an edge behind its corners, and of the words of those only as many mean something. */
static uint32_t add_hidden(uint32_t hash, const uint16_t *hidden, unsigned n)
{
    for (unsigned k = 0; k < n; k++)
        hash = add(hash, hidden[k / 16] >> k % 16 & 1);
    return hash;
}

/* What is written of a polygon's cells, which may be larger, and how many they are. */
static uint32_t add_retained(uint32_t hash, const union lim_retained_cell *cells, bool wireframe, unsigned *count)
{
    const unsigned n = cells[0].link.n, corners = LIM_RETAINED_HEAD_CELLS + n, cell_bits = 8 * sizeof *cells;
    const bool transparent = cells[1].look.bottom & LIM_RETAINED_TRANSPARENT;

    hash = add(add(add(hash, cells[0].link.next), n), cells[0].link.first);
    hash = add(add(hash, cells[1].look.bottom), cells[1].look.colour);
    for (unsigned k = LIM_RETAINED_HEAD_CELLS; k < corners; k++)
        hash = add(add(hash, cells[k].at.x), cells[k].at.y);
    if (transparent) hash = add(hash, cells[corners].alpha);
    if (wireframe) hash = add_hidden(hash, cells[corners].hidden, n);
    *count = corners + transparent;
    if (wireframe) *count += ((n + 15) / 16 * 16 + cell_bits - 1) / cell_bits;
    return hash;
}

/* All of the cells; the rest has what pass two left there. Up to the first piece: how many lines that has is not noted.
 */
static uint32_t add_cells(uint32_t hash, const struct lim_retained *retained, bool wireframe)
{
    unsigned count;

    for (uint16_t at = 0; at < retained->used && retained->cells[at].link.n; at = (uint16_t)(at + count))
        hash = add_retained(hash, &retained->cells[at], wireframe, &count);
    return hash;
}

/* Where something moves: by lines, as cells may lie between polygons that tell of the next. */
static uint32_t add_cells_of_lines(uint32_t hash, const struct lim_nearest *nearest, uint16_t h_px, bool wireframe)
{
    const union lim_retained_cell *const cells = nearest->retained.cells;
    unsigned count;

    for (uint16_t y = 0; y < h_px; y++)
        for (uint16_t at = nearest->spans.lines[y].retained; at != LIM_NONE; at = cells[at].link.next) {
            if (cells[at + 1].look.bottom & LIM_RETAINED_MET)
                hash = add(add(hash, lim_met_owner(&cells[at])), cells[at - 2].word);
            hash = add_retained(hash, &cells[at], wireframe, &count);
        }
    return hash;
}

/* Polygons may have lain where lines and vertices were, or cuts. */
static bool is_overwritten(const struct lim_nearest *nearest)
{
    return nearest->paint.actives.in_pool || *nearest->paint.actives.crowded;
}

/* All of it ---------------------------------------------------------------------------------- */

static uint32_t add_spans(uint32_t hash, const struct lim *lim)
{
    const struct lim_spans *spans = &lim->nearest->spans;
    const struct lim_retained *retained = &lim->nearest->retained;
    const uint16_t gaps = lim_is_antialiased(&lim->pass.view) ? *spans->strips_size : spans->pool_size;

    hash = add(add(add(hash, gaps), gaps - spans->fresh), spans->open_lines);
    if (!lim_is_antialiased(&lim->pass.view))
        hash = golden_hash(hash, &spans->pool[spans->fresh], (gaps - spans->fresh) * sizeof *spans->pool);
    if (!lim->nearest->bands && !is_overwritten(lim->nearest))
        hash = golden_hash(hash, spans->lines, lim->pass.target.h_px * sizeof *spans->lines);
    hash = add(add(hash, retained->whole), retained->used);
    if (!lim_moves(lim->movers))
        hash = add_cells(hash, retained, lim->pass.wireframe->on);
    else if (!lim->nearest->bands && !is_overwritten(lim->nearest))
        hash = add_cells_of_lines(hash, lim->nearest, lim->pass.target.h_px, lim->pass.wireframe->on);
    if (!lim->nearest->bands && !lim->nearest->paint.actives.in_pool)
        hash = add_actives(hash, &lim->nearest->paint.actives, retained);
    return add(add(hash, lim->nearest->paint.layers->size), lim->nearest->paint.layers->used);
}

static uint32_t state_of(const void *state, uint16_t movers)
{
    const struct lim *lim = state;
    const enum lim_method method = lim->pass.target.method;
    const bool spans = method != LIM_CONVEX && method != LIM_PAINTER;
    uint32_t hash = add_rows(GOLDEN_HASH, &lim->pass.view.rows);

    if (!spans || !is_overwritten(lim->nearest)) hash = add_vertices(hash, lim->pass.view.cache);
    hash = add_eye(add_cull(add(hash, lim->pass.view.vertices), lim->pass.cull), &lim->pass.walk->eye);
    if (lim->pass.scene->textures) hash = add_texturing(hash, lim->pass.texturing);
    if (method == LIM_CONVEX) return add_crossings(hash, lim->convex, lim->pass.scene->textures);
    if (lim->movers->most) hash = add_movers(hash, lim->movers, movers);
    if (method == LIM_NEWELL || method == LIM_DEPTH) hash = add_sorted(hash, lim->sorter, method == LIM_NEWELL);
    if (lim->pass.walk->portals->bits)
        hash = golden_hash(hash, lim->pass.walk->portals->bits, LIM_PORTALS_BITS_B(lim->pass.scene->box_count));
    return method == LIM_PAINTER ? hash : add_spans(hash, lim);
}

#endif
