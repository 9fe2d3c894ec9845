/* SPDX-License-Identifier: MIT
 *
 * What a program on an emulated target may call beside its own code. The target's start-up file
 * implements it: start_arm.c, start_riscv.c, start_avr.c, or start_host.c under an operating system. */
#ifndef TARGETS_CONSOLE_H
#define TARGETS_CONSOLE_H

/* Prints on the console of the host that runs the emulator. */
void console_put(const char *text);

#endif
