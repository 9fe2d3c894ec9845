/* SPDX-License-Identifier: MIT
 *
 * Start-up of a bare image for RISC-V in machine mode: trap vector, stack, memory, main(). Any trap
 * ends the run. */
#include "image.h"
#include "semihost.h"

void riscv_reset(void);
void riscv_start(void);

/* The two shifts around the break tell the emulator that this is semihosting; all three must be
 * uncompressed and in one page. RISC-V, "Semihosting" (riscv-non-isa), 2. */
void semihost(uint32_t operation, const void *argument)
{
    register uint32_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    __asm__ volatile(".option push\n\t"
                     ".option norvc\n\t"
                     ".balign 16\n\t"
                     "slli zero, zero, 0x1f\n\t"
                     "ebreak\n\t"
                     "srai zero, zero, 7\n\t"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
}

/* Direct mode takes a trap vector at a multiple of four. */
__attribute__((aligned(4))) static void trap(void)
{
    semihost_fault();
}

__attribute__((used)) void riscv_start(void)
{
    __asm__ volatile(".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "csrw mtvec, %0\n\t"
                     ".option pop" ::"r"(trap));
    image_memory_init();
    semihost_exit(main());
}

/* Where the processor begins: there is no stack yet. */
__attribute__((section(".vectors"), naked, used)) void riscv_reset(void)
{
    __asm__ volatile("la sp, image_stack_top\n\t"
                     "j riscv_start");
}
