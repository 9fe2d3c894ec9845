/* SPDX-License-Identifier: MIT
 *
 * Between the file's instants and the emulated display: where the display's time begins, in what state it is, where
 * frames end. */
#include "glass/capture.h"

#include "base/deadline.h"
#include "base/parse.h"
#include "base/printable.h"
#include "base/progress.h"

#include <inttypes.h>
#include <string.h>

/* Power came so long before whatever comes first: that is no chip's wait. */
enum { POWER_US = 200000, PAUSE_MAX_US = 1000000000, USUAL_MODE = 0 };

/* The command line --------------------------------------------------------------------------- */

static bool take_number(struct capture_choice *out, struct arguments *arguments, const char *name, uint32_t least,
                        uint32_t most, uint32_t *value, struct error *err)
{
    const char *text = NULL;
    if (!arguments_value(arguments, name, &text, err)) return false;
    out->is_asked |= text != NULL;
    return !text || parse_whole(name, text, least, most, value, err);
}

bool capture_choice_parse(struct capture_choice *out, struct arguments *arguments, struct error *err)
{
    const char *wires = NULL;
    *out = (struct capture_choice){.is_running = arguments_flag(arguments, "--running")};
    if (!arguments_value(arguments, "--wires", &wires, err)) return false;
    out->is_asked = out->is_running || wires;
    return wire_names_parse(&out->names, wires, err) &&
           take_number(out, arguments, "--pause", 1, PAUSE_MAX_US, &out->pause_us, err);
}

/* Errors ------------------------------------------------------------------------------------- */

/* Somebody looks there with a viewer. */
static bool prefix_time(const struct capture *capture, struct error *err)
{
    char where[400];
    if (!err->text[0]) return false; /* no more is wanted */
    if (capture->has_time)
        snprintf(where, sizeof where, "%.256s: at %" PRIu64 ".%03u us", capture->path, capture->now_ns / 1000,
                 (unsigned)(capture->now_ns % 1000));
    else
        snprintf(where, sizeof where, "%.256s: at sample %" PRIu64, capture->path, capture->now_ns);
    return error_prefix(err, where);
}

/* Whoever samples too slowly, or begins in the middle, sees complaints first, or bytes that are cut. */
static bool add_hint(const struct capture *capture, struct error *err)
{
    const struct spi_wires *wires = &capture->wires;
    const char *hint = NULL;
    char text[ERROR_B];
    if (!capture->frames && !capture->choice->is_running)
        hint = "if the firmware was started before the capture: --running";
    if (wires->shortest_ns < 2 * wires->sample_ns)
        hint = "sck's shortest level is a single sample: take more samples a second, or slow the bus down by --hz";
    if (!err->text[0] || !hint) return false;
    memcpy(text, err->text, sizeof text);
    return error_set(err, "%.400s (%s)", text, hint);
}

static bool is_quiet(const struct capture *capture, struct error *err)
{
    return emulated_display_is_quiet(&capture->listener->display, err);
}

/* Frames ------------------------------------------------------------------------------------- */

static bool look_at_frames(struct capture *capture, struct error *err)
{
    if (capture->listener->frames == capture->frames) return true;
    capture->frames = capture->listener->frames;
    return capture->on_frame(capture->ctx, err);
}

static bool end_frame(struct capture *capture, struct error *err)
{
    listener_end_frame(capture->listener);
    return look_at_frames(capture, err);
}

/* Where a frame ends: of the first one the capture may have missed a part. */
static void begin_frames(struct capture *capture)
{
    if (capture->is_partial) capture->frames = capture->listener->frames;
    capture->is_partial = false;
}

/* The board's light tells, or a pause; without either it is the pictures themselves. */
static bool is_by_picture(const struct capture *capture)
{
    return !capture->wire[CAPTURE_LED].channel && !capture->choice->pause_us;
}

static bool look_at_pause(struct capture *capture, uint64_t pause_ns, struct error *err)
{
    const uint64_t least_ns = (uint64_t)capture->choice->pause_us * 1000;
    if (!least_ns || pause_ns < least_ns) return true;
    listener_end_frame(capture->listener);
    begin_frames(capture);
    return look_at_frames(capture, err);
}

static bool look_at_store(struct capture *capture, struct error *err)
{
    const struct emulated_port *port = capture->listener->display.port;
    if (port->stores == capture->stores) return true;
    capture->stores = port->stores;
    return !picture_ends_store(&capture->ends, port->stored) || end_frame(capture, err);
}

/* What comes over the wires ------------------------------------------------------------------ */

static void set_time(struct capture *capture, uint64_t now_ns)
{
    if (!capture->has_begun) capture->from_ns = now_ns;
    capture->has_begun = true;
    if (capture->has_time)
        (void)listener_time(capture->listener, capture->from_us * 1000 + (now_ns - capture->from_ns));
}

static bool take_byte(void *ctx, uint64_t now_ns, uint8_t byte, struct error *err)
{
    struct capture *capture = ctx;
    const bool is_command = !capture->listener->is_high[LISTENER_DC];
    if (!look_at_pause(capture, capture->wires.pause_ns, err)) return false;
    if (is_by_picture(capture) && is_command && picture_ends_command(&capture->ends) && !end_frame(capture, err))
        return false;
    set_time(capture, now_ns);
    listener_bytes(capture->listener, &byte, 1);
    return is_quiet(capture, err) && (!is_by_picture(capture) || look_at_store(capture, err));
}

