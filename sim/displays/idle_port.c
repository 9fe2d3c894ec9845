/* SPDX-License-Identifier: MIT */
#include "displays/idle_port.h"

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

bool idle_display_setup(struct display *display, const struct module_choice *choice, struct error *err)
{
    struct port port = idle_port();
    if (!choice->panel.family->tells_refresh) port.tearing = (struct edge){0};
    if (!choice->panel.family->selects) port.select = (struct pin){0};
    return display_setup(display, &choice->panel, &choice->module, &port, err);
}
