/* SPDX-License-Identifier: MIT
 *
 * What a machine lacks for counting instructions and for the plot: `limner measure` does without what nobody asked
 * for by name. */
#ifndef SIM_MEASURE_TOOLS_H
#define SIM_MEASURE_TOOLS_H

#include "measure/measure_request.h"

/* Leaves out processors and the plot whose tools are not there, and says in a line each what to install. Processors of
 * --core stay, for measure_request_check() to refuse. */
void measure_tools_fit(struct measure_request *request);

#endif
