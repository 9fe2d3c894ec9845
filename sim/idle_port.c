/* SPDX-License-Identifier: MIT */
#include "idle_port.h"

static int write_nothing(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)ctx, (void)data, (void)n_b;
    return 0;
}

static int set_nothing(void *ctx, bool high)
{
    (void)ctx, (void)high;
    return 0;
}

static int wait_for_nothing(void *ctx, uint32_t delay_us)
{
    (void)ctx, (void)delay_us;
    return 0;
}

struct port idle_port(void)
{
    const struct pin pin = {.set = set_nothing};
    return (struct port){.bus = {.write = write_nothing},
                         .dc = pin,
                         .reset = pin,
                         .backlight = pin,
                         .select = pin,
                         .tearing = {.wait = wait_for_nothing},
                         .clock = {.delay = wait_for_nothing}};
}
