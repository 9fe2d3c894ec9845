/* SPDX-License-Identifier: MIT
 *
 * The emulated families, each with what the others need to know of it. */
#include "glass/emulated_display.h"

#include "base/rgb565.h"
#include "displays/module_choice.h"
#include "glass/glass_choice.h"

#include <string.h>

struct emulation {
    /* The chip's port; NULL: it is none of the family. */
    struct emulated_port *(*init)(struct emulated_display *display, const struct glass *glass);
    unsigned (*complaints)(const struct emulated_display *display, const char **last);
    void (*show)(const struct emulated_display *display, uint8_t *rgb);
};

/* MIPI DCS ----------------------------------------------------------------------------------- */

static struct emulated_port *dcs_init(struct emulated_display *display, const struct glass *glass)
{
    if (!emulated_kind_find(glass->chip)) return NULL;
    emulated_dcs_init(&display->chip.dcs, glass);
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

static struct emulated_port *pages_init(struct emulated_display *display, const struct glass *glass)
{
    if (!emulated_pages_kind_find(glass->chip)) return NULL;
    emulated_pages_init(&display->chip.pages, glass);
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

static struct emulated_port *solomon_init(struct emulated_display *display, const struct glass *glass)
{
    if (!emulated_solomon_kind_find(glass->chip)) return NULL;
    emulated_solomon_init(&display->chip.solomon, glass);
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

/* The parts come in one size and kind. */
static struct emulated_port *sharp_init(struct emulated_display *display, const struct glass *glass)
{
    const struct emulated_sharp_kind *kind = emulated_sharp_kind_find(glass->chip);
    if (!kind) return NULL;
    emulated_sharp_init(&display->chip.sharp, kind, false);
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
    {dcs_init, dcs_complaints, dcs_show},
    {pages_init, pages_complaints, pages_show},
    {solomon_init, solomon_complaints, solomon_show},
    {sharp_init, sharp_complaints, sharp_show},
};

void emulated_display_init(struct emulated_display *display, const struct glass *glass)
{
    const struct emulation *emulation = EMULATIONS;
    while (!(display->port = emulation->init(display, glass)))
        emulation++;
    display->emulation = emulation;
    display->name = glass->chip;
    display->w_px = glass->w_px;
    display->h_px = glass->h_px;
    display->port->deferred = true;
}

void emulated_display_choose(struct emulated_display *display, const struct panel_choice *panel,
                             const struct display_module *module)
{
    const struct glass glass = glass_choose(panel, module);
    emulated_display_init(display, &glass);
}

unsigned emulated_display_complaints(const struct emulated_display *display, const char **last)
{
    return display->emulation->complaints(display, last);
}

void emulated_display_take_foreign(struct emulated_display *display)
{
    display->port->foreign = true;
}

unsigned emulated_display_notices(const struct emulated_display *display, const char **last)
{
    *last = display->port->notice;
    return display->port->notices;
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

/* The pixel of the upright glass that the viewer sees at x, y of a picture of w_px x h_px. */
static size_t glass_index(const struct display_module *module, unsigned w_px, unsigned h_px, unsigned x, unsigned y)
{
    const unsigned from_left = module->mirror ? w_px - 1 - x : x, from_right = w_px - 1 - from_left;
    const unsigned below = h_px - 1 - y;
    const unsigned column[] = {from_left, below, from_right, y}, row[] = {y, from_left, below, from_right};
    return (size_t)row[module->rotation] * module->w_px + column[module->rotation];
}

void emulated_display_read(const struct emulated_display *display, const struct display_module *module, uint8_t *rgb,
                           uint16_t *pixels)
{
    unsigned w_px, h_px;
    module_choice_picture(module, &w_px, &h_px);
    emulated_display_show(display, rgb);
    for (unsigned y = 0; y < h_px; y++)
        for (unsigned x = 0; x < w_px; x++)
            *pixels++ = rgb565_from_rgb888(&rgb[3 * glass_index(module, w_px, h_px, x, y)]);
}
