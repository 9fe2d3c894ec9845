/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech's controllers behind struct panel.
 * In: windows and pixels of the turned picture. Out: bytes on the bus, and the level of D/C. */
#include "solomon.h"

#include "turn.h"

enum {
    COLUMNS = 0x15, /* first and last that a window has */
    ROWS = 0x75,
    REMAP = 0xA0,
    START_LINE = 0xA1,
    SHIFT = 0xA2,
    SLEEP = 0xAE,
    WAKE = 0xAF
};

#define RESET_US UINT32_C(10000) /* no chip asks for more than 2 */

static struct solomon *solomon_of(const struct panel *panel)
{
    return panel->chip;
}

static int solomon_send_byte(struct solomon *solomon, uint8_t command, uint8_t arg)
{
    return wire_send(&solomon->wire, command, &arg, 1);
}

/* The picture on the glass, and then the glass on the memory. */
static uint8_t solomon_turn(const struct solomon *solomon, enum panel_rotation rotation)
{
    const struct solomon_config *config = &solomon->config;
    unsigned turn = turn_of(rotation, config->mirror);

    if (config->flip_columns) turn ^= TURN_COLUMNS;
    if (config->flip_rows) turn ^= TURN_ROWS;
    return (uint8_t)turn;
}

/* Glass on the first of all outputs has its top line as far from the last one as memory has more lines than it: what is
 * scanned from there meets it later. */
static uint8_t solomon_start_line(const struct solomon *solomon, enum panel_rotation rotation)
{
    const struct solomon_chip *chip = solomon->chip;
    const struct solomon_config *config = &solomon->config;
    const bool on_its_head = turn_of(rotation, config->mirror) & TURN_ROWS;
    const bool from_the_last = !(solomon_turn(solomon, rotation) & TURN_ROWS);
    const unsigned line = on_its_head ? chip->mem_h_px - (unsigned)config->start_line : config->start_line;

    return (uint8_t)((line + (chip->scans_all && from_the_last ? config->h_px : 0u)) % chip->mem_h_px);
}

/* Lines counted from below: what is shifted one way is shifted the other. A chip that counts from the last of all
 * outputs, and not of those that the glass has, meets the glass that much later. */
static uint8_t solomon_shift_turned(const struct solomon *solomon)
{
    const struct solomon_chip *chip = solomon->chip;
    const struct solomon_config *config = &solomon->config;

    if (config->shift_turned) return config->shift_turned;
    return (uint8_t)((2u * chip->mem_h_px + (chip->counts_all ? config->h_px : 0u) - config->shift) % chip->mem_h_px);
}

static int solomon_send_turn(struct solomon *solomon, enum panel_rotation rotation)
{
    const struct solomon_chip *chip = solomon->chip;
    const struct solomon_config *config = &solomon->config;
    const uint8_t turn = solomon_turn(solomon, rotation);
    const bool on_its_head = turn_of(rotation, config->mirror) & TURN_ROWS;
    unsigned remap = chip->remap;

    if (turn & TURN_ROWS) remap ^= chip->remap_rows;
    if (turn & TURN_COLUMNS) remap ^= chip->remap_columns;
    if (turn & TURN_EXCHANGE) remap ^= chip->remap_exchange;
    if (config->bgr) remap ^= chip->remap_bgr;
    if (solomon->panel.format == PANEL_RGB666_LOW) remap ^= chip->remap_wide;
    int err = solomon_send_byte(solomon, REMAP, (uint8_t)remap);
    if (err) return err;
    err = solomon_send_byte(solomon, START_LINE, solomon_start_line(solomon, rotation));
    if (err) return err;
    return solomon_send_byte(solomon, SHIFT, on_its_head ? solomon_shift_turned(solomon) : config->shift);
}

static int solomon_send_shown(struct solomon *solomon, bool blank, bool inverted)
{
    const struct solomon_chip *chip = solomon->chip;
    const bool negative = inverted != solomon->config.invert;

    return wire_send(&solomon->wire, blank ? chip->all_off : negative ? chip->negative : chip->as_is, NULL, 0);
}

/* A command that an error cut short would take what comes with D/C low for the arguments that it lacks: a window's lack
 * two at most. So two commands come first that need none and change nothing. */
