/* SPDX-License-Identifier: MIT
 *
 * Panels of the MIPI Display Command Set behind struct panel.
 * In: windows and pixels of the turned picture. Out: bytes on the bus, and the level of D/C,
 * which tells a command (low) from arguments and pixels (high).
 * Every command ends with a flush, so that its bytes may live on the stack; only pixels are left
 * to travel on their own. */
#include "dcs.h"

#include "turn.h"

/* MADCTL, beside enum turn: the glass is refreshed from its last line up; blue first. */
#define MADCTL_ML 0x10u
#define MADCTL_BGR 0x08u

/* Waits, in microseconds. The standard asks for 10 us of reset, 5 ms until the chip listens again and
 * 120 ms until it may leave sleep, and 120 ms between entering and leaving sleep, either way. */
#define LISTEN_US UINT32_C(10000)
#define RESET_US UINT32_C(150000)
#define SLEEP_US UINT32_C(120000)

/* CASET and RASET with four arguments each, and RAMWR: their bytes, and how often they are written or D/C changes. */
enum { WINDOW_B = 11, WINDOW_MESSAGES = 11 };

/* Two frames of the slowest refresh that one of the chips can be set to, 28 Hz. */
#define TEARING_US UINT32_C(72000)

static struct dcs *dcs_of(const struct panel *panel)
{
    return panel->chip;
}

static int dcs_command_wait(struct dcs *dcs, uint8_t command, uint32_t delay_us)
{
    int err = wire_send(&dcs->wire, command, NULL, 0);
    if (err) return err;
    return clock_delay(&dcs->config.clock, delay_us);
}

/* The picture on the glass, and then the glass on the memory. Who waits for the refresh wants to write behind it: it
 * starts at the picture's first line where that is one of the glass's. */
static uint8_t dcs_madctl(const struct dcs *dcs, enum panel_rotation rotation)
{
    const struct dcs_config *config = &dcs->config;
    unsigned madctl = (unsigned)turn_of(rotation, config->mirror) ^ dcs->chip->reversed;

    if (config->flip_columns) madctl ^= TURN_COLUMNS;
    if (config->flip_rows) madctl ^= TURN_ROWS;
    if (edge_is_wired(&config->tearing) && (madctl & (TURN_EXCHANGE | TURN_ROWS)) == TURN_ROWS) madctl |= MADCTL_ML;
    if (config->bgr) madctl |= MADCTL_BGR;
    return (uint8_t)madctl;
}

static int dcs_send_madctl(struct dcs *dcs, enum panel_rotation rotation)
{
    uint8_t madctl = dcs_madctl(dcs, rotation);
    return wire_send(&dcs->wire, DCS_MADCTL, &madctl, 1);
}

static int dcs_send_inverted(struct dcs *dcs, bool inverted)
{
    return wire_send(&dcs->wire, dcs->config.invert != inverted ? DCS_INVON : DCS_INVOFF, NULL, 0);
}

static void dcs_set_size(struct dcs *dcs, enum panel_rotation rotation)
{
    dcs->rotation = rotation;
    turn_size(&dcs->panel, rotation, dcs->config.w_px, dcs->config.h_px);
}

/* Sends CASET or RASET: first and last address, high byte first. */
static int dcs_address(struct dcs *dcs, uint8_t command, uint16_t first, uint16_t n)
{
    uint16_t last = (uint16_t)(first + n - 1u);
    uint8_t args[] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    return wire_send(&dcs->wire, command, args, sizeof args);
}

static uint16_t dcs_mem_w_px(const struct dcs_config *config, const struct dcs_chip *chip)
{
    return config->mem_w_px ? config->mem_w_px : chip->mem_w_px;
}

static uint16_t dcs_mem_h_px(const struct dcs_config *config, const struct dcs_chip *chip)
{
    return config->mem_h_px ? config->mem_h_px : chip->mem_h_px;
}

/* The offset rule: an axis that the picture runs against counts from the memory's far end, so the glass's other margin
 * is the offset; exchanged axes exchange the offsets. It holds for every turn and mirror, and however the glass shows
 * memory: offsets are those of the upright picture. */
static void dcs_offsets(const struct dcs *dcs, uint16_t *x_px, uint16_t *y_px)
{
    const struct dcs_config *config = &dcs->config;
    const uint8_t turn = turn_of(dcs->rotation, config->mirror);
    uint16_t column = config->ox_px;
    uint16_t row = config->oy_px;
    if (turn & TURN_COLUMNS) column = (uint16_t)(dcs_mem_w_px(config, dcs->chip) - config->w_px - config->ox_px);
    if (turn & TURN_ROWS) row = (uint16_t)(dcs_mem_h_px(config, dcs->chip) - config->h_px - config->oy_px);
    *x_px = turn & TURN_EXCHANGE ? row : column;
    *y_px = turn & TURN_EXCHANGE ? column : row;
}

static int dcs_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    struct dcs *dcs = dcs_of(panel);
    wire_open(&dcs->wire, 0);
    if (!panel_holds(panel, x_px, y_px, w_px, h_px)) return PANEL_ERR_WINDOW;

    uint16_t ox_px, oy_px;
    dcs_offsets(dcs, &ox_px, &oy_px);
    int err = dcs_address(dcs, DCS_CASET, (uint16_t)(ox_px + x_px), w_px);
    if (err) return err;
    err = dcs_address(dcs, DCS_RASET, (uint16_t)(oy_px + y_px), h_px);
    if (err) return err;
    err = wire_send(&dcs->wire, DCS_RAMWR, NULL, 0);
    if (err) return err;
    wire_open(&dcs->wire, (uint32_t)w_px * h_px);
    return 0;
}

