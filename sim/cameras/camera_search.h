/* SPDX-License-Identifier: MIT
 *
 * Searching a scene's free space for the camera that scores most: what a frame costs, what is wrong with it, whatever
 * the caller measures. Cameras at random first; then the best few of them are moved about in steps that shrink where
 * they find nothing better. What is found is searched, not proved: there may be worse. */
#ifndef SIM_CAMERA_SEARCH_H
#define SIM_CAMERA_SEARCH_H

#include "cameras/camera_path.h"
#include "scene/compiled.h"

enum { SEARCH_GOALS_MAX = 4 };

/* Scores a camera for each goal, more is worse; below 0: it does not count. Whatever moves is where it is at
 * viewpoint->time_s. False: an error, which ends the search. */
typedef bool search_measure(void *ctx, const struct viewpoint *viewpoint, double *scores, struct error *err);

struct camera_search {
    const struct compiled *scene;
    struct lens lens;
    double length_s;              /* of the animation; 0: nothing moves */
    uint32_t seed;                /* the same seed, tries and scene find the same, where time does not end the search */
    size_t tries;                 /* at most; time ends it as well (deadline.h) */
    const struct viewpoint *hint; /* a camera to begin with; NULL: none */
    size_t goals;                 /* scores a camera has; SEARCH_GOALS_MAX at most */
    const char *doing;            /* for the line of progress */
    search_measure *measure;
    void *ctx;
};

struct search_goal {
    struct viewpoint worst;
    double score;      /* of that; below 0: no camera counted */
    double mean, most; /* of plain random cameras, on which nothing was searched */
};

struct search_result {
    struct search_goal goals[SEARCH_GOALS_MAX];
    size_t plain; /* random cameras, as random:SEED draws them */
    size_t tried; /* all together */
    bool is_cut;  /* time ended it before all tries were made */
};

/* Eyes keep so far from whatever has a front that no near plane cuts it, where there is room for that. Fails where no
 * free space is found. */
bool camera_search_run(const struct camera_search *search, struct search_result *out, struct error *err);

#endif
