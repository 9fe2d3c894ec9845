/* SPDX-License-Identifier: MIT
 *
 * Panels of the MIPI Display Command Set behind struct panel.
 * In: windows and pixels of the turned picture. Out: bytes on the bus, and the level of D/C,
 * which tells a command (low) from arguments and pixels (high).
 * Every command ends with a flush, so that its bytes may live on the stack; only pixels are left
 * to travel on their own. */
#include "dcs.h"

/* MADCTL: how addresses map to memory. MV is applied first, MX and MY then mirror memory columns
 * and rows, whatever MV says. */
#define MADCTL_MY 0x80u
#define MADCTL_MX 0x40u
#define MADCTL_MV 0x20u
#define MADCTL_BGR 0x08u

/* Waits, in microseconds. The standard asks for 10 us of reset, 5 ms until the chip listens again and
 * 120 ms until it may leave sleep, and 120 ms between entering and leaving sleep, either way. */
#define RESET_US UINT32_C(150000)
#define SLEEP_US UINT32_C(120000)

/* CASET and RASET with four arguments each, and RAMWR: their bytes, and how often they are written or D/C changes. */
enum { WINDOW_B = 11, WINDOW_MESSAGES = 11 };

static struct dcs *dcs_of(const struct panel *panel)
{
    return panel->chip;
}

/* Any command ends the chip's frame write, so it closes the window. */
static int dcs_command(struct dcs *dcs, uint8_t command, const uint8_t *args, size_t n_args)
{
    dcs->left_px = 0;
    int err = wire_command(&dcs->wire, &command, 1);
    if (err || n_args == 0) return err;
    err = wire_data(&dcs->wire, args, n_args);
    if (err) return err;
    return wire_flush(&dcs->wire);
}

static int dcs_command_wait(struct dcs *dcs, uint8_t command, uint32_t delay_us)
{
    int err = dcs_command(dcs, command, NULL, 0);
    if (err) return err;
    return clock_delay(&dcs->config.clock, delay_us);
}

/* A picture turned clockwise by 90 degrees runs down the glass from its right edge: its x is the
 * memory's row, its y the mirrored column; and so on round. A mirrored picture runs its x backwards,
 * which is along rows when columns and rows are exchanged. */
static uint8_t dcs_madctl(const struct dcs *dcs, enum panel_rotation rotation)
{
    static const uint8_t turned[] = {0, MADCTL_MV | MADCTL_MX, MADCTL_MX | MADCTL_MY, MADCTL_MV | MADCTL_MY};
    unsigned madctl = turned[rotation];
    if (dcs->config.mirror) madctl ^= madctl & MADCTL_MV ? MADCTL_MY : MADCTL_MX;
    if (dcs->config.bgr) madctl |= MADCTL_BGR;
    return (uint8_t)madctl;
}

static int dcs_send_madctl(struct dcs *dcs, enum panel_rotation rotation)
{
    uint8_t madctl = dcs_madctl(dcs, rotation);
    return dcs_command(dcs, DCS_MADCTL, &madctl, 1);
}

static int dcs_send_inverted(struct dcs *dcs, bool inverted)
{
    return dcs_command(dcs, dcs->config.invert != inverted ? DCS_INVON : DCS_INVOFF, NULL, 0);
}

static void dcs_set_size(struct dcs *dcs, enum panel_rotation rotation)
{
    bool upright = rotation == PANEL_UPRIGHT || rotation == PANEL_TURNED_180;
    dcs->rotation = rotation;
    dcs->panel.w_px = upright ? dcs->config.w_px : dcs->config.h_px;
    dcs->panel.h_px = upright ? dcs->config.h_px : dcs->config.w_px;
}

/* Sends CASET or RASET: first and last address, high byte first. */
static int dcs_address(struct dcs *dcs, uint8_t command, uint16_t first, uint16_t n)
{
    uint16_t last = (uint16_t)(first + n - 1u);
    uint8_t args[] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    return dcs_command(dcs, command, args, sizeof args);
}

/* The offset rule: a mirrored axis counts from the memory's far end, so the glass's other margin
 * is the offset; exchanged axes exchange the offsets. It holds for every turn and mirror. */
static void dcs_offsets(const struct dcs *dcs, uint16_t *x_px, uint16_t *y_px)
{
    const struct dcs_config *config = &dcs->config;
    uint8_t madctl = dcs_madctl(dcs, dcs->rotation);
    uint16_t column = config->ox_px;
    uint16_t row = config->oy_px;
    if (madctl & MADCTL_MX) column = (uint16_t)(dcs->chip->mem_w_px - config->w_px - config->ox_px);
    if (madctl & MADCTL_MY) row = (uint16_t)(dcs->chip->mem_h_px - config->h_px - config->oy_px);
    *x_px = madctl & MADCTL_MV ? row : column;
    *y_px = madctl & MADCTL_MV ? column : row;
}

