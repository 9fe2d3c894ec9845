/* SPDX-License-Identifier: MIT
 *
 * The hashes of frames of which nobody knows the number beforehand, and what the command line wants done with them. */
#ifndef SIM_HASH_LIST_H
#define SIM_HASH_LIST_H

#include "base/arguments.h"
#include "outputs/outputs.h"

#include <stddef.h>
#include <stdint.h>

struct hash_list {
    const char *check_path, *loop_path, *write_path; /* NULL: not asked for */
    FILE *file;
    uint64_t *hashes;
    size_t count, capacity;
};

/* Takes --check, --check-loop and --write-hashes out of *arguments; *list must be zero. */
bool hash_list_parse(struct hash_list *list, struct arguments *arguments, struct error *err);

/* Begins the file that is to be written. */
bool hash_list_open(struct hash_list *list, struct outputs *outputs, struct error *err);

void hash_list_add(struct hash_list *list, uint64_t hash);

/* Writes the file. */
bool hash_list_close(struct hash_list *list, struct error *err);

/* Comes last: a frame that differs is worth looking at, so what was written stays. */
bool hash_list_check(const struct hash_list *list, struct error *err);

void hash_list_free(struct hash_list *list);

#endif
