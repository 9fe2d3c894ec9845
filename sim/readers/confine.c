/* SPDX-License-Identifier: MIT
 *
 * Landlock, by its system calls alone: all that is handled is forbidden, as no rule allows any of it. Numbers are those
 * of Linux's interface, the same on all processors; older headers lack some of them. */
#define _GNU_SOURCE /* syscall() */
#include "readers/confine.h"

#include <stddef.h>
#include <stdint.h>
#include <sys/prctl.h>
#include <unistd.h>

enum { CALL_CREATE_RULESET = 444, CALL_RESTRICT_SELF = 446, ASKS_VERSION = 1 };

enum {
    FILES_WITHOUT_READING = 0x1FF3, /* bits 0 to 12: execute, write, remove, make; 2 and 3 are reading */
    FILES_MOVED = 1 << 13,          /* from version 2 on: from one folder to another */
    FILES_CUT = 1 << 14,            /* 3 */
    NET_TCP = 3,                    /* 4: bind, connect */
    SCOPE_OUTSIDE = 3               /* 6: abstract sockets, signals */
};

struct ruleset {
    uint64_t files, net, scoped;
};

/* The version says how much of the structure the kernel knows. */
static size_t ruleset_for(long version, struct ruleset *out)
{
    *out = (struct ruleset){FILES_WITHOUT_READING, NET_TCP, SCOPE_OUTSIDE};
    if (version >= 2) out->files |= FILES_MOVED;
    if (version >= 3) out->files |= FILES_CUT;
    return version >= 6 ? sizeof *out : version >= 4 ? offsetof(struct ruleset, scoped) : offsetof(struct ruleset, net);
}

void confine_to_reading(void)
{
    struct ruleset ruleset;
    const long version = syscall(CALL_CREATE_RULESET, NULL, (size_t)0, ASKS_VERSION);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || version < 1) return;
    const size_t size_b = ruleset_for(version, &ruleset);
    const int descriptor = (int)syscall(CALL_CREATE_RULESET, &ruleset, size_b, 0);
    if (descriptor < 0) return;
    (void)syscall(CALL_RESTRICT_SELF, descriptor, 0);
    close(descriptor);
}
