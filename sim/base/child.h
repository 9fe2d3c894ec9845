/* SPDX-License-Identifier: MIT
 *
 * Programs that a command runs to do its work: a compiler, an emulator, a plotter. No shell is between. */
#ifndef SIM_CHILD_H
#define SIM_CHILD_H

#include "base/error.h"

#include <sys/types.h>

struct child {
    const char *const *argv; /* NULL behind the last; argv[0] is looked for in PATH */
    const char *folder;      /* to run in; NULL: this process's */
    const char *out_path;    /* gets standard output; NULL: the log does */
    const char *log_path;    /* gets standard error */
};

/* Runs it to its end, with nothing to read. If that is not exit status 0, err says what failed (`task`) and
 * has the last line of the log. Ended early (deadline.h), with all that it started in turn. */
bool child_run(const struct child *child, const char *task, struct error *err);

/* Waits for what ending_fork() began until it ends, or time is over (deadline.h): then it is killed with all that it
 * started in turn, and err says so of the task. */
bool child_wait(pid_t pid, const char *task, int *status, struct error *err);

/* Whether PATH has such a program. */
bool child_exists(const char *program);

/* The absolute path of the running program's own file, also where there is no /proc. false, with errno: that cannot be
 * found out. */
enum { CHILD_PATH_B = 4096 };
bool child_own_path(char path[CHILD_PATH_B]);

#endif
