/* SPDX-License-Identifier: MIT
 *
 * Frames as PNG, GIF, contact sheet and terminal picture, read back by libgd or counted; the
 * LIMNER_DUMP and LIMNER_CHECK hook. */
#include "cli/terminal.h"
#include "pictures/dump.h"
#include "pictures/image.h"
#include "rigs/cmocka_ready.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { W_PX = 12, H_PX = 10, MOST_FRAMES = 40 };

static const char SCRATCH[] = "limner-test-image.tmp"; /* in the scratch folder, which the tests run in */
static char folder[] = "/tmp/limner-image-XXXXXX";

static int enter_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    (void)state;
    unlink(SCRATCH);
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1; /* fails if a test left a file behind */
}

/* Frames whose pixels all differ: pixel i of frame f has colour 97 * (i + 120 f), modulo `colours`. */
static struct film make_film(uint16_t *pixels, size_t frame_count, unsigned colours)
{
    for (size_t i = 0; i < frame_count * W_PX * H_PX; i++)
        pixels[i] = (uint16_t)(97 * i % colours * (65536 / colours));
    return (struct film){W_PX, H_PX, frame_count, pixels};
}

static FILE *write_file(void)
{
    FILE *file = fopen(SCRATCH, "wb");
    assert_non_null(file);
    return file;
}

static void write_png(const struct film *film)
{
    FILE *file = write_file();
    gdImagePtr image = image_from_frame(film, 0);
    struct error err;
    assert_true(image_write_png(image, file, SCRATCH, &err));
    gdImageDestroy(image);
    fclose(file);
}

static unsigned char *read_bytes(size_t *size_b)
{
    FILE *file = fopen(SCRATCH, "rb");
    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    *size_b = (size_t)ftell(file);
    rewind(file);
    unsigned char *bytes = malloc(*size_b + 1);
    assert_int_equal(fread(bytes, 1, *size_b, file), *size_b);
    bytes[*size_b] = '\0';
    fclose(file);
    return bytes;
}

/* Colours and PNG ---------------------------------------------------------------------------- */

static void full_intensity_stays_full(void **state)
{
    (void)state;
    assert_int_equal(image_rgb888_from_565(0xFFFF), 0xFFFFFF);
    assert_int_equal(image_rgb888_from_565(0x0000), 0x000000);
    assert_int_equal(image_rgb888_from_565(0xF800), 0xFF0000);
    assert_int_equal(image_rgb888_from_565(0x07E0), 0x00FF00);
    assert_int_equal(image_rgb888_from_565(0x001F), 0x0000FF);
    assert_int_equal(image_rgb888_from_565(0x8410), 0x848284);
}

static void png_holds_every_pixel(void **state)
{
    (void)state;
    uint16_t pixels[W_PX * H_PX];
    struct film film = make_film(pixels, 1, 65536);
    struct error err;
    write_png(&film);
    assert_true(image_check_png(&film, SCRATCH, &err));
}

static void check_names_the_first_pixel_that_differs(void **state)
{
    (void)state;
    uint16_t pixels[W_PX * H_PX];
    struct film film = make_film(pixels, 1, 65536);
    struct error err;
    write_png(&film);
    pixels[3 * W_PX + 5] ^= 1;
    pixels[9 * W_PX + 11] ^= 0x8000;
    assert_false(image_check_png(&film, SCRATCH, &err));
    assert_string_equal(err.text, "limner-test-image.tmp: 2 of 120 pixels differ, the first at (5, 3)");
}

