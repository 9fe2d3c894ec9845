/* SPDX-License-Identifier: MIT
 *
 * bounded SECONDS MEGABYTES COMMAND...: runs the command, signals as a login shell has them. Its exit status, or 128
 * and the signal's number; with a line on standard error, 120 if it and the programs that it ran took more processor
 * time, or hung and were killed: ten times as long, as machines are busy; 121 if one of them had more resident memory.
 */
#define _DEFAULT_SOURCE
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { TOO_LONG = 120, TOO_LARGE = 121, KB_A_MB = 1024, WALL_A_CPU = 10 };

static volatile pid_t child;
static volatile sig_atomic_t took_too_long;

static void kill_child(int signal_number)
{
    (void)signal_number;
    took_too_long = 1;
    kill(-child, SIGKILL);
}

int main(int argc, char **argv)
{
    int status = 0;
    struct rusage usage;
    if (argc < 4) return EXIT_FAILURE;
    child = fork();
    if (child == 0) {
        setpgid(0, 0);
        for (int number = SIGHUP; number <= SIGTERM; number++)
            signal(number, SIG_DFL);
        execvp(argv[3], argv + 3);
        _exit(EXIT_FAILURE);
    }
    setpgid(child, child);
    struct sigaction action = {.sa_handler = kill_child, .sa_flags = SA_RESTART};
    sigaction(SIGALRM, &action, NULL);
    alarm(WALL_A_CPU * (unsigned)atoi(argv[1]));
    if (wait4(child, &status, 0, &usage) < 0) return EXIT_FAILURE;
    if (took_too_long || usage.ru_utime.tv_sec + usage.ru_stime.tv_sec >= atol(argv[1])) {
        fprintf(stderr, "bounded: more than %s s\n", argv[1]);
        return TOO_LONG;
    }
    if (usage.ru_maxrss > atol(argv[2]) * KB_A_MB) {
        fprintf(stderr, "bounded: %ld MB, more than %s\n", usage.ru_maxrss / KB_A_MB, argv[2]);
        return TOO_LARGE;
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