static int dcs_pixels(struct panel *panel, const void *data, size_t n_px)
{
    return wire_pixels(&dcs_of(panel)->wire, panel->format, data, n_px);
}

static int dcs_flush(struct panel *panel)
{
    return wire_flush(&dcs_of(panel)->wire);
}

/* A frame that comes too late for one refresh is better than none. */
static int dcs_begin_frame(struct panel *panel)
{
    const struct edge *tearing = &dcs_of(panel)->config.tearing;

    if (!edge_is_wired(tearing)) return 0;
    const int came = edge_wait(tearing, TEARING_US);
    if (came == 0) panel->missed_edges++;
    return came < 0 ? came : 0;
}

/* The first wait: the host may have restarted while the chip was leaving sleep, when it takes no
 * SWRESET, or both have just been powered. */
static int dcs_reset_by_command(struct dcs *dcs)
{
    int err = clock_delay(&dcs->config.clock, SLEEP_US);
    if (err) return err;
    return dcs_command_wait(dcs, DCS_SWRESET, RESET_US);
}

/* At the end of each refresh alone, not at that of each line. */
static int dcs_send_tearing(struct dcs *dcs)
{
    const uint8_t mode = 0;

    return edge_is_wired(&dcs->config.tearing) ? wire_send(&dcs->wire, DCS_TEON, &mode, 1) : 0;
}

static int dcs_send_format(struct dcs *dcs)
{
    static const uint8_t colmod[] = {[PANEL_RGB565] = 0x55, [PANEL_RGB444] = 0x53, [PANEL_RGB666] = 0x66};
    return wire_send(&dcs->wire, DCS_COLMOD, &colmod[dcs->panel.format], 1);
}

/* A pin that the board has may lead nowhere on the module, so the command comes in any case. */
static int dcs_reset(struct dcs *dcs)
{
    const struct dcs_config *config = &dcs->config;
    int err = pin_is_wired(&config->reset) ? wire_reset(&config->reset, &config->clock, LISTEN_US) : 0;
    if (err) return err;
    return dcs_reset_by_command(dcs);
}

/* Out of sleep with the chip's own registers set. */
static int dcs_leave_sleep(struct dcs *dcs)
{
    const struct dcs_chip *chip = dcs->chip;
    int err = chip->wakes_last ? wire_send_list(&dcs->wire, chip->setup, chip->setup_b) : 0;
    if (err) return err;
    err = dcs_command_wait(dcs, DCS_SLPOUT, SLEEP_US);
    if (err || chip->wakes_last) return err;
    return wire_send_list(&dcs->wire, chip->setup, chip->setup_b);
}

/* From reset to a chip that shows its memory. */
static int dcs_wake(struct dcs *dcs)
{
    int err = dcs_leave_sleep(dcs);
    if (err) return err;
    err = dcs_send_tearing(dcs);
    if (err) return err;
    err = dcs_send_format(dcs);
    if (err) return err;
    err = dcs_send_madctl(dcs, dcs->rotation);
    if (err) return err;
    err = dcs_send_inverted(dcs, dcs->inverted);
    if (err) return err;
    return wire_send(&dcs->wire, DCS_DISPON, NULL, 0);
}

static int dcs_init(struct panel *panel)
{
    struct dcs *dcs = dcs_of(panel);
    int err = wire_begin(&dcs->wire);
    if (err) return err;
    err = wire_set(&dcs->config.backlight, false);
    if (err) return err;
    err = dcs_reset(dcs);
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
        return wire_send(&dcs->wire, DCS_DISPOFF, NULL, 0);
    }
    int err = wire_send(&dcs->wire, DCS_DISPON, NULL, 0);
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
    const uint16_t mem_w_px = dcs_mem_w_px(config, chip), mem_h_px = dcs_mem_h_px(config, chip);
    if (mem_w_px > chip->mem_w_px || mem_h_px > chip->mem_h_px) return false;
    if (config->w_px == 0 || config->w_px > mem_w_px || config->ox_px > mem_w_px - config->w_px) return false;
    if (config->h_px == 0 || config->h_px > mem_h_px || config->oy_px > mem_h_px - config->h_px) return false;
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
        .begin_frame = dcs_begin_frame,
        .sleep = dcs_sleep,
        .blank = dcs_blank,
        .set_rotation = dcs_set_rotation,
        .set_inverted = dcs_set_inverted,
        .set_backlight = dcs_set_backlight,
    };
    if (!dcs_config_fits(config, chip)) return PANEL_ERR_CONFIG;
    *dcs = (struct dcs){.chip = chip, .config = *config, .wire = {.bus = config->bus, .dc = config->dc}};
    dcs->panel = (struct panel){.ops = &ops, .chip = dcs, .step_x_px = 1, .step_y_px = 1};
    dcs->panel.format = config->format != PANEL_USUAL ? config->format : chip->format;
    if (chip->is_round) dcs->panel.visible = dcs_visible;
    dcs->panel.window_b = (uint16_t)(WINDOW_B + WINDOW_MESSAGES * config->bus.message_b);
    dcs_set_size(dcs, config->rotation);
    return 0;
}
