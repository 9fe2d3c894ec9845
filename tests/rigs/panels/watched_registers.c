/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* REG_ERR and REG_EFL */
#include "rigs/panels/watched_registers.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <ucontext.h>

struct watched_registers watched;

static uint8_t *page;

bool watched_is_possible(void)
{
#ifdef __x86_64__
    return true;
#else
    return false;
#endif
}

#ifdef __x86_64__
enum { FAULT_WRITES = 2, FLAG_TRAP = 0x100 };

static struct {
    bool busy, writes;
    size_t at_b;
} now;

static struct sigaction before_segv, before_trap; /* a sanitizer's, perhaps */

static void protect(int allowed)
{
    if (mprotect(page, WATCHED_B, allowed)) abort();
}

/* The instruction is let through, and its end is waited for. */
static void touched(int number, siginfo_t *info, void *context)
{
    greg_t *registers = ((ucontext_t *)context)->uc_mcontext.gregs;
    const uint8_t *at = info->si_addr;

    (void)number;
    if (at < page || at >= page + WATCHED_B || now.busy) abort();
    now.busy = true;
    now.writes = registers[REG_ERR] & FAULT_WRITES;
    now.at_b = (size_t)(at - page);
    protect(PROT_READ | PROT_WRITE);
    if (!now.writes) {
        watched.reads[now.at_b]++;
        if (watched.before_read) watched.before_read(now.at_b);
    }
    registers[REG_EFL] |= FLAG_TRAP;
}

static void note_write(void)
{
    watched.writes[now.at_b]++;
    if (watched.n_log < WATCHED_LOG_MAX && now.at_b <= WATCHED_B - sizeof(uint32_t)) {
        struct watched_write *write = &watched.log[watched.n_log++];
        write->at_b = (uint16_t)now.at_b;
        memcpy(&write->value, page + now.at_b, sizeof write->value);
    }
    if (watched.after_write) watched.after_write(now.at_b);
}

static void stepped(int number, siginfo_t *info, void *context)
{
    (void)number, (void)info;
    ((ucontext_t *)context)->uc_mcontext.gregs[REG_EFL] &= ~(greg_t)FLAG_TRAP;
    if (now.writes) note_write();
    protect(PROT_NONE);
    now.busy = false;
}

void watched_start(void)
{
    struct sigaction action = {.sa_sigaction = touched, .sa_flags = SA_SIGINFO};

    sigemptyset(&action.sa_mask);
    if (sigaction(SIGSEGV, &action, &before_segv)) abort();
    action.sa_sigaction = stepped;
    if (sigaction(SIGTRAP, &action, &before_trap)) abort();
    protect(PROT_NONE);
}

void watched_stop(void)
{
    protect(PROT_READ | PROT_WRITE);
    if (sigaction(SIGSEGV, &before_segv, NULL) || sigaction(SIGTRAP, &before_trap, NULL)) abort();
}
#else
void watched_start(void) {}

void watched_stop(void) {}
#endif

void *watched_begin(void)
{
    if (!page) page = mmap(NULL, WATCHED_B, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) abort();
    memset(page, 0, WATCHED_B);
    memset(&watched, 0, sizeof watched);
    return page;
}

unsigned watched_times(size_t at_b, uint32_t value)
{
    unsigned times = 0;

    for (unsigned i = 0; i < watched.n_log; i++)
        times += watched.log[i].at_b == at_b && watched.log[i].value == value;
    return times;
}
