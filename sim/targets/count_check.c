/* SPDX-License-Identifier: MIT
 *
 * Runs a loop of known length between the marks of a frame, before anything else. Linked with
 * --wrap=main: the first frame that the plugin counts is then this one. */
#include "count_check.h"

#include "app_scene.h"

#include <stdint.h>

int __real_main(void);
int __wrap_main(void);
void count_check_loop(uint32_t turns);

__attribute__((naked, noinline)) void count_check_loop(__attribute__((unused)) uint32_t turns)
{
#if defined(__arm__)
    __asm__ volatile(".syntax unified\n"
                     "0: subs r0, #1\n\t"
                     "bne 0b\n\t"
                     "bx lr");
#elif defined(__riscv)
    __asm__ volatile("0: addi a0, a0, -1\n\t"
                     "bnez a0, 0b\n\t"
                     "ret");
#else
#error "no loop for this processor"
#endif
}

int __wrap_main(void)
{
    frame_begin(0);
    count_check_loop(COUNT_CHECK_TURNS);
    frame_end(0);
    return __real_main();
}
