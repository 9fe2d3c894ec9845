/* SPDX-License-Identifier: MIT
 *
 * What precision profiles promise: at most so many of a path's pixels show another face than the model has there. It is
 * kept by what is chosen; what a scene gets wrong is a property of the scene as well, and the compiler says where it is
 * more. */
#ifndef SIM_PROMISE_H
#define SIM_PROMISE_H

#include "core/core.h"
#include "scene/compiled.h"

/* Percent; 0: nothing is promised, as by draft. NULL: fast. */
double promise_wrong_percent(const struct core *core);

/* Says in a note of the report that a scene is predicted to have more wrong than its profile promises, which face errs
 * most, and what helps; else that its views along faces are, if so; else nothing. */
void promise_note(struct compiled *scene);

#endif
