/* SPDX-License-Identifier: MIT
 *
 * A decorator between a driver and any port: with its n-th call something goes wrong. */
#ifndef TESTS_FAULT_PORT_H
#define TESTS_FAULT_PORT_H

#include "port.h"

enum fault {
    FAULT_AT_ONCE, /* the call fails and does nothing; what was on its way is lost as well */
    FAULT_LATE,    /* it fails after it has taken effect */
    FAULT_SHORT,   /* a write fails after half of its bytes; other calls at once */
    FAULT_SLOW,    /* it succeeds, after FAULT_SLOW_US more than asked for */
    FAULTS
};

#define FAULT_SLOW_US UINT32_C(500000)

struct fault_port;

struct fault_pin {
    struct fault_port *port;
    struct pin inner;
};

struct fault_port {
    /* The port behind. */
    struct bus bus;
    struct fault_pin dc, reset, backlight, select;
    struct edge tearing;
    struct clock clock;
    size_t *pending_b; /* of a bus that reads late: one that fails at once loses the transfer under way; or NULL */

    enum fault fault;
    long calls;      /* so far */
    long fail_at;    /* index of the call that fails; -1: none */
    long calls_late; /* calls that came after the failed one, before it was cleared */
    long pin_sets;   /* calls that set a pin */
    bool failed;     /* it came to that call */
    int code;        /* that it returns: 0 if it is but slow */
};

/* Decorates what is wired of a port, which the decorator copies. */
struct port fault_port_over(struct fault_port *fault, const struct port *port, size_t *pending_b);

/* A fault is forgotten, and call number fail_at will be the next one, which fails at once unless `fault` is set. */
void fault_port_arm(struct fault_port *port, long fail_at);

/* What the driver gets. */
struct bus fault_port_bus(struct fault_port *port);
struct pin fault_port_pin(struct fault_port *port, struct fault_pin *pin);
struct edge fault_port_tearing(struct fault_port *port);
struct clock fault_port_clock(struct fault_port *port);

#endif
