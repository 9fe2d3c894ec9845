/* SPDX-License-Identifier: MIT
 *
 * Each line by its first letter. */
#include "glass/wire_log.h"

#include "base/hex.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { BATCH_B = 512 };

/* " XX XX ...", in batches, as a line may hold a frame. */
static bool take_bytes(struct listener *listener, const char *text, struct error *err)
{
    uint8_t bytes[BATCH_B];
    size_t n_b = 0;
    for (; *text; text += 3) {
        const int high = text[0] == ' ' ? hex_digit(text[1]) : -1, low = high >= 0 ? hex_digit(text[2]) : -1;
        if (low < 0) return error_set(err, "'%.8s' is no byte of two hexadecimal digits", text);
        bytes[n_b++] = (uint8_t)(high << 4 | low);
        if (n_b < BATCH_B) continue;
        listener_bytes(listener, bytes, n_b);
        n_b = 0;
    }
    if (n_b) listener_bytes(listener, bytes, n_b);
    return true;
}

/* " NAME 0|1" */
static bool take_level(struct listener *listener, const char *text, struct error *err)
{
    const char *name = text + 1;
    const size_t length = text[0] == ' ' ? strcspn(name, " ") : 0;
    enum listener_pin pin;
    if (!listener_find_pin(name, length, &pin, err)) return false;
    const char *level = name + length;
    if (strcmp(level, " 0") != 0 && strcmp(level, " 1") != 0)
        return error_set(err, "a level is 0 or 1, not '%.8s'", level);
    listener_level(listener, pin, level[1] == '1');
    return true;
}

/* " NANOSECONDS" */
static bool take_time(struct listener *listener, const char *text, struct error *err)
{
    char *end;
    errno = 0;
    const unsigned long long now_ns = strtoull(text, &end, 10);
    if (text[0] != ' ' || text[1] < '0' || text[1] > '9' || *end || errno)
        return error_set(err, "'%.24s' is no number of nanoseconds", text);
    return listener_time(listener, now_ns) || error_set(err, "time goes back to %llu ns", now_ns);
}

bool wire_log_take(struct listener *listener, const char *line, struct error *err)
{
    switch (line[0]) {
    case 'b':
        return take_bytes(listener, line + 1, err);
    case 'p':
        return take_level(listener, line + 1, err);
    case 't':
        return take_time(listener, line + 1, err);
    case '#':
    case '\0':
        return true;
    default:
        return error_set(err, "'%.24s' is no line of a wire log", line);
    }
}