static void check_refuses_other_sizes_and_files_that_are_no_png(void **state)
{
    (void)state;
    uint16_t pixels[2 * W_PX * H_PX];
    struct film film = make_film(pixels, 2, 65536);
    struct error err;
    write_png(&film);
    struct film taller = {W_PX, 2 * H_PX, 1, pixels};
    assert_false(image_check_png(&taller, SCRATCH, &err));
    assert_string_equal(err.text, "limner-test-image.tmp: 12x10 pixels, the frame has 12x20");
    FILE *file = write_file();
    fputs("no picture", file);
    fclose(file);
    assert_false(image_check_png(&film, SCRATCH, &err));
    assert_string_equal(err.text, "limner-test-image.tmp: not a readable PNG file");
    assert_false(image_check_png(&film, "missing.png", &err));
    assert_string_equal(err.text, "missing.png: No such file or directory");
}

static void full_disk_is_an_error(void **state)
{
    (void)state;
    uint16_t pixels[MOST_FRAMES * W_PX * H_PX];
    struct film film = make_film(pixels, MOST_FRAMES, 65536);
    struct error err;
    FILE *full = fopen("/dev/full", "wb");
    assert_non_null(full);
    setvbuf(full, NULL, _IONBF, 0);
    gdImagePtr image = image_from_frame(&film, 0);
    assert_false(image_write_png(image, full, "x.png", &err));
    assert_string_equal(err.text, "x.png: No space left on device");
    assert_false(image_write_gif(&film, 15, full, "x.gif", &err));
    assert_memory_equal(err.text, "x.gif: ", 7);
    gdImageDestroy(image);
    fclose(full);
}

/* Contact sheet ------------------------------------------------------------------------------ */

static void assert_sheet(size_t frame_count, int columns, int rows)
{
    static uint16_t pixels[MOST_FRAMES * W_PX * H_PX];
    struct film film = make_film(pixels, frame_count, 65536);
    gdImagePtr sheet = image_contact_sheet(&film);
    assert_int_equal(gdImageSX(sheet), columns * (W_PX + 2) + 2);
    assert_int_equal(gdImageSY(sheet), rows * (H_PX + 2) + 2);
    size_t shown = frame_count < 24 ? frame_count : 24;
    for (size_t i = 0; i < shown; i++) {
        const uint16_t *frame = pixels + i * frame_count / shown * W_PX * H_PX;
        int x_px = 2 + (int)i % columns * (W_PX + 2), y_px = 2 + (int)i / columns * (H_PX + 2);
        assert_int_equal(gdImageTrueColorPixel(sheet, x_px, y_px), image_rgb888_from_565(frame[0]));
        assert_int_equal(gdImageTrueColorPixel(sheet, x_px + W_PX - 1, y_px + H_PX - 1),
                         image_rgb888_from_565(frame[W_PX * H_PX - 1]));
    }
    gdImageDestroy(sheet);
}

static void sheet_shows_evenly_chosen_frames_in_a_grid(void **state)
{
    (void)state;
    assert_sheet(1, 1, 1);
    assert_sheet(5, 5, 1);
    assert_sheet(7, 6, 2);
    assert_sheet(24, 6, 4);
    assert_sheet(40, 6, 4);
}

static void sheet_shrinks_large_frames_even_thin_ones(void **state)
{
    (void)state;
    uint16_t *pixels = calloc(1024, sizeof *pixels);
    gdImagePtr sheet = image_contact_sheet(&(struct film){1024, 1, 1, pixels});
    assert_int_equal(gdImageSX(sheet), 240 + 4);
    assert_int_equal(gdImageSY(sheet), 1 + 4);
    gdImageDestroy(sheet);
    free(pixels);
}

/* GIF ---------------------------------------------------------------------------------------- */

struct gif_facts {
    int frames, delay_cs, local_palettes, loops;
};

