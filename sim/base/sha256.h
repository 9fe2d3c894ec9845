/* SPDX-License-Identifier: MIT
 *
 * SHA-256 as FIPS 180-4 describes it. */
#ifndef SIM_SHA256_H
#define SIM_SHA256_H

#include <stddef.h>
#include <stdint.h>

enum { SHA256_B = 32 };

void sha256(uint8_t digest[SHA256_B], const uint8_t *bytes, size_t n_b);

#endif
