/* SPDX-License-Identifier: MIT
 *
 * Draws the frames of cameras.h through one of the adapters over lim_send and prints each one's number and the hash of
 * what the display then shows, as `limner render --write-hashes` does:
 *
 *     send_frames esp_lcd|lvgl|tft_espi|lovyangfx [OPTION...]
 *
 * Options: at=X,Y the picture's corner on the display; swap: the sketch has set the other byte order; lines=N of a
 * block or a stripe; native: LVGL's format; abandon=N: of the second frame the program gives up at its piece N, and
 * draws it again; fail=N: the library refuses its call N (espfail: by ESP_FAIL), after which that frame is drawn again.
 * Before the first frame pixels are left out by lim_set_visible(), which the adapter refuses. Exits with 1 if the
 * display or the library complained. C, and C++, which has two libraries more. */
#include "limner.h" /* as the library of the tests is built, whatever the scene's header says */

#include "cameras.h"
#include "model.h"

#include "fake_display.h"
#include "limner_esp_lcd.h"
#include "limner_lvgl.h"
#ifdef __cplusplus
#include "limner_lovyangfx.h"
#include "limner_tft_espi.h"
#endif

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ABANDONED = -77, FRAMES_PER_S = 15, LINES_MOST = 400, WIDE = CAMERAS_W_PX > 20 };

MODEL_MEMORY(CAMERAS_W_PX, CAMERAS_H_PX);

static struct {
    int x_px, y_px, lines, abandon, fail;
    bool swap, native, espfail;
} option = {0, 0, 7, -1, -1, false, false, false};

enum { ASKS = MODEL_SCENE_METHOD != LIM_CONVEX && MODEL_SCENE_METHOD != LIM_PAINTER };
enum { LEFT, RIGHT, ABOVE, BELOW };
static int hidden;
static uint16_t frame;
static int pieces_left = -1; /* until the frame is abandoned */
static lim_send *library_send;

static int draw(void)
{
#ifdef MODEL_MOVERS
    static struct lim_instance instances[MODEL_MOVERS];
    lim_moved_at(model_movers, MODEL_MOVERS, (frame * 1000u + FRAMES_PER_S / 2) / FRAMES_PER_S, instances);
    return lim_movers_frame(model_memory.lim, &cameras[frame], instances, MODEL_MOVERS);
#else
    return lim_frame(model_memory.lim, &cameras[frame]);
#endif
}

/* What a program may put before an adapter's function. */
static int send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    if (pieces_left == 0) return ABANDONED;
    if (pieces_left > 0) pieces_left--;
    const int err = library_send(ctx, y_px, pixels, x_px, n_px);
    memset(model_memory.lines, 0xEE, model_memory.lines_b > LIM_LINE_B(CAMERAS_W_PX) ? 0 : model_memory.lines_b);
    return err;
}

static int begin(lim_send *send_pixels, void *ctx)
{
    library_send = send_pixels;
    return model_begin(&model_memory, send, ctx);
}

static int draw_again(void)
{
    if (frame == 1 && option.abandon >= 0) {
        pieces_left = option.abandon;
        if (draw() != ABANDONED) fake_complain("a frame that was abandoned has another result");
        pieces_left = -1;
    }
    int err = draw();
    if (err && option.fail >= 0) {
        printf("# refused: %d\n", err);
        option.fail = -1;
        if (err >= 0) fake_complain("an error that is not negative");
        err = draw();
    }
    return err;
}

/* On the left, on the right, lines above, a line below those that are sent. */
static void hide(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    (void)ctx;
    *x0_px = hidden == LEFT && y_px >= CAMERAS_H_PX / 2;
    *x1_px = (uint16_t)(CAMERAS_W_PX - (hidden == RIGHT && y_px >= CAMERAS_H_PX / 2));
    if ((hidden == ABOVE && y_px < 2) || (hidden == BELOW && y_px + 1 == CAMERAS_H_PX)) *x1_px = 0;
}

/* By methods that ask what is seen; the others send all. */
static void refuse_holes(void)
{
    lim_set_visible(model_memory.lim, hide);
    for (hidden = LEFT; hidden <= BELOW; hidden++) {
        const int err = draw();
        if (err != (ASKS ? LIM_ERR_TARGET : LIM_OK)) fake_complain("pixels were left out, and nobody said so");
    }
    lim_set_visible(model_memory.lim, NULL);
    fake_wipe();
}

static void show(void)
{
    if (fake_left_px()) fake_complain("a window was left open");
    printf("%u %016" PRIx64 "\n", frame, fake_hash(option.x_px, option.y_px, CAMERAS_W_PX, CAMERAS_H_PX));
    fake_wipe();
}

