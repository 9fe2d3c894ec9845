/* SPDX-License-Identifier: MIT
 *
 * Profiles by their names, colours as RGB565. */
#include "core/core_parse.h"

#include "base/choice.h"
#include "base/rgb565.h"

#include <stdlib.h>
#include <string.h>

enum { COLOUR_DIGITS = 6 };

static const char *name_at(const void *list, size_t index)
{
    const struct core *const *of = list;
    return of[index] ? of[index]->name : NULL;
}

bool parse_precision(const char *text, const struct core **core, struct error *err)
{
    size_t index;
    if (!choice_find(&(struct choice){"--precision", "profile", name_at, cores}, text, &index, err)) return false;
    *core = cores[index];
    return true;
}

/* Six hexadecimal digits, then `stop`. */
static bool parse_colour(const char *text, char stop, uint16_t *rgb565)
{
    if (strspn(text, "0123456789abcdefABCDEF") != COLOUR_DIGITS || text[COLOUR_DIGITS] != stop) return false;
    *rgb565 = rgb565_nearest((uint32_t)strtoul(text, NULL, 16));
    return true;
}

bool parse_wireframe(const char *text, struct lim_wireframe *out, struct error *err)
{
    *out = (struct lim_wireframe){.on = true, .one_colour = text != NULL};
    return !text ||
           (parse_colour(text, ',', &out->colour) && parse_colour(text + COLOUR_DIGITS + 1, '\0', &out->background)) ||
           error_set(err, "--wireframe=%s: must be two colours, the line's and the background's: RRGGBB,RRGGBB", text);
}

bool parse_background(const char *text, uint16_t *out, struct error *err)
{
    return parse_colour(text, '\0', out) ||
           error_set(err, "--background %s: must be a colour, six hexadecimal digits: RRGGBB", text);
}
