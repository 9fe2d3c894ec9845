/* SPDX-License-Identifier: MIT */
#include "hid/bridge_port.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PINS_MAX = 9 }; /* of all kinds */
enum { PIN_DC, PIN_RESET, PIN_BACKLIGHT, PIN_SELECT, PINS };

struct bridge_pin {
    struct bridge_port *owner;
    unsigned index;
};

struct bridge_port {
    struct port *port;
    struct bridge_link link;
    bool open;                   /* the link, and the bridge is set up */
    struct bridge_config config; /* with the levels that the pins have now, for the next time it is opened */
    struct bridge_pin pins[PINS];
    const struct bridge_kind *kind; /* NULL: never opened */
    uint8_t *state;                 /* the kind's, and behind it what was gathered */
    size_t waiting_b;
};

static void report(struct bridge_port *self, const char *reason)
{
    snprintf(self->port->error, sizeof self->port->error, "%s: %s", self->link.name(self->link.ctx), reason);
}

static void report_link(struct bridge_port *self)
{
    report(self, self->link.why(self->link.ctx));
    self->link.close(self->link.ctx);
    self->open = false;
}

/* The reason is the bridge's, or if it has none the link's. An error of the link closes it, which makes the next call
 * open it again. */
static int settle_error(struct bridge_port *self, int err)
{
    if (!err) return 0;
    const char *reason = self->kind ? self->kind->why(self->state) : "out of memory";
    if (!reason[0]) {
        report_link(self);
        return err;
    }
    report(self, reason);
    if (!self->open) self->link.close(self->link.ctx);
    return err;
}

static int begin(struct bridge_port *self, const struct reports *reports, const struct bridge_kind *kind)
{
    if (kind != self->kind) {
        free(self->state);
        self->kind = NULL;
        self->state = calloc(1, kind->state_b + kind->gathered_b);
        if (!self->state) return -ENOMEM;
        self->kind = kind;
    }
    self->waiting_b = 0;
    return kind->begin(self->state, reports, &self->config);
}

static int connect(struct bridge_port *self)
{
    const struct bridge_kind *kind;
    struct reports reports;

    if (self->open) return 0;
    int err = self->link.open(self->link.ctx, &reports, &kind);
    if (err) {
        report_link(self);
        return err;
    }
    err = begin(self, &reports, kind);
    self->open = !err;
    self->port->bus.message_b =
        (uint16_t)(2u * kind->transfer_b); /* a report to send it in, and one that says how long it is */
    return settle_error(self, err);
}

/* What fails is not sent again; where nothing waits, nothing is sent. */
static int send_waiting(struct bridge_port *self)
{
    const size_t n_b = self->waiting_b;

    self->waiting_b = 0;
    return settle_error(self, self->kind->send(self->state, self->state + self->kind->state_b, n_b));
}

/* Gathers, so that reports are full. */
static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    struct bridge_port *self = ctx;
    int err = connect(self);

    while (!err && n_b) {
        const size_t room_b = self->kind->gathered_b - self->waiting_b;
        const size_t part_b = n_b < room_b ? n_b : room_b;
        memcpy(self->state + self->kind->state_b + self->waiting_b, data, part_b);
        self->waiting_b += part_b;
        data += part_b;
        n_b -= part_b;
        if (self->waiting_b == self->kind->gathered_b) err = send_waiting(self);
    }
    return err;
}

static int flush(void *ctx)
{
    struct bridge_port *self = ctx;
    const int err = connect(self);

    return err ? err : send_waiting(self);
}

static int set(void *ctx, bool high)
{
    const struct bridge_pin *pin = ctx;
    struct bridge_port *self = pin->owner;
    const uint16_t bit = (uint16_t)(1u << pin->index);

    int err = connect(self);
    if (!err) err = send_waiting(self);
    if (!err) err = settle_error(self, self->kind->set(self->state, pin->index, high));
    if (!err) self->config.levels = (uint16_t)(high ? self->config.levels | bit : self->config.levels & ~bit);
    return err;
}

static void close_port(struct port *port)
{
    struct bridge_port *self = port->ctx;

    self->link.close(self->link.ctx);
    if (self->link.release) self->link.release(self->link.ctx);
    free(self->state);
    free(self);
    *port = (struct port){0};
}

/* "GP3" is 3; anything else is no pin. */
static int pin_index(const char *name)
{
    const bool is_pin = name[0] == 'G' && name[1] == 'P' && name[2] >= '0' && name[2] < '0' + PINS_MAX && !name[3];
    return is_pin ? name[2] - '0' : -1;
}

static int parse_pin(struct port *port, const char *name, uint16_t *mask, uint16_t taken, unsigned *index)
{
    const int pin = pin_index(name);
    if (pin < 0) {
        snprintf(port->error, sizeof port->error, "%.32s: no such pin; bridges have GP0 to GP%d", name, PINS_MAX - 1);
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
    struct bridge_config *config = &self->config;
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

    *port = (struct port){.error = "USB-HID bridge: out of memory", .ctx = self, .clock = link->clock};
    if (self) {
        self->port = port;
        self->link = *link;
        self->config.bit_rate_hz = options->bit_rate_hz ? options->bit_rate_hz : UINT32_MAX;
        self->config.mode = options->mode;
        port->spi_mode = options->mode;
        port->bus = (struct bus){.ctx = self, .write = write_bytes, .flush = flush};
        port->close = close_port;
        err = parse_pins(port, self, options);
    }
    if (!err) err = connect(self);
    if (!err) return 0;
    link->close(link->ctx);
    if (link->release) link->release(link->ctx);
    if (self) free(self->state);
    free(self);
    port->close = NULL;
    return err;
}
