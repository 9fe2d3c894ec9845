/* SPDX-License-Identifier: MIT
 *
 * A decorator between a driver and any port: its n-th call fails, at once or after it has taken effect. */
#ifndef TESTS_FAULT_PORT_H
#define TESTS_FAULT_PORT_H

#include "bus.h"

struct fault_port;

struct fault_pin {
    struct fault_port *port;
    struct pin inner;
};

struct fault_port {
    /* The port behind. */
    struct bus bus;
    struct fault_pin dc, reset, backlight;
    struct clock clock;
    size_t *pending_b; /* of a bus that reads late: one that fails at once loses the transfer under way as well */

    long calls;      /* so far */
    long fail_at;    /* index of the call that fails; -1: none */
    long calls_late; /* calls that came after the failed one, before it was cleared */
    long pin_sets;   /* calls that set a pin */
    bool late;       /* the call that fails takes effect all the same */
    bool failed;
    int code; /* that it returns */
};

/* A fault is forgotten, and call number fail_at will be the next one. */
void fault_port_arm(struct fault_port *port, long fail_at);

/* What the driver gets. */
struct bus fault_port_bus(struct fault_port *port);
struct pin fault_port_pin(struct fault_port *port, struct fault_pin *pin);
struct clock fault_port_clock(struct fault_port *port);

#endif
