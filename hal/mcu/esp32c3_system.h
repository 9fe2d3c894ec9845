/* SPDX-License-Identifier: MIT
 *
 * What an ESP32-C3 has for all its peripherals: clocks, resets, watchdogs. Registers: ESP32-C3 Technical Reference
 * Manual, chapters "System Registers", "Low-power Management" and "Watchdog Timers"; offsets and bits as in
 * espressif/esp-idf components/soc/esp32c3/register/soc (system_reg.h, rtc_cntl_reg.h, timer_group_reg.h). Not tried on
 * hardware. */
#ifndef HAL_MCU_ESP32C3_SYSTEM_H
#define HAL_MCU_ESP32C3_SYSTEM_H

#include "bus.h"

HAL_C_BEGIN

struct esp32c3_system {
    volatile uint32_t reserved_00[4], perip_clk_en0, reserved_14, perip_rst_en0, reserved_1c[15], sysclk_conf;
};

#define ESP32C3_SYSTEM ((struct esp32c3_system *)UINT32_C(0x600C0000))

/* Bits of perip_clk_en0 and perip_rst_en0. */
#define ESP32C3_SPI2 (UINT32_C(1) << 6)
#define ESP32C3_SYSTIMER_PART (UINT32_C(1) << 29)

/* The RTC's watchdog and the super watchdog behind it. */
struct esp32c3_rtc_watchdogs {
    volatile uint32_t config0, config[4], feed, wprotect, swd_conf, swd_wprotect;
};

#define ESP32C3_RTC_WATCHDOGS ((struct esp32c3_rtc_watchdogs *)UINT32_C(0x60008090))

/* A timer group's. */
struct esp32c3_watchdog {
    volatile uint32_t config0, config[5], feed, wprotect;
};

#define ESP32C3_WATCHDOG0 ((struct esp32c3_watchdog *)UINT32_C(0x6001F048))

/* The first two run when the ROM has loaded an image, and reset a chip that leaves them running; the super watchdog
 * feeds itself from now on. */
void esp32c3_watchdogs_stop(struct esp32c3_rtc_watchdogs *rtc, struct esp32c3_watchdog *timer);

/* Processor and APB by the crystal, 40 MHz, undivided; an ESP32-C3 takes no other crystal. */
#define ESP32C3_CRYSTAL_HZ UINT32_C(40000000)
void esp32c3_clock_init(struct esp32c3_system *system);

/* Gives peripherals their clock, and leaves them as after a reset. */
void esp32c3_system_begin(struct esp32c3_system *system, uint32_t parts);

HAL_C_END

#endif
