/* SPDX-License-Identifier: MIT
 *
 * Text over frames on emulated glass of every kind: what is seen is the frame without it, on which this test writes
 * with the font's pictures. White and black are what they are in all formats, dithered or not. Where only changes are
 * sent, what stays is not. */
#include "render/caption.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/room_stage.h"
#include "unit/firmware/font_pictures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 6, RUNS = 20000, BORDER_PX = 2 };

/* Pixels that share bytes, side by side and one above the other; three bytes, and two; whole lines; round glass. */
static const struct glass_kind {
    const char *panel;
    uint16_t w_px, h_px;
} KINDS[] = {{"ssd1306", 128, 64}, {"pcd8544", 84, 48},        {"ssd0323", 128, 64},        {"ssd1327", 96, 96},
             {"st7789", 101, 77},  {"st7789:rgb444", 101, 77}, {"ili9341:rgb666", 101, 77}, {"ssd1351", 96, 64},
             {"gc9a01", 240, 240}, {"ls013b7dh03", 128, 128}};

static struct font_pictures font;

static void start(struct simulator *simulator, const struct lim_scene *scene, const struct glass_kind *kind,
                  enum lim_method method)
{
    const struct simulator_setup setup = {kind->w_px, kind->h_px, method, SIMULATOR_PANEL, NULL};
    struct panel_choice choice;
    struct error err;

    if (!panel_choice_parse(kind->panel, NULL, &choice, &err) ||
        !simulator_init_on(simulator, scene, &setup, &choice, &err))
        fail_msg("%s: %s", kind->panel, err.text);
}

/* In the middle, an eighth of the height below the upper edge: white on a black box. */
static uint16_t ought_at(const struct glass_kind *kind, const char *text, const uint16_t *plain, int x, int y)
{
    const int ink_px = FONT_CELL_PX * (int)strlen(text) - 1, w_px = ink_px + 2 * BORDER_PX;
    const int h_px = FONT_ROWS - 1 + 2 * BORDER_PX, x0 = (kind->w_px - w_px) / 2, y0 = kind->h_px / 8;
    bool in_cell;

    if (x < x0 || x >= x0 + w_px || y < y0 || y >= y0 + h_px) return plain[y * kind->w_px + x];
    return font_pictures_at(&font, text, 1, x - x0 - BORDER_PX, y - y0 - BORDER_PX, &in_cell) ? 0xFFFF : 0;
}

static void assert_seen(const struct glass_kind *kind, const char *text, const uint16_t *plain, const uint16_t *seen)
{
    for (int i = 0; i < kind->w_px * kind->h_px; i++) {
        const int x = i % kind->w_px, y = i / kind->w_px;
        const uint16_t ought = ought_at(kind, text, plain, x, y);
        if (seen[i] != ought) fail_msg("%s: %d, %d is %04x, not %04x", kind->panel, x, y, seen[i], ought);
    }
}

static void draw(struct simulator *simulator, const struct lim_camera *camera)
{
    struct error err;

    if (!simulator_frame(simulator, camera, &err)) fail_msg("%s", err.text);
}

/* Every second frame is the one before it. */
static void fly(struct room_stage *stage, const struct glass_kind *kind, enum lim_method method, bool delta,
                bool antialias)
{
    struct simulator *plain = calloc(1, sizeof *plain), *captioned = calloc(1, sizeof *captioned);
    struct caption caption;
    struct lim_camera camera;
    struct error err;

    start(plain, &stage->scene.scene, kind, method);
    start(captioned, &stage->scene.scene, kind, method);
    assert_true(simulator_set_antialias(plain, antialias, &err) && simulator_set_antialias(captioned, antialias, &err));
    assert_true(!delta || simulator_set_delta(captioned, RUNS, &err));
    for (int i = 0; i < effort(FRAMES); i++) {
        char text[32];
        if (i % 4 == 0) camera = room_stage_view(stage, kind->w_px, kind->h_px);
        caption_set(&caption, "No. # [g]", (size_t)i / 2, captioned);
        snprintf(text, sizeof text, "No. %d [g]", i / 2);
        draw(plain, &camera);
        draw(captioned, &camera);
        assert_seen(kind, text, plain->pixels, captioned->pixels);
        if (delta && i % 2) assert_int_equal(simulator_stats(captioned)->delta.windows, 0);
    }
    simulator_free(plain);
    simulator_free(captioned);
    free(plain);
    free(captioned);
}

static void all_glass_shows_it(void **state)
{
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++)
        fly(*state, &KINDS[i], LIM_NEAREST_FIRST, false, false);
}

static void all_glass_shows_its_changes(void **state)
{
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++)
        fly(*state, &KINDS[i], LIM_NEAREST_FIRST, true, false);
}

static void other_methods_and_smooth_edges_show_it(void **state)
{
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i += 2) {
        fly(*state, &KINDS[i], LIM_PAINTER, i % 4, false);
        fly(*state, &KINDS[i], LIM_NEAREST_FIRST, i % 4, true);
    }
}

static void what_the_font_has_not_is_refused(void **state)
{
    char most[CAPTION_MOST + 2];
    struct error err;

    (void)state;
    memset(most, '#', sizeof most);
    most[CAPTION_MOST] = '\0';
    assert_true(caption_check(most, &err));
    most[CAPTION_MOST] = '#';
    most[CAPTION_MOST + 1] = '\0';
    assert_false(caption_check(most, &err));
    assert_false(caption_check("", &err));
    assert_false(caption_check("a\tb", &err));
    assert_false(caption_check("\303\244", &err));
    assert_true(caption_check(" ~", &err));
}

static int set_up(void **state)
{
    font_pictures_read(&font);
    return room_stage_set_up(state, 2210);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_glass_shows_it),
        cmocka_unit_test(all_glass_shows_its_changes),
        cmocka_unit_test(other_methods_and_smooth_edges_show_it),
        cmocka_unit_test(what_the_font_has_not_is_refused),
    };
    return cmocka_run_group_tests(tests, set_up, room_stage_tear_down);
}
