/* SPDX-License-Identifier: MIT
 *
 * GPIO chips and their lines, by libgpiod of either generation: gpio_v1.c or gpio_v2.c, which share no call. Each line
 * is requested by itself: in the first generation a value set on one line of several requested together goes to the
 * first of them. What fails returns a negative errno. LIM_GPIOD is the generation, 1 or 2. */
#ifndef HAL_LINUX_GPIO_LINES_H
#define HAL_LINUX_GPIO_LINES_H

#include "bus.h"

#include <errno.h>
#include <stdio.h>

HAL_C_BEGIN

enum { GPIO_NAME_B = 32 }; /* of the kernel's names, with their end */

struct gpio_chip {
    void *handle;                               /* libgpiod's; NULL: not open */
    char name[GPIO_NAME_B], label[GPIO_NAME_B]; /* gpiochip0; pinctrl-bcm2711 */
    unsigned n_lines;
};

struct gpio_line_info {
    char name[GPIO_NAME_B];     /* "": it has none */
    char consumer[GPIO_NAME_B]; /* who has it; "": nobody, or somebody without a name */
    bool is_used;
};

enum gpio_use {
    GPIO_OUTPUT_LOW, /* at first */
    GPIO_OUTPUT_HIGH,
    GPIO_RISES /* an input whose rises are remembered, the last few of them */
};

/* A line that is held, and the chip that it is on. All zero: none. */
struct gpio_line {
    struct gpio_chip chip;
    unsigned offset;
    void *handle, *events; /* libgpiod's */
};

/* For the two files: what libgpiod's functions return, -1 with errno set, as a code; and its strings, perhaps NULL. */
static inline int gpio_code(int result)
{
    return result < 0 ? -errno : result;
}

static inline void gpio_copy_name(char to[GPIO_NAME_B], const char *from)
{
    snprintf(to, GPIO_NAME_B, "%s", from ? from : "");
}

/* `path` may be a link: the chip's name is the kernel's. */
HAL_MUST_CHECK int gpio_chip_open(struct gpio_chip *chip, const char *path);
void gpio_chip_close(struct gpio_chip *chip);

HAL_MUST_CHECK int gpio_chip_line(const struct gpio_chip *chip, unsigned offset, struct gpio_line_info *out);

/* Takes line->chip's line->offset; the chip stays open until the line is released. */
HAL_MUST_CHECK int gpio_line_request(struct gpio_line *line, enum gpio_use use, const char *consumer);

/* Closes the chip as well; also one whose line was not requested. */
void gpio_line_release(struct gpio_line *line);

HAL_MUST_CHECK int gpio_line_set(const struct gpio_line *line, bool high);

/* 1: a rise is remembered, or came in time; 0: none. -EINTR: a signal came first. */
HAL_MUST_CHECK int gpio_line_wait(const struct gpio_line *line, uint64_t timeout_ns);

/* Forgets a remembered rise, or several. */
HAL_MUST_CHECK int gpio_line_forget(const struct gpio_line *line);

HAL_C_END

#endif
