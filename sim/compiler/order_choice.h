/* SPDX-License-Identifier: MIT
 *
 * Nearest first or by scan lines: the same pictures. Where the eye sees most of what the walk reaches, to paint all of
 * it costs less than to find out what is hidden. The compiler tries both, on the cameras that size its pools and for
 * the panel's size, and takes what is predicted to need fewer instructions. */
#ifndef SIM_ORDER_CHOICE_H
#define SIM_ORDER_CHOICE_H

#include "compiler/compile_options.h"
#include "model/model.h"
#include "scene/compiled.h"

/* What keeps the scene, or what it is to be compiled for, from being painted by scan lines; as method_scans()
 * takes it; NULL: nothing does. */
const char *order_needs_nearest(const struct compile_options *options, const struct lim_scene *scene);

/* Whether it can be painted into a framebuffer, polygon by polygon; an error says why not. */
bool order_can_fill(const struct compile_options *options, const struct compiled *scene, struct error *err);

/* Of a scene whose pools are measured for nearest first: draws it by scan lines from now on if that is cheaper, and the
 * options leave the choice. */
bool order_choose(struct compiled *scene, const struct compile_options *options, struct error *err);

/* The same of a scene with all that moves in it, whose pools it measures first. */
bool order_choose_moving(struct compiled *scene, struct moving *moving, const struct compile_options *options,
                         struct error *err);

/* The options with which a model is compiled: not for a framebuffer, where lines are copied into it. */
struct compile_options order_options_for(const struct compile_options *options, const struct model *model);

/* Once the tree is chosen, too: into a framebuffer what is best drawn by scan lines is painted back to front, which is
 * the same, but that nothing waits for its lines. What a frame costs there is not predicted. */
void order_settle_framebuffer(struct compile_report *report);

#endif
