/* SPDX-License-Identifier: MIT
 *
 * Console and end of a bare image that an emulator runs: by semihosting, on Arm and RISC-V. */
#include "semihost.h"

#include "bare_image.h"
#include "console.h"

#if defined(__arm__)
void semihost(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}
#else
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
#endif

void console_put(const char *text)
{
    semihost(SEMIHOST_WRITE0, text);
}

/* The status becomes that of the emulator. */
_Noreturn void image_exit(int status)
{
    const uint32_t reason_and_status[2] = {SEMIHOST_APPLICATION_EXIT, (uint32_t)status};
    semihost(SEMIHOST_EXIT_EXTENDED, reason_and_status);
    for (;;)
        ;
}

_Noreturn void image_fault(void)
{
    console_put("fault: the processor took an exception\n");
    image_exit(2);
}
