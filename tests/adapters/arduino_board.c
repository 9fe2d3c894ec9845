/* SPDX-License-Identifier: MIT
 *
 * C++. */
#include "limner_arduino.h"
#include "port_boards.h"

SPIClass SPI;

extern "C" int arduino_board(struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select)
{
    static struct limner_arduino port = {WIRE_CS, WIRE_DC, WIRE_RESET, WIRE_BACKLIGHT, LIMNER_NO_PIN, SPISettings()};

    if (has_select) port.cs = LIMNER_NO_PIN, port.select = WIRE_SELECT;
    limner_arduino_board(&port, board, spi_hz, spi_modes);
    return 0;
}
