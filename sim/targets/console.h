/* SPDX-License-Identifier: MIT
 *
 * What a program on an emulated target may call beside its own code. Semihosting implements
 * it (semihost.c), or start_avr.c, or under an operating system start_host.c. */
#ifndef TARGETS_CONSOLE_H
#define TARGETS_CONSOLE_H

#ifdef __cplusplus
extern "C" {
#endif

/* Prints on the console of the host that runs the emulator. */
void console_put(const char *text);

#ifdef __cplusplus
}
#endif

#endif
