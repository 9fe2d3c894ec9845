/* SPDX-License-Identifier: MIT
 *
 * The one variable that a signal handler may set. */
#include "interrupt.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t seen;

typedef void signal_handler(int signal_number);
static signal_handler note;

static void note(int signal_number)
{
    seen = signal_number;
}

/* One that was to be ignored, as nohup wishes, stays so. */
static void watch(int signal_number)
{
    const struct sigaction action = {.sa_handler = note};
    struct sigaction before;
    if (sigaction(signal_number, NULL, &before) == 0 && before.sa_handler != SIG_IGN)
        sigaction(signal_number, &action, NULL);
}

void interrupt_watch(void)
{
    static const int watched[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU};
    for (size_t i = 0; i < sizeof watched / sizeof watched[0]; i++)
        watch(watched[i]);
}

int interrupt_signal(void)
{
    return seen;
}

void interrupt_die(void)
{
    if (!seen) return;
    signal(seen, SIG_DFL);
    raise(seen);
}
