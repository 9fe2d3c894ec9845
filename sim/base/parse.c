/* SPDX-License-Identifier: MIT
 *
 * Form and range of option values; nothing here knows a scene. */
#include "base/parse.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

bool parse_number(const char *option, const char *text, double *out, struct error *err)
{
    char *end;
    errno = 0;
    *out = strtod(text, &end);
    return (end != text && *end == '\0' && errno == 0) || error_set(err, "%s %s: not a number", option, text);
}

bool parse_whole(const char *option, const char *text, uint32_t least, uint32_t most, uint32_t *out, struct error *err)
{
    double number;
    if (!parse_number(option, text, &number, err)) return false;
    if (!(number >= least && number <= most) || number != (uint32_t)number)
        return error_set(err, "%s %s: must be a whole number from %" PRIu32 " to %" PRIu32, option, text, least, most);
    *out = (uint32_t)number;
    return true;
}

/* Digits up to `stop`; 0 if there are none or too many. */
static unsigned parse_side(const char **at, char stop)
{
    unsigned side_px = 0;
    while (**at >= '0' && **at <= '9') {
        if (side_px <= PARSE_SIDE_MAX_PX) side_px = side_px * 10 + (unsigned)(**at - '0');
        ++*at;
    }
    return **at == stop && side_px <= PARSE_SIDE_MAX_PX ? side_px : 0;
}

bool parse_size(const char *text, unsigned *w_px, unsigned *h_px, struct error *err)
{
    const char *at = text;
    *w_px = parse_side(&at, 'x');
    if (*w_px) {
        at++;
        *h_px = parse_side(&at, '\0');
    }
    return (*w_px && *h_px) ||
           error_set(err, "--size %s: must be WxH, each from 1 to %d pixels", text, PARSE_SIDE_MAX_PX);
}

bool parse_bound(const char *option, const char *text, const char *unit, double *out, struct error *err)
{
    char *end;
    errno = 0;
    *out = strtod(text, &end);
    if (end == text || errno || (*end && strcmp(end, unit) != 0))
        return error_set(err, "%s %s: not a number of %s", option, text, unit);
    return *out > 0.0 || error_set(err, "%s %s: must be above 0", option, text);
}

bool parse_near(const char *text, double *near_m, struct error *err)
{
    return parse_number("--near", text, near_m, err) &&
           ((*near_m > 0.0 && isfinite(*near_m)) ||
            error_set(err, "--near %s: the near plane must lie in front of the eye", text));
}

bool parse_fov(const char *text, double *fov_deg, struct error *err)
{
    if (!parse_number("--fov", text, fov_deg, err)) return false;
    return (*fov_deg > 0.0 && *fov_deg < 180.0) ||
           error_set(err, "--fov %s: the vertical field of view must lie between 0 and 180 degrees", text);
}

bool parse_tolerance(const char *text, double *units, struct error *err)
{
    if (!parse_number("--tolerance", text, units, err)) return false;
    return (*units >= 0.0 && *units <= 1024.0) || error_set(err, "--tolerance %s: must be 0 to 1024 units", text);
}

bool parse_ram(const char *text, size_t *bytes, double *percent, struct error *err)
{
    uint32_t whole;
    if (strchr(text, '%')) return parse_bound("--ram", text, "%", percent, err);
    if (!parse_whole("--ram", text, 1, UINT32_MAX, &whole, err)) return false;
    *bytes = whole;
    return true;
}

bool parse_picture_path(const char *option, const char *path, const char *suffix, struct error *err)
{
    static const char *const others[] = {".png", ".gif", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".tga"};
    const char *own = strrchr(path, '.');
    if (!own || strcasecmp(own, suffix) == 0) return true;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcasecmp(own, others[i]) == 0)
            return error_set(err, "%s %s: it writes %s files; name it %.*s%s", option, path, suffix + 1,
                             (int)(own - path), path, suffix);
    return true;
}
