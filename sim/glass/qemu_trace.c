/* SPDX-License-Identifier: MIT
 *
 * A line of QEMU's, PID@TIME: before it with `-msg timestamp=on`:
 *     memory_region_ops_write cpu 0 mr 0x55d4 addr 0x4001300c value 0x2c size 1 name 'stm32f2xx-spi'
 * Addresses are absolute. Millions of them are read, and most concern a few registers. */
#include "glass/qemu_trace.h"

#include "base/hex.h"
#include "base/input_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MOST_B = 255, FILE_MOST_B = 1 << 20 };

/* The map ------------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    unsigned bits;
} IDIOMS[] = {[QEMU_BSRR] = {"bsrr", 16},
              [QEMU_CLEAR] = {"clear", 16},
              [QEMU_MASKED] = {"masked", 8},
              [QEMU_OUTPUT] = {"output", 32}};

static bool parse_address(const char *word, uint64_t *address, struct error *err)
{
    const char *digits = strncmp(word, "0x", 2) == 0 ? word + 2 : word;
    const char *end = hex_number(digits, address);
    return (end > digits && *end == '\0') || error_set(err, "'%s' is no hexadecimal address", word);
}

static bool parse_idiom(const char *word, enum qemu_idiom *idiom, struct error *err)
{
    for (int i = QEMU_BSRR; i <= QEMU_OUTPUT; i++) {
        *idiom = (enum qemu_idiom)i;
        if (strcmp(word, IDIOMS[i].name) == 0) return true;
    }
    return error_set(err, "'%s' is no idiom: bsrr, clear, masked or output", word);
}

static bool parse_pin(char *const words[5], struct qemu_register *out, struct error *err)
{
    char *end;
    if (!listener_find_pin(words[1], strlen(words[1]), &out->pin, err) || !parse_idiom(words[2], &out->idiom, err) ||
        !parse_address(words[3], &out->address, err))
        return false;
    const unsigned long bit = strtoul(words[4], &end, 10);
    if (*end || end == words[4] || bit >= IDIOMS[out->idiom].bits)
        return error_set(err, "'%s' is no bit: %s has 0..%u", words[4], words[2], IDIOMS[out->idiom].bits - 1);
    out->bit = (uint8_t)bit;
    return true;
}

static bool parse_register(char *const words[5], size_t count, struct qemu_register *out, struct error *err)
{
    if (count == 2 && strcmp(words[0], "spi") == 0) return parse_address(words[1], &out->address, err);
    if (count == 5 && strcmp(words[0], "pin") == 0) return parse_pin(words, out, err);
    return error_set(err, "neither `spi ADDRESS` nor `pin NAME IDIOM ADDRESS BIT`");
}

/* A line, which is cut into its words. */
static bool parse_line(struct qemu_map *map, char *line, struct error *err)
{
    char *words[6], *rest = NULL;
    size_t count = 0;
    line[strcspn(line, "#\n")] = '\0';
    for (char *word = strtok_r(line, " \t\r", &rest); word && count < 6; word = strtok_r(NULL, " \t\r", &rest))
        words[count++] = word;
    if (count == 0) return true;
    if (map->count == QEMU_TRACE_REGISTERS) return error_set(err, "more than %d registers", QEMU_TRACE_REGISTERS);
    struct qemu_register *out = &map->registers[map->count++];
    *out = (struct qemu_register){.idiom = QEMU_SPI};
    return parse_register(words, count, out, err);
}

static bool has_register(const struct qemu_map *map, bool is_spi, enum listener_pin pin)
{
    for (size_t i = 0; i < map->count; i++) {
        const struct qemu_register *at = &map->registers[i];
        if ((at->idiom == QEMU_SPI) == is_spi && (is_spi || at->pin == pin)) return true;
    }
    return false;
}

static bool read_lines(struct qemu_map *map, struct input_lines *lines, struct error *err)
{
    char where[300];
    const char *path = lines->path;
    while (input_line(lines, err)) {
        snprintf(where, sizeof where, "%.256s:%zu", path, lines->number);
        if (!parse_line(map, lines->line, err)) return error_prefix(err, where);
    }
    if (err->text[0]) return false;
    if (!has_register(map, true, LISTENER_DC)) return error_set(err, "%s: no line `spi ADDRESS`", path);
    return has_register(map, false, LISTENER_LED) ||
           error_set(err, "%s: no line `pin led IDIOM ADDRESS BIT`, which ends frames", path);
}

bool qemu_map_read(struct qemu_map *map, const char *path, struct error *err)
{
    struct input_lines lines = {.path = path, .line_most_b = LINE_MOST_B};
    map->count = 0;
    err->text[0] = '\0';
    lines.file = input_open(path, FILE_MOST_B, NULL, err);
    if (!lines.file) return false;
    const bool ok = read_lines(map, &lines, err);
    input_lines_free(&lines);
    fclose(lines.file);
    return ok;
}

/* The trace ---------------------------------------------------------------------------------- */

static const char EVENT[] = "memory_region_ops_write ";

/* Behind PID@TIME: where there is one. */
static const char *skip_stamp(const char *line)
{
    const size_t pid = strspn(line, "0123456789");
    if (pid == 0 || line[pid] != '@') return line;
    const size_t time = strspn(line + pid + 1, "0123456789.");
    return line[pid + 1 + time] == ':' ? line + pid + 2 + time : line;
}

bool qemu_trace_is(const char *line)
{
    return strncmp(skip_stamp(line), EVENT, sizeof EVENT - 1) == 0;
}

/* Behind the number that follows the label; NULL: there is none. */
static const char *find_number(const char *text, const char *label, uint64_t *number)
{
    const char *at = strstr(text, label);
    if (!at) return NULL;
    at += strlen(label);
    const char *end = hex_number(at, number);
    return end > at && *end == ' ' ? end : NULL;
}

/* What a value written to an address of the register's says of its wire, if anything. */
static bool tells_level(const struct qemu_register *at, uint64_t address, uint64_t value, bool *high)
{
    const bool lower = value >> at->bit & 1, upper = value >> (at->bit + 16) & 1;
    const bool is_here = address == at->address, is_masked = (address & ~UINT64_C(0x3FC)) == at->address;
    *high = lower;
    switch (at->idiom) {
    case QEMU_BSRR: /* if both are ones, set wins */
        return is_here && (lower || upper);
    case QEMU_CLEAR:
        *high = false;
        return is_here && lower;
    case QEMU_MASKED:
        return is_masked && (address >> 2 >> at->bit & 1);
    default:
        return is_here;
    }
}

bool qemu_trace_take(const struct qemu_map *map, struct listener *listener, const char *line, struct error *err)
{
    uint64_t address, value;
    const char *behind = find_number(line, " addr 0x", &address);
    if (!behind || !find_number(behind, " value 0x", &value))
        return error_set(err, "a trace without addr or value: '%.80s'", line);
    for (size_t i = 0; i < map->count; i++) {
        const struct qemu_register *at = &map->registers[i];
        const uint8_t byte = (uint8_t)value;
        bool high;
        if (at->idiom != QEMU_SPI) {
            if (tells_level(at, address, value, &high)) listener_level(listener, at->pin, high);
        } else if (address == at->address) {
            listener_bytes(listener, &byte, 1);
        }
    }
    return true;
}
