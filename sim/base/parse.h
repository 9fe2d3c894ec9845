/* SPDX-License-Identifier: MIT
 *
 * Values of command-line options that more than one command takes. Each refusal names the option. */
#ifndef SIM_PARSE_H
#define SIM_PARSE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PARSE_SIDE_MAX_PX = 1024 };

bool parse_number(const char *option, const char *text, double *out, struct error *err);

/* A whole number, 4e7 too. */
bool parse_whole(const char *option, const char *text, uint32_t least, uint32_t most, uint32_t *out, struct error *err);

/* --size WxH */
bool parse_size(const char *text, unsigned *w_px, unsigned *h_px, struct error *err);

/* A number above 0, with its unit or without: `0.03%`, `0.25px`. */
bool parse_bound(const char *option, const char *text, const char *unit, double *out, struct error *err);

/* --ram: bytes, or a share, as `70%`. */
bool parse_ram(const char *text, size_t *bytes, double *percent, struct error *err);

/* --near M */
bool parse_near(const char *text, double *near_m, struct error *err);

/* --fov DEG: above 0 and below 180. */
bool parse_fov(const char *text, double *fov_deg, struct error *err);

/* A picture's file: the name of another kind of picture than `suffix` (".png") is refused. */
bool parse_picture_path(const char *option, const char *path, const char *suffix, struct error *err);

/* --tolerance UNITS */
bool parse_tolerance(const char *text, double *units, struct error *err);

#endif
