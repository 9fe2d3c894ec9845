/* SPDX-License-Identifier: MIT
 *
 * Lines as people name them: by the line's own name, as GPIO25, or by its chip's label or name and its number there, as
 * pinctrl-bcm2711:25 and gpiochip0:25. Chips are numbered as they are found, so a number may change from one start to
 * the next; a label does not. */
#ifndef HAL_LINUX_GPIO_NAMES_H
#define HAL_LINUX_GPIO_NAMES_H

#include "gpio_lines.h"
#include "port.h"

HAL_C_BEGIN

/* Takes the line of that name into *line, which is all zero before, and after a failure. Refused, with a line in
 * port->error: a name that no line has, or more than one; a line that somebody else has. */
HAL_MUST_CHECK int gpio_take(struct gpio_line *line, const char *name, enum gpio_use use, struct port *port);

HAL_C_END

#endif
