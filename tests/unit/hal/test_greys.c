/* SPDX-License-Identifier: MIT
 *
 * Pieces of greys: any piece of any line is just what gathering the same pixels makes, and nothing beside it changes;
 * and the screen that keeps a picture of them. */
#include "greys.h"
#include "rigs/cmocka_ready.h"
#include "screen.h"

#include <string.h>

enum { W_PX = 32, LINE_B = W_PX / 2, H_PX = 5, OLD = 0x5A };

static uint8_t picture[H_PX][LINE_B] __attribute__((aligned(4)));

/* The piece by pixels_gather(), in an otherwise old line. */
static void gather(uint8_t *line, uint16_t colour, uint16_t y_px, uint16_t x0_px, uint16_t x1_px)
{
    uint16_t pixels[W_PX];
    uint8_t gathered[LINE_B] = {0};

    for (uint16_t x = 0; x < W_PX; x++)
        pixels[x] = colour;
    pixels_gather(PANEL_GREY4, gathered, (const uint8_t *)pixels, 0, y_px, W_PX);
    for (uint16_t x = x0_px; x < x1_px; x++) {
        const uint8_t mask = x & 1 ? 0x0F : 0xF0;
        line[x / 2] = (uint8_t)((line[x / 2] & ~mask) | (gathered[x / 2] & mask));
    }
}

static void any_piece_is_what_gathering_makes(void **state)
{
    (void)state;
    static const uint16_t COLOURS[] = {0, 0xFFFF, 0x1234, 0xABCD, 0x7BEF, 0x0841, 0xF800, 0x07E0};
    struct greys greys = {.picture = picture[0], .line_b = LINE_B};

    for (size_t c = 0; c < sizeof COLOURS / sizeof COLOURS[0]; c++) {
        greys_set(&greys, COLOURS[c]);
        assert_int_equal(greys.colour, COLOURS[c]);
        for (uint16_t x0 = 0; x0 < W_PX; x0++)
            for (uint16_t x1 = (uint16_t)(x0 + 1); x1 <= W_PX; x1++) {
                const uint16_t y = (uint16_t)((x0 * 7u + x1) % H_PX);
                uint8_t ought[H_PX][LINE_B];
                memset(picture, OLD, sizeof picture);
                memset(ought, OLD, sizeof ought);
                gather(ought[y], COLOURS[c], y, x0, x1);
                greys_fill(&greys, y, x0, x1);
                assert_memory_equal(picture, ought, sizeof ought);
            }
    }
}

/* A panel that remembers its window and what was sent to it. */
struct listener {
    struct panel panel;
    uint16_t window[4];
    const void *data;
    size_t n_px;
    int answer;
};

static int listen_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    struct listener *listener = panel->chip;

    memcpy(listener->window, (uint16_t[4]){x_px, y_px, w_px, h_px}, sizeof listener->window);
    return listener->answer;
}

static int listen_pixels(struct panel *panel, const void *data, size_t n_px)
{
    struct listener *listener = panel->chip;

    listener->data = data;
    listener->n_px = n_px;
    return 0;
}

static void listener_init(struct listener *listener, enum panel_format format, uint16_t w_px)
{
    static const struct panel_ops ops = {.window = listen_window, .pixels = listen_pixels};

    *listener = (struct listener){0};
    listener->panel = (struct panel){
        .ops = &ops, .chip = listener, .format = format, .w_px = w_px, .h_px = H_PX, .step_x_px = 2, .step_y_px = 1};
}

static uint32_t lines[SCREEN_PAGES_MEM_B(40, 1) / 4];

static int init(struct screen *screen, struct listener *listener, size_t picture_b)
{
    assert_int_equal(screen_init(screen, &listener->panel, LIM_NEAREST_FIRST, lines, sizeof lines), 0);
    assert_null(screen->target.fill);
    return screen_set_frame(screen, picture, picture_b);
}

static void a_screen_shows_its_picture_in_one_window(void **state)
{
    (void)state;
    struct listener listener;
    struct screen screen;
    uint8_t ought[H_PX][LINE_B] = {{0}};

    memset(picture, 0, sizeof picture);
    listener_init(&listener, PANEL_GREY4, W_PX);
    assert_int_equal(init(&screen, &listener, sizeof picture), 0);
    for (uint16_t y = 0; y < H_PX; y++) {
        struct lim_piece_look look = {&screen, (uint16_t)(y / 2 * 9999), y};
        screen.target.fill(&look, 3, (uint16_t)(20 + y));
        gather(ought[y], look.colour, y, 3, (uint16_t)(20 + y));
    }
    assert_int_equal(screen.target.show(&screen), 0);
    assert_memory_equal(listener.window, ((uint16_t[4]){0, 0, W_PX, H_PX}), sizeof listener.window);
    assert_ptr_equal(listener.data, picture);
    assert_int_equal(listener.n_px, W_PX * H_PX);
    assert_memory_equal(picture, ought, sizeof ought);
    listener.answer = -5;
    assert_int_equal(screen.target.show(&screen), -5);
}

static void a_picture_that_cannot_be_kept_is_refused(void **state)
{
    (void)state;
    struct listener listener;
    struct screen screen;

    listener_init(&listener, PANEL_GREY4, W_PX);
    assert_int_equal(init(&screen, &listener, sizeof picture - 1), LIM_ERR_MEMORY);
    assert_null(screen.target.fill);
    listener_init(&listener, PANEL_GREY4, W_PX - 2);
    assert_int_equal(init(&screen, &listener, sizeof picture), PANEL_ERR_UNSUPPORTED);
    listener_init(&listener, PANEL_RGB444, W_PX);
    assert_int_equal(init(&screen, &listener, sizeof picture), PANEL_ERR_UNSUPPORTED);
    assert_null(screen.target.show);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_piece_is_what_gathering_makes),
        cmocka_unit_test(a_screen_shows_its_picture_in_one_window),
        cmocka_unit_test(a_picture_that_cannot_be_kept_is_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
