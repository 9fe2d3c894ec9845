/* SPDX-License-Identifier: MIT
 *
 * Boxes, tapered boxes, turned solids and folded cloth as polygons. */
#include "demo_shape.h"

void shape_quad(struct soup *soup, const struct frame *frame, const double corner_mm[4][3], int material)
{
    struct vec3 corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = frame_point(frame, corner_mm[i][0], corner_mm[i][1], corner_mm[i][2]);
    soup_add(soup, corner, 4, material);
}

/* Corner bits: 1 right, 2 top, 4 front. */
static struct vec3 box_corner(const struct frame *frame, const struct box *box, int bits)
{
    int side_x = bits & 1 ? NO_RIGHT : NO_LEFT, side_z = bits & 4 ? NO_FRONT : NO_BACK;
    int inset_x_mm = bits & 2 && !(box->hidden & side_x) ? box->taper_mm : 0;
    int inset_z_mm = bits & 2 && !(box->hidden & side_z) ? box->taper_mm : 0;
    return frame_point(frame, bits & 1 ? box->hi_mm[0] - inset_x_mm : box->lo_mm[0] + inset_x_mm,
                       bits & 2 ? box->hi_mm[1] : box->lo_mm[1],
                       bits & 4 ? box->hi_mm[2] - inset_z_mm : box->lo_mm[2] + inset_z_mm);
}

void shape_box(struct soup *soup, const struct frame *frame, const struct box *box)
{
    static const int side[6][4] = {
        {0, 4, 6, 2}, {5, 1, 3, 7}, {0, 1, 5, 4}, {6, 7, 3, 2}, {1, 0, 2, 3}, {4, 5, 7, 6},
    };
    for (int i = 0; i < 6; i++) {
        struct vec3 corner[4];
        if (box->hidden & 1 << i) continue;
        for (int j = 0; j < 4; j++)
            corner[j] = box_corner(frame, box, side[i][j]);
        soup_add(soup, corner, 4, box->material);
    }
}

static struct vec3 ring_point(const struct frame *frame, const struct turned *turned, int ring, int side)
{
    /* half a step on, so that a four-sided one stands square in its frame */
    double angle = 2 * DEMO_PI * (side + 0.5) / turned->sides;
    double radius_mm = turned->ring[ring].radius_mm;
    return frame_point(frame, turned->x_mm + radius_mm * sin(angle), turned->ring[ring].y_mm,
                       turned->z_mm + radius_mm * cos(angle));
}

static void turned_side(struct soup *soup, const struct frame *frame, const struct turned *turned, int ring, int side)
{
    struct vec3 corner[4];
    int count = 0;
    corner[count++] = ring_point(frame, turned, ring, side);
    if (turned->ring[ring].radius_mm) corner[count++] = ring_point(frame, turned, ring, side + 1);
    corner[count++] = ring_point(frame, turned, ring + 1, side + 1);
    if (turned->ring[ring + 1].radius_mm) corner[count++] = ring_point(frame, turned, ring + 1, side);
    soup_add(soup, corner, count, turned->material);
}

void shape_turned(struct soup *soup, const struct frame *frame, const struct turned *turned)
{
    int last = turned->rings - 1;
    for (int ring = 0; ring < last; ring++)
        for (int side = 0; side < turned->sides; side++)
            turned_side(soup, frame, turned, ring, side);
    if (!turned->open_top && turned->ring[last].radius_mm) {
        struct vec3 lid[SIDES_MAX];
        for (int side = 0; side < turned->sides; side++)
            lid[side] = ring_point(frame, turned, last, side);
        soup_add(soup, lid, turned->sides, turned->material);
    }
}

void shape_drape(struct soup *soup, const struct frame *frame, const struct drape *drape)
{
    int strips = 2 * drape->folds;
    for (int i = 0; i < strips; i++) {
        double x0 = (double)drape->width_mm * i / strips, x1 = (double)drape->width_mm * (i + 1) / strips;
        double z0 = i % 2 ? drape->depth_mm : 0, z1 = i % 2 ? 0 : drape->depth_mm;
        double top = drape->height_mm;
        shape_quad(soup, frame, (const double[4][3]){{x0, 0, z0}, {x1, 0, z1}, {x1, top, z1}, {x0, top, z0}},
                   drape->material);
        if (drape->two_sided)
            shape_quad(soup, frame, (const double[4][3]){{x1, 0, z1}, {x0, 0, z0}, {x0, top, z0}, {x1, top, z1}},
                       drape->material);
    }
}
