/* SPDX-License-Identifier: MIT */
#include "base/streams.h"

#include <errno.h>
#include <fcntl.h>
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
