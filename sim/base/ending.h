/* SPDX-License-Identifier: MIT
 *
 * What must not outlive the process: temporary files and folders, and a program that it runs. However it ends, by
 * return, exit() or a signal that can be caught, they go first; then a signal ends the process as its parent
 * expects. SIGKILL cannot be caught: temporary files stay, under names that nobody else uses. */
#ifndef SIM_ENDING_H
#define SIM_ENDING_H

#include <sys/types.h>

enum leftover_kind {
    LEFTOVER_FILE,
    LEFTOVER_FOLDER, /* is removed if it is empty */
    LEFTOVER_TREE    /* with all that is in it */
};

struct leftover;

/* First in main(), before there is anything to remove. Signals that were ignored, as nohup wishes, stay so. Writing
 * beyond a limit on file sizes is an error of the write, no signal. */
void ending_prepare(void);

/* A library that takes signals which nobody else has may have them until ending_watch(); nothing may be listed. */
void ending_lend(void);
void ending_watch(void);

/* Signals wait from ending_hold() to ending_release(): what is made in between is listed when they come. Pairs nest. */
void ending_hold(void);
void ending_release(void);

/* Lists what has just been made; NULL: out of memory. The path is copied; if relative, to the working folder. */
struct leftover *ending_add(enum leftover_kind kind, const char *path);

/* Takes it off the list, as it is removed or is to stay. NULL: nothing. */
void ending_forget(struct leftover *leftover);

/* fork() of the one child that there may be at a time. It has signals as they were before ending_prepare(), but
 * for the one of limits on file sizes, and a process group of its own, and is ended with its parent, its own children
 * included. */
pid_t ending_fork(void);

/* Whether it has come to its end. It is still to be waited for. */
_Bool ending_has_ended(pid_t child);

/* waitpid() for it: false, with errno, if that fails. */
_Bool ending_wait(pid_t child, int *status);

#endif
