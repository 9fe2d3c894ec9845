/* SPDX-License-Identifier: MIT
 *
 * The driver itself is asked what it makes of the module, with pins that do nothing; the fields of its configuration
 * are the family's, see display.c. */
#include "displays/module_c.h"

#include "base/c_field.h"
#include "base/c_name.h"
#include "displays/idle_port.h"

#include <inttypes.h>

/* In screen.h's terms. */
static const char *lines_macro(const struct panel *panel)
{
    if (panel->step_x_px > 1 || panel->step_y_px > 1) return "SCREEN_PAGES_MEM_B";
    return pixels_head_b(panel->format, 1) ? "SCREEN_WIDE_MEM_B" : "SCREEN_MEM_B";
}

static void write_header(FILE *file, const struct module_choice *choice, const struct display *display,
                         const struct c_name *name)
{
    const struct panel *panel = display->panel;
    const bool is_mono = panel_choice_is_mono(&choice->panel);
    const struct lim_wireframe outlines = panel_choice_outlines(&choice->panel);

    fprintf(file, "/* A display's module, written by `limner module`. */\n");
    fprintf(file, "#ifndef %s_MODULE_H\n#define %s_MODULE_H\n\n#include \"screen.h\"\n\n", name->macro, name->macro);
    fprintf(file, "#define MODULE_NAME \"%s\"\n", choice->panel.name);
    fprintf(file, "#define MODULE_SPEED_HZ %" PRIu32 "u\n", choice->speed_hz);
    fprintf(file, "/* Modes of SPI that it takes, 1 << mode each: spi_modes.h. */\n#define MODULE_SPI_MODES %uu\n\n",
            (unsigned)choice->spi_modes);
    fprintf(file, "/* Of the panel, and so of the renderer's target. What its chip cannot turn is the camera's: "
                  "screen_turn_camera(). */\n");
    fprintf(file, "#define MODULE_W_PX %u\n#define MODULE_H_PX %u\n", panel->w_px, panel->h_px);
    fprintf(file, "#define MODULE_CAMERA_TURN %s\n", c_field_rotation_name(display->camera_turn));
    fprintf(file, "#define MODULE_FORMAT %s\n", c_field_format_name(panel->format));
    fprintf(file, "#define MODULE_MONO %d\n#define MODULE_ROUND %d\n", is_mono, panel->visible != NULL);
    fprintf(file, "/* A struct lim_wireframe that can be read on it. */\n#define MODULE_OUTLINES {.on = true");
    if (outlines.one_colour)
        fprintf(file, ", .one_colour = true, .colour = 0x%04X, .background = 0x%04X", outlines.colour,
                outlines.background);
    fprintf(file, "}\n\n");
    fprintf(file, "/* Bytes for screen_init() of so many lines. */\n");
    fprintf(file, "#define MODULE_LINES_MEM_B(n_lines) %s(MODULE_W_PX, n_lines)\n\n", lines_macro(panel));
    fprintf(file, "struct board;\n\nHAL_C_BEGIN\n\n");
    fprintf(file,
            "/* Sets the driver up without touching the hardware: panel_init(*panel) does. 0 or an enum panel_error. "
            "The board\n * outlives the panel. */\n");
    fprintf(
        file,
        "HAL_MUST_CHECK int module_setup(struct panel **panel, const struct board *board);\n\nHAL_C_END\n\n#endif\n");
}

static void write_source(FILE *file, const struct module_choice *choice, const struct display *display,
                         const struct c_name *name)
{
    const char *driver = choice->panel.family->driver;
    struct display_module module = choice->module;

    if (display->camera_turn) module.rotation = PANEL_UPRIGHT;
    fprintf(file, "/* A display's module, written by `limner module`. */\n");
    fprintf(file, "#include \"%s.h\"\n\n#include \"board.h\"\n#include \"panels.h\"\n\n", name->file);
    fprintf(file, "static struct %s display;\n\n", driver);
    fprintf(file, "int module_setup(struct panel **panel, const struct board *board)\n{\n");
    fprintf(file, "    const struct %s_config config = {\n", driver);
    choice->panel.family->write(file, &choice->panel, &module);
    fprintf(file, "    };\n\n    *panel = &display.panel;\n");
    fprintf(file, "    return %s_setup(&display, &%s, &config);\n}\n", driver, choice->panel.name);
}

static bool put(const struct module_choice *choice, const struct display *display, const char *path, bool is_header,
                struct outputs *outputs, struct error *err)
{
    char file_path[C_PATH_MAX_B];
    struct c_name name;
    if (!c_name_init(&name, path, err) || !c_path(file_path, path, is_header ? ".h" : ".c", err)) return false;
    FILE *file = outputs_open(outputs, file_path, err);
    if (!file) return false;
    (is_header ? write_header : write_source)(file, choice, display, &name);
    return outputs_close(file, file_path, err);
}

bool module_c_write(const struct module_choice *choice, const char *name, FILE *header, FILE *source, struct error *err)
{
    struct display display;
    struct c_name c_name;
    if (!idle_display_setup(&display, choice, err) || !c_name_init(&c_name, name, err)) return false;
    write_header(header, choice, &display, &c_name);
    write_source(source, choice, &display, &c_name);
    return true;
}

bool module_c_put(const struct module_choice *choice, const char *path, struct outputs *outputs, struct error *err)
{
    struct display display;
    return idle_display_setup(&display, choice, err) && put(choice, &display, path, true, outputs, err) &&
           put(choice, &display, path, false, outputs, err);
}
