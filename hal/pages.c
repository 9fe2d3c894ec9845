/* SPDX-License-Identifier: MIT
 *
 * Panels of pages behind struct panel.
 * In: windows of whole pages, and their bytes. Out: an address before each page, or before a window where the chip goes
 * on by itself, and the bytes. */
#include "pages.h"

uint8_t pages_put(uint8_t *commands, const uint8_t *list, uint8_t n_b)
{
    for (uint8_t i = 0; i < n_b; i++)
        commands[i] = list[i];
    return n_b;
}

uint8_t pages_setup_oled(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast,
                         const uint8_t *supply, uint8_t supply_b, uint8_t precharge)
{
    /* clang-format off */
    const uint8_t list[] = {
        0xAE,                             /* display off */
        0xD5, 0x80,                       /* clock */
        0xA8, (uint8_t)(config->h_px - 1u), /* lines */
        0xDA, config->wiring == PAGES_WIRING_SEQUENTIAL ? 0x02 : 0x12,
        0x81, contrast,
        0xD9, precharge, 0xDB, 0x40,      /* level of what is off */
        0xA4,                             /* show memory */
    };
    /* clang-format on */
    const uint8_t n_b = pages_put(commands, list, sizeof list);

    return (uint8_t)(n_b + pages_put(commands + n_b, supply, supply_b));
}

uint8_t pages_look_ae(uint8_t commands[2], bool on, bool inverted)
{
    commands[0] = inverted ? 0xA7 : 0xA6;
    commands[1] = on ? 0xAF : 0xAE;
    return 2;
}

uint8_t pages_flip_a0(uint8_t commands[2], bool columns, bool rows)
{
    commands[0] = columns ? 0xA0 : 0xA1;
    commands[1] = rows ? 0xC0 : 0xC8;
    return 2;
}

uint8_t pages_address_b0(uint8_t commands[PAGES_ADDRESS_MAX_B], uint8_t page, uint8_t column)
{
    commands[0] = (uint8_t)(0xB0 | page);
    commands[1] = column & 0x0F;
    commands[2] = (uint8_t)(0x10 | column >> 4);
    return 3;
}

/* An address, after D/C's change and before its change back. */
enum { WINDOW_MESSAGES = 3 };

static struct pages *pages_of(const struct panel *panel)
{
    return panel->chip;
}

static void pages_close(struct pages *pages)
{
    pages->page = pages->end_page = 0;
}

/* A command that an error cut short would take what comes next for the arguments that it lacks: a window's lack two at
 * most. So two commands come first that take none and change nothing. Other commands take one argument at most, and
 * only a set-up has such, which begins with a command to spare. */
static int pages_resume(struct pages *pages)
{
    uint8_t commands[2];

    if (!pages->chip->window || !pages->wire.cut) return 0;
    return wire_command(&pages->wire, commands,
                        pages->chip->look(commands, pages->on, pages->inverted != pages->config.invert));
}

static int pages_command(struct pages *pages, const uint8_t *commands, uint8_t n_b)
{
    int err = pages_resume(pages);

    if (err) return err;
    err = wire_command(&pages->wire, commands, n_b);
    pages->wire.cut = err;
    return err;
}

/* Whether the picture runs against the glass's columns. */
static bool pages_runs_back(const struct pages *pages, enum panel_rotation rotation)
{
    return (rotation == PANEL_TURNED_180) != pages->config.mirror;
}

/* Lines counted from below meet the glass as far on the other side; where all outputs are scanned, and not those of the
 * glass alone, those that it does not have come before. Chips count lines modulo 64. */
static int pages_send_flip(struct pages *pages, enum panel_rotation rotation)
{
    const struct pages_chip *chip = pages->chip;
    const struct pages_config *config = &pages->config;
    const bool on_its_head = rotation == PANEL_TURNED_180;
    uint8_t line = config->start_line, shift = config->shift, commands[5];

    if (!chip->flip) return 0;
    if (on_its_head) {
        line = (uint8_t)((chip->scans_all ? config->h_px : 0) - line);
        shift = (uint8_t)-shift;
    }
    chip->flip(commands, config->flip_columns != pages_runs_back(pages, rotation), config->flip_rows != on_its_head);
    commands[2] = (uint8_t)(chip->start_line | (line & 63));
    commands[3] = 0xD3;
    commands[4] = shift & 63;
    return pages_command(pages, commands, chip->is_oled ? 5 : 3);
}

static int pages_send_look(struct pages *pages, bool on, bool inverted)
{
    uint8_t commands[2];

    return pages_command(pages, commands, pages->chip->look(commands, on, inverted != pages->config.invert));
}