static int dcs_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    struct dcs *dcs = dcs_of(panel);
    dcs->left_px = 0;
    if (w_px == 0 || x_px >= panel->w_px || w_px > panel->w_px - x_px) return PANEL_ERR_WINDOW;
    if (h_px == 0 || y_px >= panel->h_px || h_px > panel->h_px - y_px) return PANEL_ERR_WINDOW;

    uint16_t ox_px, oy_px;
    dcs_offsets(dcs, &ox_px, &oy_px);
    int err = dcs_address(dcs, DCS_CASET, (uint16_t)(ox_px + x_px), w_px);
    if (err) return err;
    err = dcs_address(dcs, DCS_RASET, (uint16_t)(oy_px + y_px), h_px);
    if (err) return err;
    err = dcs_command(dcs, DCS_RAMWR, NULL, 0);
    if (err) return err;
    dcs->left_px = (uint32_t)w_px * h_px;
    return 0;
}

static int dcs_pixels(struct panel *panel, const void *data, size_t n_px)
{
    struct dcs *dcs = dcs_of(panel);
    uint32_t left_px = dcs->left_px;
    dcs->left_px = 0; /* stays closed after an error */
    if (n_px > left_px) return PANEL_ERR_WINDOW;
    int err = wire_data(&dcs->wire, data, pixels_b(panel->format, n_px));
    if (err) return err;
    dcs->left_px = left_px - (uint32_t)n_px;
    return 0;
}

static int dcs_flush(struct panel *panel)
{
    struct dcs *dcs = dcs_of(panel);
    int err = wire_flush(&dcs->wire);
    if (err) dcs->left_px = 0;
    return err;
}

/* The first wait: the host may have restarted while the chip was leaving sleep, when it takes no
 * SWRESET, or both have just been powered. */
static int dcs_reset_by_command(struct dcs *dcs)
{
    int err = clock_delay(&dcs->config.clock, SLEEP_US);
    if (err) return err;
    return dcs_command_wait(dcs, DCS_SWRESET, RESET_US);
}

static int dcs_send_setup(struct dcs *dcs)
{
    const uint8_t *setup = dcs->chip->setup;
    for (size_t i = 0; i < dcs->chip->setup_b; i += 2u + setup[i + 1]) {
        int err = dcs_command(dcs, setup[i], &setup[i + 2], setup[i + 1]);
        if (err) return err;
    }
    return 0;
}

static int dcs_send_format(struct dcs *dcs)
{
    static const uint8_t colmod[] = {[PANEL_RGB565] = 0x55, [PANEL_RGB444] = 0x53, [PANEL_RGB666] = 0x66};
    return dcs_command(dcs, DCS_COLMOD, &colmod[dcs->panel.format], 1);
}

/* From reset to a chip that shows its memory. */
static int dcs_wake(struct dcs *dcs)
{
    int err = dcs_command_wait(dcs, DCS_SLPOUT, SLEEP_US);
    if (err) return err;
    err = dcs_send_setup(dcs);
    if (err) return err;
    err = dcs_send_format(dcs);
    if (err) return err;
    err = dcs_send_madctl(dcs, dcs->rotation);
    if (err) return err;
    err = dcs_send_inverted(dcs, dcs->inverted);
    if (err) return err;
    return dcs_command(dcs, DCS_DISPON, NULL, 0);
}

static int dcs_init(struct panel *panel)
{
    struct dcs *dcs = dcs_of(panel);
    dcs->left_px = 0;
    int err = wire_begin(&dcs->wire);
    if (err) return err;
    err = wire_set(&dcs->config.backlight, false);
    if (err) return err;
    err = pin_is_wired(&dcs->config.reset) ? wire_reset(&dcs->config.reset, &dcs->config.clock, RESET_US)
                                           : dcs_reset_by_command(dcs);
    if (err) return err;
    err = dcs_wake(dcs);
    if (err) return err;
    return wire_set(&dcs->config.backlight, true);
}

static int dcs_sleep(struct panel *panel, bool asleep)
{
    return dcs_command_wait(dcs_of(panel), asleep ? DCS_SLPIN : DCS_SLPOUT, SLEEP_US);
}

