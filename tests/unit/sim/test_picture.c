/* SPDX-License-Identifier: MIT
 *
 * Pictures of a model's materials: from files of each format, out of the model, and all that cannot be read. */
#include "files/companion.h"
#include "files/picture.h"
#include "model/model.h"
#include "readers/model_import.h"
#include "rigs/cmocka_ready.h"

#include <assimp/scene.h>
#include <gd.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-picture-XXXXXX";

static const char *in_folder(const char *name)
{
    static char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static struct picture picture_of(const struct aiScene *scene, const char *name)
{
    char model[128];
    struct picture picture;
    snprintf(model, sizeof model, "%s", in_folder("model.obj"));
    companions_begin(model);
    picture_read(scene, name, &picture);
    return picture;
}

static struct picture from_file(const char *name)
{
    static struct aiScene nothing;
    return picture_of(&nothing, name);
}

static void put_bytes(const char *name, const void *bytes, size_t size_b)
{
    FILE *file = fopen(in_folder(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size_b, file), size_b);
    assert_int_equal(fclose(file), 0);
}

/* Red on the left, blue on the right. */
static gdImagePtr two_halves(int w_px, int h_px)
{
    gdImagePtr image = gdImageCreateTrueColor(w_px, h_px);
    gdImageFilledRectangle(image, 0, 0, w_px / 2 - 1, h_px - 1, 0xFF0000);
    gdImageFilledRectangle(image, w_px / 2, 0, w_px - 1, h_px - 1, 0x0000FF);
    return image;
}

static bool is_near(uint32_t a, uint32_t b)
{
    bool near = true;
    for (int shift = 0; shift < 24; shift += 8)
        near = near && abs((int)(a >> shift & 0xFF) - (int)(b >> shift & 0xFF)) <= 12;
    return near;
}

static void assert_halves(struct picture *picture, uint32_t w_px, uint32_t h_px)
{
    assert_string_equal(picture->reason, "");
    assert_int_equal(picture->w_px, w_px);
    assert_int_equal(picture->h_px, h_px);
    assert_true(is_near(picture->pixels[0], 0xFF0000));
    assert_true(is_near(picture->pixels[(size_t)w_px * h_px - 1], 0x0000FF));
    picture_free(picture);
}

static void every_format_is_read(void **state)
{
    (void)state;
    gdImagePtr image = two_halves(32, 16);
    const char *names[] = {"a.png", "a.jpg", "a.gif", "a.bmp"};
    void *bytes[4];
    int size_b[4];
    bytes[0] = gdImagePngPtr(image, &size_b[0]);
    bytes[1] = gdImageJpegPtr(image, &size_b[1], 95);
    bytes[2] = gdImageGifPtr(image, &size_b[2]);
    bytes[3] = gdImageBmpPtr(image, &size_b[3], 0);
    for (int i = 0; i < 4; i++) {
        put_bytes(names[i], bytes[i], (size_t)size_b[i]);
        gdFree(bytes[i]);
        struct picture picture = from_file(names[i]);
        assert_halves(&picture, 32, 16);
    }
    gdImageDestroy(image);
}

static void put_png(const char *name, gdImagePtr image)
{
    int size_b;
    void *bytes = gdImagePngPtr(image, &size_b);
    put_bytes(name, bytes, (size_t)size_b);
    gdFree(bytes);
    gdImageDestroy(image);
}

static void a_large_picture_is_made_smaller(void **state)
{
    (void)state;
    put_png("large.png", two_halves(1500, 40));
    struct picture picture = from_file("large.png");
    assert_int_equal(picture.found_w_px, 1500);
    assert_int_equal(picture.found_h_px, 40);
    assert_halves(&picture, 1024, 40);
}

static void folders_may_be_written_as_on_windows(void **state)
{
    (void)state;
    assert_int_equal(mkdir(in_folder("sub"), 0777), 0);
    put_png("sub/a b.png", two_halves(8, 8));
    struct picture picture = from_file("nowhere\\a b.png");
    assert_null(picture.pixels);
    picture = from_file(".\\sub\\a b.png");
    assert_halves(&picture, 8, 8);
    picture = from_file("sub/a%20b.png");
    assert_halves(&picture, 8, 8);
    assert_int_equal(unlink(in_folder("sub/a b.png")), 0);
    assert_int_equal(rmdir(in_folder("sub")), 0);
}

static void assert_ends_import(const char *name, const char *reason)
{
    struct error err;
    struct picture picture = from_file(name);
    assert_null(picture.pixels);
    assert_true(companions_refused(&err));
    if (!strstr(err.text, reason)) fail_msg("%s: %s", name, err.text);
}

static void what_may_not_be_read_ends_the_import(void **state)
{
    (void)state;
    const char *outside[] = {"../none.png",   "..\\none.png", "sub/../../none.png", "/etc/passwd",
                             "\\etc\\passwd", "..",           "%2e%2e/none.png",    "sub%2F..%2f..%5Cnone.png",
                             "./..",          "link.png",     "%2Fetc/passwd"};
    assert_int_equal(symlink("/etc/passwd", in_folder("link.png")), 0);
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++)
        assert_ends_import(outside[i], "outside of its folder; --trust-paths permits that");
    assert_int_equal(unlink(in_folder("link.png")), 0);
    assert_int_equal(mkfifo(in_folder("pipe.png"), 0666), 0);
    assert_ends_import("pipe.png", "is a pipe, not a regular file");
    assert_int_equal(unlink(in_folder("pipe.png")), 0);
    gdImagePtr many = gdImageCreate(4097, 4096);
    gdImageColorAllocate(many, 0, 0, 0);
    put_png("many.png", many);
    assert_ends_import("many.png", "4097x4096 pixels, 16777216 are the most");
    assert_int_equal(unlink(in_folder("many.png")), 0);
    const char *inside[] = {"..a.png", "a..png", "...", "sub/..a"};
    struct error err;
    for (size_t i = 0; i < sizeof inside / sizeof *inside; i++) {
        from_file(inside[i]);
        assert_false(companions_refused(&err));
    }
}

