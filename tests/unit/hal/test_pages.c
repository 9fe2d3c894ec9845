/* SPDX-License-Identifier: MIT
 *
 * Monochrome panels of pages, beside what test_every_panel.c shows of all panels: with and without reset, glass of any
 * make, what a chip cannot, windows and pieces, and addresses that are cut short. */
#include "fakes/fault_port.h"
#include "glass/emulated_pages.h"
#include "panels.h"
#include "rigs/cmocka_ready.h"
#include "screen.h"
#include "test_card.h"

#include <math.h>
#include <string.h>

enum { MOST_W_PX = 132, MOST_H_PX = 64, MESSAGE_B = 60 };

struct piece {
    uint16_t x, n;
};

static struct rig {
    struct emulated_pages chip;
    struct fault_port fault;
    struct pages_config config;
    struct pages display;
    struct screen screen;
    uint32_t mem[SCREEN_PAGES_MEM_B(MOST_W_PX, MOST_H_PX) / 4];
    unsigned card; /* another ramp each */
} rig;

static void rig_setup(const struct pages_chip *driver, uint16_t w_px, uint16_t h_px)
{
    const uint16_t ox_px = (uint16_t)((driver->mem_w_px - w_px) / 3);
    const struct glass glass = glass_like(driver->name, w_px, h_px, ox_px, 0);
    emulated_pages_init(&rig.chip, &glass);
    rig.chip.port.deferred = true;
    rig.fault = (struct fault_port){.bus = emulated_port_bus(&rig.chip.port),
                                    .dc = {.inner = emulated_port_dc(&rig.chip.port)},
                                    .reset = {.inner = emulated_port_reset(&rig.chip.port)},
                                    .backlight = {.inner = emulated_port_backlight(&rig.chip.port)},
                                    .clock = emulated_port_clock(&rig.chip.port),
                                    .pending_b = &rig.chip.port.pending_b};
    fault_port_arm(&rig.fault, -1);
    rig.config = (struct pages_config){.bus = fault_port_bus(&rig.fault),
                                       .dc = fault_port_pin(&rig.fault, &rig.fault.dc),
                                       .reset = fault_port_pin(&rig.fault, &rig.fault.reset),
                                       .backlight = fault_port_pin(&rig.fault, &rig.fault.backlight),
                                       .clock = fault_port_clock(&rig.fault),
                                       .w_px = w_px,
                                       .h_px = h_px,
                                       .ox_px = ox_px};
}

static void rig_open(const struct pages_chip *driver, unsigned n_lines)
{
    assert_int_equal(pages_setup(&rig.display, driver, &rig.config), 0);
    const size_t mem_b = SCREEN_PAGES_MEM_B(rig.config.w_px, n_lines);
    assert_int_equal(screen_init(&rig.screen, &rig.display.panel, LIM_NEAREST_FIRST, rig.mem, mem_b), 0);
}

/* Red, green, blue and grey corners; a ramp elsewhere. */
static uint16_t card_px(unsigned x, unsigned y)
{
    uint16_t corner;

    return test_card_corner(x, y, rig.config.w_px, rig.config.h_px, &corner)
               ? corner
               : (uint16_t)(x * 211u + (y + 9 * rig.card) * 31u);
}

static void paint_line(uint16_t y)
{
    const struct lim_target *target = &rig.screen.target;
    uint8_t *line = target->lend(target->ctx, y);

    for (unsigned x = 0; x < target->w_px; x++) {
        line[2 * x] = (uint8_t)(card_px(x, y) >> 8);
        line[2 * x + 1] = (uint8_t)card_px(x, y);
    }
}

/* In pieces of at most piece_px. */
static int draw(unsigned piece_px)
{
    const struct lim_target *target = &rig.screen.target;

    const int late = screen_begin_frame(&rig.screen);
    if (late) return late;
    for (uint16_t y = 0; y < target->h_px; y++) {
        paint_line(y);
        for (unsigned x = 0; x < target->w_px; x += piece_px) {
            const unsigned n = target->w_px - x < piece_px ? target->w_px - x : piece_px;
            const int err = target->done(target->ctx, y, (uint16_t)x, (uint16_t)n);
            if (err) return err;
        }
    }
    return screen_end_frame(&rig.screen);
}

