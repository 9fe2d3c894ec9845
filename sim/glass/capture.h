/* SPDX-License-Identifier: MIT
 *
 * What a logic analyser saw of a display's wires becomes frames of an emulated one. Files: VCD, and sigrok's sessions.
 */
#ifndef SIM_CAPTURE_H
#define SIM_CAPTURE_H

#include "base/arguments.h"
#include "glass/channels.h"
#include "glass/listener.h"
#include "glass/picture_ends.h"
#include "glass/spi_wires.h"

#include <stdio.h>

/* What the command line says. */
struct capture_choice {
    struct wire_names names;
    uint32_t pause_us; /* a frame ends where nothing comes for so long; 0: it does not */
    bool is_running; /* the firmware was started before the capture: the display is as the module's own driver starts it
                      */
    bool is_asked;   /* there was one of the options: they mean nothing without a capture */
};

/* Takes --wires, --pause and --running out of *arguments. */
bool capture_choice_parse(struct capture_choice *out, struct arguments *arguments, struct error *err);

/* Private but for what is set at first. */
struct capture {
    const struct capture_choice *choice;
    const struct module_choice *module;
    struct listener *listener;
    const char *path;                               /* for errors */
    bool is_stream;                                 /* and not a file that can be opened again by that */
    bool (*on_frame)(void *ctx, struct error *err); /* the listener shows a frame; false: no more are wanted */
    void *ctx;
    size_t lines_before; /* of the file, which were skipped */

    struct spi_wires wires;
    struct channel_bit wire[CAPTURE_WIRES];
    struct picture_ends ends;
    bool has_time;            /* instants are nanoseconds, else samples */
    uint64_t now_ns, from_ns; /* the latest instant, at the end the capture's; what the listener's first is */
    uint64_t from_us;         /* in the listener's time */
    uint64_t stores, frames;  /* of the listener, that were looked at */
    bool has_begun;           /* something came over the wires */
    unsigned percent;         /* of the file, that were told */
    bool is_partial;          /* what has come may be the end of a frame only */
};

/* Why there are no more frames, as far as one can tell: words behind `ends after 2 frames; `. */
void capture_say_end(const struct capture *capture, char *text, size_t size_b);

/* For the readers of files: which channels there are, how long a sample takes (0: edges have times of their own), and
 * whether there is a time; then the levels from an instant on. false: an error, or (without a text) no more is wanted.
 */
bool capture_begin(struct capture *capture, const struct channels *channels, uint64_t sample_ns, bool has_time,
                   struct error *err);
bool capture_levels(struct capture *capture, uint64_t now_ns, struct wire_levels levels, struct error *err);

/* How much of the file was read, for who waits; all == 0: nobody knows. */
void capture_tell_progress(struct capture *capture, uint64_t done, uint64_t all);

/* Asked now and then by who reads it: false, with an error, once time is over (deadline.h). */
bool capture_has_time_left(const struct capture *capture, struct error *err);

/* No more follows: the last frame may end. */
bool capture_end(struct capture *capture, struct error *err);

#endif
