/* SPDX-License-Identifier: MIT
 *
 * libgpiod 1.6 for the fake machine: a chip is a struct fake_chip, a line a struct fake_line. */
#include "fake_linux.h"

#if LIM_GPIOD == 1

#include <errno.h>
#include <gpiod.h>

static struct fake_chip *chip_of(struct gpiod_chip *chip)
{
    return (struct fake_chip *)(void *)chip;
}

static struct fake_line *line_of(struct gpiod_line *line)
{
    return (struct fake_line *)(void *)line;
}

struct gpiod_chip *gpiod_chip_open(const char *path)
{
    return (struct gpiod_chip *)(void *)fake_chip_open(path);
}

void gpiod_chip_close(struct gpiod_chip *chip)
{
    (void)chip;
    fake_chip_close();
}

const char *gpiod_chip_name(struct gpiod_chip *chip)
{
    return chip_of(chip)->name;
}

const char *gpiod_chip_label(struct gpiod_chip *chip)
{
    return chip_of(chip)->label;
}

unsigned int gpiod_chip_num_lines(struct gpiod_chip *chip)
{
    return chip_of(chip)->n_lines;
}

struct gpiod_line *gpiod_chip_get_line(struct gpiod_chip *chip, unsigned int offset)
{
    if (fake_fails("get_line")) return NULL;
    errno = EINVAL;
    if (offset >= chip_of(chip)->n_lines) return NULL;
    return (struct gpiod_line *)(void *)&chip_of(chip)->lines[offset];
}

const char *gpiod_line_name(struct gpiod_line *line)
{
    return line_of(line)->name;
}

const char *gpiod_line_consumer(struct gpiod_line *line)
{
    return line_of(line)->consumer;
}

bool gpiod_line_is_used(struct gpiod_line *line)
{
    return line_of(line)->is_used || line_of(line)->held;
}

int gpiod_line_request_output(struct gpiod_line *line, const char *consumer, int value)
{
    (void)consumer;
    return fake_line_request(line_of(line), true, value != 0);
}

int gpiod_line_request_rising_edge_events(struct gpiod_line *line, const char *consumer)
{
    (void)consumer;
    return fake_line_request(line_of(line), false, false);
}

void gpiod_line_release(struct gpiod_line *line)
{
    fake_line_release(line_of(line));
}

int gpiod_line_set_value(struct gpiod_line *line, int value)
{
    return fake_line_set(line_of(line), value != 0);
}

int gpiod_line_event_wait(struct gpiod_line *line, const struct timespec *timeout)
{
    return fake_line_wait(line_of(line), (uint64_t)timeout->tv_sec * 1000000000u + (uint64_t)timeout->tv_nsec);
}

int gpiod_line_event_read(struct gpiod_line *line, struct gpiod_line_event *event)
{
    if (fake_fails("event_read")) return -1;
    *event = (struct gpiod_line_event){0};
    line_of(line)->rises--;
    return 0;
}

#endif
