/* SPDX-License-Identifier: MIT
 *
 * A fake of FreeRTOS's other tasks: time passes. */
#ifndef FAKE_TASK_H
#define FAKE_TASK_H

#include "FreeRTOS.h"

#define pdMS_TO_TICKS(ms) ((TickType_t)(ms) / 10)

void vTaskDelay(TickType_t xTicksToDelay);

#endif
