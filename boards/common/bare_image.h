/* SPDX-License-Identifier: MIT
 *
 * A bare image: its memory, whose regions the linker script names (sections.ld), and what the start-up code of an
 * architecture (start_*.c) leaves to the program. */
#ifndef BOARDS_BARE_IMAGE_H
#define BOARDS_BARE_IMAGE_H

#include <stdint.h>

extern uint32_t image_stack_top[];

/* Copies initial values to RAM and clears the rest. */
void image_memory_init(void);

/* The program's own: what is done, what comes after it, and what when the processor takes an exception. */
int main(void);
_Noreturn void image_exit(int status);
_Noreturn void image_fault(void);

#endif
