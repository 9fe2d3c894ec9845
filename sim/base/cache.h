/* SPDX-License-Identifier: MIT
 *
 * What took long, for the next time: bytes by a key, in files of $LIMNER_CACHE, $XDG_CACHE_HOME/limner
 * or ~/.cache/limner. Nothing depends on it: where there is no such folder, nothing is kept; what is damaged, or of
 * another program, is not there.
 */
#ifndef SIM_CACHE_H
#define SIM_CACHE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { CACHE_KEY_B = 32, CACHE_MOST_B = 256 << 20, CACHE_ENTRY_MOST_B = CACHE_MOST_B / 8 };

/* From now on entries are found and kept. Before, as in tests, none are. The folder's parent must be there. */
void cache_begin(void);

/* Whether it has begun, and has a folder. */
bool cache_is_open(void);

/* A digest of bytes and of this program: another build has other keys. */
void cache_key(uint8_t key[CACHE_KEY_B], const uint8_t *bytes, size_t n_b);

/* The entry, the caller's to free, or NULL. It counts as used now. */
uint8_t *cache_find(const uint8_t key[CACHE_KEY_B], size_t *n_b);

/* Keeps it, if it is not too large; of all entries those used longest ago go, until the folder holds CACHE_MOST_B at
 * most. What fails, fails silently. */
void cache_keep(const uint8_t key[CACHE_KEY_B], const uint8_t *bytes, size_t n_b);

#endif
