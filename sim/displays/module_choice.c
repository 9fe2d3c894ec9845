/* SPDX-License-Identifier: MIT
 *
 * What most sellers put behind a chip. Glass of any other size lies in the middle of the chip's memory: so do those of
 * 135x240, 170x320 and 240x280 pixels on ST7789 and of 64x48 and 64x32 on SSD1306.
 *
 * Modes of SPI: most modules of 240x240 pixels on ST7789 lack CS and take mode 3 alone (Bodmer/TFT_eSPI, issue 163),
 * those with CS take it as well (ST7789V's datasheet, in its pull request 182), so that Bodmer/TFT_eSPI's TFT_eSPI.h
 * and moononournation/Arduino_GFX's Arduino_ST7789.cpp have it for all. Sharp's memory LCDs want a clock that is low
 * between messages (olikraus/u8g2, issue 1071). For others mode 0 is usual, and mode 3 disturbs where they share a bus
 * with what takes mode 0 (SH1106: olikraus/u8g2, issue 1901). */
#include "displays/module_choice.h"

#include "base/notice.h"
#include "base/parse.h"

#include <stdio.h>
#include <string.h>

enum { SPEED_MAX_HZ = 1000000000 };

struct usual_module {
    const char *panel;
    struct display_module module;
    uint32_t speed_hz;
    uint8_t spi_modes; /* that it takes, a set of spi_modes.h */
};

static const struct usual_module USUAL[] = {
    {"gc9a01", {.w_px = 240, .h_px = 240, .bgr = true, .invert = true}, 40000000, SPI_IDLES_ANYHOW},
    {"ili9341", {.w_px = 240, .h_px = 320, .bgr = true}, 32000000, SPI_IDLES_ANYHOW},
    {"ili9488", {.w_px = 320, .h_px = 480, .bgr = true}, 20000000, SPI_IDLES_ANYHOW},
    {"ls013b7dh03", {.w_px = 128, .h_px = 128}, 1000000, SPI_IDLES_LOW},
    {"ls027b7dh01", {.w_px = 400, .h_px = 240}, 2000000, SPI_IDLES_LOW},
    {"pcd8544", {.w_px = 84, .h_px = 48}, 4000000, SPI_IDLES_ANYHOW},
    {"sh1106", {.w_px = 128, .h_px = 64, .ox_px = 2}, 4000000, SPI_IDLES_ANYHOW},
    {"sh1106", {.w_px = 128, .h_px = 32, .ox_px = 2, .shift = 16}, 4000000, SPI_IDLES_ANYHOW},
    {"ssd1306", {.w_px = 128, .h_px = 64}, 8000000, SPI_IDLES_ANYHOW},
    {"ssd1306", {.w_px = 128, .h_px = 32, .wiring = PAGES_WIRING_SEQUENTIAL}, 8000000, SPI_IDLES_ANYHOW},
    {"ssd1306", {.w_px = 96, .h_px = 16, .wiring = PAGES_WIRING_SEQUENTIAL}, 8000000, SPI_IDLES_ANYHOW},
    {"ssd1306", {.w_px = 72, .h_px = 40, .ox_px = 28, .internal_reference = true}, 8000000, SPI_IDLES_ANYHOW},
    {"ssd0323", {.w_px = 128, .h_px = 64, .shift = 76, .shift_turned = 68}, 4000000, SPI_IDLES_ANYHOW},
    {"ssd1327", {.w_px = 128, .h_px = 128}, 4000000, SPI_IDLES_ANYHOW},
    {"ssd1327", {.w_px = 128, .h_px = 96, .shift = 32, .shift_turned = 96}, 4000000, SPI_IDLES_ANYHOW},
    {"ssd1351", {.w_px = 128, .h_px = 128}, 16000000, SPI_IDLES_ANYHOW},
    {"ssd1351", {.w_px = 128, .h_px = 96}, 16000000, SPI_IDLES_ANYHOW},
    {"st7567", {.w_px = 128, .h_px = 64, .ox_px = 4}, 4000000, SPI_IDLES_ANYHOW},
    {"st7735", {.w_px = 128, .h_px = 160, .ox_px = 2, .oy_px = 1, .bgr = true}, 15000000, SPI_IDLES_ANYHOW},
    {"st7735",
     {.w_px = 128, .h_px = 128, .mem_w_px = 132, .mem_h_px = 132, .ox_px = 2, .oy_px = 3, .bgr = true},
     15000000,
     SPI_IDLES_ANYHOW},
    {"st7735",
     {.w_px = 80, .h_px = 160, .ox_px = 26, .oy_px = 1, .bgr = true, .invert = true},
     15000000,
     SPI_IDLES_ANYHOW},
    {"st7789", {.w_px = 240, .h_px = 240, .invert = true}, 40000000, SPI_IDLES_HIGH},
    {"st7796", {.w_px = 320, .h_px = 480, .bgr = true}, 40000000, SPI_IDLES_ANYHOW},
    {"st7796", {.w_px = 222, .h_px = 480, .ox_px = 49, .bgr = true, .invert = true}, 40000000, SPI_IDLES_ANYHOW},
    {"uc1701", {.w_px = 128, .h_px = 64}, 4000000, SPI_IDLES_ANYHOW},
    {"uc1701", {.w_px = 102, .h_px = 64, .flip_columns = true, .flip_rows = true}, 4000000, SPI_IDLES_ANYHOW},
};

