/* SPDX-License-Identifier: MIT
 *
 * The test card, as whoever holds the display sees it, however it is turned and whoever turns it: what README says of
 * it, point by point; and the same in runs, for boards without memory for a line. */
#include "card.h"
#include "glass/listener.h"
#include "rigs/cmocka_ready.h"
#include "test_card.h"

#include <stdlib.h>
#include <string.h>

enum { PIXELS_MAX = 320 * 480 };

static struct module_choice choice;
static struct listener listener;
static struct display display;
static struct screen screen;
static uint32_t mem[SCREEN_WIDE_MEM_B(480, 2) / 4 + 2 * SCREEN_PAGE_B(480) / 4];
static uint8_t rgb[3 * PIXELS_MAX];
static uint16_t pixels[PIXELS_MAX];
static unsigned w_px, h_px;

/* Options of a module, in words. */
static void choose(const char *options)
{
    char text[200], *words[20], *rest = NULL;
    struct arguments arguments = {words, 0};
    struct error err;
    snprintf(text, sizeof text, "card %s", options);
    for (char *word = strtok_r(text, " ", &rest); word; word = strtok_r(NULL, " ", &rest))
        words[arguments.count++] = word;
    words[arguments.count] = NULL;
    if (!module_choice_parse(&choice, &arguments, &err)) fail_msg("%s", err.text);
    assert_int_equal(arguments.count, 1);
}

/* A driver for a module with these options, on one that has others, with so much memory for lines; what is seen goes to
 * pixels. */
static void draw_on(const char *glass_options, const char *options, size_t mem_b)
{
    struct error err;
    choose(glass_options);
    listener_init(&listener, &choice);
    choose(options);
    if (!display_setup(&display, &choice.panel, &choice.module, &listener.port, &err)) fail_msg("%s", err.text);
    assert_int_equal(panel_init(display.panel), 0);
    const enum lim_method method = mem_b < sizeof mem ? LIM_CONVEX : LIM_NEAREST_FIRST;
    assert_int_equal(screen_init(&screen, display.panel, method, mem, mem_b), 0);
    assert_int_equal(card_draw(&screen, display.camera_turn), 0);
    if (!emulated_display_is_quiet(&listener.display, &err)) fail_msg("%s", err.text);
    listener_read(&listener, rgb, pixels);
    module_choice_picture(&choice.module, &w_px, &h_px);
}

static void draw(const char *options, size_t mem_b)
{
    draw_on(options, options, mem_b);
}

static uint16_t at(unsigned x_px, unsigned y_px)
{
    return pixels[(size_t)y_px * w_px + x_px];
}

static void assert_card(void)
{
    const unsigned last_x = w_px - 1, last_y = h_px - 1, side = (w_px < h_px ? w_px : h_px) / 4;
    assert_int_equal(at(0, 0), 0xF800); /* red, green, blue from the top left on, clockwise */
    assert_int_equal(at(last_x, 0), 0x07E0);
    assert_int_equal(at(last_x, last_y), 0x001F);
    assert_int_equal(at(0, last_y), 0); /* a ramp of greys begins black and ends white */
    assert_int_equal(at(side - 1, last_y), 0xFFFF);
    for (unsigned x = 1; x < side; x++)
        assert_true(at(x, last_y) >= at(x - 1, last_y));
    assert_int_equal(at(side - 1, side - 1), 0xF800);
    assert_int_equal(at(side, side), 0); /* the middle is black */
    assert_int_equal(at(w_px / 2, h_px / 2), 0);
    for (unsigned x = side; x < w_px - side; x++) { /* a white line all round */
        assert_int_equal(at(x, 0), 0xFFFF);
        assert_int_equal(at(x, last_y), 0xFFFF);
        assert_int_equal(at(x, 1), 0);
    }
    for (unsigned y = side; y < h_px - side; y++) {
        assert_int_equal(at(0, y), 0xFFFF);
        assert_int_equal(at(last_x, y), 0xFFFF);
        assert_int_equal(at(1, y), 0);
    }
}

static void its_viewer_sees_it_upright_however_the_module_is_turned(void **state)
{
    (void)state;
    static const char *const turns[] = {"0", "90", "180", "270"};
    static const char *const modules[] = {"--panel st7789 --size 135x240", "--panel ili9341", "--panel st7735",
                                          "--panel ssd1351 --size 128x96", "--panel st7796 --size 222x480"};
    for (int module = 0; module < 5; module++)
        for (int turn = 0; turn < 4; turn++) {
            char options[100];
            snprintf(options, sizeof options, "%s --rotate %s", modules[module], turns[turn]);
            draw(options, sizeof mem);
            assert_card();
        }
}

/* How much of a corner is lit. */
static unsigned lit_px(unsigned x0_px, unsigned y0_px, unsigned side_px)
{
    unsigned lit = 0;
    for (unsigned y = y0_px; y < y0_px + side_px; y++)
        for (unsigned x = x0_px; x < x0_px + side_px; x++)
            lit += at(x, y) != 0;
    return lit;
}

