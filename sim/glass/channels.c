/* SPDX-License-Identifier: MIT
 *
 * A name is looked for as it is written, then in capitals or not; with all scopes, or without any. */
#include "glass/channels.h"

#include "base/grow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { NAMES_MAX = 16, LISTED_MAX = 16 };

const char *const capture_wire_names[CAPTURE_WIRES] = {"dc",    "sck",    "mosi",      "cs",
                                                       "reset", "select", "backlight", "led"};

/* What modules, boards and analysers call them. LED is the board's light: a display's is called BL. */
static const char *const USUAL[CAPTURE_WIRES][NAMES_MAX] = {
    {"DC", "D/C", "D_C", "DCX", "D/CX", "RS", "A0"},
    {"SCK", "SCLK", "CLK", "SCL", "CLOCK", "SPI_SCK", "SPI_CLK"},
    {"MOSI", "SDA", "DIN", "SDI", "SI", "COPI", "DATA", "SPI_MOSI"},
    {"CS", "CE", "SS", "CSX", "NSS", "NCS", "CSN", "CS#", "/CS", "SCE", "CE0"},
    {"RST", "RES", "RESET", "RESX", "NRST", "RSTN", "RST#", "/RST"},
    {"SCS", "SELECT"},
    {"BL", "BLK", "BACKLIGHT", "LEDA"},
    {"LED"},
};

void channels_add(struct channels *channels, struct channel channel)
{
    channels->items = grow(channels->items, channels->count, &channels->capacity, sizeof channel);
    channels->items[channels->count++] = channel;
}

void channels_free(struct channels *channels)
{
    for (size_t i = 0; i < channels->count; i++) {
        free(channels->items[i].path);
        free(channels->items[i].id);
    }
    free(channels->items);
    *channels = (struct channels){.items = NULL};
}

/* --wires ------------------------------------------------------------------------------------ */

static bool take_name(struct wire_names *names, char *item, struct error *err)
{
    char *const value = strchr(item, '=');
    if (!value || value == item || !value[1])
        return error_set(err, "--wires: '%s' is not WIRE=CHANNEL, as dc=D0,sck=D1,mosi=D2,cs=D3", item);
    *value = '\0';
    for (int wire = 0; wire < CAPTURE_WIRES; wire++) {
        if (strcasecmp(item, capture_wire_names[wire]) != 0) continue;
        if (names->of[wire])
            return error_set(err, "--wires: %s is given twice: %s, %s", item, names->of[wire], value + 1);
        names->of[wire] = value + 1;
        return true;
    }
    return error_set(err, "--wires: '%s' is no wire: dc, sck, mosi, cs, reset, select, backlight or led", item);
}

bool wire_names_parse(struct wire_names *names, const char *text, struct error *err)
{
    char *rest = NULL;
    *names = (struct wire_names){.text = text ? strdup(text) : NULL};
    if (!text) return true;
    if (!names->text) return error_set(err, "--wires: out of memory");
    for (char *item = strtok_r(names->text, ",", &rest); item; item = strtok_r(NULL, ",", &rest))
        if (!take_name(names, item, err)) return false;
    return true;
}

void wire_names_free(struct wire_names *names)
{
    free(names->text);
    names->text = NULL;
}

/* Finding ------------------------------------------------------------------------------------ */

static bool is_same(const char *a, const char *b, size_t length, bool exactly)
{
    return strlen(a) == length && (exactly ? strncmp(a, b, length) : strncasecmp(a, b, length)) == 0;
}

/* Of several bits `name[index]` is one. */
static bool is_bit(const struct channel *channel, const char *name, size_t length, unsigned *bit)
{
    int index = 0, end = 0;
    *bit = 0;
    if (!name[length]) return channel->bits == 1;
    if (sscanf(name + length, "[%d]%n", &index, &end) != 1 || name[length + (size_t)end]) return false;
    const int at = channel->counts_down ? channel->first_bit_index - index : index - channel->first_bit_index;
    *bit = (unsigned)at;
    return channel->bits > 1 && at >= 0 && (unsigned)at < channel->bits;
}

static const char *leaf_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot && dot[1] ? dot + 1 : path;
}

static bool is_called(const struct channel *channel, const char *name, bool exactly, unsigned *bit)
{
    const size_t whole = strlen(name), base = strcspn(name, "[");
    const char *const paths[] = {channel->path, leaf_of(channel->path)};
    for (int i = 0; i < 2; i++) {
        if (is_same(paths[i], name, whole, exactly) && is_bit(channel, name, whole, bit)) return true;
        if (base < whole && is_same(paths[i], name, base, exactly) && is_bit(channel, name, base, bit)) return true;
    }
    return false;
}