static bool is_row_of(const struct usual_module *row, const struct panel_choice *panel, unsigned w_px, unsigned h_px)
{
    return strcmp(row->panel, panel->name) == 0 && (!w_px || (row->module.w_px == w_px && row->module.h_px == h_px));
}

/* The first row of the chip, if w_px is 0, or else that of the size. NULL: there is none. */
static const struct usual_module *find_usual(const struct panel_choice *panel, unsigned w_px, unsigned h_px)
{
    for (size_t i = 0; i < sizeof USUAL / sizeof USUAL[0]; i++)
        if (is_row_of(&USUAL[i], panel, w_px, h_px)) return &USUAL[i];
    return NULL;
}

void module_usual_size(const struct panel_choice *panel, unsigned *w_px, unsigned *h_px)
{
    const struct usual_module *row = find_usual(panel, 0, 0);
    *w_px = row ? row->module.w_px : panel->mem_w_px;
    *h_px = row ? row->module.h_px : panel->mem_h_px;
}

/* A chip without a row: all of its memory, at a rate that any takes. */
static void take_fast(struct module_choice *out)
{
    const struct usual_module *row = find_usual(&out->panel, 0, 0);
    out->module = row ? row->module : (struct display_module){.w_px = out->panel.mem_w_px, .h_px = out->panel.mem_h_px};
    out->speed_hz = row ? row->speed_hz : 1000000;
    out->spi_modes = row ? row->spi_modes : SPI_IDLES_ANYHOW;
    out->mode_given = false;
}

static bool take_size(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    struct display_module *module = &out->module;
    const char *text = NULL;
    unsigned w_px, h_px;
    if (!arguments_value(arguments, "--size", &text, err)) return false;
    if (!text) return true;
    if (!parse_size(text, &w_px, &h_px, err)) return false;
    const struct usual_module *row = find_usual(&out->panel, w_px, h_px);
    if (row) {
        *module = row->module;
        return true;
    }
    module->w_px = (uint16_t)w_px;
    module->h_px = (uint16_t)h_px;
    module->ox_px = module->oy_px = 0;
    module->shift = module->shift_turned = 0; /* of the usual size */
    if (!display_module_check(&out->panel, module, err)) return false;
    module->ox_px = (uint16_t)((out->panel.mem_w_px - w_px) / 2 / out->panel.w_step_px * out->panel.w_step_px);
    module->oy_px = (uint16_t)((out->panel.mem_h_px - h_px) / 2);
    return true;
}

/* What mode pins leave of a chip's memory. Glass that was in the middle of all of it is in the middle of what is left.
 */
static bool take_memory(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    struct display_module *module = &out->module;
    const struct panel_choice *panel = &out->panel;
    const char *text = NULL;
    unsigned w_px, h_px;
    if (!arguments_value(arguments, "--memory", &text, err)) return false;
    if (!text) return true;
    if (!panel->has_mode_pins) return error_set(err, "--memory %s: %s has no mode pins", text, panel->name);
    if (!parse_size(text, &w_px, &h_px, err)) return false;
    if (w_px > panel->mem_w_px || h_px > panel->mem_h_px)
        return error_set(err, "--memory %s: %s has %ux%u", text, panel->name, panel->mem_w_px, panel->mem_h_px);
    if (w_px == module->mem_w_px && h_px == module->mem_h_px) return true; /* so is the usual module's */
    module->mem_w_px = (uint16_t)w_px;
    module->mem_h_px = (uint16_t)h_px;
    module->ox_px = module->oy_px = 0;
    if (!display_module_check(panel, module, err)) return false;
    module->ox_px = (uint16_t)((w_px - module->w_px) / 2);
    module->oy_px = (uint16_t)((h_px - module->h_px) / 2);
    return true;
}

static bool take_offset(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    unsigned x_px, y_px;
    int length = 0;
    if (!arguments_value(arguments, "--offset", &text, err)) return false;
    if (!text) return true;
    const bool is_pair = strspn(text, "0123456789,") == strlen(text) && strlen(text) < 10 &&
                         sscanf(text, "%u,%u%n", &x_px, &y_px, &length) == 2 && text[length] == '\0';
    if (!is_pair || x_px > UINT16_MAX || y_px > UINT16_MAX)
        return error_set(err, "--offset %s: must be X,Y, in pixels of the chip's memory", text);
    if (y_px && !out->panel.family->has_rows)
        return error_set(err, "--offset %s: the glass of %s begins in the first row of its memory, say %u,0", text,
                         out->panel.name, x_px);
    out->module.ox_px = (uint16_t)x_px;
    out->module.oy_px = (uint16_t)y_px;
    return true;
}