/* Where the camera turns what the chip cannot: brightness of the corners tells them apart, and only the ramp has its
 * light on one side. */
static void black_and_white_has_the_same_corners(void **state)
{
    (void)state;
    static const char *const turns[] = {"0", "90", "180", "270"};
    for (int turn = 0; turn < 4; turn++) {
        char options[100];
        snprintf(options, sizeof options, "--panel ssd1306 --rotate %s", turns[turn]);
        draw(options, sizeof mem);
        const unsigned green = lit_px(w_px - 16, 0, 16), red = lit_px(0, 0, 16),
                       blue = lit_px(w_px - 16, h_px - 16, 16);
        assert_true(green > red && red > blue && blue > 0);
        assert_true(lit_px(0, h_px - 8, 8) + 20 < lit_px(8, h_px - 8, 8));
        for (unsigned x = 16; x < w_px - 16; x++)
            assert_true(at(x, 0) && at(x, h_px - 1) && !at(x, 1));
    }
}

static void runs_draw_what_lines_do(void **state)
{
    (void)state;
    static const char *const modules[] = {"--panel ssd1306", "--panel ssd1306 --rotate 180",
                                          "--panel ssd1306 --rotate 90", "--panel sh1106", "--panel pcd8544"};
    static uint16_t by_lines[PIXELS_MAX];
    for (int i = 0; i < 5; i++) {
        draw(modules[i], sizeof mem);
        memcpy(by_lines, pixels, sizeof pixels);
        memset(pixels, 0, sizeof pixels);
        draw(modules[i], SCREEN_PAGE_B(display.panel->w_px));
        assert_non_null(screen.target.fill);
        assert_memory_equal(by_lines, pixels, sizeof pixels[0] * w_px * h_px);
    }
}

/* The table of hal/README.md: what is seen of a module that is built otherwise than its driver was told, and that the
 * table's option mends it. */
static void what_is_seen_tells_which_option_mends_it(void **state)
{
    (void)state;
    enum { RED = 0xF800, GREEN = 0x07E0, BLUE = 0x001F, RAMP = 0 };
    static const struct {
        const char *panel, *told, *mending;
        uint16_t clockwise[4]; /* from the top left on */
    } rows[] = {
        {"st7789 --size 240x320", "", "--mirror-columns", {GREEN, RED, RAMP, BLUE}},
        {"st7789 --size 240x320", "", "--mirror-rows", {RAMP, BLUE, GREEN, RED}},
        {"st7789 --size 240x320", "", "--mirror-rows --mirror-columns", {BLUE, RAMP, RED, GREEN}},
        {"st7789", "--rgb", "--bgr", {BLUE, GREEN, RED, RAMP}},
        {"ili9341", "--bgr", "--rgb", {BLUE, GREEN, RED, RAMP}},
        {"st7789", "--no-invert", "--invert", {0x07FF, 0xF81F, 0xFFE0, 0xFFFF}},
        {"ili9341", "--invert", "--no-invert", {0x07FF, 0xF81F, 0xFFE0, 0xFFFF}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char told[100], mended[100];
        snprintf(told, sizeof told, "--panel %s %s", rows[i].panel, rows[i].told);
        snprintf(mended, sizeof mended, "--panel %s %s", rows[i].panel, rows[i].mending);
        draw_on(mended, told, sizeof mem);
        const uint16_t *corners = rows[i].clockwise;
        const unsigned right = w_px - 1, below = h_px - 1;
        const unsigned x[] = {0, right, right, 0}, y[] = {0, 0, below, below};
        for (int corner = 0; corner < 4; corner++)
            if (corners[corner] != RAMP) assert_int_equal(at(x[corner], y[corner]), corners[corner]);
        draw_on(mended, mended, sizeof mem);
        assert_card();
    }
}

/* Down to a pixel there is a card, with whatever of it there is room for. */
static void cards_may_be_small(void **state)
{
    (void)state;
    for (unsigned w = 1; w < 12; w++)
        for (unsigned h = 1; h < 12; h++)
            for (unsigned i = 0; i < w * h; i++) {
                const uint16_t rgb565 = test_card_px(i % w, i / w, w, h);
                const bool is_edge = i % w == 0 || i / w == 0 || i % w == w - 1 || i / w == h - 1;
                if (w < 4 || h < 4) assert_int_equal(rgb565, is_edge ? 0xFFFF : 0);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(its_viewer_sees_it_upright_however_the_module_is_turned),
        cmocka_unit_test(black_and_white_has_the_same_corners),
        cmocka_unit_test(runs_draw_what_lines_do),
        cmocka_unit_test(what_is_seen_tells_which_option_mends_it),
        cmocka_unit_test(cards_may_be_small),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
