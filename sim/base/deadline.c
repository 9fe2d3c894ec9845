/* SPDX-License-Identifier: MIT
 *
 * The monotonic clock against the end of the time; both in seconds. */
#include "base/deadline.h"

#include "base/parse.h"
#include "base/progress.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { AFTER_B = 96 };

static double system_now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

static double (*clock_now_s)(void) = system_now_s;
static double limit_s, began_s, end_s = INFINITY;
static bool is_given; /* by the command line */

void deadline_set_clock(double (*now_s)(void))
{
    clock_now_s = now_s ? now_s : system_now_s;
}

void deadline_begin(double limit)
{
    limit_s = limit;
    began_s = limit > 0.0 ? clock_now_s() : 0.0;
    end_s = limit > 0.0 ? began_s + limit : INFINITY;
}

bool deadline_parse(const char *text, double *limit, struct error *err)
{
    const char *name = "--time-limit";
    *limit = DEADLINE_DEFAULT_S;
    is_given = text != NULL;
    if (!text) {
        name = "LIMNER_TIME_LIMIT";
        text = getenv(name);
    }
    if (!text || !*text) return true;
    if (!parse_number(name, text, limit, err)) return false;
    return (*limit >= 0.0 && isfinite(*limit)) || error_set(err, "%s %s: seconds, or 0 for no limit", name, text);
}

void deadline_only_if_given(void)
{
    if (!is_given) deadline_begin(0.0);
}

bool deadline_is_set(void)
{
    return !isinf(end_s);
}

static size_t cuts;

bool deadline_passed(void)
{
    progress_beat();
    const bool has_passed = !isinf(end_s) && clock_now_s() >= end_s;
    cuts += has_passed;
    return has_passed;
}

size_t deadline_cuts(void)
{
    return cuts;
}

/* A stretch may have had a part of the time only. */
static const char *after_what(char text[AFTER_B])
{
    const bool is_part = end_s < began_s + limit_s;
    snprintf(text, AFTER_B, "stopped after %.3g s (%s--time-limit %g)", clock_now_s() - began_s,
             is_part ? "its part of " : "", limit_s);
    return text;
}

bool deadline_check(struct error *err, const char *doing, ...)
{
    char text[sizeof err->text / 2];
    va_list arguments;
    if (!deadline_passed()) return true;
    va_start(arguments, doing);
    vsnprintf(text, sizeof text, doing, arguments);
    va_end(arguments);
    char after[AFTER_B];
    return error_set(err, "%s: %s", after_what(after), text);
}

struct deadline_end deadline_within(double seconds)
{
    const struct deadline_end outer = {end_s};
    if (seconds > 0.0) end_s = fmin(end_s, clock_now_s() + seconds);
    return outer;
}

struct deadline_end deadline_end(void)
{
    return (struct deadline_end){end_s};
}

struct deadline_end deadline_share(double share)
{
    const struct deadline_end outer = {end_s};
    if (isinf(end_s)) return outer;
    const double now_s = clock_now_s();
    if (now_s < end_s) end_s = now_s + share * (end_s - now_s);
    return outer;
}

void deadline_restore(struct deadline_end outer)
{
    end_s = outer.end_s;
}

/* What is too long for it is cut: there are a few stages, and a line each. */
static char kept_lines[4096];
static size_t kept_b;

static void keep(const char *format, va_list arguments)
{
    const size_t room_b = sizeof kept_lines - kept_b;
    const int n_b = vsnprintf(kept_lines + kept_b, room_b, format, arguments);
    if (n_b > 0) kept_b += (size_t)n_b < room_b ? (size_t)n_b : room_b - 1;
}

static void keep_text(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    keep(format, arguments);
    va_end(arguments);
}

void deadline_say(const char *kept, ...)
{
    va_list arguments;
    if (!deadline_passed()) return;
    char after[AFTER_B];
    keep_text("limner: %s: best so far: ", after_what(after));
    va_start(arguments, kept);
    keep(kept, arguments);
    va_end(arguments);
    keep_text("\n");
}

void deadline_tell(void)
{
    fputs(kept_lines, stderr);
}
