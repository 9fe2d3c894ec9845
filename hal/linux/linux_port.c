/* SPDX-License-Identifier: MIT
 *
 * Joins spidev, lines and the clock behind struct port. In: names. Out: what a panel's driver takes. Memory: one
 * allocation, until the port is closed. */
#include "linux_port.h"

#include "fail.h"
#include "gpio_names.h"
#include "spidev.h"

#include <errno.h>
#include <linux/spi/spi.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum line_index { DC, RESET, BACKLIGHT, SELECT, LED, TEARING, LINE_COUNT };

/* A call of the kernel that sends a byte or sets a line takes some 20 us on small boards. */
enum { BEGINNINGS_PER_S = 50000 };

enum { REMEMBERED_MAX = 64 }; /* more rises than the kernel keeps for a line */

struct named_line {
    struct gpio_line line;
    const char *name;
    struct port *port;
};

struct linux_port {
    struct spidev spi;
    struct named_line lines[LINE_COUNT];
};

/* Time ------------------------------------------------------------------------------------------ */

static struct timespec time_after(uint32_t delay_us)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at); /* cannot fail for this clock */
    at.tv_nsec += (long)(delay_us % 1000000u) * 1000;
    at.tv_sec += (time_t)(delay_us / 1000000u) + at.tv_nsec / 1000000000;
    at.tv_nsec %= 1000000000;
    return at;
}

/* Until an instant, so that signals do not make it longer. */
static int delay(void *ctx, uint32_t delay_us)
{
    const struct timespec end = time_after(delay_us);
    int err_no;
    do
        err_no = clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &end, NULL);
    while (err_no == EINTR);
    return err_no ? linux_fail(ctx, err_no, "waiting %u us: %s", (unsigned)delay_us, strerror(err_no)) : 0;
}

static uint64_t left_ns(const struct timespec *end)
{
    const struct timespec now = time_after(0);
    const int64_t left = (int64_t)(end->tv_sec - now.tv_sec) * 1000000000 + (end->tv_nsec - now.tv_nsec);
    return left > 0 ? (uint64_t)left : 0;
}

/* Lines ----------------------------------------------------------------------------------------- */

static int set(void *ctx, bool high)
{
    struct named_line *line = ctx;
    const int err = gpio_line_set(&line->line, high);
    return err ? linux_fail(line->port, -err, "%s: cannot be set: %s", line->name, strerror(-err)) : 0;
}

static int cannot_wait(struct named_line *line, int err)
{
    return linux_fail(line->port, -err, "%s: cannot be waited for: %s", line->name, strerror(-err));
}

/* What rose earlier says nothing of now. */
static int forget_earlier(const struct gpio_line *line)
{
    for (int i = 0; i < REMEMBERED_MAX; i++) {
        int code = gpio_line_wait(line, 0);
        if (code > 0)
            code = gpio_line_forget(line);
        else
            return code == -EINTR ? 0 : code;
        if (code) return code;
    }
    return 0;
}

static int wait(void *ctx, uint32_t timeout_us)
{
    struct named_line *line = ctx;
    const struct timespec end = time_after(timeout_us);
    int code = forget_earlier(&line->line);
    if (code) return cannot_wait(line, code);
    do
        code = gpio_line_wait(&line->line, left_ns(&end));
    while (code == -EINTR);
    if (code < 0) return cannot_wait(line, code);
    return code;
}

static int take(struct linux_port *self, struct port *port, enum line_index index, const char *name, enum gpio_use use)
{
    struct named_line *line = &self->lines[index];
    if (!name) return 0;
    line->name = name;
    line->port = port;
    return gpio_take(&line->line, name, use, port);
}

static struct pin pin_of(struct linux_port *self, enum line_index index)
{
    struct named_line *line = &self->lines[index];
    return line->name ? (struct pin){.ctx = line, .set = set} : (struct pin){0};
}

/* The port -------------------------------------------------------------------------------------- */

static void release(struct linux_port *self)
{
    for (int i = 0; i < LINE_COUNT; i++)
        gpio_line_release(&self->lines[i].line);
    spidev_close(&self->spi);
    free(self);
}

static void close_port(struct port *port)
{
    release(port->ctx);
    port->ctx = NULL;
}

static int acquire(struct linux_port *self, struct port *port, const struct linux_port_config *config)
{
    const unsigned mode = config->mode | (config->no_cs ? SPI_NO_CS : 0u) | (config->cs_high ? SPI_CS_HIGH : 0u);
    const unsigned spare = (config->no_cs ? SPI_NO_CS : 0u) | (config->any_mode ? SPI_MODE_3 : 0u);
    int err = spidev_open(&self->spi, config->spi, (uint8_t)mode, (uint8_t)spare, config->speed_hz, port);
    if (!err) err = take(self, port, DC, config->dc, GPIO_OUTPUT_LOW);
    if (!err) err = take(self, port, RESET, config->reset, GPIO_OUTPUT_HIGH);
    if (!err) err = take(self, port, BACKLIGHT, config->backlight, GPIO_OUTPUT_LOW);
    if (!err) err = take(self, port, SELECT, config->select, GPIO_OUTPUT_LOW);
    if (!err) err = take(self, port, LED, config->led, GPIO_OUTPUT_LOW);
    if (!err) err = take(self, port, TEARING, config->tearing, GPIO_RISES);
    return err;
}

static void fill(struct port *port, struct linux_port *self)
{
    const uint32_t begin_b = self->spi.speed_hz / 8 / BEGINNINGS_PER_S;
    port->bus = (struct bus){
        .ctx = &self->spi, .write = spidev_write, .message_b = begin_b < UINT16_MAX ? (uint16_t)begin_b : UINT16_MAX};
    port->dc = pin_of(self, DC);
    port->reset = pin_of(self, RESET);
    port->backlight = pin_of(self, BACKLIGHT);
    port->select = pin_of(self, SELECT);
    port->led = pin_of(self, LED);
    if (self->lines[TEARING].name) port->tearing = (struct edge){.ctx = &self->lines[TEARING], .wait = wait};
    port->clock = (struct clock){.ctx = port, .delay = delay};
    port->spi_mode = self->spi.mode;
    port->ctx = self;
    port->close = close_port;
}

int linux_port_open(struct port *port, const struct linux_port_config *config)
{
    *port = (struct port){0};
    if (!config->spi || config->speed_hz == 0 || config->mode > 3)
        return linux_fail(port, EINVAL, "a port needs an SPI device, a clock rate and a mode of 0 to 3");
    struct linux_port *self = calloc(1, sizeof *self);
    if (!self) return linux_fail(port, ENOMEM, "%s: out of memory", config->spi);
    const int err = acquire(self, port, config);
    if (err)
        release(self);
    else
        fill(port, self);
    return err;
}
