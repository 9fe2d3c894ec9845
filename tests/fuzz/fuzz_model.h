/* SPDX-License-Identifier: MIT
 *
 * What targets of models share. */
#ifndef TESTS_FUZZ_MODEL_H
#define TESTS_FUZZ_MODEL_H

#include <stddef.h>
#include <stdint.h>

/* Imports a file, without the importer's child process, and compiles it if it is small; the dice say how. NULL: every
 * promise was kept. */
const char *fuzz_model_read(const char *path, uint32_t dice);

/* A small map for the target `wad`; returns how many bytes it has. */
size_t fuzz_wad_seed(uint8_t *out, size_t most_b, const uint8_t dice[8]);

#endif
