/* SPDX-License-Identifier: MIT
 *
 * Gaps are only read here: what a transparent polygon covers stays open. A masked texture's texels are painted where a
 * colour is blended. */
#include "lines/layers.h"

#include "lines/active.h"
#include "pixels/blend.h"
#include "pixels/texture.h"
#include "screen/edge.h"

#if LIM_HAS_SPANS && LIM_HAS_TRANSPARENT

void lim_layers_open(struct lim_layers *layers, const struct lim_actives *actives, const struct lim_spans *spans,
                     uint16_t y)
{
    uint8_t *const idle = LIM_HAS_MOVERS && *actives->cut_count ? *actives->cuts_end : lim_actives_idle(actives);
    uint32_t idle_b = (uint32_t)((uint8_t *)&spans->lines[y] - idle);

    if (LIM_HAS_STATS && spans->counted->is_apart) {
        const uint32_t counted_b = lim_actives_counted_idle_b(actives, spans, y);
        if (counted_b < idle_b) idle_b = counted_b;
    }
    const uint16_t size = (uint16_t)(idle_b / sizeof(struct lim_layer));
    const bool in_idle = size > layers->own_size;
    layers->pool = in_idle ? (void *)idle : layers->own;
    layers->size = in_idle ? size : layers->own_size;
    if (in_idle) layers->in_idle = true;
}

void lim_layers_push(struct lim_layers *layers, const struct lim_spans *spans, const struct lim_line *line,
                     const struct lim_layer *piece)
{
    const struct lim_gap *gap = &line->gap;

    for (;; gap = &spans->pool[gap->next]) {
        const uint16_t x0 = gap->x0 > piece->x0 ? gap->x0 : piece->x0, x1 = gap->x1 < piece->x1 ? gap->x1 : piece->x1;
        if (x0 < x1) {
            layers->exhausted = layers->used == layers->size;
            if (layers->exhausted) return;
            layers->pool[layers->used++] =
                (struct lim_layer){.x0 = x0, .x1 = x1, .colour = piece->colour, .alpha = piece->alpha};
            if (LIM_HAS_MASKED) lim_layers_note(layers);
        }
        if (gap->next == LIM_NONE || gap->x1 >= piece->x1) return;
    }
}

/* A pixel of whose samples the polygon has some. */
static LIM_IF_CALLED void mix_masked(const struct lim_textured_span *span, uint16_t *line, uint16_t x, uint8_t alpha,
                                     struct lim_stats *stats)
{
    const uint16_t behind = line[x];

    lim_texture_fill(span, line, x, (uint16_t)(x + 1), stats);
    const uint16_t colour = line[x];
    line[x] = behind;
    lim_blend(line, x, 1, colour, alpha); /* a clear texel's is `behind` itself */
}

static LIM_IF_CALLED void fill_masked(const struct lim_layers *layers, const struct lim_layer *layer, uint16_t *line,
                                      struct lim_stats *stats)
{
    const struct lim_masked_layer *const masked = layer->masked;
    void *const gradients = (uint8_t *)layers->own + masked->at;
    const struct lim_textured_span span = {*layers->texturing, gradients, *layers->y, masked->left, masked->right};

    if (!LIM_HAS_ANTIALIAS || layer->alpha == LIM_OPAQUE) {
        lim_texture_fill(&span, line, layer->x0, layer->x1, stats);
        return;
    }
    for (uint16_t x = layer->x0; x < layer->x1; x++)
        mix_masked(&span, line, x, layer->alpha, stats);
}

bool lim_layers_finish(struct lim_layers *layers, uint16_t *line, struct lim_stats *stats)
{
    if (layers->exhausted) {
        layers->exhausted = false;
        layers->used = 0;
        return false;
    }
    if (LIM_HAS_STATS && layers->used > stats->layers_max) stats->layers_max = layers->used;
    while (layers->used) {
        const struct lim_layer *layer = &layers->pool[--layers->used];
        if (LIM_HAS_MASKED && layer->masked->at)
            fill_masked(layers, layer, line, stats);
        else
            lim_blend(line, layer->x0, (uint16_t)(layer->x1 - layer->x0), layer->colour, layer->alpha);
    }
    return true;
}

#endif
