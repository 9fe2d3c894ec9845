/* SPDX-License-Identifier: MIT
 *
 * Plays a record of a display's wires to an emulated panel: what the kernel's tap or an emulated bridge saw becomes
 * bytes, levels and waits of a chip that has just been given power. Prints what travelled; fails if the chip complains,
 * if bytes came without their chip select, or if what the glass showed last, before it was darkened, is not the picture
 * that was asked for. */
#include "card.h"
#include "pictures/image.h"
#include "render/panel_board.h"
#include "wire_tap.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char USAGE[] = "usage: replay RECORD PANEL[:FORMAT] WxH[+X+Y] WANTED [SHOWN.png]\n"
                            "  +X+Y    where the glass, of the kind that wants inversion, begins in the chip's memory\n"
                            "  WANTED  the picture on the glass: a PNG file, card for the test card, or any\n";

enum { SELECTS = 3, ARGUMENTS_MAX_B = 16, RECORD_MAX_B = 64 << 20 };

struct replay {
    struct panel_choice panel;
    struct emulated_display module;
    struct port port;        /* the module's */
    bool lit;                /* by its backlight */
    uint64_t data_b;         /* since D/C changed last */
    struct film film;        /* what the glass showed last, while it was lit */
    uint16_t *pixels;        /* the film's, */
    uint8_t *rgb;            /* and 3 bytes for each of them */
    bool started;            /* and since when */
    uint64_t start_ns;       /* by the record's clock */
    bool selected[SELECTS];  /* chip selects that are low */
    unsigned held;           /* lines that a program has: a bit each */
    uint64_t sent_b, writes; /* in all */
    uint32_t most_b;         /* of one transfer */
    uint32_t speed_hz, mode; /* of the last transfer */
};

/* Record ------------------------------------------------------------------------------------- */

static int wait_until(struct replay *replay, uint64_t time_ns)
{
    if (!replay->started) replay->start_ns = time_ns;
    replay->started = true;
    const uint64_t now_us = (time_ns - replay->start_ns) / 1000;
    return clock_delay(&replay->port.clock, (uint32_t)(now_us - replay->module.port->now_us));
}

/* Drivers may darken the glass by command before they switch its light off: then there is nothing new to see. */
static void look(struct replay *replay)
{
    const size_t count = (size_t)replay->film.w_px * replay->film.h_px;
    const uint8_t *rgb = replay->rgb;
    bool is_dark = true;

    emulated_display_show(&replay->module, replay->rgb);
    for (size_t i = 0; i < 3 * count && is_dark; i++)
        is_dark = rgb[i] == 0;
    for (size_t i = 0; i < count && !is_dark; i++, rgb += 3)
        replay->pixels[i] = (uint16_t)((rgb[0] >> 3) << 11 | (rgb[1] >> 2) << 5 | rgb[2] >> 3);
}

static int set_backlight(struct replay *replay, bool on)
{
    if (replay->lit && !on) look(replay);
    replay->lit = on;
    return pin_set(&replay->port.backlight, on);
}

/* A command follows; if there were pixels before it, they are the picture, or part of it. */
static int set_dc(struct replay *replay, bool high)
{
    if (replay->lit && !high && replay->data_b > ARGUMENTS_MAX_B) look(replay);
    replay->data_b = 0;
    return pin_set(&replay->port.dc, high);
}

/* Of a module that has such a wire. */
static int set_pin(const struct pin *pin, bool high)
{
    return pin_is_wired(pin) ? pin_set(pin, high) : 0;
}

static int set_line(struct replay *replay, unsigned line, bool high)
{
    replay->held |= 1u << line;
    if (line == WIRE_DC) return set_dc(replay, high);
    if (line == WIRE_RESET) return set_pin(&replay->port.reset, high);
    if (line == WIRE_SELECT) return set_pin(&replay->port.select, high);
    return line == WIRE_BACKLIGHT ? set_backlight(replay, high) : 0;
}

static int send(struct replay *replay, const struct wire_tap_event *event, const uint8_t *data)
{
    replay->sent_b += event->n_b;
    replay->data_b += event->n_b;
    replay->writes++;
    replay->most_b = event->n_b > replay->most_b ? event->n_b : replay->most_b;
    replay->speed_hz = event->value;
    replay->mode = event->mode;
    return bus_write(&replay->port.bus, data, event->n_b);
}

static bool play_event(struct replay *replay, const struct wire_tap_event *event, const uint8_t *data,
                       struct error *err)
{
    const unsigned which = event->which;
    int code = wait_until(replay, event->time_ns);

    if (event->kind == WIRE_TAP_LEVEL) code |= set_line(replay, which, event->value);
    if (event->kind == WIRE_TAP_RELEASED) replay->held &= ~(1u << which);
    if (event->kind == WIRE_TAP_SELECT) replay->selected[which % SELECTS] = event->value == 0;
    if (event->kind == WIRE_TAP_BYTES) {
        if (!replay->selected[which % SELECTS])
            return error_set(err, "%u bytes while chip select %u is high", event->n_b, which);
        code |= send(replay, event, data);
    }
    return code == 0 || error_set(err, "the emulated chip's port fails");
}

static bool play_record(struct replay *replay, const uint8_t *record, size_t record_b, struct error *err)
{
    struct wire_tap_event event;

    for (size_t at_b = 0; at_b < record_b; at_b += sizeof event + event.n_b) {
        if (record_b - at_b < sizeof event) return error_set(err, "ends within an event");
        memcpy(&event, record + at_b, sizeof event);
        if (record_b - at_b - sizeof event < event.n_b) return error_set(err, "ends within an event");
        if (!play_event(replay, &event, record + at_b + sizeof event, err)) return false;
    }
    return true;
}

