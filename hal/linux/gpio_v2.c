/* SPDX-License-Identifier: MIT
 *
 * GPIO lines by libgpiod 2, as in Debian 13. What is asked for is put together from three objects, and what is got is a
 * request of its own that holds one line. */
#include "gpio_lines.h"

#if LIM_GPIOD == 2

#include <errno.h>
#include <gpiod.h>

enum { EVENTS_AT_ONCE = 16 }; /* as many as the kernel keeps for a line */

int gpio_chip_open(struct gpio_chip *chip, const char *path)
{
    struct gpiod_chip *opened = gpiod_chip_open(path);
    if (!opened) return -errno;
    struct gpiod_chip_info *info = gpiod_chip_get_info(opened);
    if (!info) {
        const int code = -errno;
        gpiod_chip_close(opened);
        return code;
    }
    *chip = (struct gpio_chip){.handle = opened, .n_lines = (unsigned)gpiod_chip_info_get_num_lines(info)};
    gpio_copy_name(chip->name, gpiod_chip_info_get_name(info));
    gpio_copy_name(chip->label, gpiod_chip_info_get_label(info));
    gpiod_chip_info_free(info);
    return 0;
}

void gpio_chip_close(struct gpio_chip *chip)
{
    if (chip->handle) gpiod_chip_close(chip->handle);
    chip->handle = NULL;
}

int gpio_chip_line(const struct gpio_chip *chip, unsigned offset, struct gpio_line_info *out)
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip->handle, offset);
    if (!info) return -errno;
    gpio_copy_name(out->name, gpiod_line_info_get_name(info));
    gpio_copy_name(out->consumer, gpiod_line_info_get_consumer(info));
    out->is_used = gpiod_line_info_is_used(info);
    gpiod_line_info_free(info);
    return 0;
}

/* What a request is put together from; any of them NULL: out of memory. */
struct wish {
    struct gpiod_line_settings *settings;
    struct gpiod_line_config *lines;
    struct gpiod_request_config *request;
};

static int wish_fill(const struct wish *wish, unsigned offset, enum gpio_use use, const char *consumer)
{
    if (!wish->settings || !wish->lines || !wish->request) return -ENOMEM;
    int code = gpio_code(gpiod_line_settings_set_direction(
        wish->settings, use == GPIO_RISES ? GPIOD_LINE_DIRECTION_INPUT : GPIOD_LINE_DIRECTION_OUTPUT));
    if (!code && use == GPIO_RISES)
        code = gpio_code(gpiod_line_settings_set_edge_detection(wish->settings, GPIOD_LINE_EDGE_RISING));
    if (!code && use == GPIO_OUTPUT_HIGH)
        code = gpio_code(gpiod_line_settings_set_output_value(wish->settings, GPIOD_LINE_VALUE_ACTIVE));
    gpiod_request_config_set_consumer(wish->request, consumer);
    return code ? code : gpio_code(gpiod_line_config_add_line_settings(wish->lines, &offset, 1, wish->settings));
}

static void wish_free(struct wish *wish)
{
    if (wish->settings) gpiod_line_settings_free(wish->settings);
    if (wish->lines) gpiod_line_config_free(wish->lines);
    if (wish->request) gpiod_request_config_free(wish->request);
}

int gpio_line_request(struct gpio_line *line, enum gpio_use use, const char *consumer)
{
    struct wish wish = {gpiod_line_settings_new(), gpiod_line_config_new(), gpiod_request_config_new()};
    int code = wish_fill(&wish, line->offset, use, consumer);
    if (!code && use == GPIO_RISES) {
        line->events = gpiod_edge_event_buffer_new(EVENTS_AT_ONCE);
        if (!line->events) code = -ENOMEM;
    }
    if (!code) {
        line->handle = gpiod_chip_request_lines(line->chip.handle, wish.request, wish.lines);
        if (!line->handle) code = -errno;
    }
    wish_free(&wish);
    return code;
}

void gpio_line_release(struct gpio_line *line)
{
    if (line->handle) gpiod_line_request_release(line->handle);
    if (line->events) gpiod_edge_event_buffer_free(line->events);
    gpio_chip_close(&line->chip);
    *line = (struct gpio_line){0};
}

int gpio_line_set(const struct gpio_line *line, bool high)
{
    return gpio_code(gpiod_line_request_set_value(line->handle, line->offset,
                                                  high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE));
}

int gpio_line_wait(const struct gpio_line *line, uint64_t timeout_ns)
{
    return gpio_code(gpiod_line_request_wait_edge_events(line->handle, (int64_t)timeout_ns));
}

int gpio_line_forget(const struct gpio_line *line)
{
    const int n = gpio_code(gpiod_line_request_read_edge_events(line->handle, line->events, EVENTS_AT_ONCE));
    return n < 0 ? n : 0;
}

#endif