/* Red above, blue below, by hand, as the specification of Truevision has it: rows from the bottom up, unless bit 5 of
 * byte 17 says otherwise, blue, green, red, and in bits 0 to 3 of that byte how many bits of alpha. */
static size_t make_tga(uint8_t bytes[1024], bool packed, bool from_top, int pixel_b)
{
    enum { W_PX = 3, H_PX = 4 };
    size_t at = 18;
    memset(bytes, 0, 1024);
    bytes[2] = packed ? 10 : 2;
    bytes[12] = W_PX, bytes[14] = H_PX;
    bytes[16] = (uint8_t)(8 * pixel_b);
    bytes[17] = (uint8_t)((from_top ? 0x20 : 0) | (pixel_b == 4 ? 8 : 0));
    for (int row = 0; row < H_PX; row++) {
        const bool is_red = (from_top ? row : H_PX - 1 - row) < H_PX / 2;
        if (packed) bytes[at++] = 0x80 | (W_PX - 1);
        for (int x = 0; x < (packed ? 1 : W_PX); x++) {
            bytes[at++] = is_red ? 0 : 255;
            bytes[at++] = 0;
            bytes[at++] = is_red ? 255 : 0;
            if (pixel_b == 4) bytes[at++] = 255;
        }
    }
    return at;
}

static void tga_is_read_whichever_way_it_runs(void **state)
{
    (void)state;
    uint8_t bytes[1024];
    for (int kind = 0; kind < 8; kind++) {
        const size_t size_b = make_tga(bytes, kind & 1, kind & 2, kind & 4 ? 4 : 3);
        put_bytes("hand.tga", bytes, size_b);
        struct picture picture = from_file("hand.tga");
        if (picture.reason[0]) fail_msg("kind %d: %s", kind, picture.reason);
        assert_int_equal(picture.w_px, 3);
        assert_int_equal(picture.h_px, 4);
        assert_int_equal(picture.has_alpha, false);
        for (int i = 0; i < 12; i++)
            if (picture.pixels[i] != (i < 6 ? 0xFF0000u : 0x0000FFu)) fail_msg("kind %d: pixel %d", kind, i);
        picture_free(&picture);
    }
}

