/* SPDX-License-Identifier: MIT
 *
 * Ctrl-C in the middle of long work: noticed at the next step, so that the work can end as it ends
 * on an error, leaving nothing half-written. */
#ifndef SIM_INTERRUPT_H
#define SIM_INTERRUPT_H

#include "error.h"

/* From now on SIGHUP, SIGINT and SIGTERM no longer end the process by themselves. */
void interrupt_watch(void);

/* An error once one of them has arrived. */
bool interrupt_check(struct error *err);

/* Which one has arrived, or 0. */
int interrupt_signal(void);

/* Ends the process by it after all, as its parent expects; returns if none has arrived. */
void interrupt_die(void);

#endif
