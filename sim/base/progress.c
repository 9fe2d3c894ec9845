/* SPDX-License-Identifier: MIT */
#include "base/progress.h"

#include "base/printable.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { PERCENT = 100, EVERY_S = 10, TEXT_B = 1024 };

#define CLEAR_LINE "\r\x1B[K"

/* On a pipe: what is being done, and when that, or something before it, was told. */
static char doing[160];
static time_t told_s;

static time_t now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec;
}

/* 0: nothing is told on pipes. */
static time_t every_s(void)
{
    const char *text = getenv("LIMNER_PROGRESS");
    return text && *text ? (time_t)strtol(text, NULL, 10) : EVERY_S;
}

void progress_beat(void)
{
    if (!doing[0] || !told_s) return;
    const time_t now = now_s(), every = every_s();
    if (every <= 0 || now - told_s < every) return;
    told_s = now;
    fprintf(stderr, "limner: %s\n", doing);
}

/* The first stretch counts from where long work begins. */
static void take(const char *format, va_list arguments)
{
    vsnprintf(doing, sizeof doing, format, arguments);
    printable(doing);
    if (!told_s) told_s = now_s();
    progress_beat();
}

static void put(const char *format, va_list arguments)
{
    char text[TEXT_B];
    vsnprintf(text, sizeof text, format, arguments);
    fputs(printable(text), stderr);
}

void progress(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (isatty(STDERR_FILENO)) {
        fputs(CLEAR_LINE, stderr);
        put(format, arguments);
    } else {
        take(format, arguments);
    }
    va_end(arguments);
}

/* Whether the bar looks different after this step than after the last one. */
static bool bar_moves(size_t done, size_t all)
{
    return done == 0 || done * PERCENT / all != (done - 1) * PERCENT / all;
}

void progress_bar(size_t done, size_t all, const char *format, ...)
{
    static const char full[] = "====================", empty[] = "                    ";
    enum { WIDTH = sizeof full - 1 };
    if (!all || done > all || !bar_moves(done, all)) {
        progress_beat();
        return;
    }
    char text[sizeof doing - 16];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const int marks = (int)(done * WIDTH / all);
    if (isatty(STDERR_FILENO))
        progress("[%.*s%.*s] %3zu %% %s", marks, full, WIDTH - marks, empty, done * PERCENT / all, text);
    else
        progress("%zu %% %s", done * PERCENT / all, text);
}

void progress_end(void)
{
    doing[0] = '\0';
    if (isatty(STDERR_FILENO)) fputs(CLEAR_LINE, stderr);
}