static bool take_rotation(struct display_module *module, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    if (!arguments_value(arguments, "--rotate", &text, err)) return false;
    return !text || panel_rotation_parse(text, &module->rotation, err);
}

/* What a chip is told of its glass by a number. */
static bool take_number(const struct panel_choice *panel, const char *name, unsigned least, unsigned most,
                        uint8_t *number, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    uint32_t value = 0;
    if (!arguments_value(arguments, name, &text, err)) return false;
    if (!text) return true;
    if (!most) return error_set(err, "%s %s: %s has none", name, text, panel->name);
    if (!parse_whole(name, text, least, most, &value, err)) return false;
    *number = (uint8_t)value;
    return true;
}

static bool take_wiring(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    if (!arguments_value(arguments, "--wiring", &text, err)) return false;
    if (!text) return true;
    if (!out->panel.has_wiring) return error_set(err, "--wiring %s: %s is not told any", text, out->panel.name);
    const bool is_sequential = strcmp(text, "sequential") == 0;
    out->module.wiring = is_sequential ? PAGES_WIRING_SEQUENTIAL : PAGES_WIRING_ALTERNATIVE;
    return is_sequential || strcmp(text, "alternative") == 0 ||
           error_set(err, "--wiring %s: must be sequential or alternative", text);
}

static bool take_mirrors(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    struct display_module *module = &out->module;
    const bool columns = arguments_flag(arguments, "--mirror-columns");
    const bool rows = arguments_flag(arguments, "--mirror-rows");
    module->mirror = arguments_flag(arguments, "--mirror");
    module->flip_columns = module->flip_columns != columns;
    module->flip_rows = module->flip_rows != rows;
    const char *name = columns ? "--mirror-columns" : rows ? "--mirror-rows" : "--mirror";
    return !(columns || rows || module->mirror) || out->panel.flips ||
           error_set(err, "%s: %s cannot", name, out->panel.name);
}

static bool take_speed(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    return arguments_value(arguments, "--hz", &text, err) &&
           (!text || parse_whole("--hz", text, 1, SPEED_MAX_HZ, &out->speed_hz, err));
}

static bool take_mode(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    uint32_t mode;
    if (!arguments_value(arguments, "--mode", &text, err)) return false;
    if (!text) return true;
    if (!parse_whole("--mode", text, 0, 3, &mode, err)) return false;
    out->spi_modes = (uint8_t)(1u << mode);
    out->mode_given = true;
    return true;
}

/* A mode that is taken, as somebody may have an inverter between, though it is hardly meant. */
static void note_mode(const struct module_choice *out, uint8_t usual_modes)
{
    const char *name = out->panel.name;
    if (!out->mode_given) return;
    if (!(out->spi_modes & SPI_IDLES_ANYHOW))
        notice("--mode %u: %s reads as the clock rises, in modes 0 and 3", spi_mode_of(out->spi_modes, 0), name);
    else if (usual_modes == SPI_IDLES_LOW && out->spi_modes != SPI_IDLES_LOW)
        notice("--mode %u: %s wants a clock that is low between messages, mode 0", spi_mode_of(out->spi_modes, 0),
               name);
}

bool module_choice_parse(struct module_choice *out, struct arguments *arguments, struct error *err)
{
    const char *panel = NULL;
    if (!arguments_value(arguments, "--panel", &panel, err)) return false;
    if (!panel) return error_set(err, "--panel NAME is missing: the display's controller; `limner help` lists them");
    if (!panel_choice_parse(panel, NULL, &out->panel, err)) return false;
    take_fast(out);
    const uint8_t usual_modes = out->spi_modes;
    struct display_module *module = &out->module;
    const unsigned last_line = out->panel.start_lines ? out->panel.start_lines - 1u : 0;
    if (!take_speed(out, arguments, err) || !take_mode(out, arguments, err) || !take_size(out, arguments, err) ||
        !take_memory(out, arguments, err) || !take_offset(out, arguments, err) ||
        !take_rotation(module, arguments, err) || !take_mirrors(out, arguments, err) ||
        !arguments_either(arguments, "--bgr", "--rgb", &module->bgr, err) ||
        !arguments_either(arguments, "--invert", "--no-invert", &module->invert, err) ||
        !take_number(&out->panel, "--contrast", 1, out->panel.contrast_max, &module->contrast, arguments, err) ||
        !take_number(&out->panel, "--start-line", 0, last_line, &module->start_line, arguments, err) ||
        !take_wiring(out, arguments, err))
        return false;
    module->converter = arguments_flag(arguments, "--converter");
    if (module->converter && !out->panel.has_converter)
        return error_set(err, "--converter: %s has no converter of the glass's voltage", out->panel.name);
    if (!display_module_check(&out->panel, module, err)) return false;
    note_mode(out, usual_modes);
    return true;
}

void module_choice_picture(const struct display_module *module, unsigned *w_px, unsigned *h_px)
{
    const bool exchanges = panel_rotation_exchanges(module->rotation);
    *w_px = exchanges ? module->h_px : module->w_px;
    *h_px = exchanges ? module->w_px : module->h_px;
}