static void assert_refused(const char *name, const char *reason)
{
    struct picture picture = from_file(name);
    assert_null(picture.pixels);
    assert_int_equal(picture.w_px, 0);
    if (!strstr(picture.reason, reason)) fail_msg("%s: %s", name, picture.reason);
}

static void what_cannot_be_read_has_a_reason(void **state)
{
    (void)state;
    char bytes[64] = "\x89PNG\r\n\x1a\n";
    assert_refused("none.png", "there is no such file");
    put_bytes("empty.png", bytes, 0);
    assert_refused("empty.png", "the file is empty");
    put_bytes("text.png", "no picture at all", 17);
    assert_refused("text.png", "neither PNG nor JPEG");
    put_bytes("broken.png", bytes, sizeof bytes);
    assert_refused("broken.png", "damaged");
    uint8_t tga[1024];
    const size_t tga_b = make_tga(tga, false, false, 3);
    put_bytes("short.tga", tga, tga_b - 9);
    assert_refused("short.tga", "damaged");
    tga[16] = 16;
    put_bytes("high.tga", tga, tga_b);
    assert_refused("high.tga", "less than 24 bits a pixel");
    assert_refused(".", "it is a folder");
    char name[5000];
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = 0;
    assert_refused(name, "its path is too long");
    assert_refused("*0", "the model holds no such picture");
}

static void a_truncated_jpeg_is_no_picture(void **state)
{
    (void)state;
    gdImagePtr image = two_halves(200, 200);
    int size_b;
    void *bytes = gdImageJpegPtr(image, &size_b, 95);
    put_bytes("cut.jpg", bytes, (size_t)size_b / 2);
    gdFree(bytes);
    gdImageDestroy(image);
    assert_refused("cut.jpg", "damaged");
}

static void pictures_inside_a_model_may_be_raw_or_files(void **state)
{
    (void)state;
    struct aiTexel texels[4] = {{.r = 255, .a = 255}, {.r = 255}, {.b = 255}, {.b = 255, .a = 255}};
    struct aiTexture raw = {.mWidth = 2, .mHeight = 2, .pcData = texels}, png = {0}, none = {.mWidth = 0, .mHeight = 3};
    gdImagePtr image = two_halves(4, 4);
    int size_b;
    png.pcData = gdImagePngPtr(image, &size_b);
    png.mWidth = (unsigned)size_b;
    strcpy(png.mFilename.data, "inside.png");
    struct aiTexture *all[] = {&raw, &png, &none};
    const struct aiScene scene = {.mNumTextures = 3, .mTextures = all};
    struct picture picture = picture_of(&scene, "*0");
    assert_halves(&picture, 2, 2);
    picture = picture_of(&scene, "*1");
    assert_halves(&picture, 4, 4);
    picture = picture_of(&scene, "inside.png");
    assert_halves(&picture, 4, 4);
    picture = picture_of(&scene, "*2");
    assert_string_equal(picture.reason, "it has no pixels");
    picture = picture_of(&scene, "*3");
    assert_string_equal(picture.reason, "the model holds no such picture");
    gdFree(png.pcData);
    gdImageDestroy(image);
}

static bool has_alpha(const struct aiScene *scene, const char *name)
{
    struct picture picture = picture_of(scene, name);
    assert_string_equal(picture.reason, "");
    picture_free(&picture);
    return picture.has_alpha;
}