/* Dark before the picture goes, light after it is back: no flash of white. */
static int dcs_blank(struct panel *panel, bool blank)
{
    struct dcs *dcs = dcs_of(panel);
    if (blank) {
        int err = wire_set(&dcs->config.backlight, false);
        if (err) return err;
        return dcs_command(dcs, DCS_DISPOFF, NULL, 0);
    }
    int err = dcs_command(dcs, DCS_DISPON, NULL, 0);
    if (err) return err;
    return wire_set(&dcs->config.backlight, true);
}

static int dcs_set_rotation(struct panel *panel, enum panel_rotation rotation)
{
    struct dcs *dcs = dcs_of(panel);
    if ((unsigned)rotation > PANEL_TURNED_270) return PANEL_ERR_CONFIG;
    int err = dcs_send_madctl(dcs, rotation);
    if (err) return err;
    dcs_set_size(dcs, rotation);
    return 0;
}

static int dcs_set_inverted(struct panel *panel, bool inverted)
{
    struct dcs *dcs = dcs_of(panel);
    int err = dcs_send_inverted(dcs, inverted);
    if (err) return err;
    dcs->inverted = inverted;
    return 0;
}

static int dcs_set_backlight(struct panel *panel, bool lit)
{
    struct dcs *dcs = dcs_of(panel);
    return pin_is_wired(&dcs->config.backlight) ? pin_set(&dcs->config.backlight, lit) : PANEL_ERR_UNSUPPORTED;
}

/* Pixel centres inside of the ellipse: dx / w and dy / h, of doubled distances from the middle. The chord's half is the
 * root of (1 - (dy / h)^2) w^2, found bit by bit. */
static void dcs_visible(const struct panel *panel, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const uint32_t w = panel->w_px, h = panel->h_px;

    const uint32_t dy = 2u * y_px + 1u > h ? 2u * y_px + 1u - h : h - 2u * y_px - 1u;
    const uint64_t room = (uint64_t)(h * h - dy * dy) * w * w;
    uint32_t reach = 0; /* the greatest dx with dx^2 h^2 <= room */

    for (uint32_t bit = UINT32_C(1) << 15; bit; bit >>= 1)
        if ((uint64_t)((reach | bit) * (reach | bit)) * h * h <= room) reach |= bit;
    const uint32_t half =
        (reach + (w & 1u ? 2u : 1u)) / 2u; /* pixels on one side of the middle, which may be one's centre */
    *x0_px = (uint16_t)(w / 2u + (w & 1u) - half);
    *x1_px = (uint16_t)(w / 2u + half);
}

/* Subtractions after the size checks cannot wrap, where sums of two 16-bit fields could. */
static bool dcs_config_fits(const struct dcs_config *config, const struct dcs_chip *chip)
{
    if (!config->bus.write || !config->dc.set || !config->clock.delay) return false;
    if (config->w_px == 0 || config->w_px > chip->mem_w_px) return false;
    if (config->h_px == 0 || config->h_px > chip->mem_h_px) return false;
    if (config->ox_px > chip->mem_w_px - config->w_px) return false;
    if (config->oy_px > chip->mem_h_px - config->h_px) return false;
    if ((unsigned)config->format >= PANEL_FORMATS || !((chip->formats | 1 << PANEL_USUAL) >> config->format & 1))
        return false;
    return (unsigned)config->rotation <= PANEL_TURNED_270;
}

int dcs_setup(struct dcs *dcs, const struct dcs_chip *chip, const struct dcs_config *config)
{
    static const struct panel_ops ops = {
        .init = dcs_init,
        .window = dcs_window,
        .pixels = dcs_pixels,
        .flush = dcs_flush,
        .sleep = dcs_sleep,
        .blank = dcs_blank,
        .set_rotation = dcs_set_rotation,
        .set_inverted = dcs_set_inverted,
        .set_backlight = dcs_set_backlight,
    };
    if (!dcs_config_fits(config, chip)) return PANEL_ERR_CONFIG;
    *dcs = (struct dcs){.chip = chip, .config = *config, .wire = {.bus = config->bus, .dc = config->dc}};
    dcs->panel = (struct panel){.ops = &ops, .chip = dcs};
    dcs->panel.format = config->format != PANEL_USUAL ? config->format : chip->format;
    if (chip->is_round) dcs->panel.visible = dcs_visible;
    dcs->panel.window_b = (uint16_t)(WINDOW_B + WINDOW_MESSAGES * config->bus.message_b);
    dcs_set_size(dcs, config->rotation);
    return 0;
}
