/* SPDX-License-Identifier: MIT
 *
 * A growing list, and the two files of hashes.h. */
#include "pictures/hash_list.h"

#include "base/grow.h"
#include "base/inputs.h"
#include "pictures/hashes.h"

#include <stdlib.h>

bool hash_list_parse(struct hash_list *list, struct arguments *arguments, struct error *err)
{
    return arguments_value(arguments, "--check", &list->check_path, err) &&
           arguments_value(arguments, "--check-loop", &list->loop_path, err) &&
           arguments_value(arguments, "--write-hashes", &list->write_path, err);
}

bool hash_list_open(struct hash_list *list, struct outputs *outputs, struct error *err)
{
    if (!list->write_path) return true;
    if (list->check_path) inputs_note_name(list->check_path);
    if (list->loop_path) inputs_note_name(list->loop_path);
    list->file = outputs_open(outputs, list->write_path, err);
    return list->file != NULL;
}

void hash_list_add(struct hash_list *list, uint64_t hash)
{
    list->hashes = grow(list->hashes, list->count, &list->capacity, sizeof list->hashes[0]);
    list->hashes[list->count++] = hash;
}

bool hash_list_close(struct hash_list *list, struct error *err)
{
    FILE *file = list->file;
    if (!file) return true;
    list->file = NULL;
    const bool written = hashes_write(list->hashes, list->count, file);
    return outputs_close(file, list->write_path, err) && written; /* what was not written is an error there */
}

bool hash_list_check(const struct hash_list *list, struct error *err)
{
    if (list->check_path && !hashes_check(list->hashes, list->count, list->check_path, err)) return false;
    return !list->loop_path || hashes_check_loop(list->hashes, list->count, list->loop_path, err);
}

void hash_list_free(struct hash_list *list)
{
    if (list->file) fclose(list->file);
    free(list->hashes);
}
