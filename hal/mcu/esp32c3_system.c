/* SPDX-License-Identifier: MIT
 *
 * Keys: espressif/esp-idf components/esp_hal_wdt/esp32c3/include/hal/rwdt_ll.h, mwdt_ll.h. A watchdog may be off and
 * run all the same, as long as its mode for booting from flash is on. */
#include "mcu/esp32c3_system.h"

#define WATCHDOG_KEY UINT32_C(0x50D83AA1)
#define SUPER_KEY UINT32_C(0x8F1D312A)
#define WATCHDOG_ON (UINT32_C(1) << 31)
#define SUPER_FEEDS_ITSELF (UINT32_C(1) << 31)
#define RTC_BOOTS (UINT32_C(1) << 12)
#define TIMER_BOOTS (UINT32_C(1) << 14)
#define TIMER_TAKES (UINT32_C(1) << 22) /* what was written counts from then on */

enum { CLOCK_SOURCE = 3 << 10, CLOCK_DIVIDER = 0x3FF };

void esp32c3_watchdogs_stop(struct esp32c3_rtc_watchdogs *rtc, struct esp32c3_watchdog *timer)
{
    rtc->wprotect = WATCHDOG_KEY;
    rtc->config0 &= ~(WATCHDOG_ON | RTC_BOOTS);
    rtc->wprotect = 0;
    rtc->swd_wprotect = SUPER_KEY;
    rtc->swd_conf |= SUPER_FEEDS_ITSELF;
    rtc->swd_wprotect = 0;
    timer->wprotect = WATCHDOG_KEY;
    timer->config0 &= ~(WATCHDOG_ON | TIMER_BOOTS);
    timer->config0 |= TIMER_TAKES;
    timer->wprotect = 0;
}

/* The divider is the crystal's; it comes first. */
void esp32c3_clock_init(struct esp32c3_system *system)
{
    system->sysclk_conf &= ~(uint32_t)CLOCK_DIVIDER;
    system->sysclk_conf &= ~(uint32_t)CLOCK_SOURCE;
}

void esp32c3_system_begin(struct esp32c3_system *system, uint32_t parts)
{
    system->perip_clk_en0 |= parts;
    system->perip_rst_en0 |= parts;
    system->perip_rst_en0 &= ~parts;
}
