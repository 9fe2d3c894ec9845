/* SPDX-License-Identifier: MIT
 *
 * What a picture is wiped with before a frame, to see that the frame leaves no pixel unpainted. */
#ifndef TESTS_UNPAINTED_H
#define TESTS_UNPAINTED_H

#include "colour.h"
#include "limner.h"

#include <stddef.h>
#include <stdint.h>

static inline bool colour_is_used(const struct lim_scene *scene, uint16_t colour)
{
    if (scene->background == colour) return true;
    for (size_t at = 0; at < scene->polygon_words; at += lim_record_words(scene->polygons[at])) {
        if (scene->polygons[at + 1] == colour) return true;
    }
    return false;
}

/* A colour that neither the background nor a polygon of the scene has, of which there are fewer than 65535. Mixed
 * colours and textures may have it. */
static inline uint16_t unused_colour(const struct lim_scene *scene)
{
    uint16_t colour = 0x5A5A;

    while (colour_is_used(scene, colour))
        colour++;
    return colour;
}

/* Pixels are as lines hold them. */
static inline void wipe_pixels(uint16_t *pixels, size_t n_px, uint16_t colour)
{
    for (size_t i = 0; i < n_px; i++)
        pixels[i] = lim_memory_colour(colour);
}

static inline size_t count_pixels(const uint16_t *pixels, size_t n_px, uint16_t colour)
{
    size_t count = 0;

    for (size_t i = 0; i < n_px; i++)
        count += pixels[i] == lim_memory_colour(colour);
    return count;
}

#endif
