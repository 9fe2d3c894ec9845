/* SPDX-License-Identifier: MIT
 *
 * The second stage of the RP2040's start: 256 bytes at the begin of flash, which the boot ROM enters only if the last
 * four are the checksum of the rest. Manual: RP2040 Datasheet, 2.8.1.3.1. */
#ifndef SIM_BOOT2_H
#define SIM_BOOT2_H

#include <stddef.h>
#include <stdint.h>

enum { BOOT2_B = 256, BOOT2_CODE_B = 252 };

/* CRC-32 of the polynomial 0x04C11DB7, most significant bit first, from all ones, not inverted. */
uint32_t boot2_checksum(const uint8_t *bytes, size_t size_b);

/* Code of at most BOOT2_CODE_B, filled up with zeros, and its checksum, least significant byte first. */
void boot2_seal(uint8_t sealed[BOOT2_B], const uint8_t *code, size_t code_b);

#endif