static int solomon_resume(struct solomon *solomon)
{
    if (!solomon->chip->args_low || !solomon->wire.cut) return 0;
    int err = solomon_send_shown(solomon, solomon->blank, solomon->inverted);
    return err ? err : solomon_send_shown(solomon, solomon->blank, solomon->inverted);
}

static int solomon_send_setup(struct solomon *solomon)
{
    const struct solomon_chip *chip = solomon->chip;
    const struct solomon_config *config = &solomon->config;

    int err = solomon_resume(solomon);
    if (err) return err;
    err = wire_send_list(&solomon->wire, chip->setup, chip->setup_b);
    if (err) return err;
    if (chip->converter)
        err = solomon_send_byte(solomon, chip->converter, config->converter ? chip->internal : chip->external);
    if (err) return err;
    err = solomon_send_byte(solomon, chip->lines, (uint8_t)((chip->scans_all ? chip->mem_h_px : config->h_px) - 1u));
    if (err) return err;
    return solomon_send_byte(solomon, chip->contrast_command, config->contrast ? config->contrast : chip->contrast);
}

static int solomon_init(struct panel *panel)
{
    struct solomon *solomon = solomon_of(panel);
    const struct solomon_config *config = &solomon->config;

    int err = wire_begin(&solomon->wire);
    if (err) return err;
    err = wire_set(&config->backlight, false);
    if (err) return err;
    if (pin_is_wired(&config->reset)) err = wire_reset(&config->reset, &config->clock, RESET_US);
    if (err) return err;
    err = solomon_send_setup(solomon);
    if (err) return err;
    err = solomon_send_turn(solomon, solomon->rotation);
    if (err) return err;
    err = solomon_send_shown(solomon, false, solomon->inverted);
    if (err) return err;
    solomon->blank = false;
    err = wire_set(&config->backlight, true);
    if (err) return err;
    return wire_send(&solomon->wire, WAKE, NULL, 0);
}

static int solomon_send_range(struct solomon *solomon, uint8_t command, unsigned first, unsigned n)
{
    const uint8_t range[] = {(uint8_t)first, (uint8_t)(first + n - 1u)};

    return wire_send(&solomon->wire, command, range, sizeof range);
}

/* Two ranges and, where there is one, the command that starts pixels: bytes, and how often they are written or D/C
 * changes. With arguments as low as commands it stays low from the first to the last. */
enum { WINDOW_B = 7, WINDOW_MESSAGES = 11, GREY_WINDOW_B = 6, GREY_WINDOW_MESSAGES = 6 };

/* Columns and rows are the memory's, however the picture runs over them. Against the glass's columns memory is counted
 * from the other end, where the glass's margin is the other one; of lines only those in use are counted, from either
 * end. */
static int solomon_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    struct solomon *solomon = solomon_of(panel);
    const struct solomon_config *config = &solomon->config;
    const struct solomon_chip *chip = solomon->chip;
    const uint8_t turn = turn_of(solomon->rotation, config->mirror);
    const bool exchanges = turn & TURN_EXCHANGE;
    const unsigned ox_px =
        turn & TURN_COLUMNS ? (unsigned)(chip->mem_w_px - config->w_px - config->ox_px) : config->ox_px;
    const unsigned column_px = ox_px + (exchanges ? y_px : x_px), n_px = exchanges ? h_px : w_px;

    wire_open(&solomon->wire, 0);
    if (!panel_holds(panel, x_px, y_px, w_px, h_px)) return PANEL_ERR_WINDOW;
    int err = solomon_resume(solomon);
    if (err) return err;
    err = solomon_send_range(solomon, COLUMNS, column_px / chip->column_px, n_px / chip->column_px);
    if (err) return err;
    err = solomon_send_range(solomon, ROWS, exchanges ? x_px : y_px, exchanges ? w_px : h_px);
    if (!err && chip->write) err = wire_send(&solomon->wire, chip->write, NULL, 0);
    if (err) return err;
    wire_open(&solomon->wire, (uint32_t)w_px * h_px);
    return 0;
}

static int solomon_pixels(struct panel *panel, const void *data, size_t n_px)
{
    return wire_pixels(&solomon_of(panel)->wire, panel->format, data, n_px);
}

static int solomon_flush(struct panel *panel)
{
    return wire_flush(&solomon_of(panel)->wire);
}

