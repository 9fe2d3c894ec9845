/* SPDX-License-Identifier: MIT
 *
 * Constants by the names that hal/panel.h and hal/pixels.h give them. */
#include "base/c_field.h"

const char *c_field_rotation_name(enum panel_rotation rotation)
{
    static const char *const names[] = {
        [PANEL_UPRIGHT] = "PANEL_UPRIGHT",
        [PANEL_TURNED_90] = "PANEL_TURNED_90",
        [PANEL_TURNED_180] = "PANEL_TURNED_180",
        [PANEL_TURNED_270] = "PANEL_TURNED_270",
    };
    return names[rotation];
}

const char *c_field_format_name(enum panel_format format)
{
    static const char *const names[PANEL_FORMATS] = {
        [PANEL_USUAL] = "PANEL_USUAL",           [PANEL_RGB565] = "PANEL_RGB565",
        [PANEL_RGB444] = "PANEL_RGB444",         [PANEL_RGB666] = "PANEL_RGB666",
        [PANEL_RGB666_LOW] = "PANEL_RGB666_LOW", [PANEL_MONO_PAGES] = "PANEL_MONO_PAGES",
        [PANEL_MONO_LINES] = "PANEL_MONO_LINES", [PANEL_GREY4] = "PANEL_GREY4",
    };
    return names[format];
}

static void put(FILE *file, const char *name, const char *value)
{
    fprintf(file, "        .%s = %s,\n", name, value);
}

void c_field_flag(FILE *file, const char *name, bool on)
{
    if (on) put(file, name, "true");
}

void c_field_number(FILE *file, const char *name, uint16_t number)
{
    if (number) fprintf(file, "        .%s = %u,\n", name, number);
}

void c_field_wiring(FILE *file, const char *name, enum pages_wiring wiring)
{
    static const char *const names[] = {
        [PAGES_WIRING_USUAL] = "PAGES_WIRING_USUAL",
        [PAGES_WIRING_SEQUENTIAL] = "PAGES_WIRING_SEQUENTIAL",
        [PAGES_WIRING_ALTERNATIVE] = "PAGES_WIRING_ALTERNATIVE",
    };
    if (wiring) put(file, name, names[wiring]);
}

void c_field_rotation(FILE *file, const char *name, enum panel_rotation rotation)
{
    if (rotation) put(file, name, c_field_rotation_name(rotation));
}

void c_field_format(FILE *file, const char *name, enum panel_format format)
{
    if (format) put(file, name, c_field_format_name(format));
}

void c_field_of_board(FILE *file, const char *name, const char *of_board)
{
    fprintf(file, "        .%s = board->%s,\n", name, of_board);
}
