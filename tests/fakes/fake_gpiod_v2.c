/* SPDX-License-Identifier: MIT
 *
 * libgpiod 2 for the fake machine. A chip, its info, and a line's info are the fake's own structs, a request is its
 * line; what a request is put together from is remembered here, for one request at a time. */
#include "fake_linux.h"

#if LIM_GPIOD == 2

#include <errno.h>
#include <gpiod.h>

struct gpiod_line_settings {
    bool is_output, level, rises;
};

struct gpiod_line_config {
    struct gpiod_line_settings settings;
    unsigned int offset;
    size_t count;
};

static struct gpiod_line_settings settings;
static struct gpiod_line_config lines;

static struct fake_chip *chip_of(void *chip)
{
    return chip;
}

static struct fake_line *line_of(void *line)
{
    return line;
}

/* Something that has to be freed. */
static void *object(void *it, const char *name)
{
    if (fake_fails(name)) return NULL;
    fake.objects++;
    return it;
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

struct gpiod_chip_info *gpiod_chip_get_info(struct gpiod_chip *chip)
{
    return object(chip, "get_info");
}

void gpiod_chip_info_free(struct gpiod_chip_info *info)
{
    (void)info;
    fake.objects--;
}

const char *gpiod_chip_info_get_name(struct gpiod_chip_info *info)
{
    return chip_of(info)->name;
}

const char *gpiod_chip_info_get_label(struct gpiod_chip_info *info)
{
    return chip_of(info)->label;
}

size_t gpiod_chip_info_get_num_lines(struct gpiod_chip_info *info)
{
    return chip_of(info)->n_lines;
}

struct gpiod_line_info *gpiod_chip_get_line_info(struct gpiod_chip *chip, unsigned int offset)
{
    errno = EINVAL;
    return offset < chip_of(chip)->n_lines ? object(&chip_of(chip)->lines[offset], "get_line_info") : NULL;
}

void gpiod_line_info_free(struct gpiod_line_info *info)
{
    (void)info;
    fake.objects--;
}

const char *gpiod_line_info_get_name(struct gpiod_line_info *info)
{
    return line_of(info)->name;
}

const char *gpiod_line_info_get_consumer(struct gpiod_line_info *info)
{
    return line_of(info)->consumer;
}

bool gpiod_line_info_is_used(struct gpiod_line_info *info)
{
    return line_of(info)->is_used || line_of(info)->held;
}

struct gpiod_line_settings *gpiod_line_settings_new(void)
{
    settings = (struct gpiod_line_settings){0};
    return object(&settings, "settings_new");
}

void gpiod_line_settings_free(struct gpiod_line_settings *given)
{
    (void)given;
    fake.objects--;
}

int gpiod_line_settings_set_direction(struct gpiod_line_settings *given, enum gpiod_line_direction direction)
{
    if (fake_fails("set_direction")) return -1;
    given->is_output = direction == GPIOD_LINE_DIRECTION_OUTPUT;
    return 0;
}

int gpiod_line_settings_set_edge_detection(struct gpiod_line_settings *given, enum gpiod_line_edge edge)
{
    if (fake_fails("set_edge_detection")) return -1;
    given->rises = edge == GPIOD_LINE_EDGE_RISING;
    return 0;
}

int gpiod_line_settings_set_output_value(struct gpiod_line_settings *given, enum gpiod_line_value value)
{
    if (fake_fails("set_output_value")) return -1;
    given->level = value == GPIOD_LINE_VALUE_ACTIVE;
    return 0;
}

struct gpiod_line_config *gpiod_line_config_new(void)
{
    lines = (struct gpiod_line_config){.count = 0};
    return object(&lines, "line_config_new");
}

void gpiod_line_config_free(struct gpiod_line_config *config)
{
    (void)config;
    fake.objects--;
}

int gpiod_line_config_add_line_settings(struct gpiod_line_config *config, const unsigned int *offsets, size_t count,
                                        struct gpiod_line_settings *given)
{
    if (fake_fails("add_line_settings")) return -1;
    *config = (struct gpiod_line_config){*given, offsets[0], count};
    return 0;
}

struct gpiod_request_config *gpiod_request_config_new(void)
{
    static char config;
    return object(&config, "request_config_new");
}

void gpiod_request_config_free(struct gpiod_request_config *config)
{
    (void)config;
    fake.objects--;
}

void gpiod_request_config_set_consumer(struct gpiod_request_config *config, const char *consumer)
{
    (void)config, (void)consumer;
}

struct gpiod_line_request *gpiod_chip_request_lines(struct gpiod_chip *chip, struct gpiod_request_config *config,
                                                    struct gpiod_line_config *wanted)
{
    (void)config;
    errno = EINVAL;
    if (wanted->count != 1 || wanted->offset >= chip_of(chip)->n_lines) return NULL;
    if (wanted->settings.is_output == wanted->settings.rises) return NULL;
    struct fake_line *line = &chip_of(chip)->lines[wanted->offset];
    const int code = fake_line_request(line, wanted->settings.is_output, wanted->settings.level);
    return code ? NULL : (struct gpiod_line_request *)(void *)line;
}

void gpiod_line_request_release(struct gpiod_line_request *request)
{
    fake_line_release(line_of(request));
}

int gpiod_line_request_set_value(struct gpiod_line_request *request, unsigned int offset, enum gpiod_line_value value)
{
    (void)offset;
    return fake_line_set(line_of(request), value == GPIOD_LINE_VALUE_ACTIVE);
}

int gpiod_line_request_wait_edge_events(struct gpiod_line_request *request, int64_t timeout_ns)
{
    return fake_line_wait(line_of(request), (uint64_t)timeout_ns);
}

int gpiod_line_request_read_edge_events(struct gpiod_line_request *request, struct gpiod_edge_event_buffer *buffer,
                                        size_t max_events)
{
    (void)buffer;
    if (fake_fails("read_edge_events")) return -1;
    const unsigned rises = line_of(request)->rises;
    const unsigned n = rises < max_events ? rises : (unsigned)max_events;
    line_of(request)->rises -= n;
    return (int)n;
}

struct gpiod_edge_event_buffer *gpiod_edge_event_buffer_new(size_t capacity)
{
    static char buffer;
    (void)capacity;
    return object(&buffer, "edge_event_buffer_new");
}

void gpiod_edge_event_buffer_free(struct gpiod_edge_event_buffer *buffer)
{
    (void)buffer;
    fake.objects--;
}

#endif
