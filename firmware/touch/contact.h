/* SPDX-License-Identifier: MIT
 *
 * CONTACT: when does a box that moves along a segment come to a polygon? In: a record, its plane. Out: how much of the
 * way it has then made, exactly, and the axis along which they were apart until then. */
#ifndef LIM_CONTACT_H
#define LIM_CONTACT_H

#include "math/fixed.h"
#include "scene.h"
#include "stages.h"

/* A box on its way. Formats leave room for a sum of two products of 17 and 25 bits. */
struct lim_mover_box {
    const struct lim_scene *scene;
    int32_t from_q8[3], way_q8[3], half_q8[3];
    const int32_t *low, *high; /* what it sweeps over at most, units: of DESCENT */
};

/* num / den of the way, 0..1. */
struct lim_contact {
    uint64_t num, den;
    int32_t axis[3]; /* not 0; from the polygon to the box */
};

/* Whether it comes to the polygon of a record. plane: the record's. from_back: the box's middle is on the back of that
 * plane, so what it is stopped by if it begins in the polygon is turned there. */
bool lim_contact_find(const struct lim_mover_box *box, const LIM_FLASH lim_index *record,
                      const struct lim_plane_unpacked *plane, bool from_back, struct lim_contact *contact);

#endif
