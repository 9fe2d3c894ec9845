/* SPDX-License-Identifier: MIT
 *
 * Where a walker can go in a scene: places half a metre apart, found by walking there (firmware/collide.h), and which
 * of them can be reached from which. */
#ifndef SIM_WALK_MAP_H
#define SIM_WALK_MAP_H

#include "base/map.h"
#include "collide.h"
#include "scene/compiled.h"

/* Metres. */
struct walk_body {
    double eye_m;    /* above its feet */
    double height_m; /* more than the eye */
    double radius_m; /* half of its width */
    double step_m;   /* the highest step that it climbs, and goes down */
};

enum { WALK_WAYS = 8, WALK_PLACES_MAX = 60000, WALK_NOWHERE = -1 };

struct walk_place {
    struct lim_walker walker; /* it stands */
    int32_t to[WALK_WAYS];    /* neighbours, or WALK_NOWHERE */
};

struct walk_map {
    const struct compiled *scene;
    struct walk_body body;
    struct lim_solid solid;
    lim_index *stack;
    struct walk_place *places; /* 0: where it began */
    size_t count, capacity;
    struct map cells;
};

/* Refuses a scene without a tree, and a body that is too large for it. */
bool walk_map_init(struct walk_map *map, const struct compiled *scene, const struct walk_body *body, struct error *err);
void walk_map_free(struct walk_map *map);

/* Who falls from an eye's place, if it comes to stand. */
bool walk_map_put(const struct walk_map *map, const double eye_m[3], struct lim_walker *walker);

/* All places that can be reached from there, WALK_PLACES_MAX at most. What was found before is forgotten. false: time
 * is over (deadline.h). */
bool walk_map_explore(struct walk_map *map, const struct lim_walker *from, struct error *err);

/* A walker goes straight to a place on the level, up to `most_m` far: whether it comes there, without falling. */
bool walk_map_goes(const struct walk_map *map, struct lim_walker *walker, const struct lim_walker *to, double most_m);

/* A part of that, by strides as short, and not off an edge: *walker is where it came to. false: it left the range. */
bool walk_map_steps(const struct walk_map *map, struct lim_walker *walker, const struct lim_walker *to, double way_m);

/* Nearer on the level than that to a place, who goes there has come there. */
extern const double WALK_NEAR_M;

/* Metres on the level between two. */
double walk_map_way_m(const struct walk_map *map, const struct lim_walker *a, const struct lim_walker *b);

void walk_map_eye(const struct walk_map *map, const struct lim_walker *walker, double eye_m[3]);

/* Whether one eye sees the other. */
bool walk_map_sees(const struct walk_map *map, const struct lim_walker *a, const struct lim_walker *b);

#endif
