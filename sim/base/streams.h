/* SPDX-License-Identifier: MIT
 *
 * Standard output as usual tools treat it: what cannot be written there is an error. */
#ifndef SIM_STREAMS_H
#define SIM_STREAMS_H

/* Before the first file is opened: a standard stream that the caller has closed must not become that file. Reading
 * from such a stream and writing to it fail. */
void streams_prepare(void);

/* Flushes standard output at a command's end. The exit status: the command's, or failure if what it has said was not
 * all written; then a line says so. */
int streams_end(int status);

#endif