static uint8_t *read_record(const char *path, size_t *n_b, struct error *err)
{
    uint8_t *bytes = malloc(RECORD_MAX_B);
    FILE *file = fopen(path, "rb");

    *n_b = bytes && file ? fread(bytes, 1, RECORD_MAX_B, file) : 0;
    if (*n_b == 0) error_set(err, "%s", file ? "empty" : strerror(errno));
    if (file) fclose(file);
    if (*n_b) return bytes;
    free(bytes);
    return NULL;
}

/* Glass -------------------------------------------------------------------------------------- */

static bool power_on(struct replay *replay, const char *panel, const char *glass, struct error *err)
{
    unsigned w_px, h_px, ox_px = 0, oy_px = 0;

    if (sscanf(glass, "%ux%u+%u+%u", &w_px, &h_px, &ox_px, &oy_px) < 2) return error_set(err, "%s: no glass", glass);
    const struct display_module module = {.w_px = (uint16_t)w_px,
                                          .h_px = (uint16_t)h_px,
                                          .ox_px = (uint16_t)ox_px,
                                          .oy_px = (uint16_t)oy_px,
                                          .invert = true};
    if (!panel_choice_parse(panel, NULL, &replay->panel, err) || !display_module_check(&replay->panel, &module, err))
        return false;
    emulated_display_choose(&replay->module, &replay->panel, &module);
    replay->module.port->deferred = false; /* what was recorded has left */
    replay->port = emulated_port_whole(replay->module.port);
    replay->pixels = calloc((size_t)w_px * h_px, sizeof *replay->pixels);
    replay->rgb = calloc((size_t)w_px * h_px, 3);
    replay->film = (struct film){.w_px = w_px, .h_px = h_px, .count = 1, .pixels = replay->pixels};
    return (replay->pixels && replay->rgb) || error_set(err, "out of memory");
}

static bool save(const struct film *film, const char *path, struct error *err)
{
    FILE *file = fopen(path, "wb");
    gdImagePtr image = image_from_frame(film, 0);
    const bool ok = file && image && image_write_png(image, file, path, err);

    if (image) gdImageDestroy(image);
    if (file) fclose(file);
    return ok;
}

static void report(const struct replay *replay)
{
    printf("sent_b=%llu writes=%llu most_b=%u speed_hz=%u mode=%u wait_ms=%llu lit=%d held=%x\n",
           (unsigned long long)replay->sent_b, (unsigned long long)replay->writes, replay->most_b, replay->speed_hz,
           replay->mode, (unsigned long long)replay->module.port->now_us / 1000, replay->lit, replay->held);
}

/* What the simulator's board shows of it. */
static bool see_card(const struct panel_choice *choice, unsigned w_px, unsigned h_px, uint16_t *pixels,
                     struct error *err)
{
    struct panel_board *board = calloc(1, sizeof *board);

    if (!board) return error_set(err, "out of memory");
    bool ok = panel_board_init(board, choice, LIM_NEAREST_FIRST, w_px, h_px, err);
    if (ok) {
        ok = (card_draw(&board->screen, PANEL_UPRIGHT) == 0 || error_set(err, "the card cannot be drawn")) &&
             panel_board_read(board, pixels, err);
        panel_board_free(board);
    }
    free(board);
    return ok;
}

static bool check_card(const struct replay *replay, struct error *err)
{
    const struct film *film = &replay->film;
    const size_t count = (size_t)film->w_px * film->h_px;
    uint16_t *card = calloc(count, sizeof *card);
    size_t same = 0;

    if (!card) return error_set(err, "out of memory");
    const bool ok = see_card(&replay->panel, film->w_px, film->h_px, card, err);
    while (same < count && card[same] == film->pixels[same])
        same++;
    free(card);
    return ok && (same == count ||
                  error_set(err, "not the test card: pixel %zu,%zu differs", same % film->w_px, same / film->w_px));
}

static bool check(const struct replay *replay, const char *wanted, const char *shown, struct error *err)
{
    if (!emulated_display_is_quiet(&replay->module, err)) return false;
    if (shown && !save(&replay->film, shown, err)) return false;
    if (strcmp(wanted, "card") == 0) return check_card(replay, err);
    return strcmp(wanted, "any") == 0 || image_check_png(&replay->film, wanted, err);
}

static bool run(struct replay *replay, char **argv, struct error *err)
{
    size_t record_b;
    uint8_t *record = read_record(argv[1], &record_b, err);
    const bool ok = record && power_on(replay, argv[2], argv[3], err) && play_record(replay, record, record_b, err);

    if (ok && replay->lit) look(replay);
    if (ok) report(replay);
    free(record);
    return ok && check(replay, argv[4], argv[5], err);
}

int main(int argc, char **argv)
{
    struct error err = {"out of memory"};

    if (argc < 5 || argc > 6) {
        fputs(USAGE, stderr);
        return EXIT_FAILURE;
    }
    struct replay *replay = calloc(1, sizeof *replay);
    const bool ok = replay && run(replay, argv, &err);
    if (!ok) fprintf(stderr, "replay: %s: %s\n", argv[1], err.text);
    if (replay) {
        free(replay->pixels);
        free(replay->rgb);
    }
    free(replay);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
