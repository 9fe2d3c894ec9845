/* SPDX-License-Identifier: MIT */
#include "hid/bridge_port.h"

#include "hid/mcp2210.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

enum { PIN_DC, PIN_RESET, PIN_BACKLIGHT, PIN_SELECT, PINS };

struct bridge_pin {
    struct bridge_port *owner;
    unsigned index;
};

struct bridge_port {
    struct port *port;
    struct bridge_link link;
    bool open;                    /* the link, and the bridge is set up */
    struct mcp2210_config config; /* with the levels that the pins have now, for the next time it is opened */
    struct bridge_pin pins[PINS];
    struct mcp2210 bridge;
};

/* The reason is the bridge's, or if it has none the link's. An error of the link closes it, which makes the next call
 * open it again. */
static int settle_error(struct bridge_port *self, int err)
{
    if (!err) return 0;
    const bool is_links = !self->bridge.why[0];
    snprintf(self->port->error, sizeof self->port->error, "%s: %s", self->link.name(self->link.ctx),
             is_links ? self->link.why(self->link.ctx) : self->bridge.why);
    if (is_links || !self->open) {
        self->link.close(self->link.ctx);
        self->open = false;
    }
    return err;
}

static int connect(struct bridge_port *self)
{
    struct reports reports;

    if (self->open) return 0;
    self->bridge.why[0] = '\0';
    int err = self->link.open(self->link.ctx, &reports);
    if (!err) err = mcp2210_begin(&self->bridge, &reports, &self->config);
    if (err) return settle_error(self, err);
    self->open = true;
    return 0;
}

static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    struct bridge_port *self = ctx;
    const int err = connect(self);
    return err ? err : settle_error(self, mcp2210_write(&self->bridge, data, n_b));
}

static int flush(void *ctx)
{
    struct bridge_port *self = ctx;
    const int err = connect(self);
    return err ? err : settle_error(self, mcp2210_flush(&self->bridge));
}

static int set(void *ctx, bool high)
{
    const struct bridge_pin *pin = ctx;
    struct bridge_port *self = pin->owner;
    const uint16_t bit = (uint16_t)(1u << pin->index);

    int err = connect(self);
    if (!err) err = settle_error(self, mcp2210_set(&self->bridge, pin->index, high));
    if (!err) self->config.levels = (uint16_t)(high ? self->config.levels | bit : self->config.levels & ~bit);
    return err;
}

static void close_port(struct port *port)
{
    struct bridge_port *self = port->ctx;

    self->link.close(self->link.ctx);
    if (self->link.release) self->link.release(self->link.ctx);
    free(self);
    *port = (struct port){0};
}

/* "GP3" is 3; anything else is no pin. */
static int pin_index(const char *name)
{
    const bool is_pin = name[0] == 'G' && name[1] == 'P' && name[2] >= '0' && name[2] < '0' + MCP2210_PINS && !name[3];
    return is_pin ? name[2] - '0' : -1;
}

static int parse_pin(struct port *port, const char *name, uint16_t *mask, uint16_t taken, unsigned *index)
{
    const int pin = pin_index(name);
    if (pin < 0) {
        snprintf(port->error, sizeof port->error, "%.32s: no such pin; a bridge has GP0 to GP%d", name,
                 MCP2210_PINS - 1);
        return -EINVAL;
    }
    if ((taken >> pin & 1) != 0) {
        snprintf(port->error, sizeof port->error, "%s: named twice; each signal needs a pin of its own", name);
        return -EINVAL;
    }
    *mask = (uint16_t)(*mask | 1u << pin);
    *index = (unsigned)pin;
    return 0;
}

/* All are low from the start, but for reset: the backlight stays dark until the panel is lit. */
static int parse_pins(struct port *port, struct bridge_port *self, const struct bridge_options *options)
{
    const char *const names[PINS] = {[PIN_DC] = options->dc,
                                     [PIN_RESET] = options->reset,
                                     [PIN_BACKLIGHT] = options->backlight,
                                     [PIN_SELECT] = options->select};
    struct pin *const outputs[PINS] = {[PIN_DC] = &port->dc,
                                       [PIN_RESET] = &port->reset,
                                       [PIN_BACKLIGHT] = &port->backlight,
                                       [PIN_SELECT] = &port->select};
    struct mcp2210_config *config = &self->config;
    unsigned index;

    for (unsigned i = 0; i < PINS; i++) {
        self->pins[i].owner = self;
        if (!names[i]) continue;
        const int err = parse_pin(port, names[i], &config->outputs, config->outputs, &self->pins[i].index);
        if (err) return err;
        if (i == PIN_RESET) config->levels = (uint16_t)(config->levels | 1u << self->pins[i].index);
        *outputs[i] = (struct pin){.ctx = &self->pins[i], .set = set};
    }
    if (!options->chip_select) return 0;
    return parse_pin(port, options->chip_select, &config->selects, config->outputs, &index);
}

int bridge_port_open(struct port *port, const struct bridge_link *link, const struct bridge_options *options)
{
    struct bridge_port *self = calloc(1, sizeof *self);
    int err = -ENOMEM;

    *port = (struct port){.error = "MCP2210: out of memory", .ctx = self, .clock = link->clock};
    if (self) {
        self->port = port;
        self->link = *link;
        self->config.bit_rate_hz = options->bit_rate_hz ? options->bit_rate_hz : MCP2210_RATE_MAX_HZ;
        self->config.mode = options->mode;
        port->bus = (struct bus){.ctx = self, .write = write_bytes, .flush = flush};
        port->close = close_port;
        err = parse_pins(port, self, options);
    }
    if (!err) err = connect(self);
    if (!err) return 0;
    link->close(link->ctx);
    if (link->release) link->release(link->ctx);
    free(self);
    port->close = NULL;
    return err;
}
