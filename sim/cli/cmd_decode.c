/* SPDX-License-Identifier: MIT
 *
 * `limner decode`: what went over a display's wires, a wire log, a trace of QEMU's or a logic analyser's capture, from
 * a file or a pipe -> an emulated display -> frames, a line each, and PNG files and hashes as `limner render --panel`
 * has them. What the chip has to complain about is an error, and named with the line or the time that it came from. */
#include "base/deadline.h"
#include "base/input_file.h"
#include "base/parse.h"
#include "base/printable.h"
#include "base/progress.h"
#include "cli/commands.h"
#include "displays/idle_options.h"
#include "glass/capture_file.h"
#include "glass/qemu_trace.h"
#include "glass/wire_log.h"
#include "pictures/frame_file.h"
#include "pictures/hash_list.h"
#include "pictures/hashes.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MOST_B = 16 << 20, FRAMES_MAX = 1000000, PATH_SIZE = 4096, OTHER_LINES_SHOWN = 20 };

struct decode {
    const char *path; /* "-": standard input */
    struct module_choice module;
    struct idle_options idle;       /* given ones, that may change nothing */
    const char *map_path, *pattern; /* NULL: not asked for */
    uint64_t frames_asked;          /* 0: all that there are */
    bool is_foreign;                /* not written by this project */

    struct capture_choice choice;

    struct qemu_map map;
    struct outputs outputs;
    struct hash_list hashes;
    struct listener *listener;
    unsigned w_px, h_px; /* of the picture */
    uint8_t *rgb;
    uint16_t *pixels;
    struct input_lines lines;
    uint64_t other_lines;
};

/* The command line --------------------------------------------------------------------------- */

static bool take_frames(struct decode *decode, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    uint32_t frames = 0;
    if (!arguments_value(arguments, "--frames", &text, err)) return false;
    if (text && !parse_whole("--frames", text, 1, FRAMES_MAX, &frames, err)) return false;
    decode->frames_asked = frames;
    return true;
}

static bool take_path(struct decode *decode, const struct arguments *arguments, struct error *err)
{
    if (arguments->count < 2) return error_set(err, "decode: needs a wire log or a capture, or - for standard input");
    if (arguments->count > 2) return error_set(err, "decode: what is '%s'?", arguments->items[2]);
    decode->path = arguments->items[1];
    return true;
}

static bool decode_parse(struct decode *decode, int argc, char **argv, struct error *err)
{
    struct arguments arguments = {argv, argc};
    idle_options_find(&decode->idle, argc, argv);
    decode->is_foreign = arguments_flag(&arguments, "--foreign");
    return module_choice_parse(&decode->module, &arguments, err) &&
           arguments_value(&arguments, "--qemu", &decode->map_path, err) &&
           arguments_value(&arguments, "-o", &decode->pattern, err) &&
           capture_choice_parse(&decode->choice, &arguments, err) &&
           hash_list_parse(&decode->hashes, &arguments, err) && take_frames(decode, &arguments, err) &&
           take_path(decode, &arguments, err);
}

/* Begin -------------------------------------------------------------------------------------- */

static bool start(struct decode *decode, struct error *err)
{
    if (decode->pattern &&
        !(parse_picture_path("-o", decode->pattern, ".png", err) && output_pattern_check(decode->pattern, err)))
        return false;
    if (decode->map_path && !qemu_map_read(&decode->map, decode->map_path, err)) return false;
    module_choice_picture(&decode->module.module, &decode->w_px, &decode->h_px);
    const size_t pixel_count = (size_t)decode->w_px * decode->h_px;
    decode->listener = malloc(sizeof *decode->listener);
    decode->rgb = malloc(3 * pixel_count);
    decode->pixels = malloc(sizeof decode->pixels[0] * pixel_count);
    if (!decode->listener || !decode->rgb || !decode->pixels) return error_set(err, "decode: out of memory");
    listener_init(decode->listener, &decode->module);
    if (decode->is_foreign) emulated_display_take_foreign(&decode->listener->display);
    const bool is_input = strcmp(decode->path, "-") == 0;
    decode->lines.file = input_open_stream(decode->path, err);
    if (!decode->lines.file) return false;
    if (!input_is_regular(decode->lines.file)) deadline_only_if_given();
    if (is_input) decode->path = "standard input";
    decode->lines.path = decode->path;
    decode->lines.line_most_b = LINE_MOST_B;
    return hash_list_open(&decode->hashes, &decode->outputs, err);
}

/* Frames ------------------------------------------------------------------------------------- */

static bool write_picture(struct decode *decode, size_t frame, struct error *err)
{
    const struct film film = {decode->w_px, decode->h_px, 1, decode->pixels};
    return frame_file_write(&film, decode->pattern, frame, &decode->outputs, err);
}

static bool take_frame(struct decode *decode, struct error *err)
{
    const size_t frame = decode->hashes.count;
    listener_read(decode->listener, decode->rgb, decode->pixels);
    const uint64_t hash = hash_pixels(decode->pixels, (size_t)decode->w_px * decode->h_px);
    hash_list_add(&decode->hashes, hash);
    progress_end();
    printf("frame %zu: %" PRIu64 " bytes, hash %016" PRIx64 "\n", frame, decode->listener->frame_bus_b, hash);
    fflush(stdout);
    return !decode->pattern || write_picture(decode, frame, err);
}

/* What QEMU or the firmware says between lines of the trace is not lost. */
static void pass_on(struct decode *decode)
{
    if (decode->other_lines++ < OTHER_LINES_SHOWN)
        printable_print(stderr, "limner: %s:%" PRIu64 ": no trace: %s\n", decode->path, (uint64_t)decode->lines.number,
                        decode->lines.line);
}

