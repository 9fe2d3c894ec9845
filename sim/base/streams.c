/* SPDX-License-Identifier: MIT */
#include "base/streams.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* open() takes the lowest number that is free, and those below are in use. */
void streams_prepare(void)
{
    static const int wrong_ways[] = {O_WRONLY, O_RDONLY, O_RDONLY};
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; descriptor++)
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", wrong_ways[descriptor]) < 0) _exit(EXIT_FAILURE);
}

int streams_end(int status)
{
    const int failed_before = ferror(stdout);
    errno = 0;
    if (fflush(stdout) == 0 && !failed_before) return status;
    fprintf(stderr, "limner: standard output: %s\n", errno ? strerror(errno) : "cannot be written");
    return EXIT_FAILURE;
}

/* What follows a prefix; NULL: the path has another. */
static const char *behind(const char *path, const char *prefix)
{
    const size_t length = strlen(prefix);
    return strncmp(path, prefix, length) == 0 ? path + length : NULL;
}

int stream_number(const char *path)
{
    static const char *const names[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr"};
    for (int number = 0; number < 3; number++)
        if (strcmp(path, names[number]) == 0) return number;
    char *end;
    const char *digits = behind(path, "/dev/fd/");
    if (!digits) digits = behind(path, "/proc/self/fd/");
    if (!digits || *digits < '0' || *digits > '9') return -1;
    const long number = strtol(digits, &end, 10);
    return *end || number > INT_MAX ? -1 : (int)number;
}

int stream_open(const char *path, int flags)
{
    const int descriptor = open(path, flags | O_NOCTTY | O_CLOEXEC);
    const int number = descriptor < 0 && errno == ENOENT ? stream_number(path) : -1;
    if (number < 0) return descriptor;
    const int copy = fcntl(number, F_DUPFD_CLOEXEC, 0);
    if (copy < 0) errno = ENOENT;
    return copy;
}
