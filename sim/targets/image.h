/* SPDX-License-Identifier: MIT
 *
 * The memory of a bare image: its regions by the linker script's names (sections.ld), and what has to
 * be done before main(). */
#ifndef TARGETS_IMAGE_H
#define TARGETS_IMAGE_H

#include <stdint.h>

extern uint32_t image_stack_top[];

/* Copies initial values to RAM and clears the rest. */
void image_memory_init(void);

int main(void);

#endif
