/* SPDX-License-Identifier: MIT
 *
 * From a model to a compiled scene. */
#ifndef SIM_COMPILE_H
#define SIM_COMPILE_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"

/* A model that has its light to compiled scene; `grid`: NULL, or the one that it is to have. */
bool compile_part(const struct model *model, const struct grid *grid, const struct compile_options *options,
                  struct compiled *out, struct error *err);

/* The points of the reference's own reader, which has a say in what is chosen; that it has none for a file is noted
 * where wrong pixels are predicted. */
bool compile_source(const char *path, struct model *model, const struct compile_options *options, struct error *err);

/* Model file -> compiled scene, all steps; what is animated stays where the file has it. */
bool compile_model(const char *path, const struct compile_options *options, struct compiled *out, struct error *err);

/* What came of it, for people: all that there is to say, and the few lines that everybody wants. */
void compile_report_print(const struct compiled *scene, const char *name);
void compile_summary_print(const struct compiled *scene, const struct moving *moving, const char *name);

/* A report's notes as notices: all but details, or only those of what is not drawn as the file says. */
void compile_report_tell(const struct compile_report *report, bool all);

/* Whether report->instructions tell what frames cost. Trees are compared as filled polygons in profile fast; of other
 * frames that says nothing. */
bool compile_report_has_cost(const struct compile_report *report);

/* RAM of all pixels, whose lines begin at whole words. */
size_t framebuffer_b(unsigned w_px, unsigned h_px);

#endif
