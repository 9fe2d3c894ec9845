/* SPDX-License-Identifier: MIT
 *
 * What the drivers of a microcontroller's peripherals share: their errors, beside those of hal/panel.h, and how long
 * they wait. A driver reaches its peripheral's registers through a pointer, so that a test can hand it plain memory. */
#ifndef HAL_MCU_H
#define HAL_MCU_H

#include "bus.h"

enum mcu_error {
    MCU_ERR_TIMEOUT = -3001, /* the peripheral did not get ready in as many looks as its driver takes */
    MCU_ERR_CONFIG = -3002,  /* a rate, a pin or a mode that the peripheral does not have */
    MCU_ERR_BUS = -3003      /* a DMA controller could not read or write memory */
};

#endif
