/* SPDX-License-Identifier: MIT
 *
 * Families of chips, and what is common to them: names, formats, sizes. */
#include "displays/display.h"

#include "base/c_field.h"
#include "base/choice.h"
#include "linux/code_words.h"

#include <stdio.h>
#include <string.h>

/* What a driver's configuration takes of a port and, by the same name, of a module or a chip: PIN(its name, the
 * port's), VALUE(name, of what). Listed once, to be filled in at run time and to be written as C for a board. Sharp's
 * DISP takes the backlight's place: it shows the picture or hides it. */
/* clang-format off */
#define DCS_FIELDS(PIN, VALUE) \
    PIN(bus, bus) PIN(dc, dc) PIN(reset, reset) PIN(backlight, backlight) PIN(tearing, tearing) PIN(clock, clock) \
    VALUE(w_px, module) VALUE(h_px, module) VALUE(mem_w_px, module) VALUE(mem_h_px, module) \
    VALUE(ox_px, module) VALUE(oy_px, module) VALUE(rotation, module) VALUE(mirror, module) \
    VALUE(flip_columns, module) VALUE(flip_rows, module) VALUE(bgr, module) VALUE(invert, module) VALUE(format, choice)
#define PAGES_FIELDS(PIN, VALUE) \
    PIN(bus, bus) PIN(dc, dc) PIN(reset, reset) PIN(backlight, backlight) PIN(clock, clock) \
    VALUE(w_px, module) VALUE(h_px, module) VALUE(ox_px, module) VALUE(rotation, module) VALUE(mirror, module) \
    VALUE(flip_columns, module) VALUE(flip_rows, module) VALUE(invert, module) VALUE(contrast, module) \
    VALUE(start_line, module) VALUE(shift, module) VALUE(wiring, module) VALUE(internal_reference, module)
#define SOLOMON_FIELDS(PIN, VALUE) \
    PIN(bus, bus) PIN(dc, dc) PIN(reset, reset) PIN(backlight, backlight) PIN(clock, clock) \
    VALUE(w_px, module) VALUE(h_px, module) VALUE(ox_px, module) VALUE(shift, module) VALUE(shift_turned, module) \
    VALUE(start_line, module) VALUE(rotation, module) VALUE(mirror, module) VALUE(flip_columns, module) \
    VALUE(flip_rows, module) VALUE(bgr, module) VALUE(invert, module) VALUE(contrast, module) \
    VALUE(converter, module) VALUE(format, choice)
#define SHARP_FIELDS(PIN, VALUE) \
    PIN(bus, bus) PIN(select, select) PIN(shown, backlight) PIN(clock, clock)
/* clang-format on */

#define FILL_PIN(field, of_port) .field = port->of_port,
#define FILL_VALUE(field, of) .field = of->field,
#define WRITE_PIN(field, of_board) c_field_of_board(file, #field, #of_board);
#define WRITE_VALUE(field, of) C_FIELD(file, #field, of->field);

/* MIPI DCS ----------------------------------------------------------------------------------- */

static bool dcs_family_chip(size_t index, struct panel_choice *out)
{
    const struct dcs_chip *chip = panels_dcs[index];
    if (!chip) return false;
    *out = (struct panel_choice){.family = &display_dcs,
                                 .chip = chip,
                                 .name = chip->name,
                                 .mem_w_px = chip->mem_w_px,
                                 .mem_h_px = chip->mem_h_px,
                                 .w_step_px = 1,
                                 .h_step_px = 1,
                                 .has_mode_pins = true,
                                 .exchanges = true,
                                 .flips = true,
                                 .formats = chip->formats,
                                 .format = chip->format};
    return true;
}

static int dcs_family_setup(struct display *display, const struct panel_choice *choice,
                            const struct display_module *module, const struct port *port)
{
    const struct dcs_config config = {DCS_FIELDS(FILL_PIN, FILL_VALUE)};
    display->panel = &display->driver.dcs.panel;
    return dcs_setup(&display->driver.dcs, choice->chip, &config);
}

static void dcs_family_write(FILE *file, const struct panel_choice *choice, const struct display_module *module)
{
    DCS_FIELDS(WRITE_PIN, WRITE_VALUE)
}

