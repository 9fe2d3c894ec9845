/* SPDX-License-Identifier: MIT
 *
 * Console and end of a program for AVR in simavr; avr-libc has the start-up. Text leaves by the
 * first serial port. The emulator has no exit status: a last line `exit N` tells it (targets.sh). */
#include "console.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdlib.h>

static void put_letter(char letter)
{
    UCSR0B |= 1 << TXEN0;
    while (!(UCSR0A & 1 << UDRE0))
        ;
    UDR0 = (uint8_t)letter;
}

void console_put(const char *text)
{
    while (*text)
        put_letter(*text++);
}

/* avr-libc comes here from main(). Sleep without interrupts ends the emulation. */
_Noreturn void exit(int status)
{
    const char line[] = {'e', 'x', 'i', 't', ' ', (char)('0' + (status & 7)), '\n', 0};
    console_put(line);
    cli();
    sleep_enable();
    for (;;)
        sleep_cpu();
}
