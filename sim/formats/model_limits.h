/* SPDX-License-Identifier: MIT
 *
 * How large a model may be, whoever reads it. */
#ifndef SIM_MODEL_LIMITS_H
#define SIM_MODEL_LIMITS_H

/* A face's own limit: what is done with it takes time that grows with the square of its corners. */
enum { MOST_CORNERS = 1 << 23, MOST_FACES = 1 << 20, MOST_FACE_CORNERS = 1024 };

#endif