/* Bayer's order of 2^k x 2^k, from that of half the size: each quarter is filled in the order of the whole. */
static unsigned order_of(unsigned x, unsigned y, unsigned k)
{
    static const unsigned two[2][2] = {{0, 2}, {3, 1}};

    return k ? 4 * order_of(x % (1u << (k - 1)), y % (1u << (k - 1)), k - 1) + two[y >> (k - 1) & 1][x >> (k - 1) & 1]
             : 0;
}

static bool is_bright(unsigned x, unsigned y)
{
    const uint16_t px = card_px(x, y);
    const double level = 0.299 * (px >> 11) / 31 + 0.587 * (px >> 5 & 63) / 63 + 0.114 * (px & 31) / 31;

    return level + (2 * order_of(x % 8, y % 8, 3) + 1) / 128.0 >= 1.0;
}

/* Nearly all: on a threshold the brightness, rounded to 2^-16, may fall otherwise. */
static void assert_shown(bool turned, bool mirrored, bool inverted)
{
    unsigned wrong = 0;

    for (unsigned y = 0; y < rig.config.h_px; y++)
        for (unsigned x = 0; x < rig.config.w_px; x++) {
            const unsigned right = rig.config.w_px - 1u - x, below = rig.config.h_px - 1u - y;
            const bool shown = emulated_pages_is_bright(&rig.chip, turned != mirrored ? right : x, turned ? below : y);
            wrong += shown != (is_bright(x, y) != inverted);
        }
    if (rig.chip.complaints) fail_msg("%u complaints, the last: %s", rig.chip.complaints, rig.chip.complaint);
    if (wrong > 4) fail_msg("%s: %u pixels are wrong", rig.display.chip->name, wrong);
}

static void check_card(const struct pages_chip *chip, uint16_t w_px, uint16_t h_px)
{
    for (unsigned way = 0; way < (chip->flip ? 4u : 1u); way++)
        for (unsigned wired = 0; wired < 2; wired++) {
            rig_setup(chip, w_px, h_px);
            rig.config.rotation = way & 1 ? PANEL_TURNED_180 : PANEL_UPRIGHT;
            rig.config.mirror = way & 2;
            rig.config.bus.message_b = wired ? MESSAGE_B : 0;
            if (!wired) rig.config.reset.set = NULL;
            rig_open(chip, 2);
            assert_int_equal(panel_init(&rig.display.panel), 0);
            assert_int_equal(draw(wired ? w_px : 7), 0);
            assert_shown(way & 1, way & 2, false);
            assert_int_equal(panel_set_inverted(&rig.display.panel, true), 0);
            assert_shown(way & 1, way & 2, true);
        }
}

static void the_card_is_right_on_every_chip(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++) {
        check_card(panels_pages[i], panels_pages[i]->mem_w_px, panels_pages[i]->mem_h_px);
        check_card(panels_pages[i], 37, 32);
    }
}

/* Glass that shows memory from the other end, or bright where a pixel is off, and a configuration that says so. */
static void glass_of_any_make_shows_the_card(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++)
        for (unsigned make = 0; make < (panels_pages[i]->flip ? 8u : 2u); make++) {
            rig_setup(panels_pages[i], 48, 48);
            struct glass *glass = &rig.chip.glass;
            glass->negative = rig.config.invert = make & 1;
            if (make & 2) {
                glass->column = (uint16_t)(glass->mem_w_px - 1 - glass->column);
                glass->columns_back = !glass->columns_back;
                rig.config.flip_columns = true;
            }
            if (make & 4) {
                glass->line =
                    (uint16_t)(glass->told_lines ? glass_line(glass, 47) : glass->mem_h_px - 1u - glass->line);
                glass->lines_back = !glass->lines_back;
                rig.config.flip_rows = true;
            }
            rig_open(panels_pages[i], 2);
            assert_int_equal(panel_init(&rig.display.panel), 0);
            assert_int_equal(draw(48), 0);
            assert_shown(false, false, false);
        }
}

