/* SPDX-License-Identifier: MIT
 *
 * TRM: ESP32-C3 Technical Reference Manual, by its chapters. Names of files are those of espressif/esp-idf. */
#include "emulators/esp32c3_chip.h"

const struct c3_rule_text c3_rules[C3_RULES] = {
    [C3_MODELLED] = {"no rule", "the emulated chip does not have what the program uses"},
    [C3_WORDS] = {"TRM, System and Memory", "registers, and RAM by the address for code, are accessed by words"},
    [C3_WATCHDOG_KEY] = {"TRM, Watchdog Timers; rwdt_ll.h, mwdt_ll.h",
                         "a watchdog's registers are written behind its key"},
    [C3_WATCHDOG_BITES] = {"TRM, Watchdog Timers; rwdt_ll.h, mwdt_ll.h",
                           "watchdogs that run since the ROM loaded the program are stopped in time"},
    [C3_CLOCK_ON] = {"TRM, System Registers; spi_ll.h",
                     "a peripheral has its clock, and is out of reset, when its registers are used"},
    [C3_SPI_BUSY] = {"TRM, SPI Controller; spi_reg.h", "registers stay as they are while bytes leave"},
    [C3_SPI_UPDATED] = {"spi_reg.h, SPI_UPDATE", "what was written is updated before bytes are sent"},
    [C3_SPI_EMPTIED] = {"spi_reg.h, SPI_BUF_AFIFO_RST; spi_ll.h", "the queue is emptied before each transfer"},
    [C3_SPI_PHASES] = {"spi_reg.h, SPI_USER_REG",
                       "a transfer has data alone: neither command, address nor dummy, on one line"},
    [C3_SPI_LENGTH] = {"spi_reg.h, SPI_MS_DLEN_REG", "a transfer has whole bytes, 64 at most"},
    [C3_SPI_CLOCK] = {"spi_reg.h, SPI_CLOCK_REG", "L is N, and H is (N + 1) / 2 - 1, rounded down"},
    [C3_SPI_RATE] = {"the display's datasheet", "the clock is no faster than the display takes"},
    [C3_SPI_PINS] = {"io_mux_reg.h, spi_pins.h", "clock and data are at their pins"},
    [C3_PIN_DRIVEN] = {"TRM, IO MUX and GPIO Matrix", "a pin that is set is an output of the matrix, of its register"},
    [C3_PIN_IDLE] = {"the display's datasheet", "D/C, select and reset change when no byte is leaving"},
    [C3_TIMER_ASKED] = {"systimer_reg.h, SYSTIMER_UNIT0_OP_REG", "a value is asked for, and valid, before it is read"},
};
