/* SPDX-License-Identifier: MIT
 *
 * Start-up of a bare image for Cortex-M: vector table, floating-point unit, memory, main(). Any
 * exception ends the run. */
#include "image.h"
#include "semihost.h"

void arm_reset(void);

void semihost(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

/* The compiler may keep integers in the unit's registers. Armv7-M Architecture Reference Manual, B3.2.20:
 * CPACR, full access to coprocessors 10 and 11. */
static inline void enable_floating_point(void)
{
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xE000ED88 |= UINT32_C(0xF) << 20;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
}

void arm_reset(void)
{
    enable_floating_point();
    image_memory_init();
    semihost_exit(main());
}

/* What the processor reads at reset: the stack pointer and the handlers of exceptions 1 to 15.
 * Interrupts, whose handlers would follow, stay disabled. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack_top;
    void (*reset)(void);
    void (*faults[14])(void);
} vectors = {
    image_stack_top,
    arm_reset,
    {semihost_fault, semihost_fault, semihost_fault, semihost_fault, semihost_fault, semihost_fault, semihost_fault,
     semihost_fault, semihost_fault, semihost_fault, semihost_fault, semihost_fault, semihost_fault, semihost_fault},
};
