/* SPDX-License-Identifier: MIT
 *
 * `limner card`: the test card, drawn by the driver of a module on that module, emulated -> what its viewer sees, as
 * PNG and hash: what a photograph of a display, or a capture of its wires, is held against. */
#include "card.h"
#include "cli/commands.h"
#include "displays/idle_options.h"
#include "glass/listener.h"
#include "linux/code_words.h"
#include "pictures/frame_file.h"
#include "pictures/hash_list.h"
#include "pictures/hashes.h"

#include <inttypes.h>
#include <stdlib.h>

struct card {
    struct module_choice choice;
    struct idle_options idle;
    const char *path; /* NULL: no picture is asked for */
    struct hash_list hashes;
    struct outputs outputs;
    struct listener *listener; /* the module */
    struct display display;
    struct screen screen;
    void *lines;
    unsigned w_px, h_px; /* of the picture */
    uint8_t *rgb;
    uint16_t *pixels;
};

static bool parse(struct card *card, int argc, char **argv, struct error *err)
{
    struct arguments arguments = {argv, argc};
    idle_options_find(&card->idle, argc, argv);
    if (!module_choice_parse(&card->choice, &arguments, err) || !arguments_value(&arguments, "-o", &card->path, err) ||
        !hash_list_parse(&card->hashes, &arguments, err))
        return false;
    return arguments.count == 1 || error_set(err, "card: what is '%s'?", arguments.items[1]);
}

static bool draw(struct card *card, struct error *err)
{
    const struct module_choice *choice = &card->choice;
    listener_init(card->listener, choice);
    if (!display_setup(&card->display, &choice->panel, &choice->module, &card->listener->port, err)) return false;
    const struct panel *panel = card->display.panel;
    const size_t lines_b = SCREEN_WIDE_MEM_B(panel->w_px, 2) + 2 * SCREEN_PAGE_B(panel->w_px);
    card->lines = malloc(lines_b);
    if (!card->lines) return error_set(err, "card: out of memory");
    int code = panel_init(card->display.panel);
    if (!code) code = screen_init(&card->screen, card->display.panel, LIM_NEAREST_FIRST, card->lines, lines_b);
    if (!code) code = card_draw(&card->screen, card->display.camera_turn);
    if (code) return error_set(err, "emulated %s: %s (%d)", choice->panel.name, code_words(code), code);
    return emulated_display_is_quiet(&card->listener->display, err);
}

static bool show(struct card *card, struct error *err)
{
    const struct film film = {card->w_px, card->h_px, 1, card->pixels};
    listener_read(card->listener, card->rgb, card->pixels);
    const uint64_t hash = hash_pixels(card->pixels, (size_t)card->w_px * card->h_px);
    hash_list_add(&card->hashes, hash);
    printf("card: %ux%u, hash %016" PRIx64 "\n", card->w_px, card->h_px, hash);
    return hash_list_open(&card->hashes, &card->outputs, err) &&
           (!card->path || frame_file_put(&film, card->path, &card->outputs, err)) &&
           hash_list_close(&card->hashes, err) && outputs_keep(&card->outputs, err) &&
           hash_list_check(&card->hashes, err);
}

static bool run(struct card *card, struct error *err)
{
    module_choice_picture(&card->choice.module, &card->w_px, &card->h_px);
    const size_t pixel_count = (size_t)card->w_px * card->h_px;
    card->listener = malloc(sizeof *card->listener);
    card->rgb = malloc(3 * pixel_count);
    card->pixels = malloc(sizeof card->pixels[0] * pixel_count);
    if (!card->listener || !card->rgb || !card->pixels) return error_set(err, "card: out of memory");
    if (!draw(card, err) || !show(card, err)) return false;
    idle_options_note_panel(&card->idle, &card->choice.panel);
    return true;
}

int cmd_card(int argc, char **argv)
{
    struct card card = {.path = NULL};
    struct error err;
    const bool ok = parse(&card, argc, argv, &err) && run(&card, &err);
    hash_list_free(&card.hashes);
    outputs_discard(&card.outputs);
    free(card.listener);
    free(card.lines);
    free(card.rgb);
    free(card.pixels);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
