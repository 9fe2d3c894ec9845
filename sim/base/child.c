/* SPDX-License-Identifier: MIT
 *
 * fork(), redirection, exec, wait; what the child could not even start with goes to its log as well. */
#define _XOPEN_SOURCE 700
#include "base/child.h"

#include "base/deadline.h"
#include "base/ending.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { CANNOT_START = 127, PATH_MAX_B = CHILD_PATH_B, LINE_MAX_B = 300 };

static bool redirect(const char *path, int flags, int descriptor)
{
    const int opened = open(path, flags, 0666);
    if (opened < 0 || dup2(opened, descriptor) < 0) return false;
    return close(opened) == 0;
}

_Noreturn static void become(const struct child *child)
{
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    bool ok = redirect("/dev/null", O_RDONLY, STDIN_FILENO) && redirect(child->log_path, flags, STDERR_FILENO);
    if (ok && child->out_path) ok = redirect(child->out_path, flags, STDOUT_FILENO);
    if (ok && !child->out_path) ok = dup2(STDERR_FILENO, STDOUT_FILENO) >= 0;
    if (ok && child->folder) ok = chdir(child->folder) == 0;
    signal(SIGXFSZ, SIG_DFL);
    /* execvp() is declared as if it changed the strings; POSIX promises that it does not. */
    if (ok) execvp(child->argv[0], (char *const *)(uintptr_t)child->argv);
    fprintf(stderr, "%s: %s\n", child->argv[0], strerror(errno));
    _exit(CANNOT_START);
}

/* That is not empty. */
static void last_line(const char *path, char line[LINE_MAX_B])
{
    char next[LINE_MAX_B];
    FILE *file = fopen(path, "r");
    snprintf(line, LINE_MAX_B, "no reason given");
    while (file && fgets(next, sizeof next, file)) {
        next[strcspn(next, "\n")] = '\0';
        if (*next) memcpy(line, next, sizeof next);
    }
    if (file) fclose(file);
}

/* Asked now and then, less often the longer it takes. */
static bool wait_for_end(pid_t pid, const char *task, struct error *err)
{
    enum { FIRST_NS = 250000, LAST_NS = 16000000 };
    struct timespec pause = {0, FIRST_NS};
    while (!ending_has_ended(pid)) {
        if (!deadline_check(err, "%s", task)) return false;
        nanosleep(&pause, NULL);
        if (pause.tv_nsec < LAST_NS) pause.tv_nsec *= 2;
    }
    return true;
}

bool child_wait(pid_t pid, const char *task, int *status, struct error *err)
{
    const bool ok = wait_for_end(pid, task, err);
    if (!ok) kill(-pid, SIGKILL);
    return ending_wait(pid, status) ? ok : error_set(err, "%s: %s", task, strerror(errno));
}

bool child_run(const struct child *child, const char *task, struct error *err)
{
    int status = 0;
    char reason[LINE_MAX_B];
    fflush(NULL);
    const pid_t pid = ending_fork();
    if (pid == 0) become(child);
    if (pid < 0) return error_set(err, "%s: %s", task, strerror(errno));
    if (!child_wait(pid, task, &status, err)) return false;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
    last_line(child->log_path, reason);
    return error_set(err, "%s: %s", task, reason);
}

bool child_exists(const char *program)
{
    const char *path = getenv("PATH");
    while (path && *path) {
        char candidate[PATH_MAX_B];
        const size_t length = strcspn(path, ":");
        const int printed = snprintf(candidate, sizeof candidate, "%.*s/%s", (int)length, path, program);
        if (printed < (int)sizeof candidate && access(candidate, X_OK) == 0) return true;
        path += length + (path[length] == ':');
    }
    return false;
}

/* Linux tells by a link in /proc. Without it, by the name that the program was started by, which may count from the
 * folder that it was started in. */
bool child_own_path(char path[CHILD_PATH_B])
{
    const ssize_t length = readlink("/proc/self/exe", path, CHILD_PATH_B - 1);
    const char *started_as = (const char *)getauxval(AT_EXECFN);
    if (length <= 0) return started_as && realpath(started_as, path);
    path[length] = '\0';
    return true;
}
