/* SPDX-License-Identifier: MIT
 *
 * Renders every camera of a list, line by line, and prints each frame's number and hash just as
 * `limner render --write-hashes` does. Compiled for a scene (`limner compile -o DIR/model`) and for
 * its cameras and screen (`limner render --write-cameras DIR/cameras.h`). Exit status 0, or 1 when
 * the renderer failed or painted out of order. */
#include "app_scene.h"
#include "console.h"

#define FNV_OFFSET_HIGH UINT32_C(0xcbf29ce4)
#define FNV_OFFSET_LOW UINT32_C(0x84222325)
enum { FNV_PRIME_LOW = 0x1b3 }; /* the prime is 2^40 + this */

enum { LINES = SCENE_LINES(CAMERAS_H_PX) }; /* that the method wants to have at any time */

struct screen {
    _Alignas(4) uint16_t lines[LINES][(CAMERAS_W_PX + 1) / 2 * 2]; /* each aligned for words */
    uint32_t hash_high, hash_low; /* FNV-1a, 64 bits, of the bytes as the bus gets them */
    uint32_t painted_px;          /* of this frame */
#if LIM_HAS_DELTA
    uint16_t shown[CAMERAS_H_PX][CAMERAS_W_PX]; /* what a panel would have: only changes come */
#endif
};

static struct screen screen;

int main(void);

/* In 32-bit products only: a 64-bit one would be a library call that the renderer makes too, and
 * who counts could not tell the two apart. */
static void hash_byte(struct screen *to, uint8_t byte)
{
    const uint32_t low = to->hash_low ^ byte;
    const uint32_t carry = ((low >> 16) * FNV_PRIME_LOW + (((low & 0xFFFFu) * FNV_PRIME_LOW) >> 16)) >> 16;
    to->hash_high = to->hash_high * FNV_PRIME_LOW + carry + (low << 8);
    to->hash_low = low * FNV_PRIME_LOW;
}

static void *lend(void *ctx, uint16_t y_px)
{
    return ((struct screen *)ctx)->lines[y_px % LINES];
}

static void hash_pixels(struct screen *to, const uint16_t *pixels, uint16_t n_px)
{
    const uint8_t *bytes = (const uint8_t *)pixels;

    for (uint16_t i = 0; i < 2 * n_px; i++)
        hash_byte(to, bytes[i]);
}

#if LIM_HAS_DELTA
static int window(void *ctx, const struct lim_rect *opened)
{
    (void)ctx;
    return opened && (opened->x1 > CAMERAS_W_PX || opened->y1 > CAMERAS_H_PX) ? -1 : 0;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct screen *to = ctx;

    if (y_px >= CAMERAS_H_PX || x_px + n_px > CAMERAS_W_PX) return -1;
    for (uint16_t x = x_px; x < x_px + n_px; x++)
        to->shown[y_px][x] = to->lines[y_px % LINES][x];
    return 0;
}

static void end_frame(struct screen *to)
{
    for (uint16_t y = 0; y < CAMERAS_H_PX; y++)
        hash_pixels(to, to->shown[y], CAMERAS_W_PX);
    to->painted_px = (uint32_t)CAMERAS_W_PX * CAMERAS_H_PX;
}
#else
/* Pixels must come from left to right and from the top down, each once. */
static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct screen *to = ctx;

    if (to->painted_px != (uint32_t)y_px * CAMERAS_W_PX + x_px || x_px + n_px > CAMERAS_W_PX) return -1;
    hash_pixels(to, to->lines[y_px % LINES] + x_px, n_px);
    to->painted_px += n_px;
    return 0;
}

static void end_frame(struct screen *to)
{
    (void)to;
}
#endif

static void put_hex(uint32_t number)
{
    char digits[9];

    for (int8_t i = 7; i >= 0; i--, number >>= 4)
        digits[i] = "0123456789abcdef"[number & 15u];
    digits[8] = 0;
    console_put(digits);
}

static void put_decimal(uint16_t number)
{
    char digits[6];
    uint8_t at = sizeof digits - 1;

    digits[at] = 0;
    do
        digits[--at] = (char)('0' + number % 10);
    while (number /= 10);
    console_put(&digits[at]);
}

/* Between the marks there is lim_frame() alone. */
static int render(uint16_t frame)
{
    struct lim_camera camera;

    scene_camera(frame, &camera);
    screen.hash_high = FNV_OFFSET_HIGH;
    screen.hash_low = FNV_OFFSET_LOW;
    screen.painted_px = 0;
    scene_announce(frame, &camera);
    frame_begin(frame);
    const int err = scene_draw();
    frame_end(frame);
    end_frame(&screen);
    return err || screen.painted_px != (uint32_t)CAMERAS_W_PX * CAMERAS_H_PX;
}

static void put_frame(uint16_t frame)
{
    put_decimal(frame);
    console_put(" ");
    put_hex(screen.hash_high);
    put_hex(screen.hash_low);
    console_put("\n");
}

int main(void)
{
    const struct lim_target target = {
        .w_px = CAMERAS_W_PX,
        .h_px = CAMERAS_H_PX,
        .format = LIM_RGB565,
        .method = SCENE_METHOD,
        .ctx = &screen,
        .lend = lend,
        .done = done,
#if LIM_HAS_FRAMEBUFFER
        .framebuffer = {screen.lines, sizeof screen.lines[0] / sizeof screen.lines[0][0]},
#endif
#if LIM_HAS_DELTA
        .window = window,
        .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1},
#endif
    };
    int err = scene_init(&target);

    for (uint16_t frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        err = render(frame);
        if (!err) put_frame(frame);
    }
    return err != 0;
}
