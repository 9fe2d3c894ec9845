/* SPDX-License-Identifier: MIT
 *
 * The camera that costs most and the one that errs most in a scene's free space, searched (camera_search.h), not
 * proved. */
#ifndef SIM_WORST_VIEWS_H
#define SIM_WORST_VIEWS_H

#include "cameras/camera_search.h"
#include "measure/measurement.h"

enum { WORST_TRIES = 2000, WORST_TRIES_MAX = 10000000, WORST_SECONDS = 20, WORST_ERROR_SHARE = 10 };

struct worst_options {
    uint32_t seed;
    size_t tries;   /* cameras for the cost; one of WORST_ERROR_SHARE as many for errors, which take longer. 0: none */
    double seconds; /* for both; 0: as long as all tries take */
};

struct worst_views {
    bool is_predicted; /* the cost is in instructions (frame_cost.h); else in counted work, which only ranks frames */
    struct search_result cost, error; /* error: the score is wrong pixels */
    struct lim_stats stats;           /* of the camera that costs most */
};

/* `views` has the lens and the size; its path is not used. */
bool worst_views_find(struct measure_source *source, const struct measure_candidate *candidate,
                      const struct measure_views *views, const struct worst_options *options, struct worst_views *out,
                      struct error *err);

/* --worst or --worst=CAMERAS, for compile_options.worst_tries. */
bool worst_tries_parse(const char *text, size_t *out, struct error *err);

/* Where nobody said how many: WORST_SECONDS; none where --time-limit is none, so that what is found does not hang on
 * how busy the machine is. */
double worst_seconds_unsaid(void);

#endif
