/* SPDX-License-Identifier: MIT
 *
 * Ctrl-C in the middle of long work: noticed at the next step, so that the work can end as it ends
 * on an error, leaving nothing half-written. */
#ifndef SIM_INTERRUPT_H
#define SIM_INTERRUPT_H

#include "error.h"
#include "linux/interrupt.h"

/* An error once a signal that is watched for has arrived. */
static inline bool interrupt_check(struct error *err)
{
    return !interrupt_signal() || error_set(err, "interrupted");
}

#endif
