/* SPDX-License-Identifier: MIT
 *
 * C, and C++. */
#include "limner_idf.h"
#include "port_boards.h"

int idf_board(struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select)
{
    static struct limner_idf port;

    port.host = SPI2_HOST;
    port.sck = WIRE_CLOCK, port.mosi = WIRE_DATA;
    port.cs = WIRE_CS, port.select = GPIO_NUM_NC;
    if (has_select) port.cs = GPIO_NUM_NC, port.select = WIRE_SELECT;
    port.dc = WIRE_DC, port.reset = WIRE_RESET, port.backlight = WIRE_BACKLIGHT;
    return limner_idf_board(&port, board, spi_hz, spi_modes);
}
