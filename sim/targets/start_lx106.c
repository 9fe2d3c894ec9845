/* SPDX-License-Identifier: MIT
 *
 * Start-up, console and end of a bare image for the ESP8266's core, an Xtensa LX106, in QEMU. Any exception is the
 * program's end.
 * Source: Xtensa Instruction Set Architecture Reference Manual, 4.4.1 (exceptions: PS, VECBASE), 4.3 (registers of the
 * call0 convention); QEMU, target/xtensa/core-lx106/core-isa.h (where vectors are behind VECBASE) and
 * target/xtensa/xtensa-semi.c (operations of simcall). */
#include "bare_image.h"
#include "console.h"

enum { SIMCALL_EXIT = 1, SIMCALL_WRITE = 4 };
enum { STANDARD_OUTPUT = 1 };

void lx106_start(void);

/* The image begins here, and so do its vectors: 0x10 a debug exception, 0x20 an NMI, 0x30 and 0x50 other exceptions,
 * 0x70 an exception within one. There is no stack yet. PS = 0: exceptions are not held to be within another; no
 * interrupt is enabled. A constant stands before the instruction that loads it (l32r). */
__asm__(".section .vectors, \"ax\"\n"
        "vectors:\n\t"
        "j begin\n\t"
        ".org 0x10\n\t"
        "j fault\n\t"
        ".org 0x20\n\t"
        "j fault\n\t"
        ".org 0x30\n\t"
        "j fault\n\t"
        ".org 0x50\n\t"
        "j fault\n\t"
        ".org 0x70\n\t"
        "j fault\n\t"
        ".org 0x80\n"
        "vectors_address: .word vectors\n"
        "stack_address: .word image_stack_top\n"
        "start_address: .word lx106_start\n"
        "fault_address: .word image_fault\n"
        "begin:\n\t"
        "l32r a2, vectors_address\n\t"
        "wsr.vecbase a2\n\t"
        "movi a2, 0\n\t"
        "wsr.intenable a2\n\t"
        "wsr.ps a2\n\t"
        "rsync\n\t"
        "l32r sp, stack_address\n\t"
        "l32r a2, start_address\n\t"
        "jx a2\n"
        "fault:\n\t"
        "l32r sp, stack_address\n\t"
        "l32r a2, fault_address\n\t"
        "jx a2\n\t"
        ".text");

__attribute__((used)) void lx106_start(void)
{
    image_memory_init();
    image_exit(main());
}

/* a2: the operation, then its result; a3: the error number. */
static int32_t simcall(uint32_t operation, uint32_t first, const void *second, uint32_t third)
{
    register uint32_t a2 __asm__("a2") = operation;
    register uint32_t a3 __asm__("a3") = first;
    register const void *a4 __asm__("a4") = second;
    register uint32_t a5 __asm__("a5") = third;
    __asm__ volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
    return (int32_t)a2;
}

void console_put(const char *text)
{
    uint32_t length = 0;

    while (text[length])
        length++;
    (void)simcall(SIMCALL_WRITE, STANDARD_OUTPUT, text, length);
}

_Noreturn void image_exit(int status)
{
    (void)simcall(SIMCALL_EXIT, (uint32_t)status, 0, 0);
    for (;;)
        ;
}

_Noreturn void image_fault(void)
{
    console_put("fault: the processor took an exception\n");
    image_exit(2);
}