const struct display_family display_dcs = {.chip = dcs_family_chip,
                                           .driver = "dcs",
                                           .setup = dcs_family_setup,
                                           .write = dcs_family_write,
                                           .has_rows = true,
                                           .tells_refresh = true};

/* Pages -------------------------------------------------------------------------------------- */

static bool pages_family_chip(size_t index, struct panel_choice *out)
{
    const struct pages_chip *chip = panels_pages[index];
    if (!chip) return false;
    *out = (struct panel_choice){.family = &display_pages,
                                 .chip = chip,
                                 .name = chip->name,
                                 .mem_w_px = chip->mem_w_px,
                                 .mem_h_px = chip->mem_h_px,
                                 .w_step_px = 1,
                                 .h_step_px = 8,
                                 .has_wiring = chip->is_oled,
                                 .flips = chip->flip != NULL,
                                 .contrast_max = chip->contrast_max,
                                 .start_lines = chip->start_line ? chip->mem_h_px : 0,
                                 .formats = 1 << PANEL_MONO_PAGES,
                                 .format = PANEL_MONO_PAGES};
    return true;
}

static int pages_family_setup(struct display *display, const struct panel_choice *choice,
                              const struct display_module *module, const struct port *port)
{
    const struct pages_config config = {PAGES_FIELDS(FILL_PIN, FILL_VALUE)};
    display->panel = &display->driver.pages.panel;
    return pages_setup(&display->driver.pages, choice->chip, &config);
}

static void pages_family_write(FILE *file, const struct panel_choice *choice, const struct display_module *module)
{
    (void)choice;
    PAGES_FIELDS(WRITE_PIN, WRITE_VALUE)
}

const struct display_family display_pages = {
    .chip = pages_family_chip, .driver = "pages", .setup = pages_family_setup, .write = pages_family_write};

/* Solomon Systech ---------------------------------------------------------------------------- */

static bool solomon_family_chip(size_t index, struct panel_choice *out)
{
    const struct solomon_chip *chip = panels_solomon[index];
    if (!chip) return false;
    *out = (struct panel_choice){.family = &display_solomon,
                                 .chip = chip,
                                 .name = chip->name,
                                 .mem_w_px = chip->mem_w_px,
                                 .mem_h_px = chip->mem_h_px,
                                 .w_step_px = chip->column_px,
                                 .h_step_px = 1,
                                 .has_converter = chip->converter != 0,
                                 .exchanges = chip->remap_exchange != 0,
                                 .flips = true,
                                 .contrast_max = chip->contrast_max,
                                 .start_lines = chip->mem_h_px,
                                 .formats = chip->formats,
                                 .format = chip->format};
    return true;
}

static int solomon_family_setup(struct display *display, const struct panel_choice *choice,
                                const struct display_module *module, const struct port *port)
{
    const struct solomon_config config = {SOLOMON_FIELDS(FILL_PIN, FILL_VALUE)};
    display->panel = &display->driver.solomon.panel;
    return solomon_setup(&display->driver.solomon, choice->chip, &config);
}

static void solomon_family_write(FILE *file, const struct panel_choice *choice, const struct display_module *module)
{
    SOLOMON_FIELDS(WRITE_PIN, WRITE_VALUE)
}

const struct display_family display_solomon = {
    .chip = solomon_family_chip, .driver = "solomon", .setup = solomon_family_setup, .write = solomon_family_write};

/* Sharp -------------------------------------------------------------------------------------- */

static bool sharp_family_chip(size_t index, struct panel_choice *out)
{
    const struct sharp_chip *chip = panels_sharp[index];
    if (!chip) return false;
    *out = (struct panel_choice){.family = &display_sharp,
                                 .chip = chip,
                                 .name = chip->name,
                                 .mem_w_px = chip->w_px,
                                 .mem_h_px = chip->h_px,
                                 .w_step_px = chip->w_px,
                                 .h_step_px = chip->h_px,
                                 .formats = 1 << PANEL_MONO_LINES,
                                 .format = PANEL_MONO_LINES};
    return true;
}

static int sharp_family_setup(struct display *display, const struct panel_choice *choice,
                              const struct display_module *module, const struct port *port)
{
    const struct sharp_config config = {SHARP_FIELDS(FILL_PIN, FILL_VALUE)};
    if (module->rotation != PANEL_UPRIGHT || module->mirror || module->flip_columns || module->flip_rows)
        return PANEL_ERR_CONFIG;
    display->panel = &display->driver.sharp.panel;
    return sharp_setup(&display->driver.sharp, choice->chip, &config);
}

