/* SPDX-License-Identifier: MIT
 *
 * A signal that ends the program is noted instead, and asked for between two steps: so that the program can end as it
 * ends otherwise, with a display that is dark and nothing half-done. */
#ifndef HAL_LINUX_INTERRUPT_H
#define HAL_LINUX_INTERRUPT_H

#include "c_linkage.h"

HAL_C_BEGIN

/* From now on no signal that would end the process, and can be noted, does so by itself: SIGHUP, SIGINT, SIGQUIT,
 * SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2 and SIGXCPU. */
void interrupt_watch(void);

/* Which one has arrived, or 0. */
int interrupt_signal(void);

/* Ends the process by it after all, as its parent expects; returns if none has arrived. */
void interrupt_die(void);

HAL_C_END

#endif
