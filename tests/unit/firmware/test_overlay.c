/* SPDX-License-Identifier: MIT
 *
 * Text and figures over a line: each is compared, pixel by pixel, with a picture that this test makes of it in its own
 * way, beyond all borders, in pieces of lines, in lines' memory and through a target's fill(). Numbers are read back.
 */
#include "overlay.h"

#include "colour.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"
#include "target.h"
#include "text.h"
#include "unit/firmware/font_pictures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 40, UNTOUCHED = 0x1234, CASES = 4000, NUMBERS = 200000 };

struct canvas {
    _Alignas(4) uint16_t pixels[H_PX][W_PX];
    uint8_t times[H_PX][W_PX]; /* that a pixel was filled */
};

static struct canvas is, ought;
static struct font_pictures font;

static void wipe(struct canvas *canvas)
{
    memset(canvas->times, 0, sizeof canvas->times);
    for (int i = 0; i < W_PX * H_PX; i++)
        canvas->pixels[i / W_PX][i % W_PX] = UNTOUCHED;
}

static void fill(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct canvas *canvas = look->ctx;

    assert_true(x0_px < x1_px && x1_px <= W_PX);
    for (int x = x0_px; x < x1_px; x++) {
        canvas->pixels[look->y_px][x] = look->colour;
        canvas->times[look->y_px][x]++;
    }
}

static const struct lim_target filled = {.w_px = W_PX, .h_px = H_PX, .ctx = &is, .fill = fill};
static const struct lim_target lent = {.w_px = W_PX, .h_px = H_PX};

/* What is drawn: one figure. */
struct figure {
    enum { BOX, FRAME, BAR, TEXT, KINDS } kind;
    struct lim_overlay_box box;
    uint16_t value, full, colour;
    char text[24];
    struct lim_text_style style;
};

static void draw(const struct figure *figure, const struct lim_overlay_line *line)
{
    switch (figure->kind) {
    case BOX:
        lim_overlay_box(line, &figure->box, figure->colour);
        return;
    case FRAME:
        lim_overlay_frame(line, &figure->box, figure->colour);
        return;
    case BAR:
        lim_overlay_bar(line, &figure->box, figure->value, figure->full, figure->colour);
        return;
    default:
        lim_text(line, figure->box.x_px, figure->box.y_px, figure->text, &figure->style);
    }
}

/* Whether a figure has a pixel, and its colour as a number. */
static bool pixel_of(const struct figure *figure, int x, int y, uint16_t *colour)
{
    const struct lim_overlay_box *box = &figure->box;
    const int right = x - box->x_px, down = y - box->y_px;
    bool is_inside = right >= 0 && down >= 0 && right < box->w_px && down < box->h_px;

    *colour = figure->colour;
    if (figure->kind == TEXT) {
        const int scale = figure->style.scale ? figure->style.scale : 1;
        const bool is_ink = font_pictures_at(&font, figure->text, scale, right, down, &is_inside);
        *colour = is_ink ? figure->style.colour : figure->style.background;
        return is_ink || (is_inside && figure->style.solid);
    }
    if (figure->kind == FRAME)
        return is_inside && (right == 0 || down == 0 || right == box->w_px - 1 || down == box->h_px - 1);
    if (figure->kind == BAR && figure->value < figure->full)
        return is_inside && (right + 1) * (long)figure->full <= box->w_px * (long)figure->value;
    return is_inside;
}

static void picture(const struct figure *figure)
{
    wipe(&ought);
    for (int i = 0; i < W_PX * H_PX; i++) {
        uint16_t colour;
        if (!pixel_of(figure, i % W_PX, i / W_PX, &colour)) continue;
        uint8_t bytes[2] = {(uint8_t)(colour >> 8), (uint8_t)colour};
        memcpy(&ought.pixels[i / W_PX][i % W_PX], bytes, 2);
        ought.times[i / W_PX][i % W_PX] = 1;
    }
}

static int16_t anywhere(struct random *random)
{
    return (int16_t)(random_in(random, 0, 9) ? random_in(random, -60, 110) : random_in(random, INT16_MIN, INT16_MAX));
}

static struct figure random_figure(struct random *random, int kind)
{
    struct figure figure = {.kind = (unsigned)kind};
    const int length = (int)random_in(random, 0, (int)sizeof figure.text - 1);