/* Walks the blocks of a GIF file: CompuServe, "Graphics Interchange Format, version 89a". */
static struct gif_facts gif_facts(const unsigned char *bytes, size_t size_b)
{
    struct gif_facts facts = {0};
    assert_memory_equal(bytes, "GIF89a", 6);
    assert_true(bytes[10] & 0x80); /* a global palette */
    size_t at = 13 + 3 * (size_t)(2 << (bytes[10] & 7));
    while (at < size_b && bytes[at] != 0x3B) {
        if (bytes[at] == 0x21) {
            if (bytes[at + 1] == 0xF9) facts.delay_cs += bytes[at + 4] | bytes[at + 5] << 8;
            if (bytes[at + 1] == 0xFF) facts.loops++;
            at += 2;
        } else {
            assert_int_equal(bytes[at], 0x2C);
            facts.frames++;
            facts.local_palettes += bytes[at + 9] >> 7;
            at += 11;
        }
        while (bytes[at])
            at += 1u + bytes[at];
        at++;
    }
    assert_int_equal(at, size_b - 1);
    return facts;
}

static struct gif_facts write_gif(const struct film *film, unsigned frames_per_s)
{
    FILE *file = write_file();
    struct error err;
    assert_true(image_write_gif(film, frames_per_s, file, SCRATCH, &err));
    fclose(file);
    size_t size_b;
    unsigned char *bytes = read_bytes(&size_b);
    struct gif_facts facts = gif_facts(bytes, size_b);
    free(bytes);
    return facts;
}

static void gif_has_all_frames_one_palette_and_the_rate_asked_for(void **state)
{
    (void)state;
    static uint16_t pixels[MOST_FRAMES * W_PX * H_PX];
    struct film film = make_film(pixels, 30, 65536);
    struct gif_facts facts = write_gif(&film, 15);
    assert_int_equal(facts.frames, 30);
    assert_int_equal(facts.local_palettes, 0);
    assert_int_equal(facts.delay_cs, 200);
    assert_int_equal(facts.loops, 1);
}

static void fail_on_gd_message(int priority, const char *format, va_list arguments)
{
    (void)priority;
    (void)arguments;
    fail_msg("libgd says: %s", format);
}

static void gif_keeps_frames_that_do_not_change(void **state)
{
    (void)state;
    static uint16_t pixels[MOST_FRAMES * W_PX * H_PX];
    memset(pixels, 0, sizeof pixels);
    pixels[3 * W_PX * H_PX] = 0xFFFF; /* frame 3 has a dot */
    gdSetErrorMethod(fail_on_gd_message);
    struct gif_facts facts = write_gif(&(struct film){W_PX, H_PX, 6, pixels}, 20);
    gdClearErrorMethod();
    assert_int_equal(facts.frames, 6);
    assert_int_equal(facts.delay_cs, 30);
}

static void gif_of_few_colours_is_exact(void **state)
{
    (void)state;
    static uint16_t pixels[MOST_FRAMES * W_PX * H_PX];
    struct film film = make_film(pixels, 3, 256);
    write_gif(&film, 15);
    FILE *file = fopen(SCRATCH, "rb");
    gdImagePtr image = gdImageCreateFromGif(file); /* the first frame */
    fclose(file);
    for (int i = 0; i < W_PX * H_PX; i++)
        assert_int_equal(gdImageGetTrueColorPixel(image, i % W_PX, i / W_PX), image_rgb888_from_565(pixels[i]));
    gdImageDestroy(image);
}

static void gif_of_many_colours_is_close(void **state)
{
    (void)state;
    static uint16_t pixels[MOST_FRAMES * W_PX * H_PX];
    for (unsigned i = 0; i < 10 * W_PX * H_PX; i++)
        pixels[i] = (uint16_t)(i % 32 << 11 | i / 32 % 64 << 5);
    write_gif(&(struct film){W_PX, H_PX, 10, pixels}, 15);
    FILE *file = fopen(SCRATCH, "rb");
    gdImagePtr image = gdImageCreateFromGif(file);
    fclose(file);
    for (int i = 0; i < W_PX * H_PX; i++) {
        int shown = gdImageGetTrueColorPixel(image, i % W_PX, i / W_PX);
        int wanted = (int)image_rgb888_from_565(pixels[i]);
        assert_in_range(abs(gdTrueColorGetRed(shown) - gdTrueColorGetRed(wanted)), 0, 24);
        assert_in_range(abs(gdTrueColorGetGreen(shown) - gdTrueColorGetGreen(wanted)), 0, 24);
    }
    gdImageDestroy(image);
}

