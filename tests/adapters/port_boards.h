/* SPDX-License-Identifier: MIT
 *
 * Boards that the ports fill, by name; has_select: for a memory LCD, whose select is its driver's. */
#ifndef PORT_BOARDS_H
#define PORT_BOARDS_H

#include "board.h"

#ifdef __cplusplus
extern "C" {
#endif

int arduino_board(struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select);
int pico_board(struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select);
int idf_board(struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select);

#ifdef __cplusplus
}
#endif

static inline int port_board(const char *port, struct board *board, uint32_t spi_hz, uint8_t spi_modes, bool has_select)
{
    if (port[0] == 'a') return arduino_board(board, spi_hz, spi_modes, has_select);
    if (port[0] == 'p') return pico_board(board, spi_hz, spi_modes, has_select);
    return idf_board(board, spi_hz, spi_modes, has_select);
}

#endif
