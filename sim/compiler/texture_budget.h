/* SPDX-License-Identifier: MIT
 *
 * --texture-budget KB: a model whose textures take no more than that, by as little loss as can be. */
#ifndef SIM_TEXTURE_BUDGET_H
#define SIM_TEXTURE_BUDGET_H

#include "compiler/compile_options.h"
#include "model/model.h"

/* For all of the process, as it means the same to all commands that read models: KB of 1000 bytes. */
bool texture_budget_parse(const char *text, struct error *err);

/* Once the model has its light. Pictures get fewer texels, faces other pictures or none; picture.became and
 * model.textures_became say so. Nothing is done if there is no budget, or if it is kept anyhow. What is seen is that of
 * options->path, or of sampled cameras. */
bool texture_budget_apply(struct model *model, const struct compile_options *options, struct error *err);

#endif