static void sharp_family_write(FILE *file, const struct panel_choice *choice, const struct display_module *module)
{
    (void)choice, (void)module;
    SHARP_FIELDS(WRITE_PIN, WRITE_VALUE)
}

const struct display_family display_sharp = {.chip = sharp_family_chip,
                                             .driver = "sharp",
                                             .setup = sharp_family_setup,
                                             .write = sharp_family_write,
                                             .selects = true};

/* All of them -------------------------------------------------------------------------------- */

static const struct display_family *const FAMILIES[] = {&display_dcs, &display_pages, &display_solomon, &display_sharp};
enum { FAMILY_COUNT = sizeof FAMILIES / sizeof FAMILIES[0] };

static const char *const FORMATS[PANEL_FORMATS] = {
    [PANEL_USUAL] = "usual",      [PANEL_RGB565] = "rgb565",     [PANEL_RGB444] = "rgb444",
    [PANEL_RGB666] = "rgb666",    [PANEL_RGB666_LOW] = "rgb666", [PANEL_MONO_PAGES] = "pages",
    [PANEL_MONO_LINES] = "lines", [PANEL_GREY4] = "grey4",
};

bool panel_choice_at(size_t index, struct panel_choice *out)
{
    for (size_t f = 0; f < FAMILY_COUNT; f++)
        for (size_t i = 0; FAMILIES[f]->chip(i, out); i++)
            if (index-- == 0) return true;
    return false;
}

bool panel_rotation_parse(const char *text, enum panel_rotation *out, struct error *err)
{
    static const char *const turns[] = {"0", "90", "180", "270"};
    for (int i = 0; i < 4; i++) {
        *out = (enum panel_rotation)i;
        if (strcmp(text, turns[i]) == 0) return true;
    }
    return error_set(err, "--rotate %s: must be 0, 90, 180 or 270 degrees, clockwise", text);
}

bool panel_rotation_exchanges(enum panel_rotation rotation)
{
    return rotation == PANEL_TURNED_90 || rotation == PANEL_TURNED_270;
}

bool panel_choice_is_mono(const struct panel_choice *choice)
{
    return choice->format == PANEL_MONO_PAGES || choice->format == PANEL_MONO_LINES;
}

struct lim_wireframe panel_choice_outlines(const struct panel_choice *choice)
{
    struct lim_wireframe wireframe = {.on = true, .one_colour = panel_choice_is_mono(choice)};
    if (choice->format == PANEL_MONO_PAGES) wireframe.colour = UINT16_MAX;
    if (choice->format == PANEL_MONO_LINES) wireframe.background = UINT16_MAX;
    return wireframe;
}

static const char *panel_name_at(const void *list, size_t index)
{
    struct panel_choice choice;
    (void)list;
    return panel_choice_at(index, &choice) ? choice.name : NULL;
}

static bool parse_format(const char *text, struct panel_choice *out, struct error *err)
{
    char names[64] = "";
    size_t used = 0;
    for (int i = 0; i < PANEL_FORMATS; i++) {
        if (!(out->formats >> i & 1)) continue;
        out->format = (enum panel_format)i;
        if (choice_is(text, strlen(text), FORMATS[i])) return true;
        used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "", FORMATS[i]);
    }
    return error_set(err, "--panel %s:%s: it does not take that format; there are %s", out->name, text, names);
}

bool panel_choice_parse(const char *text, const char *also, struct panel_choice *out, struct error *err)
{
    static const struct choice choice = {"--panel", "panel", panel_name_at, NULL};
    const size_t length = strcspn(text, ":");
    size_t index;
    if (!choice_find_part(&choice, text, length, also, &index, err)) return false;
    panel_choice_at(index, out);
    return !text[length] || parse_format(text + length + 1, out, err);
}

