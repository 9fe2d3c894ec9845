/* SPDX-License-Identifier: MIT
 *
 * How long a command may take: --time-limit. Long loops ask between steps whether time is over and end early; whoever
 * can keep what was found so far does, and says so, and whoever cannot fails. Without a limit nothing ever ends early,
 * and under one that is not reached results are the same. One a process. A signal ends the process by itself
 * (ending.h). */
#ifndef SIM_DEADLINE_H
#define SIM_DEADLINE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { DEADLINE_DEFAULT_S = 600 };

/* Begins now. 0: no limit. */
void deadline_begin(double limit_s);

/* The option's value, or without one (NULL) that of LIMNER_TIME_LIMIT in the environment, or the default. */
bool deadline_parse(const char *text, double *limit_s, struct error *err);

/* Of work that waits for others: no limit but one that the command line has given. */
void deadline_only_if_given(void);

/* Whether there is a limit. */
bool deadline_is_set(void);

/* Whether loops should end, because time is over. Some 30 ns. */
bool deadline_passed(void);

/* How often somebody has been told so: what is made meanwhile may hang on the machine's speed. */
size_t deadline_cuts(void);

/* An error if they should. `doing` says what is not finished: "no tree of 500 polygons so far". */
bool deadline_check(struct error *err, const char *doing, ...) __attribute__((format(printf, 2, 3)));

/* A stretch of time that ends earlier, so that what follows has some left: `share` of what is left now. What it returns
 * is for deadline_restore(), innermost first. */
struct deadline_end {
    double end_s;
};
struct deadline_end deadline_share(double share);
struct deadline_end deadline_within(double seconds); /* so long at most, also without a limit; 0: as it is */
struct deadline_end deadline_end(void);              /* as it is now */
void deadline_restore(struct deadline_end outer);

/* Notes, if time is over, what counts nonetheless. */
void deadline_say(const char *kept, ...) __attribute__((format(printf, 1, 2)));

/* Prints these notes, a line each on standard error: for commands that succeed. One that fails keeps nothing, and has
 * its error to print. */
void deadline_tell(void);

/* The clock, for tests: seconds that never go back. NULL: the system's. */
void deadline_set_clock(double (*now_s)(void));

#endif
