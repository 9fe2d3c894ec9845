/* SPDX-License-Identifier: MIT
 *
 * The emulated chip's port, driven by records instead of a driver. */
#include "glass/listener.h"

#include <assert.h>
#include <string.h>

void listener_init(struct listener *listener, const struct module_choice *choice)
{
    *listener = (struct listener){.module = choice->module};
    emulated_display_choose(&listener->display, &choice->panel, &choice->module);
    listener->display.port->deferred = false;
    listener->display.port->timeless = true;
    listener->port = emulated_port_whole(listener->display.port);
}

bool listener_find_pin(const char *name, size_t length, enum listener_pin *pin, struct error *err)
{
    static const char *const names[LISTENER_PINS] = {"dc", "reset", "select", "backlight", "cs", "led"};
    for (int i = 0; i < LISTENER_PINS; i++) {
        if (strlen(names[i]) != length || strncmp(names[i], name, length) != 0) continue;
        *pin = (enum listener_pin)i;
        return true;
    }
    return error_set(err, "'%.*s' is no wire: dc, reset, select, backlight, cs or led", (int)length, name);
}

/* An emulated port takes everything. */
static void expect(int err)
{
    assert(err == 0);
    (void)err;
}

void listener_bytes(struct listener *listener, const uint8_t *bytes, size_t n_b)
{
    if (listener->is_high[LISTENER_CS])
        listener->other_b += n_b;
    else
        expect(bus_write(&listener->port.bus, bytes, n_b));
}

void listener_end_frame(struct listener *listener)
{
    const struct emulated_port *port = listener->display.port;
    if (port->stores == listener->last_stores) return;
    listener->frames++;
    listener->frame_bus_b = port->bus_b - listener->last_b;
    listener->last_b = port->bus_b;
    listener->last_stores = port->stores;
}

static const struct pin *wired_pin(const struct listener *listener, enum listener_pin pin)
{
    switch (pin) {
    case LISTENER_DC:
        return &listener->port.dc;
    case LISTENER_RESET:
        return &listener->port.reset;
    case LISTENER_SELECT:
        return &listener->port.select;
    case LISTENER_BACKLIGHT:
        return &listener->port.backlight;
    default:
        return NULL;
    }
}

void listener_level(struct listener *listener, enum listener_pin pin, bool high)
{
    const struct pin *of_chip = wired_pin(listener, pin);
    if (of_chip && pin_is_wired(of_chip)) expect(pin_set(of_chip, high));
    if (pin == LISTENER_LED && high != listener->is_high[LISTENER_LED]) listener_end_frame(listener);
    listener->is_high[pin] = high;
}

bool listener_time(struct listener *listener, uint64_t now_ns)
{
    struct emulated_port *port = listener->display.port;
    if (now_ns / 1000 < port->now_us) return false;
    port->now_us = now_ns / 1000;
    port->timeless = false;
    return true;
}

void listener_read(const struct listener *listener, uint8_t *rgb, uint16_t *pixels)
{
    emulated_display_read(&listener->display, &listener->module, rgb, pixels);
}