    figure.box = (struct lim_overlay_box){anywhere(random), anywhere(random), anywhere(random), anywhere(random)};
    figure.value = (uint16_t)random_in(random, 0, 300);
    figure.full = (uint16_t)random_in(random, 0, 200);
    figure.colour = (uint16_t)random_u64(random);
    for (int i = 0; i < length; i++)
        figure.text[i] = (char)(random_in(random, 0, 9) ? random_in(random, 32, 126) : random_in(random, 1, 255));
    figure.style = (struct lim_text_style){(uint16_t)random_u64(random), random_in(random, 0, 1),
                                           (uint16_t)random_u64(random), (uint8_t)random_in(random, 0, 5)};
    return figure;
}

/* Each pixel of it once, and none beside it. */
static void a_figure_is_its_picture(void **state)
{
    struct random random = {22};

    (void)state;
    for (int i = 0; i < effort(CASES); i++) {
        const struct figure figure = random_figure(&random, i % KINDS);
        wipe(&is);
        for (uint16_t y = 0; y < H_PX; y++)
            draw(&figure, &(const struct lim_overlay_line){y, 0, W_PX, NULL, &filled});
        picture(&figure);
        assert_memory_equal(is.pixels, ought.pixels, sizeof is.pixels);
        assert_memory_equal(is.times, ought.times, sizeof is.times);
    }
}

/* In memory, a line in one piece or in several, of which some are left out. */
static void pieces_of_a_line_are_what_the_line_is(void **state)
{
    struct random random = {23};

    (void)state;
    for (int i = 0; i < effort(CASES); i++) {
        const struct figure figure = random_figure(&random, i % KINDS);
        wipe(&is);
        picture(&figure);
        for (uint16_t y = 0; y < H_PX; y++) {
            for (uint16_t x0 = 0, x1; x0 < W_PX; x0 = x1) {
                x1 = (uint16_t)random_in(&random, x0 + 1, W_PX);
                if (random_in(&random, 0, 3))
                    draw(&figure, &(const struct lim_overlay_line){y, x0, x1, is.pixels[y], &lent});
                else
                    for (uint16_t x = x0; x < x1; x++)
                        ought.pixels[y][x] = UNTOUCHED;
            }
        }
        assert_memory_equal(is.pixels, ought.pixels, sizeof is.pixels);
    }
}

static unsigned runs_of(const struct canvas *canvas)
{
    unsigned runs = 0;

    for (int i = 0; i < W_PX * H_PX; i++)
        runs += i % W_PX == 0 || canvas->pixels[i / W_PX][i % W_PX] != canvas->pixels[i / W_PX][i % W_PX - 1];
    return runs;
}

/* The same character, as often as it fits. */
static void a_text_has_no_more_runs_than_its_constant(void **state)
{
    unsigned most = 0;

    (void)state;
    for (int i = 0; i < 2 * 5 * FONT_GLYPHS; i++) {
        const uint8_t scale = (uint8_t)(i / 2 % 5), n = (uint8_t)((W_PX - 2) / LIM_TEXT_W_PX / (scale ? scale : 1));
        struct figure figure = {.kind = TEXT, .box = {1, 1, 0, 0}, .colour = 0xFFFF};
        figure.style = (struct lim_text_style){0xFFFF, i % 2, 0x001F, scale};
        memset(figure.text, ' ' + i / 10, n);
        picture(&figure);
        const unsigned runs = runs_of(&ought) - H_PX;
        assert_true(runs <= LIM_TEXT_RUNS(n, scale));
        if (scale == 4 && runs > most) most = runs;
    }
    assert_true(most > LIM_TEXT_RUNS((W_PX - 2) / LIM_TEXT_W_PX / 4, 1)); /* the scale counts */
}

/* As text.h says. */
static void a_box_has_two_runs_a_line_and_a_frame_four(void **state)
{
    struct figure figure = {.kind = BOX, .box = {7, 3, 40, 11}, .value = 1, .full = 2, .colour = 0xFFFF};

    (void)state;
    picture(&figure);
    assert_int_equal(runs_of(&ought) - H_PX, 2 * 11);
    figure.kind = BAR;
    picture(&figure);
    assert_int_equal(runs_of(&ought) - H_PX, 2 * 11);
    figure.kind = FRAME;
    picture(&figure);
    assert_int_equal(runs_of(&ought) - H_PX, 2 * 2 + 4 * 9);
}