static void what_a_chip_cannot_is_refused(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++) {
        const struct pages_chip *chip = panels_pages[i];
        rig_setup(chip, 48, 48);
        const struct pages_config good = rig.config;
        struct pages_config bad[12];
        for (unsigned k = 0; k < 12; k++)
            bad[k] = good;
        bad[0].w_px = 0;
        bad[1].h_px = 20;
        bad[2].h_px = (uint16_t)(chip->mem_h_px + 8);
        bad[3].w_px = (uint16_t)(chip->mem_w_px + 1);
        bad[4].ox_px = (uint16_t)(chip->mem_w_px - 47);
        bad[5].rotation = PANEL_TURNED_90;
        bad[6].bus.write = NULL;
        bad[7].dc.set = NULL;
        bad[8].clock.delay = NULL;
        bad[9].shift = 64;
        bad[10].start_line = 64;
        bad[11].wiring = (enum pages_wiring)3;
        for (unsigned k = 0; k < 12; k++)
            assert_int_equal(pages_setup(&rig.display, chip, &bad[k]), PANEL_ERR_CONFIG);
        bad[0] = good;
        bad[0].shift = 63;
        assert_int_equal(pages_setup(&rig.display, chip, &bad[0]), chip->is_oled ? 0 : PANEL_ERR_CONFIG);
        bad[0] = good;
        bad[0].mirror = true;
        assert_int_equal(pages_setup(&rig.display, chip, &bad[0]), chip->flip ? 0 : PANEL_ERR_CONFIG);
        rig_open(chip, 1);
        assert_int_equal(panel_window(&rig.display.panel, 0, 4, 8, 8), PANEL_ERR_WINDOW);
        assert_int_equal(panel_window(&rig.display.panel, 0, 0, 49, 8), PANEL_ERR_WINDOW);
        assert_int_equal(panel_pixels(&rig.display.panel, rig.mem, 8), PANEL_ERR_WINDOW);
    }
}

/* Bytes of commands, beside the pixels' own. */
static uint64_t commands_of(const struct pages_chip *chip, uint16_t w_px, uint16_t h_px, uint16_t message_b)
{
    rig_setup(chip, w_px, h_px);
    rig.config.bus.message_b = message_b;
    rig_open(chip, 2);
    assert_int_equal(panel_init(&rig.display.panel), 0);
    const uint64_t before_b = rig.chip.port.bus_b;
    assert_int_equal(draw(w_px), 0);
    assert_shown(false, false, false);
    return rig.chip.port.bus_b - before_b - (uint64_t)w_px * h_px / 8;
}

/* A window is three messages: D/C, the address, D/C. Where it costs more than a page, delta output sends whole pages.
 */
