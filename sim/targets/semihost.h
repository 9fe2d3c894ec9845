/* SPDX-License-Identifier: MIT
 *
 * Semihosting: how a program without an operating system prints and ends inside of an emulator.
 * semihost() is the trap, which the start-up file of each architecture implements; the rest is shared.
 * Arm, "Semihosting for AArch32 and AArch64"; RISC-V took over the operations and structures. */
#ifndef TARGETS_SEMIHOST_H
#define TARGETS_SEMIHOST_H

#include <stdint.h>

enum { SEMIHOST_WRITE0 = 0x04, SEMIHOST_EXIT_EXTENDED = 0x20, SEMIHOST_APPLICATION_EXIT = 0x20026 };

/* Implemented by the start-up file of the architecture. */
void semihost(uint32_t operation, const void *argument);

/* Ends the emulation; status becomes that of the emulator. */
_Noreturn void semihost_exit(int status);

/* Says that the processor took an exception, and ends with status 2. */
_Noreturn void semihost_fault(void);

#endif
