/* SPDX-License-Identifier: MIT
 *
 * Start-up of a bare test image for Cortex-M in QEMU: vector table, memory set-up, main(). Text and
 * exit status go to the host by semihosting. Any exception ends the run with status 2. */
#include "arm.h"

#include <stddef.h>
#include <stdint.h>

/* Semihosting operations; Arm, "Semihosting for AArch32 and AArch64". */
enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20, ADP_STOPPED_APPLICATION_EXIT = 0x20026 };

/* From the linker script. */
extern uint32_t arm_data_start[], arm_data_end[], arm_bss_start[], arm_bss_end[], arm_stack_top[];
extern const uint32_t arm_data_load[];

int main(void);
void arm_reset(void);
void *memcpy(void *restrict to, const void *restrict from, size_t size_b);
void *memset(void *to, int value, size_t size_b);

static void semihost(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void arm_put(const char *text)
{
    semihost(SYS_WRITE0, text);
}

static _Noreturn void leave(int status)
{
    const uint32_t reason_and_status[2] = {ADP_STOPPED_APPLICATION_EXIT, (uint32_t)status};
    semihost(SYS_EXIT_EXTENDED, reason_and_status);
    for (;;)
        ;
}

void arm_reset(void)
{
    const uint32_t *load = arm_data_load;
    for (uint32_t *word = arm_data_start; word < arm_data_end; word++)
        *word = *load++;
    for (uint32_t *word = arm_bss_start; word < arm_bss_end; word++)
        *word = 0;
    leave(main());
}

static void fault(void)
{
    arm_put("fault: the processor took an exception\n");
    leave(2);
}

/* What the processor reads at reset: the stack pointer and the handlers of exceptions 1 to 15.
 * Interrupts, whose handlers would follow, stay disabled. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack_top;
    void (*reset)(void);
    void (*faults[14])(void);
} vectors = {
    arm_stack_top,
    arm_reset,
    {fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault},
};

/* The compiler calls these two on its own account, and there is no C library in the image. The
 * loops must not become calls of what they implement: -fno-tree-loop-distribute-patterns. */
void *memcpy(void *restrict to, const void *restrict from, size_t size_b)
{
    for (size_t i = 0; i < size_b; i++)
        ((uint8_t *)to)[i] = ((const uint8_t *)from)[i];
    return to;
}

void *memset(void *to, int value, size_t size_b)
{
    for (size_t i = 0; i < size_b; i++)
        ((uint8_t *)to)[i] = (uint8_t)value;
    return to;
}