static int solomon_sleep(struct panel *panel, bool asleep)
{
    return wire_send(&solomon_of(panel)->wire, asleep ? SLEEP : WAKE, NULL, 0);
}

/* Dark before the supply goes, and until it is back. */
static int solomon_blank(struct panel *panel, bool blank)
{
    struct solomon *solomon = solomon_of(panel);
    int err = blank ? 0 : wire_set(&solomon->config.backlight, true);

    if (!err) err = solomon_send_shown(solomon, blank, solomon->inverted);
    if (err) return err;
    solomon->blank = blank;
    return blank ? wire_set(&solomon->config.backlight, false) : 0;
}

static bool solomon_can(const struct solomon_chip *chip, enum panel_rotation rotation)
{
    return (unsigned)rotation <= PANEL_TURNED_270 &&
           (chip->remap_exchange || !(turn_of(rotation, false) & TURN_EXCHANGE));
}

static void solomon_set_size(struct solomon *solomon, enum panel_rotation rotation)
{
    solomon->rotation = rotation;
    turn_size(&solomon->panel, rotation, solomon->config.w_px, solomon->config.h_px);
}

static int solomon_set_rotation(struct panel *panel, enum panel_rotation rotation)
{
    struct solomon *solomon = solomon_of(panel);

    if (!solomon_can(solomon->chip, rotation)) return PANEL_ERR_UNSUPPORTED;
    int err = solomon_send_turn(solomon, rotation);
    if (!err) solomon_set_size(solomon, rotation);
    return err;
}

static int solomon_set_inverted(struct panel *panel, bool inverted)
{
    struct solomon *solomon = solomon_of(panel);
    int err = solomon_send_shown(solomon, solomon->blank, inverted);

    if (!err) solomon->inverted = inverted;
    return err;
}

static int solomon_set_backlight(struct panel *panel, bool lit)
{
    const struct pin *backlight = &solomon_of(panel)->config.backlight;

    return pin_is_wired(backlight) ? pin_set(backlight, lit) : PANEL_ERR_UNSUPPORTED;
}

static bool solomon_config_fits(const struct solomon_config *config, const struct solomon_chip *chip)
{
    if (!config->bus.write || !config->dc.set || !config->clock.delay) return false;
    if (config->w_px == 0 || config->w_px > chip->mem_w_px || config->ox_px > chip->mem_w_px - config->w_px)
        return false;
    if (config->h_px == 0 || config->h_px > chip->mem_h_px || config->contrast > chip->contrast_max) return false;
    if (config->w_px % chip->column_px || config->ox_px % chip->column_px) return false;
    if (config->start_line >= chip->mem_h_px) return false;
    if ((unsigned)config->format >= PANEL_FORMATS || !((chip->formats | 1 << PANEL_USUAL) >> config->format & 1))
        return false;
    if (config->converter && !chip->converter) return false;
    return solomon_can(chip, config->rotation);
}

int solomon_setup(struct solomon *solomon, const struct solomon_chip *chip, const struct solomon_config *config)
{
    static const struct panel_ops ops = {
        .init = solomon_init,
        .window = solomon_window,
        .pixels = solomon_pixels,
        .flush = solomon_flush,
        .sleep = solomon_sleep,
        .blank = solomon_blank,
        .set_rotation = solomon_set_rotation,
        .set_inverted = solomon_set_inverted,
        .set_backlight = solomon_set_backlight,
    };
    if (!solomon_config_fits(config, chip)) return PANEL_ERR_CONFIG;
    *solomon = (struct solomon){
        .chip = chip, .config = *config, .wire = {.bus = config->bus, .dc = config->dc, .args_low = chip->args_low}};
    solomon->panel = (struct panel){.ops = &ops, .chip = solomon, .step_x_px = chip->column_px, .step_y_px = 1};
    solomon->panel.window_b = (uint16_t)(chip->write ? WINDOW_B + WINDOW_MESSAGES * config->bus.message_b
                                                     : GREY_WINDOW_B + GREY_WINDOW_MESSAGES * config->bus.message_b);
    solomon->panel.format = config->format != PANEL_USUAL ? config->format : chip->format;
    solomon_set_size(solomon, config->rotation);
    return 0;
}
