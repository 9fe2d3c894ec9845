/* SPDX-License-Identifier: MIT
 *
 * Start-up of a bare image for Cortex-M: vector table, floating-point unit, memory, main().
 * Any exception is the program's end, and interrupts never come: a boot loader that jumps here, as the STM32's over
 * USB, may have left some of them on, and its own vector table in use. */
#include "bare_image.h"

typedef void arm_handler(void); /* of an exception */

arm_handler arm_reset;
arm_handler image_fault;

extern const uint32_t image_entry[]; /* the vector table, sections.ld */

/* Armv7-M Architecture Reference Manual, B3.2.5: VTOR. Where a Cortex-M0 has none, nothing is written. */
static inline void take_exceptions(void)
{
    __asm__ volatile("cpsid i" ::: "memory");
    *(volatile uint32_t *)0xE000ED08 = (uint32_t)image_entry;
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
    take_exceptions();
    enable_floating_point();
    image_memory_init();
    image_exit(main());
}

/* What the processor reads at reset: the stack pointer and the handlers of exceptions 1 to 15. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack_top;
    arm_handler *reset;
    arm_handler *faults[14];
} vectors = {
    image_stack_top,
    arm_reset,
    {image_fault, image_fault, image_fault, image_fault, image_fault, image_fault, image_fault, image_fault,
     image_fault, image_fault, image_fault, image_fault, image_fault, image_fault},
};
