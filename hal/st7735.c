/* SPDX-License-Identifier: MIT
 *
 * Sitronix ST7735R, ST7735S: 132x162 memory, or less by the module's mode pins (mem_w_px, mem_h_px); write clock 15 MHz
 * by the datasheet, 27 MHz in wide use. Common modules:
 *     glass     memory    ox_px, oy_px  colours
 *     128x160   128x160   0, 0          RGB or BGR, by the batch ("red tab", "black tab")
 *     128x160   132x162   2, 1          BGR ("green tab")
 *     128x128   132x132   2, 3          BGR
 *     80x160    132x162   26, 1         BGR, IPS (invert)
 * Usual glass shows memory's last column and row first; offsets are those of the upright picture, as everywhere. What
 * the chip loads at reset suits few glasses: frame rate, voltages and gamma are those of the modules' makers. */
#include "panels.h"
#include "turn.h"

enum {
    FRMCTR1 = 0xB1, /* frame rate: normal, idle, partial */
    FRMCTR2 = 0xB2,
    FRMCTR3 = 0xB3,
    INVCTR = 0xB4, /* inversion of the voltage by columns */
    PWCTR1 = 0xC0, /* gate and source voltages, and the currents of the amplifiers */
    PWCTR2 = 0xC1,
    PWCTR3 = 0xC2,
    PWCTR4 = 0xC3,
    PWCTR5 = 0xC4,
    VMCTR1 = 0xC5,
    GMCTRP1 = 0xE0, /* gamma */
    GMCTRN1 = 0xE1
};

/* clang-format off */
static const uint8_t setup[] = {
    FRMCTR1, 3, 0x01, 0x2C, 0x2D,
    FRMCTR2, 3, 0x01, 0x2C, 0x2D,
    FRMCTR3, 6, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D,
    INVCTR, 1, 0x07,
    PWCTR1, 3, 0xA2, 0x02, 0x84,
    PWCTR2, 1, 0xC5,
    PWCTR3, 2, 0x0A, 0x00,
    PWCTR4, 2, 0x8A, 0x2A,
    PWCTR5, 2, 0x8A, 0xEE,
    VMCTR1, 1, 0x0E,
    GMCTRP1, 16, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00, 0x01, 0x03, 0x10,
    GMCTRN1, 16, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00, 0x00, 0x02, 0x10,
    DCS_NORON, 0,
};
/* clang-format on */

const struct dcs_chip st7735 = {
    .name = "st7735",
    .mem_w_px = 132,
    .mem_h_px = 162,
    .formats = 1 << PANEL_RGB565 | 1 << PANEL_RGB444 | 1 << PANEL_RGB666,
    .format = PANEL_RGB565,
    .reversed = TURN_COLUMNS | TURN_ROWS,
    .setup = setup,
    .setup_b = sizeof setup,
};