/* Scopes often have the same signal again: it is one if the file calls it by one name. */
static bool is_one(const struct channel_bit *a, const struct channel_bit *b)
{
    return a->bit == b->bit && strcmp(a->channel->id, b->channel->id) == 0;
}

static bool find(struct channel_bit *out, const struct channels *channels, const char *name, bool exactly,
                 struct error *err)
{
    for (size_t i = 0; i < channels->count; i++) {
        const struct channel *channel = &channels->items[i];
        struct channel_bit found = {channel, 0};
        if (!is_called(channel, name, exactly, &found.bit)) continue;
        if (out->channel && !is_one(out, &found))
            return error_set(err, "'%s' is %s as well as %s: say which by --wires", name, out->channel->path,
                             channel->path);
        *out = found;
    }
    return true;
}

static bool find_either(struct channel_bit *out, const struct channels *channels, const char *name, struct error *err)
{
    return find(out, channels, name, true, err) && (out->channel || find(out, channels, name, false, err));
}

/* For errors: the first of all names. */
static void list_channels(char *list, size_t size_b, const struct channels *channels)
{
    size_t length = 0;
    list[0] = '\0';
    for (size_t i = 0; i < channels->count && i < LISTED_MAX && length < size_b; i++)
        length += (size_t)snprintf(list + length, size_b - length, "%s%s", i ? ", " : "", channels->items[i].path);
    if (channels->count > LISTED_MAX && length < size_b) snprintf(list + length, size_b - length, " ...");
}

static bool find_wire(struct channel_bit *out, const struct wire_names *names, enum capture_wire wire,
                      const struct channels *channels, struct error *err)
{
    char list[200];
    const char *name = names->of[wire];
    *out = (struct channel_bit){NULL, 0};
    if (name && strcmp(name, "-") == 0) return true;
    for (int i = 0; !name && !out->channel && USUAL[wire][i]; i++)
        if (!find_either(out, channels, USUAL[wire][i], err)) return false;
    if (!name) return true;
    if (!find_either(out, channels, name, err)) return false;
    list_channels(list, sizeof list, channels);
    return out->channel ||
           error_set(err, "there is no channel '%s' for %s; there are: %s", name, capture_wire_names[wire], list);
}

static bool has_all(const struct channel_bit wires[CAPTURE_WIRES], const struct channels *channels, bool selects,
                    struct error *err)
{
    const enum capture_wire needed[] = {CAPTURE_SCK, CAPTURE_MOSI, selects ? CAPTURE_SELECT : CAPTURE_DC};
    char list[200];
    list_channels(list, sizeof list, channels);
    for (int i = 0; i < 3; i++)
        if (!wires[needed[i]].channel)
            return error_set(err, "no channel is %s: say which by --wires %s=CHANNEL; there are: %s",
                             capture_wire_names[needed[i]], capture_wire_names[needed[i]], list);
    return true;
}

/* A channel shows one wire. */
static bool are_apart(const struct channel_bit wires[CAPTURE_WIRES], struct error *err)
{
    for (int a = 0; a < CAPTURE_WIRES; a++)
        for (int b = 0; b < a; b++)
            if (wires[a].channel && wires[b].channel && is_one(&wires[a], &wires[b]))
                return error_set(err, "%s and %s are the same channel, %s", capture_wire_names[b],
                                 capture_wire_names[a], wires[a].channel->path);
    return true;
}

bool wires_find(struct channel_bit out[CAPTURE_WIRES], const struct wire_names *names, const struct channels *channels,
                bool selects, const char *path, struct error *err)
{
    for (int wire = 0; wire < CAPTURE_WIRES; wire++)
        if (!find_wire(&out[wire], names, (enum capture_wire)wire, channels, err)) return error_prefix(err, path);
    if (selects && !out[CAPTURE_SELECT].channel) out[CAPTURE_SELECT] = out[CAPTURE_CS];
    if (selects) out[CAPTURE_CS].channel = out[CAPTURE_DC].channel = out[CAPTURE_RESET].channel = NULL;
    if (!selects) out[CAPTURE_SELECT].channel = NULL;
    return (has_all(out, channels, selects, err) && are_apart(out, err)) || error_prefix(err, path);
}
