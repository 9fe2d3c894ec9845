/* SPDX-License-Identifier: MIT
 *
 * Semihosting: how a program without an operating system prints and ends inside of an emulator, with console.h and
 * boards/common/bare_image.h in front of it.
 * Arm, "Semihosting for AArch32 and AArch64"; RISC-V took over the operations and structures. */
#ifndef TARGETS_SEMIHOST_H
#define TARGETS_SEMIHOST_H

#include <stdint.h>

enum { SEMIHOST_WRITE0 = 0x04, SEMIHOST_EXIT_EXTENDED = 0x20, SEMIHOST_APPLICATION_EXIT = 0x20026 };

/* The trap. */
void semihost(uint32_t operation, const void *argument);

#endif
