/* SPDX-License-Identifier: MIT
 *
 * The modules. Where a row says less than its sources, or they disagree, the comment before it says so; how a fact was
 * read out of what they send stands there too. MADCTL, A0h and so on in these comments are what the sources send. */
#include "glass/glass.h"

#include <stddef.h>

#define ADAFRUIT_77XX "adafruit/Adafruit-ST7735-Library "
#define ARDUINO_GFX "moononournation/Arduino_GFX src/display/"
#define LOVYANGFX "lovyan03/LovyanGFX src/lgfx/"
#define LUMA_LCD "rm-hull/luma.lcd luma/lcd/device.py"
#define LUMA_OLED "rm-hull/luma.oled luma/oled/device/__init__.py"
#define LINUX "torvalds/linux drivers/"
#define TFT_ESPI "Bodmer/TFT_eSPI TFT_Drivers/"
#define U8G2 "olikraus/u8g2 csrc/"

const struct glass glass_rows[] = {
    /* MIPI DCS ------------------------------------------------------------------------------------------------------
     *
     * A column or row counts back where upright has MX or MY. */

    /* 08h, colours inverted. */
    {.chip = "gc9a01",
     .module = "1.28 inch, round, IPS",
     .w_px = 240,
     .h_px = 240,
     .mem_w_px = 240,
     .mem_h_px = 240,
     .blue_first = true,
     .negative = true,
     .sources = {TFT_ESPI "GC9A01_Rotation.h", TFT_ESPI "GC9A01_Init.h", ARDUINO_GFX "Arduino_GC9A01.cpp",
                 LOVYANGFX "v1/panel/Panel_GC9A01.hpp"}},

    /* 48h with B6h 08 82 27, whose second byte leaves both directions of scanning as they are after a reset. luma has
     * 28h for landscape. LovyanGFX has 08h with B6h 08 C2 27, lines scanned the other way: the same glass, half a turn
     * on. */
    {.chip = "ili9341",
     .module = "2.2 to 3.2 inch",
     .w_px = 240,
     .h_px = 320,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .column = 239,
     .columns_back = true,
     .blue_first = true,
     .sources = {LINUX "gpu/drm/tiny/ili9341.c", "adafruit/Adafruit_ILI9341 Adafruit_ILI9341.cpp",
                 TFT_ESPI "ILI9341_Rotation.h", "zephyrproject-rtos/zephyr drivers/display/display_ili9xxx.c",
                 LUMA_LCD}},

    /* 48h with B6h 02 02 3B. */
    {.chip = "ili9488",
     .module = "3.5 inch",
     .w_px = 320,
     .h_px = 480,
     .mem_w_px = 320,
     .mem_h_px = 480,
     .column = 319,
     .columns_back = true,
     .blue_first = true,
     .sources = {TFT_ESPI "ILI9488_Rotation.h", TFT_ESPI "ILI9488_Init.h", ARDUINO_GFX "Arduino_ILI9488_18bit.cpp",
                 "zephyrproject-rtos/zephyr drivers/display/display_ili9xxx.c",
                 LOVYANGFX "v1/panel/Panel_ILI948x.hpp"}},

    /* All that were read have MX and MY upright, none of them 0: C8h. A module with a green tab, whose memory has
     * 132x162 pixels: windows begin at 2, 1. (Those with a black or a red tab have 128x160; a black one is red first.)
     */
    {.chip = "st7735",
     .module = "1.8 inch, green tab",
     .w_px = 128,
     .h_px = 160,
     .mem_w_px = 132,
     .mem_h_px = 162,
     .column = 132 - 1 - 2,
     .line = 162 - 1 - 1,
     .columns_back = true,
     .lines_back = true,
     .blue_first = true,
     .sources = {ADAFRUIT_77XX "Adafruit_ST7735.cpp", TFT_ESPI "ST7735_Rotation.h", LINUX "gpu/drm/tiny/st7735r.c",
                 LOVYANGFX "v1_autodetect/LGFX_AutoDetect_ESP32_all.hpp", LINUX "staging/fbtft/fb_st7735r.c"}},
    /* As above, and windows begin at 2, 3 with MX and MY, at 2, 1 without: memory has 132 lines. LovyanGFX says so. */
    {.chip = "st7735",
     .module = "1.44 inch, green tab",
     .w_px = 128,
     .h_px = 128,
     .mem_w_px = 132,
     .mem_h_px = 132,
     .column = 132 - 1 - 2,
     .line = 132 - 1 - 3,
     .columns_back = true,
     .lines_back = true,
     .blue_first = true,
     .sources = {ADAFRUIT_77XX "Adafruit_ST7735.cpp", TFT_ESPI "ST7735_Rotation.h", LINUX "gpu/drm/tiny/st7735r.c",
                 LOVYANGFX "v1_autodetect/LGFX_AutoDetect_ESP32_all.hpp"}},
    /* Windows begin at 26, 1. (Adafruit's own module of this size is another: 24, 0, red first, not negative.) */
    {.chip = "st7735",
     .module = "0.96 inch, IPS",
     .w_px = 80,
     .h_px = 160,
     .mem_w_px = 132,
     .mem_h_px = 162,
     .column = 132 - 1 - 26,
     .line = 162 - 1 - 1,
     .columns_back = true,
     .lines_back = true,
     .blue_first = true,
     .negative = true,
     .sources = {ADAFRUIT_77XX "Adafruit_ST7735.cpp", TFT_ESPI "ST7735_Rotation.h", TFT_ESPI "ST7735_Init.h",
                 LOVYANGFX "v1_autodetect/LGFX_AutoDetect_ESP32_all.hpp"}},

    /* 00h, colours inverted; margins as TFT_eSPI's CGRAM_OFFSET has them. Adafruit's modules are held the other way up:
     * C0h, and windows begin at the far margins, which are those of the same glass, half a turn on. */
    {.chip = "st7789",
     .module = "1.3 and 1.54 inch, IPS",
     .w_px = 240,
     .h_px = 240,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .negative = true,
     .sources = {TFT_ESPI "ST7789_Rotation.h", TFT_ESPI "ST7789_Init.h", ARDUINO_GFX "Arduino_ST7789.cpp",
                 ADAFRUIT_77XX "Adafruit_ST7789.cpp"}},
    {.chip = "st7789",
     .module = "2 and 2.4 inch, IPS",
     .w_px = 240,
     .h_px = 320,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .negative = true,
     .sources = {TFT_ESPI "ST7789_Rotation.h", TFT_ESPI "ST7789_Init.h", ARDUINO_GFX "Arduino_ST7789.cpp",
                 ADAFRUIT_77XX "Adafruit_ST7789.cpp", LINUX "staging/fbtft/fb_st7789v.c"}},
    {.chip = "st7789",
     .module = "1.14 inch, IPS",
     .w_px = 135,
     .h_px = 240,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .column = 52,
     .line = 40,
     .negative = true,
     .sources = {TFT_ESPI "ST7789_Rotation.h", ADAFRUIT_77XX "Adafruit_ST7789.cpp", ARDUINO_GFX "Arduino_ST7789.cpp"}},
    {.chip = "st7789",
     .module = "1.9 inch, IPS",
     .w_px = 170,
     .h_px = 320,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .column = 35,
     .negative = true,
     .sources = {TFT_ESPI "ST7789_Rotation.h", ADAFRUIT_77XX "Adafruit_ST7789.cpp", ARDUINO_GFX "Arduino_ST7789.cpp"}},
    {.chip = "st7789",
     .module = "1.47 inch, IPS",
     .w_px = 172,
     .h_px = 320,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .column = 34,
     .negative = true,
     .sources = {TFT_ESPI "ST7789_Rotation.h", ADAFRUIT_77XX "Adafruit_ST7789.cpp", ARDUINO_GFX "Arduino_ST7789.cpp"}},
    {.chip = "st7789",
     .module = "1.69 inch, IPS",
     .w_px = 240,
     .h_px = 280,
     .mem_w_px = 240,
     .mem_h_px = 320,
     .line = 20,
     .negative = true,
     .sources = {TFT_ESPI "ST7789_Rotation.h", ADAFRUIT_77XX "Adafruit_ST7789.cpp", ARDUINO_GFX "Arduino_ST7789.cpp"}},

    /* Pages ----------------------------------------------------------------------------------------------------------
     *
     * With A1h a chip of n columns puts what is addressed as c on its output n - 1 - c. With C8h lines are scanned from
     * the last of those in use down to output 0. Chips with fewer lines than outputs are told so (A8h), and shift
     * nothing (D3h 0) unless the comment says otherwise. */

    /* Vop 40 (Adafruit), 48 (luma), 64 (u8g2). */
    {.chip = "pcd8544",
     .module = "Nokia 5110",
     .w_px = 84,
     .h_px = 48,
     .mem_w_px = 84,
     .mem_h_px = 48,
     .least_mv = 5460,
     .most_mv = 6900,
     .sources = {U8G2 "u8x8_d_pcd8544_84x48.c", LUMA_LCD,
                 "adafruit/Adafruit-PCD8544-Nokia-5110-LCD-library Adafruit_PCD8544.cpp"}},

    /* A1h, C8h, DAh 12h, first column addressed 2. The pump: 32h, which it is after a reset, or 33h. */
    {.chip = "sh1106",
     .module = "1.3 inch",
     .w_px = 128,
     .h_px = 64,
     .mem_w_px = 132,
     .mem_h_px = 64,
     .column = 132 - 1 - 2,
     .line = 63,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_ALTERNATING,
     .least_mv = 8000,
     .most_mv = 9000,
     .sources = {U8G2 "u8x8_d_ssd1306_128x64_noname.c", LUMA_OLED, "adafruit/Adafruit_SH110x Adafruit_SH1106G.cpp"}},

    /* The same with A8h 1Fh and D3h 10h; luma has 20h and 0Fh, the same outputs. u8g2 says Visionox of it, M01033; but
     * after its table it sends that of an SSD1306 of 128x32 (D3h 0, DAh 02h) as well, which would be other outputs. An
     * owner (u8g2's issue 1250) saw the picture of 128x64 pixels right, from its line 16 on: these. */
    {.chip = "sh1106",
     .module = "0.91 inch",
     .w_px = 128,
     .h_px = 32,
     .mem_w_px = 132,
     .mem_h_px = 64,
     .column = 132 - 1 - 2,
     .line = 47,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_ALTERNATING,
     .sources = {U8G2 "u8x8_d_ssd1306_128x32.c", LUMA_OLED}},

    /* A1h, C8h; first column addressed 0, or as said. */
    {.chip = "ssd1306",
     .module = "0.96 inch",
     .w_px = 128,
     .h_px = 64,
     .mem_w_px = 128,
     .mem_h_px = 64,
     .column = 127,
     .line = 63,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_ALTERNATING,
     .sources = {U8G2 "u8x8_d_ssd1306_128x64_noname.c", LUMA_OLED, "adafruit/Adafruit_SSD1306 Adafruit_SSD1306.cpp",
                 "micropython/micropython-lib micropython/drivers/display/ssd1306/ssd1306.py"}},
    {.chip = "ssd1306",
     .module = "0.91 inch",
     .w_px = 128,
     .h_px = 32,
     .mem_w_px = 128,
     .mem_h_px = 64,
     .column = 127,
     .line = 31,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_IN_ORDER,
     .sources = {U8G2 "u8x8_d_ssd1306_128x32.c", LUMA_OLED, "adafruit/Adafruit_SSD1306 Adafruit_SSD1306.cpp",
                 "micropython/micropython-lib micropython/drivers/display/ssd1306/ssd1306.py"}},
    /* 32 */
    {.chip = "ssd1306",
     .module = "0.66 inch",
     .w_px = 64,
     .h_px = 48,
     .mem_w_px = 128,
     .mem_h_px = 64,
     .column = 127 - 32,
     .line = 47,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_ALTERNATING,
     .sources = {U8G2 "u8x8_d_ssd1306_64x48.c", LUMA_OLED,
                 "micropython/micropython-lib micropython/drivers/display/ssd1306/ssd1306.py"}},
    /* 32 */
    {.chip = "ssd1306",
     .module = "0.49 inch",
     .w_px = 64,
     .h_px = 32,
     .mem_w_px = 128,
     .mem_h_px = 64,
     .column = 127 - 32,
     .line = 31,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_ALTERNATING,
     .sources = {U8G2 "u8x8_d_ssd1306_64x32.c", LUMA_OLED, "adafruit/Adafruit_SSD1306 Adafruit_SSD1306.cpp",
                 "micropython/micropython-lib micropython/drivers/display/ssd1306/ssd1306.py"}},
    /* Not in the middle of memory: luma.oled 3.10 still had it there, and today's has not; micropython-lib, which puts
     * glass of any width there, is no source for this one. */
    {.chip = "ssd1306",
     .module = "0.69 inch",
     .w_px = 96,
     .h_px = 16,
     .mem_w_px = 128,
     .mem_h_px = 64,
     .column = 127,
     .line = 15,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_IN_ORDER,
     .sources = {U8G2 "u8x8_d_ssd1306_96x16.c", LUMA_OLED, "adafruit/Adafruit_SSD1306 Adafruit_SSD1306.cpp"}},
    /* 28; both send ADh 30h. */
    {.chip = "ssd1306",
     .module = "0.42 inch",
     .w_px = 72,
     .h_px = 40,
     .mem_w_px = 128,
     .mem_h_px = 64,
     .column = 127 - 28,
     .line = 39,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .wiring = GLASS_ALTERNATING,
     .needs_reference = true,
     .sources = {U8G2 "u8x8_d_ssd1306_72x40.c",
                 "micropython/micropython-lib micropython/drivers/display/ssd1306/ssd1306.py"}},

    /* A1h, C0h, first column addressed 4: three of u8g2's four modules of this size (JLX12864, OS12864, ERC12864) and
     * luma's. Turned by half they are A0h, C8h and 0. Voltages differ by glass:
     * 23h with 10 (JLX), 50 (DG128064); 26h with 12 (OS), 39 (ERC); 22h with 57 (luma). */
    {.chip = "st7567",
     .module = "128x64 LCD",
     .w_px = 128,
     .h_px = 64,
     .mem_w_px = 132,
     .mem_h_px = 64,
     .column = 132 - 1 - 4,
     .columns_back = true,
     .least_mv = 6358,
     .most_mv = 10733,
     .sources = {U8G2 "u8x8_d_st7567.c", LUMA_LCD}},

    /* A0h, C8h, 0. luma has A1h, C0h, 4: the same glass, half a turn on. */
    {.chip = "uc1701",
     .module = "mini 12864",
     .w_px = 128,
     .h_px = 64,
     .mem_w_px = 132,
     .mem_h_px = 64,
     .line = 63,
     .lines_back = true,
     .sources = {U8G2 "u8x8_d_uc1701_mini12864.c",
                 "MarlinFirmware/Marlin Marlin/src/lcd/dogm/u8g_dev_uc1701_mini12864_HAL.cpp", LUMA_LCD}},
    /* A1h, C0h, 0. */
    {.chip = "uc1701",
     .module = "EA DOGS102",
     .w_px = 102,
     .h_px = 64,
     .mem_w_px = 132,
     .mem_h_px = 64,
     .column = 131,
     .columns_back = true,
     .sources = {U8G2 "u8x8_d_uc1701_dogs102.c", LINUX "staging/fbtft/fb_uc1701.c"}},

    /* Solomon Systech with windows -----------------------------------------------------------------------------------
     *
     * Which output is the first is worked out from the lines in use (A8h or CAh), the direction of scanning and the
     * shift (A2h) of the sources; memory_row() of emulated_solomon.c says how these go together. */

    /* A8h 3Fh, A0h with its bit 4, A2h 4Ch: OSRAM's glass, as the maker of the LM3S6965EVB drives it (osram128x64x4.c,
     * from OSRAM's application note AN018), NHD's in u8g2, and luma's. u8g2's OS128064 is another module: 40h, and
     * without bit 4 50h; of the two directions together only 79 as the output where the chip starts to count backwards
     * makes one glass. So it is taken to be the last of all, not of those in use. The maker's current is 50 of 127 in
     * half of the range (85h, 81h 50 in decimal). */
    {.chip = "ssd0323",
     .module = "OSRAM, of the LM3S6965EVB",
     .w_px = 128,
     .h_px = 64,
     .mem_w_px = 128,
     .mem_h_px = 80,
     .line = 75,
     .lines_back = true,
     .current_permille = 196,
     .sources = {U8G2 "u8x8_d_ssd1325.c", LUMA_OLED}},

    /* A8h 7Fh, A0h 51h: bits 0 and 4. luma's 53h exchanges the pixels of a byte as well, as it sends them. */
    {.chip = "ssd1327",
     .module = "1.5 inch",
     .w_px = 128,
     .h_px = 128,
     .mem_w_px = 128,
     .mem_h_px = 128,
     .column = 127,
     .line = 127,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .sources = {U8G2 "u8x8_d_ssd1327.c", "adafruit/Adafruit_SSD1327 Adafruit_SSD1327.cpp", LUMA_OLED,
                 LOVYANGFX "v1/panel/Panel_SSD1327.cpp"}},
    /* A8h 5Fh, A2h 20h with bit 4 of A0h, 60h without. Seeed's module of 96x96 has its lines on the same outputs, by
     * u8g2's driver and by Seeed's own. */
    {.chip = "ssd1327",
     .module = "Visionox",
     .w_px = 128,
     .h_px = 96,
     .mem_w_px = 128,
     .mem_h_px = 128,
     .column = 127,
     .line = 127,
     .columns_back = true,
     .lines_back = true,
     .told_lines = true,
     .sources = {U8G2 "u8x8_d_ssd1327.c", "Seeed-Studio/OLED_Display_96X96 SeeedGrayOLED.cpp"}},

    /* CAh 7Fh, A0h 74h: bits 2 and 4. luma and fbtft set bit 2, for blue and red, if they are asked to. LovyanGFX has
     * lines the other way, which is a mirror image on these. */
    {.chip = "ssd1351",
     .module = "1.5 inch",
     .w_px = 128,
     .h_px = 128,
     .mem_w_px = 128,
     .mem_h_px = 128,
     .line = 127,
     .lines_back = true,
     .told_lines = true,
     .blue_first = true,
     .sources = {"adafruit/Adafruit-SSD1351-library Adafruit_SSD1351.cpp", ARDUINO_GFX "Arduino_SSD1351.cpp",
                 LINUX "staging/fbtft/fb_ssd1351.c", LUMA_OLED}},
    /* CAh 7Fh as well: all lines are scanned, of which 96 are there. A1h is 60h with bit 4 of A0h, and 0 without. */
    {.chip = "ssd1351",
     .module = "1.27 inch",
     .w_px = 128,
     .h_px = 96,
     .mem_w_px = 128,
     .mem_h_px = 128,
     .line = 95,
     .lines_back = true,
     .told_lines = true,
     .blue_first = true,
     .sources = {"adafruit/Adafruit-SSD1351-library Adafruit_SSD1351.cpp", ARDUINO_GFX "Arduino_SSD1351.cpp"}},

    /* Sharp ------------------------------------------------------------------------------------------------------ */

    {.chip = "ls013b7dh03",
     .module = "1.28 inch",
     .w_px = 128,
     .h_px = 128,
     .mem_w_px = 128,
     .mem_h_px = 128,
     .sources = {U8G2 "u8x8_d_ls013b7dh03.c", "zephyrproject-rtos/zephyr drivers/display/ls0xx.c",
                 LOVYANGFX "v1/panel/Panel_SharpLCD.cpp"}},
    {.chip = "ls027b7dh01",
     .module = "2.7 inch",
     .w_px = 400,
     .h_px = 240,
     .mem_w_px = 400,
     .mem_h_px = 240,
     .sources = {U8G2 "u8x8_d_ls013b7dh03.c", "zephyrproject-rtos/zephyr drivers/display/ls0xx.c",
                 "adafruit/Adafruit_SHARP_Memory_Display Adafruit_SharpMem.cpp",
                 LOVYANGFX "v1/panel/Panel_SharpLCD.cpp"}},

    {.chip = NULL},
};
