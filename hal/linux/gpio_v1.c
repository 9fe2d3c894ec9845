/* SPDX-License-Identifier: MIT
 *
 * GPIO lines by libgpiod 1.6, as in Debian 12. A line belongs to its chip, and one request holds one line. */
#include "gpio_lines.h"

#if LIM_GPIOD == 1

#include <errno.h>
#include <gpiod.h>

int gpio_chip_open(struct gpio_chip *chip, const char *path)
{
    struct gpiod_chip *opened = gpiod_chip_open(path);
    if (!opened) return -errno;
    *chip = (struct gpio_chip){.handle = opened, .n_lines = gpiod_chip_num_lines(opened)};
    gpio_copy_name(chip->name, gpiod_chip_name(opened));
    gpio_copy_name(chip->label, gpiod_chip_label(opened));
    return 0;
}

void gpio_chip_close(struct gpio_chip *chip)
{
    if (chip->handle) gpiod_chip_close(chip->handle);
    chip->handle = NULL;
}

int gpio_chip_line(const struct gpio_chip *chip, unsigned offset, struct gpio_line_info *out)
{
    struct gpiod_line *line = gpiod_chip_get_line(chip->handle, offset);
    if (!line) return -errno;
    gpio_copy_name(out->name, gpiod_line_name(line));
    gpio_copy_name(out->consumer, gpiod_line_consumer(line));
    out->is_used = gpiod_line_is_used(line);
    return 0;
}

int gpio_line_request(struct gpio_line *line, enum gpio_use use, const char *consumer)
{
    struct gpiod_line *found = gpiod_chip_get_line(line->chip.handle, line->offset);
    if (!found) return -errno;
    const int code = gpio_code(use == GPIO_RISES ? gpiod_line_request_rising_edge_events(found, consumer)
                                                 : gpiod_line_request_output(found, consumer, use == GPIO_OUTPUT_HIGH));
    if (code) return code;
    line->handle = found;
    return 0;
}

void gpio_line_release(struct gpio_line *line)
{
    if (line->handle) gpiod_line_release(line->handle);
    gpio_chip_close(&line->chip);
    *line = (struct gpio_line){0};
}

int gpio_line_set(const struct gpio_line *line, bool high)
{
    return gpio_code(gpiod_line_set_value(line->handle, high));
}

int gpio_line_wait(const struct gpio_line *line, uint64_t timeout_ns)
{
    const struct timespec timeout = {(time_t)(timeout_ns / 1000000000u), (long)(timeout_ns % 1000000000u)};
    return gpio_code(gpiod_line_event_wait(line->handle, &timeout));
}

int gpio_line_forget(const struct gpio_line *line)
{
    struct gpiod_line_event event;
    return gpio_code(gpiod_line_event_read(line->handle, &event));
}

#endif
