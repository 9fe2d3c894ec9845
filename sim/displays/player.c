/* SPDX-License-Identifier: MIT */
#include "displays/player.h"

#include "base/notice.h"
#include "base/progress.h"
#include "linux/code_words.h"
#include "linux/interrupt.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <time.h>

enum { RETRY_US = 200000, SLICE_US = 50000 };

#define PROGRESS_S 0.25

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Bytes ----------------------------------------------------------------------------------------- */

static int write_counted(void *ctx, const uint8_t *data, size_t n_b)
{
    struct player *player = ctx;
    player->sent_b += n_b;
    return bus_write(&player->port->bus, data, n_b);
}

static int flush_counted(void *ctx)
{
    const struct player *player = ctx;
    return bus_flush(&player->port->bus);
}

void player_init(struct player *player, struct port *port)
{
    *player = (struct player){
        .port = port,
        .bus = {.ctx = player, .write = write_counted, .flush = flush_counted, .message_b = port->bus.message_b}};
}

/* What is told ---------------------------------------------------------------------------------- */

static double per_s(const struct player *player)
{
    return player->took_s > 0.0 ? (double)player->drawn / player->took_s : 0.0;
}

static uint64_t b_per_frame(const struct player *player)
{
    return player->drawn ? player->drawn_b / player->drawn : 0;
}

static void show_progress(const struct player *player, double *shown_s)
{
    const double time_s = now_s();
    if (time_s - *shown_s < PROGRESS_S) return;
    *shown_s = time_s;
    progress("frame %" PRIu64 ", %.1f frames a second, %" PRIu64 " bytes a frame, %" PRIu64 " errors", player->drawn,
             per_s(player), b_per_frame(player), player->failed);
}

void player_print(const struct player *player)
{
    printf("%" PRIu64 " frames in %.1f s: %.1f frames a second, %" PRIu64 " bytes a frame, %" PRIu64 " errors",
           player->drawn, player->took_s, per_s(player), b_per_frame(player), player->failed);
    if (player->panel->missed_edges)
        printf(", %" PRIu32 " frames not held for the refresh, of which --te told nothing",
               player->panel->missed_edges);
    putchar('\n');
}

/* The port has said more than its code does. */
static bool explain(const struct player *player, const char *what, int code, struct error *err)
{
    if (player->port->error[0]) return error_set(err, "%s: %s", what, player->port->error);
    return error_set(err, "%s: %s (%d)", what, code_words(code), code);
}

/* Frames ---------------------------------------------------------------------------------------- */

static int draw_frame(struct player *player)
{
    player->port->error[0] = '\0';
    int code = player->in_a_row ? panel_init(player->panel) : 0;
    const uint64_t before_b = player->sent_b;
    if (!code) code = player->draw(player->ctx, player->drawn);
    if (code) return code;
    player->drawn++;
    player->drawn_b += player->sent_b - before_b;
    player->in_a_row = player->gone_in_a_row = 0;
    return 0;
}

/* What has been unplugged for long fails otherwise too before it is back: it may be there, but not yet ours to open. */
static bool is_enough(const struct player *player)
{
    return player->in_a_row - player->gone_in_a_row >= PLAYER_FAILURES_MAX || player->gone_in_a_row >= PLAYER_GONE_MAX;
}

/* The first failure of a row is told at once, the last is the caller's to tell. */
static bool note_failure(struct player *player, int code, struct error *err)
{
    char what[40];
    snprintf(what, sizeof what, "frame %" PRIu64, player->drawn + 1);
    explain(player, what, code, err);
    player->failed++;
    player->in_a_row++;
    if (code == -ENODEV) player->gone_in_a_row++;
    if (is_enough(player)) return false;
    if (player->in_a_row > 1) return true;
    progress_end();
    fprintf(stderr, "limner: %s; trying again\n", err->text);
    return true;
}

/* In slices, so that a signal need not wait for the end. */
static int rest(const struct player *player, uint32_t pause_us)
{
    int code = 0;
    for (uint32_t done_us = 0; done_us < pause_us && !code && !interrupt_signal(); done_us += SLICE_US)
        code = clock_delay(&player->port->clock, pause_us - done_us < SLICE_US ? pause_us - done_us : SLICE_US);
    return code;
}

static bool play_frames(struct player *player, struct error *err)
{
    double shown_s = 0.0;
    bool ok = true;
    while (ok && !interrupt_signal() && (player->frames == 0 || player->drawn < player->frames)) {
        int code = draw_frame(player);
        if (!code) code = rest(player, player->pause_us);
        if (code) ok = note_failure(player, code, err);
        if (code && ok) (void)rest(player, RETRY_US);
        player->took_s = now_s() - player->began_s;
        show_progress(player, &shown_s);
    }
    progress_end();
    const struct error last = *err;
    return ok || error_set(err, "%s; given up after %u failures in a row", last.text, player->in_a_row);
}

/* A memory LCD without its DISP line cannot be switched off, which is no failure. */
static int darken(const struct player *player)
{
    player->port->error[0] = '\0';
    const int code = panel_darken(player->panel);
    if (code != PANEL_ERR_UNSUPPORTED) return code;
    notice("the display keeps showing its last picture: its pin DISP is not wired; --backlight LINE names its line");
    return 0;
}

bool player_run(struct player *player, struct error *err)
{
    interrupt_watch();
    player->port->error[0] = '\0';
    int code = panel_init(player->panel);
    if (code) return explain(player, "the panel cannot be set up", code, err);
    player->began_s = now_s();
    const bool ok = play_frames(player, err);
    code = darken(player);
    return ok && (code == 0 || explain(player, "the panel cannot be switched off", code, err));
}