static int pages_send_setup(struct pages *pages)
{
    const struct pages_config *config = &pages->config;
    uint8_t commands[PAGES_SETUP_MAX_B];
    const uint8_t n_b =
        pages->chip->setup(commands, config, config->contrast ? config->contrast : pages->chip->contrast);

    pages->on = false; /* and no look before the voltages says otherwise */
    int err = pages_command(pages, commands, n_b);
    for (uint8_t i = 0; i < pages->chip->wake_b && !err; i++) {
        err = pages_command(pages, &pages->chip->wake[i], 1);
        if (!err) err = clock_delay(&pages->config.clock, pages->chip->wake_us);
    }
    return err;
}

static int pages_init(struct panel *panel)
{
    struct pages *pages = pages_of(panel);
    const struct pages_config *config = &pages->config;

    pages_close(pages);
    int err = wire_begin(&pages->wire);
    if (err) return err;
    err = wire_set(&config->backlight, false);
    if (err) return err;
    if (pin_is_wired(&config->reset)) err = wire_reset(&config->reset, &config->clock, pages->chip->reset_us);
    if (err) return err;
    err = pages_send_setup(pages);
    if (err) return err;
    err = pages_send_flip(pages, pages->rotation);
    if (err) return err;
    err = pages_send_look(pages, true, pages->inverted);
    if (err) return err;
    pages->on = true;
    return wire_set(&config->backlight, true);
}

/* Against the glass's columns memory is counted from the other end, where the glass's margin is the other one. */
static uint8_t pages_column(const struct pages *pages, uint16_t x_px)
{
    const struct pages_config *config = &pages->config;
    const uint16_t margin_px = (uint16_t)(pages->chip->mem_w_px - config->w_px - config->ox_px);

    return (uint8_t)((pages_runs_back(pages, pages->rotation) ? margin_px : config->ox_px) + x_px);
}

/* Windows take more bytes than pages do, so they are for ports where each message costs as much as many bytes: there a
 * frame is one address. Elsewhere an address for each page costs less than a longer one for each piece of a page. */
static bool pages_takes_windows(const struct pages *pages)
{
    return pages->chip->window && pages->config.bus.message_b;
}

/* Of the window, or of the page that is next. */
static uint8_t pages_put_address(const struct pages *pages, uint8_t commands[PAGES_ADDRESS_MAX_B])
{
    const uint8_t first = pages_column(pages, pages->x_px);
    const uint8_t last = (uint8_t)(first + pages->end_x_px - pages->x_px - 1);

    if (!pages_takes_windows(pages)) return pages->chip->address(commands, pages->page, first);
    return pages->chip->window(commands, (const uint8_t[]){first, last},
                               (const uint8_t[]){pages->page, (uint8_t)(pages->end_page - 1u)});
}

/* Whether the chip goes from page to page of such a window by itself. */
static bool pages_runs_on(const struct pages *pages, uint16_t w_px)
{
    return pages_takes_windows(pages) || (pages->chip->runs_on && w_px == pages->chip->mem_w_px);
}

static int pages_send_address(struct pages *pages)
{
    uint8_t commands[PAGES_ADDRESS_MAX_B];

    return pages_command(pages, commands, pages_put_address(pages, commands));
}

/* Where pages are addressed one by one each of them costs as much. */
static uint16_t pages_window_b(const struct pages *pages)
{
    uint8_t commands[PAGES_ADDRESS_MAX_B];

    return (uint16_t)(pages_put_address(pages, commands) + WINDOW_MESSAGES * pages->config.bus.message_b);
}

static int pages_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    struct pages *pages = pages_of(panel);

    pages_close(pages);
    if (!panel_holds(panel, x_px, y_px, w_px, h_px)) return PANEL_ERR_WINDOW;
    pages->x_px = pages->at_x_px = x_px;
    pages->end_x_px = (uint16_t)(x_px + w_px);
    pages->page = (uint8_t)(y_px / 8u);
    pages->end_page = (uint8_t)(pages->page + h_px / 8u);
    pages->whole = pages_runs_on(pages, w_px);
    int err = pages_send_address(pages);
    if (err) pages_close(pages);
    return err;
}

/* The address of the next page, where it takes one, goes out with its first byte. */
static int pages_send_some(struct pages *pages, const uint8_t *data, size_t *n_b)
{
    if (pages->page == pages->end_page) return PANEL_ERR_WINDOW;
    if (pages->at_x_px == pages->end_x_px) {
        if (++pages->page == pages->end_page) return PANEL_ERR_WINDOW;
        pages->at_x_px = pages->x_px;
        int err = pages->whole ? 0 : pages_send_address(pages);
        if (err) return err;
    }
    const size_t room_b = (size_t)(pages->end_x_px - pages->at_x_px);
    if (*n_b > room_b) *n_b = room_b;
    pages->at_x_px = (uint16_t)(pages->at_x_px + *n_b);
    return wire_data(&pages->wire, data, *n_b);
}

