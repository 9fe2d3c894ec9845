/* SPDX-License-Identifier: MIT
 *
 * Ends the tests' kernel, which has no init system that could. Of use to process 1 of that kernel alone. */
#define _DEFAULT_SOURCE
#include <stdio.h>
#include <sys/reboot.h>
#include <unistd.h>

int main(void)
{
    if (getpid() == 1) {
        sync();
        reboot(RB_POWER_OFF);
    }
    fputs("power_off: this is not process 1\n", stderr);
    return 1;
}
