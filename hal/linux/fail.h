/* SPDX-License-Identifier: MIT
 *
 * How a port on Linux fails: one line for people in port->error, and a negative errno for programs; and what it says
 * where it does not. */
#ifndef HAL_LINUX_FAIL_H
#define HAL_LINUX_FAIL_H

#include "port.h"

HAL_C_BEGIN

/* Sets the text, printf-style, and returns -err_no. */
int linux_fail(struct port *port, int err_no, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Adds a sentence to port->notice: what the port does otherwise than it was asked to. */
void linux_note(struct port *port, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* What can be done about a node of /dev that may not be opened: `group` owns it on most distributions. */
int linux_fail_denied(struct port *port, int err_no, const char *path, const char *group);

HAL_C_END

#endif
