/* SPDX-License-Identifier: MIT
 *
 * What Arm and RISC-V share of semihosting: console and exit. */
#include "semihost.h"

#include "console.h"

void console_put(const char *text)
{
    semihost(SEMIHOST_WRITE0, text);
}

_Noreturn void semihost_exit(int status)
{
    const uint32_t reason_and_status[2] = {SEMIHOST_APPLICATION_EXIT, (uint32_t)status};
    semihost(SEMIHOST_EXIT_EXTENDED, reason_and_status);
    for (;;)
        ;
}

_Noreturn void semihost_fault(void)
{
    console_put("fault: the processor took an exception\n");
    semihost_exit(2);
}
