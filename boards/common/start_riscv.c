/* SPDX-License-Identifier: MIT
 *
 * Start-up of a bare image for RISC-V in machine mode: trap vector, stack, memory, main(). Any trap
 * is the program's end. */
#include "bare_image.h"

void riscv_reset(void);
void riscv_start(void);

/* Direct mode takes a trap vector at a multiple of four. */
__attribute__((aligned(4))) static void trap(void)
{
    image_fault();
}

__attribute__((used)) void riscv_start(void)
{
    __asm__ volatile(".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "csrw mtvec, %0\n\t"
                     ".option pop" ::"r"(trap));
    image_memory_init();
    image_exit(main());
}

/* Where the processor begins: there is no stack yet. */
__attribute__((section(".vectors"), naked, used)) void riscv_reset(void)
{
    __asm__ volatile("la sp, image_stack_top\n\t"
                     "j riscv_start");
}
