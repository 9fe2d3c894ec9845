/* SPDX-License-Identifier: MIT
 *
 * Cells and portals, as far as a frame is concerned: the compiler found out which subtrees can be seen from each
 * part of the scene. Before the walk, what can be seen from around the eye is unpacked, a bit a box; the walk skips
 * subtrees whose bit is 0. In: the scene, the eye, the near plane. Out: those bits. Memory: lim_portals_mem_b(), lent.
 */
#ifndef LIM_PORTALS_H
#define LIM_PORTALS_H

#include "camera.h"
#include "stages.h"

/* Lends a scene's portals that many bytes. */
static inline void lim_portals_lend(struct lim_portals *portals, const struct lim_scene *scene, void *mem)
{
    uint8_t *bits = lim_portals_mem_b(scene) ? (uint8_t *)mem : NULL;

    portals->bits = bits;
    portals->stack = bits ? (uint16_t *)(void *)(bits + LIM_PORTALS_BITS_B(scene->box_count)) : NULL;
}

/* The radius of a ball about the eye that holds the near rectangle, and some units that rounding may move a wall by.
 * far_units: the distance of the scene's far end. Unless the eye is within the grid, the result is meaningless. */
uint32_t lim_portals_ball_units(const struct lim_camera *camera, uint32_t far_units);

/* Unpacks what can be seen from the ball about the eye. false: nothing is known, everything must be walked: the ball
 * touches matter or open space or is larger than some thousand units, or the eye is as good as on a plane. */
bool lim_portals_unpack(const struct lim_portals *portals, const struct lim_eye *eye, uint32_t ball_units);

/* Whether a subtree with that box may be seen. */
static inline bool lim_portals_show(const uint8_t *bits, lim_index box)
{
    return bits[box >> 3] >> (box & 7) & 1;
}

#endif
