/* SPDX-License-Identifier: MIT
 *
 * What can go wrong at run time. Functions that can fail return 0 or a negative code and must be
 * checked; a target's own negative codes pass through unchanged. */
#ifndef LIM_ERRORS_H
#define LIM_ERRORS_H

#define LIM_MUST_CHECK __attribute__((warn_unused_result))

enum lim_error {
    LIM_OK = 0,
    LIM_ERR_MEMORY = -1001, /* mem_b is below lim_mem_min_b() */
    LIM_ERR_SCENE = -1002,  /* the scene needs more than this build was configured for */
    LIM_ERR_TARGET = -1003, /* the target's size or format is not supported, or it lent no line */
    LIM_ERR_CAMERA = -1004, /* position or lens out of range */
    LIM_ERR_BEGIN = -1005   /* no frame was begun */
};

#endif
