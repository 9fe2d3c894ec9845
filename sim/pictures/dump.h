/* SPDX-License-Identifier: MIT
 *
 * The hook for scripts that every simulated program calls with the last frame it showed:
 * LIMNER_DUMP=x.png in the environment writes it, LIMNER_CHECK=x.png compares it. */
#ifndef SIM_DUMP_H
#define SIM_DUMP_H

#include "pictures/image.h"

/* Does what the environment asks, which may be nothing. False, with the reason, when the file
 * cannot be written or the frame differs: the program's exit status must tell. */
bool dump_last_frame(const struct film *frame, struct error *err);

/* Whether the environment asks for either. */
bool dump_is_asked(void);

#endif
