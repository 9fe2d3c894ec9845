/* SPDX-License-Identifier: MIT
 *
 * Levels lie one behind the other, the finest first. */
#include "model/texture_cut.h"

#include "scene.h"

#include <string.h>

static size_t level_first(const struct texture *texture, unsigned level)
{
    size_t first = 0;
    for (unsigned k = 0; k < level; k++)
        first += (size_t)1 << (texture->w_bits + texture->h_bits - 2 * k);
    return first;
}

size_t texture_cut_texels(const struct texture *texture, unsigned levels)
{
    return texture_texels((uint8_t)(texture->w_bits - levels), (uint8_t)(texture->h_bits - levels));
}

static void mark_colours(const struct texture *texture, unsigned levels, bool used[TEXTURE_COLOURS])
{
    const size_t end = level_first(texture, texture->levels);
    memset(used, 0, TEXTURE_COLOURS * sizeof *used);
    for (size_t i = level_first(texture, levels); i < end; i++)
        used[texture->texels[i]] = true;
}

size_t texture_cut_colours(const struct texture *texture, unsigned levels)
{
    bool used[TEXTURE_COLOURS];
    size_t count = 0;
    mark_colours(texture, levels, used);
    for (int i = 0; i < TEXTURE_COLOURS; i++)
        count += used[i];
    return count;
}

void texture_cut(struct texture *texture, unsigned levels)
{
    bool used[TEXTURE_COLOURS];
    uint8_t now[TEXTURE_COLOURS];
    const size_t first = level_first(texture, levels), end = level_first(texture, texture->levels);
    if (!levels) return;
    mark_colours(texture, levels, used);
    uint32_t colours = 0;
    for (unsigned i = 0; i < TEXTURE_COLOURS; i++) {
        if (!used[i]) continue;
        now[i] = (uint8_t)colours;
        texture->palette[colours++] = texture->palette[i];
    }
    for (size_t i = first; i < end; i++)
        texture->texels[i - first] = now[texture->texels[i]];
    texture->texel_count = texture_cut_texels(texture, levels);
    memset(texture->texels + (end - first), 0, texture->texel_count - (end - first));
    texture->colours = colours;
    texture->w_bits = (uint8_t)(texture->w_bits - levels);
    texture->h_bits = (uint8_t)(texture->h_bits - levels);
    texture->levels = (uint8_t)(texture->levels - levels);
}

bool texture_is_plain(const struct texture *texture)
{
    return !texture->is_masked && !texture->sky.times;
}

bool texture_is_alike(const struct texture *a, const struct texture *b)
{
    return texture_is_plain(a) && texture_is_plain(b) && a->w_bits == b->w_bits && a->h_bits == b->h_bits &&
           a->transposed == b->transposed;
}

static double apart2(uint32_t a, uint32_t b)
{
    double sum = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const double way = (double)(a >> shift & 0xFF) - (double)(b >> shift & 0xFF);
        sum += way * way;
    }
    return sum;
}

double texture_error(const struct texture *texture, unsigned level, const struct texture *as, unsigned as_level)
{
    const unsigned w_bits = texture->w_bits - level, h_bits = texture->h_bits - level, down = as_level - level;
    const uint8_t *from = texture->texels + level_first(texture, level), *to = as->texels + level_first(as, as_level);
    double sum = 0;
    for (size_t y = 0; y < (size_t)1 << h_bits; y++)
        for (size_t x = 0; x < (size_t)1 << w_bits; x++) {
            const uint8_t here = from[y << w_bits | x], there = to[(y >> down) << (w_bits - down) | x >> down];
            sum += apart2(texture->palette[here], as->palette[there]);
        }
    return sum / (double)((size_t)1 << (w_bits + h_bits));
}

double texture_error_flat(const struct texture *texture, unsigned level)
{
    const size_t count = (size_t)1 << (texture->w_bits + texture->h_bits - 2 * level);
    const uint8_t *from = texture->texels + level_first(texture, level);
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += apart2(texture->palette[from[i]], texture->mean);
    return sum / (double)count;
}