static bool take_text(struct decode *decode, struct error *err)
{
    if (!decode->map_path) return wire_log_take(decode->listener, decode->lines.line, err);
    if (qemu_trace_is(decode->lines.line))
        return qemu_trace_take(&decode->map, decode->listener, decode->lines.line, err);
    pass_on(decode);
    return true;
}

static bool take_line(struct decode *decode, struct error *err)
{
    char where[PATH_SIZE];
    if (!take_text(decode, err) || !emulated_display_is_quiet(&decode->listener->display, err)) {
        snprintf(where, sizeof where, "%s:%" PRIu64, decode->path, (uint64_t)decode->lines.number);
        return error_prefix(err, where);
    }
    return decode->listener->frames == decode->hashes.count || take_frame(decode, err);
}

static bool has_all(const struct decode *decode)
{
    return decode->frames_asked && decode->hashes.count == decode->frames_asked;
}

/* " of 8", where somebody asked for so many. */
static const char *print_asked(const struct decode *decode, char *text, size_t size_b)
{
    text[0] = '\0';
    if (decode->frames_asked) snprintf(text, size_b, " of %" PRIu64, decode->frames_asked);
    return text;
}

/* Where there should be frames and are not, the reason is often on the wires. */
static bool check_count(const struct decode *decode, struct error *err)
{
    const struct listener *listener = decode->listener;
    const size_t count = decode->hashes.count;
    if (count && (!decode->frames_asked || has_all(decode))) return true;
    char asked[32];
    return error_set(err,
                     "%s: ends after %zu%s frames; then %" PRIu64 " bytes came, and the LED, whose change ends a "
                     "frame, stayed%s",
                     decode->path, count, print_asked(decode, asked, sizeof asked),
                     listener->display.port->bus_b - listener->last_b,
                     listener->other_b ? "; bytes came while cs was high" : "");
}

static bool read_lines(struct decode *decode, struct error *err)
{
    err->text[0] = '\0';
    while (!has_all(decode) && input_line(&decode->lines, err))
        if (!take_line(decode, err) ||
            !deadline_check(err, "%s:%zu, after %zu frames", decode->path, decode->lines.number, decode->hashes.count))
            return false;
    if (err->text[0]) return false;
    if (decode->other_lines > OTHER_LINES_SHOWN)
        printable_print(stderr, "limner: %s: %" PRIu64 " more lines that are no trace\n", decode->path,
                        decode->other_lines - OTHER_LINES_SHOWN);
    return check_count(decode, err);
}

/* What glass would bear, and a driver's author may want to know. */
static void tell_notices(const struct decode *decode)
{
    const char *last;
    const unsigned notices = emulated_display_notices(&decode->listener->display, &last);
    if (notices) printable_print(stderr, "limner: %s: %u notices, the last: %s\n", decode->path, notices, last);
}

/* Captures ----------------------------------------------------------------------------------- */

static bool take_captured(void *ctx, struct error *err)
{
    struct decode *decode = ctx;
    return take_frame(decode, err) && !has_all(decode);
}

static bool check_captured(const struct decode *decode, const struct capture *capture, struct error *err)
{
    char why[256], asked[32];
    if (decode->hashes.count && (!decode->frames_asked || has_all(decode))) return true;
    capture_say_end(capture, why, sizeof why);
    return error_set(err, "%s: ends after %zu%s frames; %s", decode->path, decode->hashes.count,
                     print_asked(decode, asked, sizeof asked), why);
}

static bool read_capture(struct decode *decode, enum capture_kind kind, struct error *err)
{
    struct capture capture = {.choice = &decode->choice,
                              .module = &decode->module,
                              .listener = decode->listener,
                              .path = decode->path,
                              .is_stream = decode->lines.file == stdin,
                              .on_frame = take_captured,
                              .ctx = decode,
                              .lines_before = decode->lines.number};
    return capture_read(&capture, kind, decode->lines.file, err) && check_captured(decode, &capture, err);
}

/* Of what the file is: a trace where there is a map, else it begins as one of them does. */
static bool read_input(struct decode *decode, struct error *err)
{
    const enum capture_kind kind =
        decode->map_path ? CAPTURE_NONE : capture_kind_of(decode->lines.file, &decode->lines.number);
    if (kind != CAPTURE_NONE) return read_capture(decode, kind, err);
    if (!decode->choice.is_asked) return read_lines(decode, err);
    return error_set(err, "%s: neither a VCD nor a session of sigrok's: --wires, --pause and --running are for these",
                     decode->path);
}

/* All of it ---------------------------------------------------------------------------------- */

static bool decode_run(struct decode *decode, struct error *err)
{
    if (!start(decode, err)) return false;
    idle_options_note_panel(&decode->idle, &decode->module.panel);
    if (!read_input(decode, err)) return false;
    tell_notices(decode);
    return hash_list_close(&decode->hashes, err) && outputs_keep(&decode->outputs, err) &&
           hash_list_check(&decode->hashes, err);
}

static void decode_free(struct decode *decode)
{
    input_close_stream(decode->lines.file);
    hash_list_free(&decode->hashes);
    wire_names_free(&decode->choice.names);
    outputs_discard(&decode->outputs);
    free(decode->listener);
    free(decode->rgb);
    free(decode->pixels);
    input_lines_free(&decode->lines);
}

int cmd_decode(int argc, char **argv)
{
    struct decode decode = {0};
    struct error err;
    const bool ok = decode_parse(&decode, argc, argv, &err) && decode_run(&decode, &err);
    decode_free(&decode);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
