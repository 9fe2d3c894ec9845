/* SPDX-License-Identifier: MIT
 *
 * The handler calls async-signal-safe functions alone. It reads a list that is changed only while signals wait. What
 * is in a folder is for rm to remove: functions that walk folders may not be called from a handler. */
#define _GNU_SOURCE /* _Fork() */
#include "base/ending.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { CHILD_WAITS = 50, CHILD_WAIT_MS = 20 };

static const int WATCHED[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU};
enum { WATCHED_COUNT = sizeof WATCHED / sizeof WATCHED[0] };

struct leftover {
    struct leftover *older, *newer;
    enum leftover_kind kind;
    char path[];
};

static struct leftover *newest;
static volatile pid_t child; /* 0: none */
static int hold_depth;
static sigset_t mask_before; /* the outermost ending_hold() */

/* Removing ----------------------------------------------------------------------------------- */

static void remove_tree(char *path)
{
    char *const argv[] = {(char[]){"rm"}, (char[]){"-rf"}, (char[]){"--"}, path, NULL};
    const pid_t pid = _Fork();
    if (pid == 0) {
        execv("/bin/rm", argv);
        _exit(EXIT_FAILURE);
    }
    while (pid > 0 && waitpid(pid, NULL, 0) < 0 && errno == EINTR)
        continue;
}

static void remove_all(void)
{
    for (struct leftover *leftover = newest; leftover; leftover = leftover->older) {
        if (leftover->kind == LEFTOVER_FILE) unlink(leftover->path);
        if (leftover->kind == LEFTOVER_FOLDER) rmdir(leftover->path);
        if (leftover->kind == LEFTOVER_TREE) remove_tree(leftover->path);
    }
    newest = NULL;
}

/* Asked first: compilers have temporary files of their own. */
static void end_child(void)
{
    const pid_t pid = child;
    if (pid <= 0) return;
    kill(-pid, SIGTERM);
    for (int i = 0; i < CHILD_WAITS && waitpid(pid, NULL, WNOHANG) == 0; i++)
        poll(NULL, 0, CHILD_WAIT_MS);
    kill(-pid, SIGKILL);
    child = 0;
}

static void end_all(void)
{
    end_child();
    remove_all();
}

static void at_exit(void)
{
    ending_hold();
    end_all();
}

/* Signals ------------------------------------------------------------------------------------ */

/* The signal, which is blocked here, ends the process as soon as this returns. */
static void end_by(int signal_number)
{
    end_all();
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

static void watched_set(sigset_t *set)
{
    sigemptyset(set);
    for (int i = 0; i < WATCHED_COUNT; i++)
        sigaddset(set, WATCHED[i]);
}

static bool handler_is(int signal_number, void (*handler)(int))
{
    struct sigaction now;
    return sigaction(signal_number, NULL, &now) == 0 && now.sa_handler == handler;
}

void ending_watch(void)
{
    struct sigaction action = {.sa_handler = end_by};
    watched_set(&action.sa_mask);
    for (int i = 0; i < WATCHED_COUNT; i++)
        if (handler_is(WATCHED[i], SIG_DFL)) sigaction(WATCHED[i], &action, NULL);
}

void ending_lend(void)
{
    for (int i = 0; i < WATCHED_COUNT; i++)
        if (handler_is(WATCHED[i], end_by)) signal(WATCHED[i], SIG_DFL);
}

void ending_prepare(void)
{
    ending_watch();
    signal(SIGXFSZ, SIG_IGN);
    atexit(at_exit);
}

void ending_hold(void)
{
    sigset_t watched, before;
    watched_set(&watched);
    sigprocmask(SIG_BLOCK, &watched, &before);
    if (hold_depth++ == 0) mask_before = before;
}

void ending_release(void)
{
    if (--hold_depth == 0) sigprocmask(SIG_SETMASK, &mask_before, NULL);
}

/* The list ----------------------------------------------------------------------------------- */

struct leftover *ending_add(enum leftover_kind kind, const char *path)
{
    const size_t path_b = strlen(path) + 1;
    struct leftover *leftover = malloc(sizeof *leftover + path_b);
    if (!leftover) return NULL;
    memcpy(leftover->path, path, path_b);
    leftover->kind = kind;
    leftover->newer = NULL;
    ending_hold();
    leftover->older = newest;
    if (newest) newest->newer = leftover;
    newest = leftover;
    ending_release();
    return leftover;
}

void ending_forget(struct leftover *leftover)
{
    if (!leftover) return;
    ending_hold();
    if (leftover->older) leftover->older->newer = leftover->newer;
    if (leftover->newer)
        leftover->newer->older = leftover->older;
    else
        newest = leftover->older;
    ending_release();
    free(leftover);
}

/* The child ---------------------------------------------------------------------------------- */

/* What the parent has to remove is not the child's. */
static void begin_child(pid_t parent)
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(EXIT_FAILURE);
    ending_lend();
    newest = NULL;
    child = 0;
}

pid_t ending_fork(void)
{
    const pid_t parent = getpid();
    ending_hold();
    const pid_t pid = fork();
    if (pid == 0) begin_child(parent);
    if (pid > 0) {
        setpgid(pid, pid); /* whichever of the two comes first */
        child = pid;
    }
    ending_release();
    return pid;
}

_Bool ending_has_ended(pid_t pid)
{
    siginfo_t about = {0};
    return waitid(P_PID, (id_t)pid, &about, WEXITED | WNOWAIT | WNOHANG) < 0 ? errno != EINTR : about.si_pid == pid;
}

/* It is collected while signals wait: the handler never takes another process for it. */
_Bool ending_wait(pid_t pid, int *status)
{
    siginfo_t about;
    while (waitid(P_PID, (id_t)pid, &about, WEXITED | WNOWAIT) < 0)
        if (errno != EINTR) return false;
    ending_hold();
    const pid_t ended = waitpid(pid, status, 0);
    if (child == pid) child = 0;
    ending_release();
    return ended == pid;
}