static void a_frame_is_one_address_where_a_chip_goes_on_by_itself(void **state)
{
    static const struct {
        const struct pages_chip *chip;
        uint16_t w_px, h_px, message_b, commands_b, window_b, align_px;
    } frames[] = {{&ssd1306, 128, 64, 60, 8, 188, 128},  {&ssd1306, 40, 32, 1, 8, 11, 1},
                  {&ssd1306, 128, 64, 0, 8 * 3, 3, 1},   {&pcd8544, 84, 48, 60, 2, 182, 84},
                  {&pcd8544, 84, 48, 0, 2, 2, 1},        {&pcd8544, 83, 48, 60, 6 * 2, 182, 1},
                  {&sh1106, 132, 64, 60, 8 * 3, 183, 1}, {&st7567, 132, 64, 0, 8 * 3, 3, 1},
                  {&uc1701, 132, 32, 60, 4 * 3, 183, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++) {
        assert_int_equal(commands_of(frames[i].chip, frames[i].w_px, frames[i].h_px, frames[i].message_b),
                         frames[i].commands_b);
        assert_int_equal(rig.display.panel.window_b, frames[i].window_b);
        assert_int_equal(rig.screen.target.costs.x_align_px, frames[i].align_px);
    }
}

/* In parts of any size, over the ends of pages; and a byte more than it holds, which the chip does not get. */
static void check_window(const struct pages_chip *chip, enum panel_rotation rotation, uint16_t message_b, size_t part_b)
{
    enum { X_PX = 5, Y_PX = 8, W_PX = 21, H_PX = 24, WINDOW_B = W_PX * H_PX / 8 };
    static const uint8_t nothing[MOST_W_PX], all[WINDOW_B] = {[0 ... WINDOW_B - 1] = 0xFF};

    rig_setup(chip, 48, 48);
    rig.config.rotation = rotation;
    rig.config.bus.message_b = message_b;
    rig_open(chip, 1);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(panel_init(panel), 0);
    assert_int_equal(panel_window(panel, 0, 0, 48, 48), 0);
    for (unsigned i = 0; i < 6; i++)
        assert_int_equal(panel_pixels(panel, nothing, 48 * 8), 0);
    assert_int_equal(panel_window(panel, X_PX, Y_PX, W_PX, H_PX), 0);
    for (size_t sent_b = 0; sent_b < WINDOW_B; sent_b += part_b)
        assert_int_equal(panel_pixels(panel, all, 8 * (WINDOW_B - sent_b < part_b ? WINDOW_B - sent_b : part_b)), 0);
    assert_int_equal(panel_flush(panel), 0);
    const uint64_t sent_b = rig.chip.port.bus_b;
    assert_int_equal(panel_pixels(panel, all, 8), PANEL_ERR_WINDOW);
    assert_int_equal(rig.chip.port.bus_b, sent_b);
    for (unsigned y = 0; y < 48; y++)
        for (unsigned x = 0; x < 48; x++) {
            const bool turned = rotation == PANEL_TURNED_180;
            const bool is_in = x >= X_PX && x < X_PX + W_PX && y >= Y_PX && y < Y_PX + H_PX;
            assert_int_equal(emulated_pages_is_bright(&rig.chip, turned ? 47 - x : x, turned ? 47 - y : y), is_in);
        }
    assert_int_equal(rig.chip.complaints, 0);
}

static void a_window_changes_what_is_in_it_alone(void **state)
{
    static const size_t parts_b[] = {1, 20, 21, 22, 63};

    (void)state;
    for (size_t i = 0; panels_pages[i]; i++)
        for (size_t k = 0; k < 2 * sizeof parts_b / sizeof *parts_b; k++) {
            const uint16_t message_b = k % 2 ? MESSAGE_B : 0;
            check_window(panels_pages[i], PANEL_UPRIGHT, message_b, parts_b[k / 2]);
            if (panels_pages[i]->flip) check_window(panels_pages[i], PANEL_TURNED_180, message_b, parts_b[k / 2]);
        }
}

/* As delta output sends them: lines of a page are taken in, and with the last of them pieces go out. */
static void draw_pieces(uint16_t page, const struct piece *pieces)
{
    const struct lim_target *target = &rig.screen.target;

    for (uint16_t y = (uint16_t)(8 * page); y < 8 * page + 8; y++) {
        paint_line(y);
        if (y % 8 < 7) assert_int_equal(target->done(target->ctx, y, 0, target->w_px), 0);
    }
    for (; pieces->n; pieces++)
        assert_int_equal(target->done(target->ctx, (uint16_t)(8 * page + 7), pieces->x, pieces->n), 0);
}

/* The second card in the pieces, the first elsewhere. How many pixels are not. */
static unsigned count_wrong(uint16_t page, const struct piece *pieces)
{
    unsigned wrong = 0;

    for (unsigned y = 8u * page; y < 8u * page + 8; y++)
        for (unsigned x = 0; x < rig.config.w_px; x++) {
            rig.card = 0;
            for (const struct piece *piece = pieces; piece->n; piece++)
                rig.card |= x >= piece->x && x < piece->x + (unsigned)piece->n;
            wrong += emulated_pages_is_bright(&rig.chip, x, y) != is_bright(x, y);
        }
    rig.card = 0;
    return wrong;
}

static void check_pieces(const struct pages_chip *chip, uint16_t message_b)
{
    static const struct piece pieces[8][4] = {
        {{10, 5}, {20, 1}, {70, 14}},
        {{0, 84}},
        {{0, 84}},
        {{0, 3}, {9, 5}},
        {{0, 9}, {9, 75}},
        {{83, 1}},
        {{0, 1}, {3, 1}},
        {{0, 84}},
    };
    const uint16_t n_pages = chip->mem_h_px / 8;
    unsigned wrong = 0;

    rig_setup(chip, 84, chip->mem_h_px);
    rig.config.bus.message_b = message_b;
    rig_open(chip, 2);
    assert_int_equal(panel_init(&rig.display.panel), 0);
    assert_int_equal(draw(84), 0);
    assert_int_equal(screen_begin_frame(&rig.screen), 0);
    rig.card = 1;
    for (uint16_t page = 0; page < n_pages; page++)
        draw_pieces(page, pieces[page]);
    assert_int_equal(screen_end_frame(&rig.screen), 0);
    for (uint16_t page = 0; page < n_pages; page++)
        wrong += count_wrong(page, pieces[page]);
    assert_true(wrong <= 4); /* as in assert_shown() */
    assert_int_equal(rig.chip.complaints, 0);
}

static void pieces_of_pages_go_where_they_belong(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++) {
        check_pieces(panels_pages[i], 0);
        check_pieces(panels_pages[i], MESSAGE_B);
    }
}

