/* SPDX-License-Identifier: MIT
 *
 * Value change dumps (IEEE 1364, four-state), as sigrok, PulseView, Logic, GTKWave and simulators write them. Of
 * any size: read once, from a pipe too; memory goes by the number of signals. */
#ifndef SIM_VCD_H
#define SIM_VCD_H

#include "glass/capture.h"

/* false: an error, with its line or its time; or, without a text, nothing more is wanted. */
bool vcd_read(struct capture *capture, FILE *file, struct error *err);

#endif
