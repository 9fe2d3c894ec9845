/* SPDX-License-Identifier: MIT
 *
 * The clock of AVR microcontrollers: a 16-bit timer runs freely at an eighth of the processor's rate, is polled, and
 * interrupts nobody.
 * Manual: Atmel-7766, ATmega16U4/ATmega32U4, section 14, "16-bit Timers/Counters". Not tried on hardware. */
#ifndef HAL_MCU_AVR_TIMER_H
#define HAL_MCU_AVR_TIMER_H

#include "bus.h"

HAL_C_BEGIN

struct avr_timer_registers {
    uint8_t tccra, tccrb, tccrc;
    uint8_t reserved;
    uint16_t tcnt; /* its low byte is read first, and holds the high one */
};

#define AVR_TIMER_1_REGISTERS ((volatile struct avr_timer_registers *)0x80)

struct avr_timer {
    volatile struct avr_timer_registers *registers;
    uint8_t ticks_per_us; /* rounded up: a wait may be longer, never shorter */
};

/* Starts the counter. MCU_ERR_CONFIG: a rate of 0, or above 2 GHz. */
HAL_MUST_CHECK int avr_timer_init(struct avr_timer *timer, volatile struct avr_timer_registers *registers,
                                  uint32_t cpu_hz);

/* Waits are up to half an hour. They end with MCU_ERR_TIMEOUT where the counter stands still. *timer must outlive it.
 */
struct clock avr_timer_clock(struct avr_timer *timer);

HAL_C_END

#endif
