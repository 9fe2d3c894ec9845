/* SPDX-License-Identifier: MIT
 *
 * A run of a command that writes files, and what is left of runs that were killed. Each run has a word of its own, of
 * which temporary names are made, and a file .limner-WORD.run in the folder of its first output, locked as long as the
 * process lives. It lists what the run writes. Where it is there and nobody holds its lock, the run was killed: the
 * next one in that folder removes what it left, or puts the rest of a complete set in its place. Files without such a
 * list are nobody's business. */
#ifndef SIM_OUTPUT_RUN_H
#define SIM_OUTPUT_RUN_H

#include <stdbool.h>
#include <stddef.h>

struct output_run;

/* Cleans up in the folder of `path`, its first output, and begins one; NULL, with errno: it cannot have a word or
 * memory. Where no file can be made or locked, it has none, and what is left of it if it is killed stays. */
struct output_run *output_run_begin(const char *path);

/* Lists the next output, and returns its number: 0, 1, 2 ... */
size_t output_run_add(struct output_run *run, const char *path);

enum output_name {
    OUTPUT_PART, /* while it is being written */
    OUTPUT_OLD   /* of what was in its place, until all outputs are in theirs */
};

/* The temporary name beside `path`, the caller's to free; NULL, with errno. */
char *output_run_name(const struct output_run *run, const char *path, size_t number, enum output_name which);

/* All parts are complete, and what was in their places has its OUTPUT_OLD: if the run is killed from here on, the next
 * one puts the others in their places. */
void output_run_is_complete(struct output_run *run);

/* Nothing is left of it, or it has failed and says so itself. NULL: there is none. */
void output_run_end(struct output_run *run);

/* The folder of a path: up to its last slash, with it, or ".". The caller's to free; NULL, with errno. */
char *output_folder_of(const char *path);

/* Two runs into one folder take turns, so that files which belong together come from one run. A lock that is not to be
 * had within a second is done without: it is another program's. Returns -1, or what to close. */
int output_folder_lock(const char *folder);

#endif