static void an_address_that_fails_leaves_no_window(void **state)
{
    (void)state;
    for (size_t i = 0; panels_pages[i]; i++) {
        rig_setup(panels_pages[i], 48, 48);
        rig_open(panels_pages[i], 1);
        struct panel *panel = &rig.display.panel;
        assert_int_equal(panel_init(panel), 0);
        fault_port_arm(&rig.fault, 0);
        assert_int_equal(panel_window(panel, 0, 16, 48, 16), rig.fault.code);
        fault_port_arm(&rig.fault, -1);
        assert_int_equal(panel_pixels(panel, rig.mem, 8), PANEL_ERR_WINDOW);
        assert_int_equal(panel_init(panel), 0);
        assert_int_equal(rig.chip.complaints, 0); /* nor does a chip that was reset light up too early */
    }
}

/* A bus that ends after so many bytes, and is as before from the next call on. */
struct cut_bus {
    struct bus inner;
    long left_b; /* negative: it does not end */
};

static int cut_write(void *ctx, const uint8_t *data, size_t n_b)
{
    enum { CUT = -4321 };
    struct cut_bus *cut = ctx;
    const bool ends = cut->left_b >= 0 && (size_t)cut->left_b < n_b;
    const size_t sent_b = ends ? (size_t)cut->left_b : n_b;
    const int err = bus_write(&cut->inner, data, sent_b);

    cut->left_b = ends || cut->left_b < 0 ? -1 : cut->left_b - (long)sent_b;
    return err ? err : ends ? CUT : 0;
}

/* Whether it came to the cut. */
static bool check_cut(const struct pages_chip *chip, long cut_b, bool starts)
{
    struct cut_bus cut = {.left_b = -1};

    rig_setup(chip, 9, 16);
    rig.chip.port.deferred = false;
    cut.inner = emulated_port_bus(&rig.chip.port);
    rig.config.bus = (struct bus){.ctx = &cut, .write = cut_write, .message_b = MESSAGE_B};
    rig.config.reset.set = NULL;
    rig_open(chip, 1);
    struct panel *panel = &rig.display.panel;
    assert_int_equal(panel_init(panel), 0);
    cut.left_b = cut_b;
    const bool fails = (starts ? panel_init(panel) : 0) || draw(9);
    cut.left_b = -1;
    if (fails && starts) assert_int_equal(panel_init(panel), 0);
    assert_int_equal(draw(9), 0);
    rig.chip.complaints = 0; /* of what was cut, and got other bytes */
    assert_shown(false, false, false);
    assert_int_equal(draw(9), 0);
    assert_shown(false, false, false);
    return fails;
}

static void after_a_cut_at_any_byte_the_next_frame_is_right(void **state)
{
    unsigned cuts = 0;

    (void)state;
    for (size_t i = 0; panels_pages[i]; i++)
        for (unsigned starts = 0; starts < 2; starts++)
            for (long cut_b = 0; check_cut(panels_pages[i], cut_b, starts); cut_b++)
                cuts++;
    print_message("# pages: cut at %u bytes\n", cuts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_card_is_right_on_every_chip),
        cmocka_unit_test(glass_of_any_make_shows_the_card),
        cmocka_unit_test(what_a_chip_cannot_is_refused),
        cmocka_unit_test(a_frame_is_one_address_where_a_chip_goes_on_by_itself),
        cmocka_unit_test(a_window_changes_what_is_in_it_alone),
        cmocka_unit_test(pieces_of_pages_go_where_they_belong),
        cmocka_unit_test(an_address_that_fails_leaves_no_window),
        cmocka_unit_test(after_a_cut_at_any_byte_the_next_frame_is_right),
    };
    return cmocka_run_group_tests_name("pages", tests, NULL, NULL);
}
