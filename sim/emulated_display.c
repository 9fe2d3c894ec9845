/* SPDX-License-Identifier: MIT
 *
 * The emulated families, each with what the others need to know of it. */
#include "emulated_display.h"

#include "rgb565.h"

#include <string.h>

struct emulation {
    const struct display_family *family;
    /* The chip's port. */
    struct emulated_port *(*init)(struct emulated_display *display, const char *name,
                                  const struct display_module *module);
    unsigned (*complaints)(const struct emulated_display *display, const char **last);
    void (*show)(const struct emulated_display *display, uint8_t *rgb);
};

/* MIPI DCS ----------------------------------------------------------------------------------- */

static struct emulated_port *dcs_init(struct emulated_display *display, const char *name,
                                      const struct display_module *module)
{
    emulated_dcs_init(&display->chip.dcs, &(struct emulated_module){.kind = emulated_kind_find(name),
                                                                    .w_px = module->w_px,
                                                                    .h_px = module->h_px,
                                                                    .ox_px = module->ox_px,
                                                                    .oy_px = module->oy_px,
                                                                    .ips = module->invert,
                                                                    .bgr = module->bgr});
    return &display->chip.dcs.port;
}

static unsigned dcs_complaints(const struct emulated_display *display, const char **last)
{
    *last = display->chip.dcs.complaint;
    return display->chip.dcs.complaints;
}

static void dcs_show(const struct emulated_display *display, uint8_t *rgb)
{
    emulated_dcs_show(&display->chip.dcs, 0, rgb, NULL);
}

/* Pages -------------------------------------------------------------------------------------- */

static struct emulated_port *pages_init(struct emulated_display *display, const char *name,
                                        const struct display_module *module)
{
    emulated_pages_init(&display->chip.pages, &(struct emulated_pages_module){.kind = emulated_pages_kind_find(name),
                                                                              .w_px = module->w_px,
                                                                              .h_px = module->h_px,
                                                                              .ox_px = module->ox_px,
                                                                              .negative = module->invert});
    return &display->chip.pages.port;
}

static unsigned pages_complaints(const struct emulated_display *display, const char **last)
{
    *last = display->chip.pages.complaint;
    return display->chip.pages.complaints;
}

static void pages_show(const struct emulated_display *display, uint8_t *rgb)
{
    for (unsigned y = 0; y < display->h_px; y++)
        for (unsigned x = 0; x < display->w_px; x++, rgb += 3)
            memset(rgb, emulated_pages_is_bright(&display->chip.pages, x, y) ? 0xFF : 0, 3);
}

/* Solomon Systech ---------------------------------------------------------------------------- */

static struct emulated_port *solomon_init(struct emulated_display *display, const char *name,
                                          const struct display_module *module)
{
    emulated_solomon_init(&display->chip.solomon,
                          &(struct emulated_solomon_module){.kind = emulated_solomon_kind_find(name),
                                                            .w_px = module->w_px,
                                                            .h_px = module->h_px,
                                                            .ox_px = module->ox_px,
                                                            .blue_first = module->bgr,
                                                            .negative = module->invert});
    return &display->chip.solomon.port;
}

static unsigned solomon_complaints(const struct emulated_display *display, const char **last)
{
    *last = display->chip.solomon.complaint;
    return display->chip.solomon.complaints;
}

static void solomon_show(const struct emulated_display *display, uint8_t *rgb)
{
    for (unsigned y = 0; y < display->h_px; y++)
        for (unsigned x = 0; x < display->w_px; x++, rgb += 3)
            emulated_solomon_see(&display->chip.solomon, x, y, rgb);
}

/* Sharp -------------------------------------------------------------------------------------- */

static struct emulated_port *sharp_init(struct emulated_display *display, const char *name,
                                        const struct display_module *module)
{
    (void)module; /* the parts come in one size and kind */
    emulated_sharp_init(&display->chip.sharp, emulated_sharp_kind_find(name), false);
    return &display->chip.sharp.port;
}

static unsigned sharp_complaints(const struct emulated_display *display, const char **last)
{
    *last = display->chip.sharp.complaint;
    return display->chip.sharp.complaints;
}

static void sharp_show(const struct emulated_display *display, uint8_t *rgb)
{
    for (unsigned y = 0; y < display->h_px; y++)
        for (unsigned x = 0; x < display->w_px; x++, rgb += 3)
            memset(rgb, emulated_sharp_is_white(&display->chip.sharp, x, y) ? 0xFF : 0, 3);
}

/* All of them -------------------------------------------------------------------------------- */

static const struct emulation EMULATIONS[] = {
    {&display_dcs, dcs_init, dcs_complaints, dcs_show},
    {&display_pages, pages_init, pages_complaints, pages_show},
    {&display_solomon, solomon_init, solomon_complaints, solomon_show},
    {&display_sharp, sharp_init, sharp_complaints, sharp_show},
};

void emulated_display_init(struct emulated_display *display, const struct panel_choice *choice,
                           const struct display_module *module)
{
    const struct emulation *emulation = EMULATIONS;
    while (emulation->family != choice->family)
        emulation++;
    display->emulation = emulation;
    display->name = choice->name;
    display->w_px = module->w_px;
    display->h_px = module->h_px;
    display->port = emulation->init(display, choice->name, module);
    display->port->deferred = true;
}

unsigned emulated_display_complaints(const struct emulated_display *display, const char **last)
{
    return display->emulation->complaints(display, last);
}

bool emulated_display_is_quiet(const struct emulated_display *display, struct error *err)
{
    const char *last;
    const unsigned complaints = emulated_display_complaints(display, &last);
    return complaints == 0 ||
           error_set(err, "emulated %s: %u complaints, the last: %s", display->name, complaints, last);
}

void emulated_display_show(const struct emulated_display *display, uint8_t *rgb)
{
    display->emulation->show(display, rgb);
}

void emulated_display_read(const struct emulated_display *display, uint8_t *rgb, uint16_t *pixels)
{
    const size_t pixel_count = (size_t)display->w_px * display->h_px;
    emulated_display_show(display, rgb);
    for (size_t i = 0; i < pixel_count; i++)
        pixels[i] = rgb565_from_rgb888(&rgb[3 * i]);
}
