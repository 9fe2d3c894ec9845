/* SPDX-License-Identifier: MIT
 *
 * The emulated families, each with what the others need to know of it. */
#include "emulated_display.h"

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

/* All of them -------------------------------------------------------------------------------- */

static const struct emulation EMULATIONS[] = {
    {&display_dcs, dcs_init, dcs_complaints, dcs_show},
    {&display_pages, pages_init, pages_complaints, pages_show},
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

bool emulated_display_is_quiet(const struct emulated_display *display, struct error *err)
{
    const char *last;
    const unsigned complaints = display->emulation->complaints(display, &last);
    return complaints == 0 ||
           error_set(err, "emulated %s: %u complaints, the last: %s", display->name, complaints, last);
}

void emulated_display_show(const struct emulated_display *display, uint8_t *rgb)
{
    display->emulation->show(display, rgb);
}
