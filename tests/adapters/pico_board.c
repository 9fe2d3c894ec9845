/* SPDX-License-Identifier: MIT
 *
 * C, and C++. */
#include "limner_pico.h"
#include "port_boards.h"

int pico_board(struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select)
{
    static struct limner_pico port;

    port.bus.spi = spi0;
    port.bus.sck = WIRE_CLOCK, port.bus.tx = WIRE_DATA;
    port.bus.cs = WIRE_CS, port.select = LIMNER_NO_PIN;
    if (has_select) port.bus.cs = LIMNER_NO_PIN, port.select = WIRE_SELECT;
    port.dc = WIRE_DC, port.reset = WIRE_RESET, port.backlight = WIRE_BACKLIGHT;
    limner_pico_board(&port, board, spi_hz, spi_modes);
    return 0;
}
