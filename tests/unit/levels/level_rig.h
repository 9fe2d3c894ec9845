/* SPDX-License-Identifier: MIT
 *
 * Maps of small WADs in a folder of the test's own, and faces of the models that they become. */
#ifndef LEVELS_LEVEL_RIG_H
#define LEVELS_LEVEL_RIG_H

#include "model/model.h"
#include "rigs/random.h"
#include "unit/levels/wad_writer.h"

extern struct wad_writer level_wad;
extern struct wad_map level_map; /* the map being made; empty after level_begin() */

/* For cmocka: into a new folder, out of it, and an empty map. The folder may have a.wad and b.wad. */
int level_enter(void **state);
int level_leave(void **state);
int level_begin(void **state);

/* The map and its looks as a.wad. */
void level_save(const char *name);

/* A test fails if there is a notice. */
struct model level_imported(const char *path, bool is_textured);
struct model level_saved(void);

/* Modulo the number of corners. */
const double *level_corner_at(const struct model *model, const struct model_face *face, uint32_t k);
const double *level_uv(const struct model *model, const struct model_face *face, uint32_t k);

/* Twice the area, by axes: the direction that a face looks. */
void level_normal(const struct model *model, const struct model_face *face, double out[3]);

/* The wall that looks that way, between two heights in units; NULL: there is none, or the test fails. */
const struct model_face *level_wall(const struct model *model, double x, double z, int low, int high);
const struct model_face *level_need_wall(const struct model *model, double x, double z, int low, int high);

/* Its name; empty: it shows none. */
const char *level_picture_of(const struct model *model, const struct model_face *face);

/* Whether so many random rays from a place all end at the front of a face that is opaque; else one is printed that does
 * not. */
bool level_is_closed(const struct model *model, const double eye_m[3], int rays, struct random *random);

/* A line between two sectors, the right one first; WAD_NO_SIDE: none. Returns it. */
unsigned level_border(unsigned from, unsigned to, unsigned right, unsigned left);

/* Its lines run counter-clockwise, so their right is outside of it. */
void level_square(int x, int y, int side, unsigned outside, unsigned inside);

/* Two sectors in a row along x, 0 to 256 high, and low to high; returns the line between them, whose right is the
 * first. */
unsigned level_step(int low, int high);

#endif
