/* SPDX-License-Identifier: MIT
 *
 * Any text as a wire log, after a line that says which module listens: each line is refused in one line or goes to the
 * emulated chip, which complains in one line or not at all; and whatever went over the wires, there is a picture. */
#include "fuzz_listener.h"
#include "glass/wire_log.h"

static bool take(struct listener *listener, const char *line, void *ctx, struct error *err)
{
    (void)ctx;
    return wire_log_take(listener, line, err);
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};

    return fuzz_listen(&bytes, take, NULL);
}

const struct fuzz_target fuzz_wire_log = {"wire_log", run, NULL};
