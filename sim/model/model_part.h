/* SPDX-License-Identifier: MIT
 *
 * What stands still in a model, and each thing that moves in it, as models of their own. */
#ifndef SIM_MODEL_PART_H
#define SIM_MODEL_PART_H

#include "model/model.h"

/* The faces of one mover, 1 .. mover_count, in its own coordinates; 0: of none. numbers[i] is the number in the model
 * of face i of the part. Both are the caller's to free, the part first: it knows the
 * numbers. is_textured: with pictures, in the sizes that those of all parts together get; else faces have
 * their mean colours. */
void model_part(const struct model *model, size_t mover, bool is_textured, struct model *part, uint32_t **numbers);

#endif