static bool take_level(void *ctx, uint64_t now_ns, enum capture_wire wire, bool high, struct error *err)
{
    static const enum listener_pin pins[CAPTURE_WIRES] = {
        [CAPTURE_DC] = LISTENER_DC,         [CAPTURE_CS] = LISTENER_CS,   [CAPTURE_RESET] = LISTENER_RESET,
        [CAPTURE_SELECT] = LISTENER_SELECT, [CAPTURE_LED] = LISTENER_LED, [CAPTURE_BACKLIGHT] = LISTENER_BACKLIGHT};
    struct capture *capture = ctx;
    if (wire == CAPTURE_LED && capture->choice->pause_us) return true;
    if (capture->wires.has_begun && wire != CAPTURE_LED) set_time(capture, now_ns);
    listener_level(capture->listener, pins[wire], high);
    if (wire == CAPTURE_LED && capture->wires.has_begun) begin_frames(capture);
    return is_quiet(capture, err) && look_at_frames(capture, err);
}

/* Begin -------------------------------------------------------------------------------------- */

/* Over the wires of the emulated display, which so is as a board's is after its start. */
static bool start_display(struct capture *capture, struct error *err)
{
    struct listener *listener = capture->listener;
    const struct module_choice *module = capture->module;
    struct display display;
    if (!display_setup(&display, &module->panel, &module->module, &listener->port, err)) return false;
    if (panel_init(display.panel)) return error_set(err, "the emulated display does not start");
    listener->last_b = listener->display.port->bus_b;
    capture->is_partial = true;
    capture->stores = listener->last_stores = listener->display.port->stores;
    printable_print(
        stderr,
        "limner: %s: --running: the display is taken for one that is set up as the options say (%s, %ux%u, and so "
        "on); what comes before the first command is left out\n",
        capture->path, module->panel.name, module->module.w_px, module->module.h_px);
    return is_quiet(capture, err);
}

bool capture_begin(struct capture *capture, const struct channels *channels, uint64_t sample_ns, bool has_time,
                   struct error *err)
{
    const struct capture_choice *choice = capture->choice;
    const uint8_t mode = spi_mode_of(capture->module->spi_modes, USUAL_MODE);
    if (!wires_find(capture->wire, &choice->names, channels, capture->module->panel.family->selects, capture->path,
                    err))
        return false;
    if (choice->pause_us && !has_time) return error_set(err, "%s: --pause: it tells no time", capture->path);
    capture->has_time = has_time;
    capture->wires = (struct spi_wires){.events = {capture, take_byte, take_level},
                                        .takes_falling = mode == 1 || mode == 2,
                                        .rests_high = mode >= 2,
                                        .is_running = choice->is_running,
                                        .sample_ns = sample_ns};
    for (int i = 0; i < CAPTURE_WIRES; i++)
        if (capture->wire[i].channel) capture->wires.wired |= (uint8_t)(1u << i);
    capture->wires.waits_for_reset = capture->wire[CAPTURE_RESET].channel && !choice->is_running;
    if (!picture_ends_init(&capture->ends, capture->module, err)) return false;
    if (choice->is_running && !start_display(capture, err)) return false;
    capture->from_us = capture->listener->display.port->now_us + POWER_US;
    return true;
}

bool capture_levels(struct capture *capture, uint64_t now_ns, struct wire_levels levels, struct error *err)
{
    err->text[0] = '\0';
    capture->now_ns = now_ns;
    return spi_wires_take(&capture->wires, now_ns, levels, err) || add_hint(capture, err) || prefix_time(capture, err);
}

bool capture_has_time_left(const struct capture *capture, struct error *err)
{
    return deadline_check(err, "%s, after %" PRIu64 " frames", capture->path, (uint64_t)capture->frames);
}

void capture_tell_progress(struct capture *capture, uint64_t done, uint64_t all)
{
    const unsigned percent = all ? (unsigned)(done * 100 / all) : 0;
    if (percent == capture->percent) return;
    capture->percent = percent;
    progress_bar(percent, 100, "reading %s", capture->path);
}

/* The last picture may be whole. */
bool capture_end(struct capture *capture, struct error *err)
{
    if (!look_at_pause(capture, capture->now_ns - capture->wires.byte_ns, err)) return false;
    return !is_by_picture(capture) || !picture_ends_command(&capture->ends) || end_frame(capture, err);
}

void capture_say_end(const struct capture *capture, char *text, size_t size_b)
{
    const struct spi_wires *wires = &capture->wires;
    if (wires->clock_edges == 0)
        snprintf(text, size_b, "sck never changed");
    else if (wires->bytes == 0 && wires->other_edges)
        snprintf(text, size_b, "sck changed only while the display was not selected");
    else if (wires->bytes == 0 && wires->waits_for_reset && !wires->is_heard)
        snprintf(
            text, size_b,
            "reset never fell: --running if the firmware was started before the capture, --wires reset=- if it does "
            "not reset the display");
    else if (wires->bytes == 0 && wires->is_running)
        snprintf(text, size_b, "no command began: dc did not fall, or select rise");
    else if (is_by_picture(capture))
        snprintf(text, size_b,
                 "%" PRIu64 " bytes came, and then %" PRIu64 " of %" PRIu64 " pixels of a picture (frames that are not "
                 "all of the glass: capture the board's LED, or --pause)",
                 wires->bytes, capture->ends.has_begun ? capture->ends.stored_px : 0, capture->ends.whole_px);
    else
        snprintf(text, size_b, "%" PRIu64 " bytes came, and then no %s", wires->bytes,
                 capture->choice->pause_us ? "pause that ends a frame"
                                           : "change of the LED, which ends a frame (without it: --wires led=-)");
}
