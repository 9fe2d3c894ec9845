/* SPDX-License-Identifier: MIT
 *
 * Of ESP-IDF's codes those that the fakes return (commit 102122904ad). */
#ifndef FAKE_ESP_ERR_H
#define FAKE_ESP_ERR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef int esp_err_t;

enum { ESP_FAIL = -1, ESP_OK = 0, ESP_ERR_INVALID_ARG = 0x102, ESP_ERR_INVALID_STATE = 0x103, ESP_ERR_TIMEOUT = 0x107 };

#endif