static int with_esp_lcd(void)
{
    static uint16_t blocks[2 * CAMERAS_W_PX * LINES_MOST];
    static struct limner_esp_lcd display;
    int something = 0;
    esp_lcd_panel_handle_t const panel = (esp_lcd_panel_handle_t)(void *)&something;

    display.memory = &model_memory;
    display.blocks = blocks;
    display.blocks_b = 4u * CAMERAS_W_PX * (unsigned)option.lines;
    display.x_px = option.x_px, display.y_px = option.y_px;
    for (int i = 0; i < 2; i++) {
        fake_esp_lcd_fail(0, i ? ESP_FAIL : ESP_ERR_INVALID_STATE);
        if (limner_esp_lcd_begin(&display, panel, (esp_lcd_panel_io_handle_t)(void *)&something) >= 0)
            fake_complain("an error that is not negative");
    }
    int err = limner_esp_lcd_begin(&display, panel, (esp_lcd_panel_io_handle_t)(void *)&something);
    if (!err) err = begin(limner_esp_lcd_send, &display);
    if (!err) refuse_holes();
    fake_esp_lcd_fail(option.fail, option.espfail ? ESP_FAIL : ESP_ERR_TIMEOUT);
    for (frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        err = draw_again();
        fake_esp_lcd_finish();
        if (!err) show();
    }
    return err;
}

static struct limner_lvgl view;

static int draw_stripe(void)
{
    return draw_again();
}

/* After each frame a part of the screen is drawn again, which changes nothing. */
static int with_lvgl(void)
{
    const lv_area_t coords = {option.x_px, option.y_px, option.x_px + CAMERAS_W_PX - 1, option.y_px + CAMERAS_H_PX - 1};
    const lv_area_t screen = {0, 0, FAKE_W_PX - 1, FAKE_H_PX - 1};
    const lv_area_t part = {coords.x1 + 5 * WIDE, coords.y1 + 9, coords.x2 - 4 * WIDE, coords.y2 + 3};
    const lv_color_format_t format = option.native ? LV_COLOR_FORMAT_RGB565 : LV_COLOR_FORMAT_RGB565_SWAPPED;

    view.frame = draw_stripe;
    int err = begin(limner_lvgl_send, &view);
    if (!err) lim_set_visible(model_memory.lim, limner_lvgl_visible);
    for (frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        fake_lvgl_refresh(format, option.lines, screen, coords, limner_lvgl_draw, &view);
        err = view.err;
        fake_lvgl_refresh(format, 3, part, coords, limner_lvgl_draw, &view);
        if (!err) err = view.err;
        if (!err) show();
    }
    fake_lvgl_refresh(LV_COLOR_FORMAT_RGB888, FAKE_H_PX, screen, coords, limner_lvgl_draw, &view);
    if (!err && view.err != LIM_ERR_TARGET) fake_complain("a stripe of another format was taken");
    return err;
}

#ifdef __cplusplus
/* Both libraries have these functions. */
template <class Library, class Display> static int with(Library *library, Display *display, lim_send *adapter_send)
{
    library->setSwapBytes(option.swap);
    int err = begin(adapter_send, display);
    if (!err) refuse_holes();
    if (library->fake_is_taken()) fake_complain("the bus is taken for a frame with holes");
    for (frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        err = draw_again();
        if (!err) show();
        if (library->fake_is_taken()) fake_complain("the bus is still taken after a frame");
        if (library->getSwapBytes() != option.swap) fake_complain("the sketch's byte order was changed");
    }
    frame = 0;
    display->x_px = FAKE_W_PX - CAMERAS_W_PX + 1;
    if (!err && draw() != LIM_ERR_TARGET) fake_complain("a picture beyond the display was taken");
    if (library->fake_is_taken()) fake_complain("the bus is taken for a frame that was refused");
    return err;
}

static int with_tft_espi(void)
{
    static TFT_eSPI tft;
    static struct limner_tft_espi display = {&tft, &model_memory, option.x_px, option.y_px, 0};
    return with(&tft, &display, limner_tft_espi_send);
}

static int with_lovyangfx(void)
{
    static lgfx::LGFX_Device lcd;
    static struct limner_lovyangfx display = {&lcd, &model_memory, option.x_px, option.y_px, 0};
    return with(&lcd, &display, limner_lovyangfx_send);
}
#endif

static int run(const char *library)
{
    if (!strcmp(library, "esp_lcd")) return with_esp_lcd();
    if (!strcmp(library, "lvgl")) return with_lvgl();
#ifdef __cplusplus
    if (!strcmp(library, "tft_espi")) return with_tft_espi();
    if (!strcmp(library, "lovyangfx")) return with_lovyangfx();
#endif
    return -1;
}

int main(int argc, char **argv)
{
    for (int i = 2; i < argc; i++) {
        if (!strcmp(argv[i], "swap")) option.swap = true;
        if (!strcmp(argv[i], "native")) option.native = true;
        if (!strcmp(argv[i], "espfail")) option.espfail = true;
        sscanf(argv[i], "at=%d,%d", &option.x_px, &option.y_px);
        sscanf(argv[i], "lines=%d", &option.lines);
        sscanf(argv[i], "abandon=%d", &option.abandon);
        sscanf(argv[i], "fail=%d", &option.fail);
    }
    fake_wipe();
    const int err = argc > 1 ? run(argv[1]) : -1;
    if (err) fprintf(stderr, "send_frames: %d\n", err);
    return err || fake_complaints();
}
