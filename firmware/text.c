/* SPDX-License-Identifier: MIT
 *
 * A line of a text is a row of each glyph: neighbouring pixels of one colour are one run, so each pixel is painted once
 * at most. */
#include "text.h"

#include "pixels/font.h"

#if LIM_HAS_OVERLAY

/* A run that is not painted yet. */
struct pen {
    const struct lim_overlay_line *line;
    const struct lim_text_style *style;
    int32_t x0_px;
    bool inked;
};

/* The run ends before x_px. */
static void pen_paint(const struct pen *pen, int32_t x_px)
{
    if (!pen->inked && !pen->style->solid) return;
    lim_overlay_fill(pen->line, pen->x0_px, x_px, pen->inked ? pen->style->colour : pen->style->background);
}

static void pen_move(struct pen *pen, int32_t x_px, bool inked)
{
    if (inked == pen->inked) return;
    pen_paint(pen, x_px);
    pen->x0_px = x_px;
    pen->inked = inked;
}

static const LIM_FLASH uint8_t *glyph_of(char character)
{
    const uint8_t code = (uint8_t)character;
    const bool is_known = code >= LIM_FONT_FIRST && code < LIM_FONT_FIRST + LIM_FONT_COUNT;

    return lim_font[(is_known ? code : (uint8_t)'?') - LIM_FONT_FIRST];
}

void lim_text(const struct lim_overlay_line *line, int16_t x_px, int16_t y_px, const char *text,
              const struct lim_text_style *style)
{
    const uint8_t scale = style->scale ? style->scale : 1;
    const int32_t depth_px = (int32_t)line->y_px - y_px;

    if (depth_px < 0 || depth_px >= LIM_TEXT_H_PX * scale) return;
    const uint8_t row = (uint8_t)(scale == 1 ? (uint16_t)depth_px : (uint16_t)depth_px / scale);
    struct pen pen = {line, style, x_px, false};
    int32_t x = x_px;
    for (; *text && x < line->x1_px; text++) {
        const LIM_FLASH uint8_t *column = glyph_of(*text), *const end = column + LIM_FONT_COLUMNS;
        for (; column < end; column++, x += scale)
            pen_move(&pen, x, *column >> row & 1);
        pen_move(&pen, x, false);
        x += scale;
    }
    pen_paint(&pen, x);
}

/* Digits of a number from its last one, so many at least. */
static char *put_digits(char *to, uint32_t number, uint8_t least)
{
    char digits[10];
    uint8_t n = 0;

    do {
        digits[n++] = (char)('0' + number % 10);
        number /= 10;
    } while (number || n < least);
    while (n)
        *to++ = digits[--n];
    *to = 0;
    return to;
}

static uint32_t put_sign(char **to, int32_t value)
{
    if (value >= 0) return (uint32_t)value;
    *(*to)++ = '-';
    return 0u - (uint32_t)value;
}

char *lim_text_integer(char *to, int32_t value)
{
    const uint32_t number = put_sign(&to, value);

    return put_digits(to, number, 1);
}

/* The fraction is below 2^16 and a power of ten at most 10^4: 32 bits hold their product and a half. */
char *lim_text_fixed(char *to, int32_t value, uint8_t fraction_bits, uint8_t decimals)
{
    uint32_t power = 1;

    LIM_ASSERT(fraction_bits <= 16 && decimals <= 4);
    for (uint8_t i = 0; i < decimals; i++)
        power *= 10;
    const uint32_t one = UINT32_C(1) << fraction_bits, magnitude = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
    uint32_t whole = magnitude >> fraction_bits, part = ((magnitude & (one - 1)) * power + one / 2) >> fraction_bits;
    if (part >= power) {
        whole++;
        part -= power;
    }
    if (value < 0 && (whole || part)) *to++ = '-';
    to = put_digits(to, whole, 1);
    if (!decimals) return to;
    *to++ = '.';
    return put_digits(to, part, decimals);
}

#endif
