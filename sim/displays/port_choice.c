/* SPDX-License-Identifier: MIT */
#include "displays/port_choice.h"

#include "base/notice.h"
#include "displays/idle_port.h"
#include "hid/hid_port.h"

#include <string.h>

/* spidev and GPIO lines ------------------------------------------------------------------------- */

static bool linux_parse(struct linux_port_config *out, struct arguments *arguments, struct error *err)
{
    *out = (struct linux_port_config){0};
    if (!arguments_value(arguments, "--spi", &out->spi, err) || !arguments_value(arguments, "--dc", &out->dc, err) ||
        !arguments_value(arguments, "--reset", &out->reset, err) ||
        !arguments_value(arguments, "--backlight", &out->backlight, err) ||
        !arguments_value(arguments, "--select", &out->select, err) ||
        !arguments_value(arguments, "--te", &out->tearing, err))
        return false;
    out->no_cs = arguments_flag(arguments, "--no-cs");
    out->cs_high = arguments_flag(arguments, "--cs-high");
    return true;
}

static bool same_line(const char *a, const char *b)
{
    return a && b && strcmp(a, b) == 0;
}

static bool lines_check(const struct linux_port_config *config, struct error *err)
{
    const struct {
        const char *option, *line;
    } lines[] = {{"--dc", config->dc},
                 {"--reset", config->reset},
                 {"--backlight", config->backlight},
                 {"--select", config->select},
                 {"--te", config->tearing}};
    enum { COUNT = sizeof lines / sizeof lines[0] };
    for (size_t i = 0; i < COUNT; i++)
        for (size_t k = i + 1; k < COUNT; k++)
            if (same_line(lines[i].line, lines[k].line))
                return error_set(err, "%s, %s: both cannot be %s", lines[i].option, lines[k].option, lines[i].line);
    return true;
}

static bool linux_check(const struct linux_port_config *config, struct error *err)
{
    if (!lines_check(config, err)) return false;
    if (config->no_cs && config->cs_high) return error_set(err, "--no-cs, --cs-high: only one of them");
    return config->spi ||
           error_set(err,
                     "play: needs --spi DEVICE, as /dev/spidev0.0, or --hid; `limner devices` lists those there are");
}

static int linux_open(const struct port_choice *choice, const struct port_clock *clock, struct port *port)
{
    struct linux_port_config config = choice->linux_port;
    config.speed_hz = clock->speed_hz;
    config.mode = clock->mode;
    config.any_mode = clock->any_mode;
    return linux_port_open(port, &config);
}

/* USB-HID bridges ------------------------------------------------------------------------------- */

/* Serial numbers are digits, and scenes are not named so: --hid SCENE stays what it looks like. */
static bool is_serial(const char *word)
{
    return word[0] != '\0' && strspn(word, "0123456789") == strlen(word);
}

static bool hid_check(const struct port_choice *choice, struct error *err)
{
    const struct linux_port_config *config = &choice->linux_port;
    if (config->spi) return error_set(err, "--hid, --spi: only one of them");
    if (config->tearing) return error_set(err, "--te: a USB-HID bridge cannot wait for a line");
    if (config->no_cs || config->cs_high)
        return error_set(err, "--no-cs, --cs-high: of --spi; with --hid, chip select is low or, without --cs, none");
    return lines_check(config, err);
}

static int hid_open(const struct port_choice *choice, const struct port_clock *clock, struct port *port)
{
    const struct linux_port_config *config = &choice->linux_port;
    const struct bridge_options options = {.dc = config->dc,
                                           .reset = config->reset,
                                           .backlight = config->backlight,
                                           .select = config->select,
                                           .chip_select = choice->chip_select,
                                           .bit_rate_hz = clock->speed_hz,
                                           .mode = clock->mode};
    return hid_port_open(port, choice->serial, &options);
}

/* All kinds ------------------------------------------------------------------------------------- */

bool port_choice_parse(struct port_choice *out, struct arguments *arguments, struct error *err)
{
    *out = (struct port_choice){.kind = PORT_LINUX};
    if (arguments_optional(arguments, "--hid", is_serial, &out->serial)) out->kind = PORT_HID;
    if (!arguments_value(arguments, "--cs", &out->chip_select, err) || !linux_parse(&out->linux_port, arguments, err))
        return false;
    if (out->kind == PORT_HID) return hid_check(out, err);
    if (out->chip_select) return error_set(err, "--cs %s: of --hid; spidev's device has its own", out->chip_select);
    return linux_check(&out->linux_port, err);
}

struct port port_choice_stand_in(const struct port_choice *choice)
{
    const struct linux_port_config *config = &choice->linux_port;
    const struct pin open = {0};
    struct port port = idle_port();
    if (!config->dc) port.dc = open;
    if (!config->reset) port.reset = open;
    if (!config->backlight) port.backlight = open;
    if (!config->select) port.select = open;
    if (!config->tearing) port.tearing = (struct edge){0};
    return port;
}

bool port_choice_open(const struct port_choice *choice, const struct port_clock *clock, struct port *port,
                      struct error *err)
{
    const bool is_hid = choice->kind == PORT_HID;
    const int code = is_hid ? hid_open(choice, clock, port) : linux_open(choice, clock, port);
    if (code) return error_set(err, "%s", port->error);
    if (port->notice[0]) notice("%s", port->notice);
    return true;
}
