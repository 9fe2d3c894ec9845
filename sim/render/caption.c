/* SPDX-License-Identifier: MIT */
#include "render/caption.h"

#include "text.h"

#include <stdio.h>
#include <string.h>

enum { WHITE = 0xFFFF, BLACK = 0, BORDER_PX = 2, FRAME_DIGITS = 7 };

bool caption_check(const char *text, struct error *err)
{
    const size_t length = strlen(text);
    if (length < 1 || length > CAPTION_MOST)
        return error_set(err, "--overlay: a text has 1 to %d characters, not %zu", CAPTION_MOST, length);
    for (const char *at = text; *at; at++)
        if (*at < ' ' || *at > '~')
            return error_set(err, "--overlay: the font has ASCII 32 to 126, not byte %d", (unsigned char)*at);
    return true;
}

static lim_overlay_draw caption_draw;

static void caption_draw(void *ctx, const struct lim_overlay_line *line)
{
    const struct caption *caption = ctx;
    const struct lim_text_style style = {.colour = WHITE};
    lim_overlay_box(line, &caption->box, BLACK);
    lim_text(line, (int16_t)(caption->box.x_px + BORDER_PX), (int16_t)(caption->box.y_px + BORDER_PX), caption->text,
             &style);
}

/* A number takes the place of one character, and has at most FRAME_DIGITS. */
static void write_text(struct caption *caption, const char *text, size_t frame)
{
    char *to = caption->text;
    for (; *text; text++) {
        if (*text == '#')
            to += snprintf(to, FRAME_DIGITS + 1, "%zu", frame % 10000000);
        else
            *to++ = *text;
    }
    *to = '\0';
}

void caption_set(struct caption *caption, const char *text, size_t frame, struct simulator *simulator)
{
    const struct lim_target *target = &simulator->target;
    write_text(caption, text, frame);
    const int w_px = (int)strlen(caption->text) * LIM_TEXT_W_PX - 1 + 2 * BORDER_PX;
    const int h_px = LIM_TEXT_H_PX + 2 * BORDER_PX - 1; /* below the capitals, which have a row less, as above */
    const int x_px = (target->w_px - w_px) / 2, y_px = target->h_px / 8;
    caption->box = (struct lim_overlay_box){(int16_t)x_px, (int16_t)y_px, (int16_t)w_px, (int16_t)h_px};
    caption->overlay = (struct lim_overlay){
        .draw = caption_draw, .ctx = caption, .y0_px = (uint16_t)y_px, .y1_px = (uint16_t)(y_px + h_px)};
    simulator->core->set_overlay(simulator->lim, &caption->overlay);
}
