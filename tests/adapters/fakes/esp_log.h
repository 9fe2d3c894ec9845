/* SPDX-License-Identifier: MIT
 *
 * A fake of ESP-IDF, for the examples alone, which are compiled and not run. */
#ifndef FAKE_ESP_LOG_H
#define FAKE_ESP_LOG_H

#include <stdio.h>

#define ESP_LOGE(tag, ...) (printf("%s: ", tag), printf(__VA_ARGS__))

void app_main(void);

#endif
