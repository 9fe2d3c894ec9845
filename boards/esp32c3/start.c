/* SPDX-License-Identifier: MIT
 *
 * Where the ROM jumps to when it has loaded the image: no interrupts, a trap vector, stack, memory, main(). An ESP32-C3
 * has vectored traps alone, at multiples of 256 bytes, of which the first entry is for exceptions: with interrupts off
 * none but these come. Any is the program's end. */
#include "bare_image.h"

void riscv_reset(void);
void riscv_start(void);

__attribute__((aligned(256))) static void trap(void)
{
    image_fault();
}

__attribute__((used)) void riscv_start(void)
{
    __asm__ volatile(".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "csrci mstatus, 8\n\t"
                     "csrw mtvec, %0\n\t"
                     ".option pop" ::"r"((uintptr_t)trap | 1u));
    image_memory_init();
    image_exit(main());
}

__attribute__((section(".vectors"), naked, used)) void riscv_reset(void)
{
    __asm__ volatile("la sp, image_stack_top\n\t"
                     "j riscv_start");
}
