/* SPDX-License-Identifier: MIT
 *
 * What the caller has opened. What cannot be written to standard output is an error, as with usual tools. */
#ifndef SIM_STREAMS_H
#define SIM_STREAMS_H

/* Before the first file is opened: a standard stream that the caller has closed must not become that file. Reading
 * from such a stream and writing to it fail. */
void streams_prepare(void);

/* Flushes standard output at a command's end. The exit status: the command's, or failure if what it has said was not
 * all written; then a line says so. */
int streams_end(int status);

/* The number that /dev/stdin, /dev/stdout, /dev/stderr, /dev/fd/N or /proc/self/fd/N names. -1: another path. */
int stream_number(const char *path);

/* Opens such a path anew. Without /proc there are no such paths, and the file is open all the same: it is duplicated
 * then. `flags` as of open(). Returns the descriptor, the caller's to close, or -1, with errno. */
int stream_open(const char *path, int flags);

#endif