/* The glass upright, and the picture turned on it, is what may have been meant. */
static bool too_large(const struct panel_choice *choice, const struct display_module *module, unsigned mem_w_px,
                      unsigned mem_h_px, struct error *err)
{
    char lying[64] = "";
    if (choice->exchanges && module->h_px <= mem_w_px && module->w_px <= mem_h_px)
        snprintf(lying, sizeof lying, "; --size %ux%u --rotate 90 draws a lying picture", (unsigned)module->h_px,
                 (unsigned)module->w_px);
    return error_set(err, "--panel %s: %ux%u pixels do not fit into its memory of %ux%u%s", choice->name,
                     (unsigned)module->w_px, (unsigned)module->h_px, mem_w_px, mem_h_px, lying);
}

bool display_module_check(const struct panel_choice *choice, const struct display_module *module, struct error *err)
{
    const unsigned w_px = module->w_px, h_px = module->h_px;
    const unsigned mem_w_px = module->mem_w_px ? module->mem_w_px : choice->mem_w_px;
    const unsigned mem_h_px = module->mem_h_px ? module->mem_h_px : choice->mem_h_px;
    if (w_px > mem_w_px || h_px > mem_h_px) return too_large(choice, module, mem_w_px, mem_h_px, err);
    if (module->ox_px > mem_w_px - w_px || module->oy_px > mem_h_px - h_px)
        return error_set(err, "--panel %s: %ux%u pixels at %u,%u leave its memory of %ux%u", choice->name, w_px, h_px,
                         module->ox_px, module->oy_px, mem_w_px, mem_h_px);
    if (choice->w_step_px == mem_w_px && (w_px != mem_w_px || h_px != mem_h_px))
        return error_set(err, "--panel %s: %ux%u: it has %ux%u pixels, and no others", choice->name, w_px, h_px,
                         mem_w_px, mem_h_px);
    const bool is_width = w_px % choice->w_step_px == 0, is_height = h_px % choice->h_step_px == 0;
    if (!is_width || !is_height)
        return error_set(err, "--panel %s: %ux%u: its %s must be a multiple of %u pixels", choice->name, w_px, h_px,
                         is_width ? "height" : "width", is_width ? choice->h_step_px : choice->w_step_px);
    return module->ox_px % choice->w_step_px == 0 ||
           error_set(err, "--panel %s: glass begins at columns that are multiples of %u, not at %u", choice->name,
                     choice->w_step_px, module->ox_px);
}

static int set_nothing(void *ctx, bool high)
{
    (void)ctx, (void)high;
    return 0;
}

/* That without which the driver refuses the port, and with which it does not. NULL: it is not for want of a pin. */
static const char *missing_pin(const struct panel_choice *choice, const struct display_module *module,
                               const struct port *port)
{
    struct display trial;
    struct port with_dc = *port, with_select = *port;
    with_dc.dc = with_select.select = (struct pin){.set = set_nothing};
    if (choice->family->setup(&trial, choice, module, &with_dc) == 0) return "--dc";
    if (choice->family->setup(&trial, choice, module, &with_select) == 0) return "--select";
    return NULL;
}

/* A line that would be taken, and never used. */
static bool check_lines(const struct panel_choice *choice, const struct port *port, struct error *err)
{
    if (edge_is_wired(&port->tearing) && !choice->family->tells_refresh)
        return error_set(err, "--te: %s does not tell its refresh", choice->name);
    return !pin_is_wired(&port->select) || choice->family->selects ||
           error_set(err, "--select: %s is selected by --spi's device, or by --cs of --hid", choice->name);
}

bool display_setup(struct display *display, const struct panel_choice *choice, const struct display_module *module,
                   const struct port *port, struct error *err)
{
    struct display_module upright = *module;
    if (!display_module_check(choice, module, err) || !check_lines(choice, port, err)) return false;
    *display = (struct display){0};
    int code = choice->family->setup(display, choice, module, port);
    if (code == PANEL_ERR_CONFIG && module->rotation != PANEL_UPRIGHT) {
        upright.rotation = PANEL_UPRIGHT;
        display->camera_turn = module->rotation;
        code = choice->family->setup(display, choice, &upright, port);
    }
    const char *missing = code == PANEL_ERR_CONFIG ? missing_pin(choice, &upright, port) : NULL;
    if (missing) return error_set(err, "--panel %s: needs a pin, %s LINE", choice->name, missing);
    return code == 0 || error_set(err, "--panel %s: %s (%d)", choice->name, code_words(code), code);
}