/* In a corner only: by an alpha of its own, or by the colour that stands for nothing. */
static void what_is_not_opaque_is_known(void **state)
{
    (void)state;
    const struct aiScene nothing = {0};
    put_png("a.png", two_halves(8, 8));
    assert_false(has_alpha(&nothing, "a.png"));
    gdImagePtr image = two_halves(1500, 40);
    gdImageSaveAlpha(image, 1);
    gdImageAlphaBlending(image, 0);
    gdImageSetPixel(image, 1499, 39, gdTrueColorAlpha(0, 0, 255, 1));
    put_png("large.png", image);
    assert_true(has_alpha(&nothing, "large.png"));
    image = gdImageCreate(8, 8);
    gdImageColorAllocate(image, 255, 0, 0);
    const int none = gdImageColorAllocate(image, 0, 0, 255);
    gdImageColorTransparent(image, none);
    int size_b;
    for (int i = 0; i < 2; i++) {
        void *bytes = gdImageGifPtr(image, &size_b);
        put_bytes("a.gif", bytes, (size_t)size_b);
        gdFree(bytes);
        assert_int_equal(has_alpha(&nothing, "a.gif"), i); /* the colour alone is nothing yet */
        gdImageSetPixel(image, 7, 7, none);
    }
    gdImageDestroy(image);
    struct aiTexel texels[2] = {{.r = 255, .a = 255}, {.r = 255, .a = 254}};
    struct aiTexture opaque = {.mWidth = 1, .mHeight = 1, .pcData = texels};
    struct aiTexture clear = {.mWidth = 2, .mHeight = 1, .pcData = texels};
    struct aiTexture *all[] = {&opaque, &clear};
    const struct aiScene scene = {.mNumTextures = 2, .mTextures = all};
    assert_false(has_alpha(&scene, "*0"));
    assert_true(has_alpha(&scene, "*1"));
}

/* Red and green above, blue and white below: where do the corners of the square lie in that? */
static void models_bring_pictures_and_coordinates(void **state)
{
    (void)state;
    static const char *const paths[] = {"tests/models/quarters.obj", "tests/models/quarters.glb"};
    for (size_t i = 0; i < 2; i++) {
        struct model model;
        struct error err;
        if (!model_import(paths[i], &model, &err)) fail_msg("%s", err.text);
        assert_int_equal(model.picture_count, 1);
        const struct picture *picture = &model.pictures[0];
        assert_int_equal(picture->w_px, 4);
        assert_int_equal(picture->h_px, 2);
        assert_int_equal(picture->faces, model.face_count);
        const uint32_t pixels[8] = {0xFF0000, 0xFF0000, 0x00FF00, 0x00FF00, 0x0000FF, 0x0000FF, 0xFFFFFF, 0xFFFFFF};
        assert_memory_equal(picture->pixels, pixels, sizeof pixels);
        for (size_t k = 0; k < model.corner_count; k++) {
            const double *at = model.points[model.corners[k]], *uv = model.uvs[model.corners[k]];
            assert_true(fabs(uv[0] - at[0]) < 1e-6 && fabs(uv[1] - (1 - at[1])) < 1e-6);
        }
        model_free(&model);
    }
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    static const char *const names[] = {"a.png",    "a.jpg",      "a.gif",    "a.bmp",     "large.png", "empty.png",
                                        "text.png", "broken.png", "hand.tga", "short.tga", "high.tga",  "cut.jpg"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        unlink(in_folder(names[i]));
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_is_read),
        cmocka_unit_test(a_large_picture_is_made_smaller),
        cmocka_unit_test(folders_may_be_written_as_on_windows),
        cmocka_unit_test(tga_is_read_whichever_way_it_runs),
        cmocka_unit_test(what_cannot_be_read_has_a_reason),
        cmocka_unit_test(what_may_not_be_read_ends_the_import),
        cmocka_unit_test(a_truncated_jpeg_is_no_picture),
        cmocka_unit_test(pictures_inside_a_model_may_be_raw_or_files),
        cmocka_unit_test(what_is_not_opaque_is_known),
        cmocka_unit_test(models_bring_pictures_and_coordinates),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
