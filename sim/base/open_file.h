/* SPDX-License-Identifier: MIT
 *
 * Files that are open already, by the names that Linux gives their numbers. */
#ifndef SIM_OPEN_FILE_H
#define SIM_OPEN_FILE_H

/* The number that a path names: /dev/stdin, /dev/stdout, /dev/stderr, /dev/fd/N or /proc/self/fd/N. -1: it names none.
 */
int open_file_number(const char *path);

/* Opens such a path anew. Without /proc there are no such paths, and the file is open all the same: it is duplicated
 * then. `flags` as of open(). Returns the descriptor, the caller's to close, or -1, with errno. */
int open_file_again(const char *path, int flags);

#endif