static void all_glyphs_are_distinct(void **state)
{
    (void)state;
    for (int a = 0; a < FONT_GLYPHS; a++)
        for (int b = 0; b < a; b++)
            assert_memory_not_equal(font.is_ink[a], font.is_ink[b], sizeof font.is_ink[a]);
}

static void integers_read_back(void **state)
{
    static const int32_t EDGES[] = {0, 9, 10, -1, -10, 99999, 1000000000, INT32_MAX, INT32_MIN, INT32_MIN + 1};
    struct random random = {24};

    (void)state;
    for (size_t i = 0; i < sizeof EDGES / sizeof *EDGES + 1000; i++) {
        const int32_t value =
            i < sizeof EDGES / sizeof *EDGES ? EDGES[i] : (int32_t)random_u64(&random) >> random_in(&random, 0, 31);
        char text[LIM_TEXT_INTEGER_B], expected[16];
        snprintf(expected, sizeof expected, "%ld", (long)value);
        assert_ptr_equal(lim_text_integer(text, value), text + strlen(expected));
        assert_string_equal(text, expected);
    }
}

/* Read as a whole number, without its point, the text is the nearest one to value * 10^decimals / 2^bits. */
static void assert_nearest(const char *text, int32_t value, int bits, int decimals)
{
    char digits[32], *to = digits;
    int64_t power = 1;

    for (int i = 0; i < decimals; i++)
        power *= 10;
    for (const char *at = text; *at; at++)
        if (*at != '.') *to++ = *at;
    *to = '\0';
    const int64_t found = strtoll(digits, NULL, 10), exact = value * power,
                  twice = 2 * (found * (INT64_C(1) << bits) - exact);
    assert_true(llabs(twice) <= INT64_C(1) << bits);
    if (llabs(twice) == INT64_C(1) << bits) assert_true(llabs(found) << bits > llabs(exact));
    const char *point = strchr(text, '.');
    assert_int_equal(point ? strlen(point + 1) : 0, decimals);
    assert_true((text[0] == '-') == (found < 0));
    const char *first = text + (text[0] == '-');
    assert_true(first[0] != '0' || first[1] == '.' || first[1] == '\0');
}

static void fixed_point_numbers_are_the_nearest(void **state)
{
    struct random random = {25};

    (void)state;
    for (int i = 0; i < effort(NUMBERS); i++) {
        const int bits = (int)random_in(&random, 0, 16), decimals = (int)random_in(&random, 0, 4);
        const int32_t value = i < 200 ? i - 100 : (int32_t)random_u64(&random) >> random_in(&random, 0, 31);
        char text[LIM_TEXT_FIXED_B + 1] = {0};
        text[LIM_TEXT_FIXED_B] = '!';
        const char *end = lim_text_fixed(text, value, (uint8_t)bits, (uint8_t)decimals);
        assert_int_equal(text[LIM_TEXT_FIXED_B], '!');
        assert_ptr_equal(end, text + strlen(text));
        assert_nearest(text, value, bits, decimals);
    }
}

static void some_numbers(void **state)
{
    char text[64];

    (void)state;
    lim_text_fixed(text, 6234, 8, 1);
    assert_string_equal(text, "24.4");
    lim_text_fixed(text, -128, 8, 2);
    assert_string_equal(text, "-0.50");
    lim_text_fixed(text, -1, 16, 4);
    assert_string_equal(text, "0.0000");
    lim_text_fixed(text, 65535, 16, 4);
    assert_string_equal(text, "1.0000");
    lim_text_integer(lim_text_fixed(text, 3, 1, 0), 7);
    assert_string_equal(text, "27");
}

static int read_font(void **state)
{
    (void)state;
    font_pictures_read(&font);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_figure_is_its_picture),
        cmocka_unit_test(pieces_of_a_line_are_what_the_line_is),
        cmocka_unit_test(a_text_has_no_more_runs_than_its_constant),
        cmocka_unit_test(a_box_has_two_runs_a_line_and_a_frame_four),
        cmocka_unit_test(all_glyphs_are_distinct),
        cmocka_unit_test(integers_read_back),
        cmocka_unit_test(fixed_point_numbers_are_the_nearest),
        cmocka_unit_test(some_numbers),
    };
    return cmocka_run_group_tests(tests, read_font, NULL);
}