/* Hook and terminal -------------------------------------------------------------------------- */

static void dump_hook_does_what_the_environment_asks(void **state)
{
    (void)state;
    uint16_t pixels[W_PX * H_PX];
    struct film film = make_film(pixels, 1, 65536);
    static const char dumped[] = "limner-test-dump.tmp"; /* other tests read dumped: it is not written over */
    struct error err;
    unsetenv("LIMNER_DUMP");
    unsetenv("LIMNER_CHECK");
    assert_true(dump_last_frame(&film, &err));

    setenv("LIMNER_DUMP", dumped, 1);
    assert_true(dump_last_frame(&film, &err));
    assert_true(image_check_png(&film, dumped, &err));

    unsetenv("LIMNER_DUMP");
    setenv("LIMNER_CHECK", dumped, 1);
    assert_true(dump_last_frame(&film, &err));
    pixels[0] ^= 1;
    assert_false(dump_last_frame(&film, &err));
    unsetenv("LIMNER_CHECK");

    setenv("LIMNER_DUMP", "/dev/null/x.png", 1);
    assert_false(dump_last_frame(&film, &err));
    unsetenv("LIMNER_DUMP");
    unlink(dumped);
}

static void terminal_shows_two_pixels_a_character(void **state)
{
    (void)state;
    static const uint16_t pixels[] = {0xF800, 0x07E0, 0x001F, 0xFFFF};
    FILE *file = write_file();
    struct error err;
    assert_true(terminal_print(&(struct film){2, 2, 1, pixels}, 80, 24, file, &err));
    fclose(file);
    size_t size_b;
    unsigned char *text = read_bytes(&size_b);
    assert_string_equal((const char *)text, "\x1B[38;2;255;0;0;48;2;0;0;255m\u2580"
                                            "\x1B[38;2;0;255;0;48;2;255;255;255m\u2580\x1B[0m\n");
    free(text);
}

static void terminal_picture_fits_and_keeps_its_proportions(void **state)
{
    (void)state;
    static uint16_t pixels[240 * 120];
    FILE *file = write_file();
    struct error err;
    assert_true(terminal_print(&(struct film){240, 120, 1, pixels}, 60, 40, file, &err));
    fclose(file);
    size_t size_b, lines = 0, cells = 0;
    unsigned char *text = read_bytes(&size_b);
    for (size_t i = 0; i < size_b; i++) {
        lines += text[i] == '\n';
        cells += text[i] == 0xE2;
    }
    free(text);
    assert_int_equal(lines, 15); /* 60 x 30 pixels */
    assert_int_equal(cells, 60 * 15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(full_intensity_stays_full),
        cmocka_unit_test(png_holds_every_pixel),
        cmocka_unit_test(check_names_the_first_pixel_that_differs),
        cmocka_unit_test(check_refuses_other_sizes_and_files_that_are_no_png),
        cmocka_unit_test(full_disk_is_an_error),
        cmocka_unit_test(sheet_shows_evenly_chosen_frames_in_a_grid),
        cmocka_unit_test(sheet_shrinks_large_frames_even_thin_ones),
        cmocka_unit_test(gif_has_all_frames_one_palette_and_the_rate_asked_for),
        cmocka_unit_test(gif_keeps_frames_that_do_not_change),
        cmocka_unit_test(gif_of_few_colours_is_exact),
        cmocka_unit_test(gif_of_many_colours_is_close),
        cmocka_unit_test(dump_hook_does_what_the_environment_asks),
        cmocka_unit_test(terminal_shows_two_pixels_a_character),
        cmocka_unit_test(terminal_picture_fits_and_keeps_its_proportions),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
