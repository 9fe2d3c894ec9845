/* SPDX-License-Identifier: MIT
 *
 * The system timer of an ESP32-C3 as a clock: 16 MHz of the crystal's 40, whatever the processor's rate is. Registers:
 * ESP32-C3 Technical Reference Manual, "System Timer (SYSTIMER)"; offsets and bits as in espressif/esp-idf
 * components/soc/esp32c3/register/soc/systimer_reg.h. */
#ifndef HAL_MCU_ESP32C3_SYSTIMER_H
#define HAL_MCU_ESP32C3_SYSTIMER_H

#include "bus.h"

HAL_C_BEGIN

struct esp32c3_systimer {
    volatile uint32_t conf, unit0_op, reserved_08[14], unit0_value_hi, unit0_value_lo;
};

#define ESP32C3_SYSTIMER ((struct esp32c3_systimer *)UINT32_C(0x60023000))

/* Starts it; waits end with MCU_ERR_TIMEOUT where it stands still. */
struct clock esp32c3_systimer_clock(struct esp32c3_systimer *timer);

HAL_C_END

#endif