static int pages_pixels(struct panel *panel, const void *data, size_t n_px)
{
    struct pages *pages = pages_of(panel);
    const uint8_t *bytes = data;

    for (size_t left_b = n_px / 8u; left_b;) {
        size_t n_b = left_b;
        int err = pages_send_some(pages, bytes, &n_b);
        if (err) {
            pages_close(pages);
            return err;
        }
        bytes += n_b;
        left_b -= n_b;
    }
    return 0;
}

static int pages_flush(struct panel *panel)
{
    struct pages *pages = pages_of(panel);
    int err = wire_flush(&pages->wire);

    if (err) pages_close(pages);
    return err;
}

/* Dark before the picture goes, light after it is back. */
static int pages_blank(struct panel *panel, bool blank)
{
    struct pages *pages = pages_of(panel);
    int err = blank ? wire_set(&pages->config.backlight, false) : 0;

    pages_close(pages);
    if (!err) err = pages_send_look(pages, !blank, pages->inverted);
    if (err) return err;
    pages->on = !blank;
    return blank ? 0 : wire_set(&pages->config.backlight, true);
}

static bool pages_can(const struct pages_chip *chip, enum panel_rotation rotation)
{
    return rotation == PANEL_UPRIGHT || (rotation == PANEL_TURNED_180 && chip->flip);
}

static int pages_set_rotation(struct panel *panel, enum panel_rotation rotation)
{
    struct pages *pages = pages_of(panel);

    if (!pages_can(pages->chip, rotation)) return PANEL_ERR_UNSUPPORTED;
    pages_close(pages);
    int err = pages_send_flip(pages, rotation);
    if (!err) pages->rotation = rotation;
    return err;
}

static int pages_set_inverted(struct panel *panel, bool inverted)
{
    struct pages *pages = pages_of(panel);

    pages_close(pages);
    int err = pages_send_look(pages, pages->on, inverted);
    if (!err) pages->inverted = inverted;
    return err;
}

static int pages_set_backlight(struct panel *panel, bool lit)
{
    struct pages *pages = pages_of(panel);

    return pin_is_wired(&pages->config.backlight) ? pin_set(&pages->config.backlight, lit) : PANEL_ERR_UNSUPPORTED;
}

static bool pages_is_size(uint16_t px, uint16_t most_px)
{
    return px && px <= most_px;
}

/* What chips that count lines are told of them has six bits. */
static bool pages_config_fits(const struct pages_config *config, const struct pages_chip *chip)
{
    if (!config->bus.write || !config->dc.set || !config->clock.delay) return false;
    if (!pages_is_size(config->w_px, chip->mem_w_px) || !pages_is_size(config->h_px, chip->mem_h_px)) return false;
    if (config->h_px % 8 || config->ox_px > chip->mem_w_px - config->w_px) return false;
    if (config->contrast > chip->contrast_max || (config->start_line | config->shift) > 63) return false;
    if (!chip->flip && (config->mirror || config->flip_columns || config->flip_rows || config->start_line))
        return false;
    if ((unsigned)config->wiring > PAGES_WIRING_ALTERNATIVE) return false;
    if (!chip->is_oled && (config->wiring || config->internal_reference || config->shift)) return false;
    return pages_can(chip, config->rotation);
}

int pages_setup(struct pages *pages, const struct pages_chip *chip, const struct pages_config *config)
{
    static const struct panel_ops ops = {
        .init = pages_init,
        .window = pages_window,
        .pixels = pages_pixels,
        .flush = pages_flush,
        .blank = pages_blank,
        .set_rotation = pages_set_rotation,
        .set_inverted = pages_set_inverted,
        .set_backlight = pages_set_backlight,
    };
    if (!pages_config_fits(config, chip)) return PANEL_ERR_CONFIG;
    *pages = (struct pages){.chip = chip, .rotation = config->rotation};
    pages->config = *config;
    pages->wire.bus = config->bus;
    pages->wire.dc = config->dc;
    struct panel *panel = &pages->panel;
    panel->ops = &ops;
    panel->chip = pages;
    panel->w_px = config->w_px;
    panel->h_px = config->h_px;
    panel->step_x_px = 1;
    panel->step_y_px = 8;
    panel->format = PANEL_MONO_PAGES;
    panel->runs_on = pages_runs_on(pages, config->w_px);
    panel->window_b = pages_window_b(pages);
    return 0;
}
