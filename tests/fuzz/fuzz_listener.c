/* SPDX-License-Identifier: MIT
 *
 * The module is that of a line of options, as the command line has them; glass of more pixels than a test has time for
 * is left alone. */
#include "fuzz_listener.h"

#include "fuzz_words.h"

#include <stdlib.h>

enum { PIXELS_MAX = 64 * 1024, FRAMES_MAX = 4 };

struct pictures {
    uint8_t *rgb;
    uint16_t *pixels;
};

static const char *check_choice(const struct module_choice *choice)
{
    struct error err;

    if (!choice->panel.family) return "a module without a chip";
    return display_module_check(&choice->panel, &choice->module, &err) ? NULL : "a module does not fit its chip";
}

static const char *hear(struct listener *listener, struct fuzz_bytes *text, fuzz_line *take, void *ctx,
                        const struct pictures *pictures)
{
    uint64_t frames = 0;

    while (text->left_b && frames < FRAMES_MAX) {
        const struct fuzz_bytes part = fuzz_part(text, '\n');
        char *line = fuzz_string(&part);
        struct error err;
        const bool ok = take(listener, line, ctx, &err) && emulated_display_is_quiet(&listener->display, &err);
        free(line);
        if (!ok) return fuzz_check_refusal(err.text, NULL);
        if (listener->frames < frames) return "a frame was taken back";
        if (listener->frames > frames) listener_read(listener, pictures->rgb, pictures->pixels);
        frames = listener->frames;
    }
    return NULL;
}

const char *fuzz_listen(struct fuzz_bytes *text, fuzz_line *take, void *ctx)
{
    struct fuzz_words words;
    struct arguments arguments = fuzz_words(text, &words);
    struct module_choice choice = {0};
    struct error err;

    if (!module_choice_parse(&choice, &arguments, &err)) return fuzz_check_refusal(err.text, "--");
    const char *broken = check_choice(&choice);
    const size_t pixels = (size_t)choice.module.w_px * choice.module.h_px;
    if (broken || pixels > PIXELS_MAX) return broken;
    const struct pictures pictures = {malloc(3 * pixels), malloc(sizeof *pictures.pixels * pixels)};
    struct listener *listener = malloc(sizeof *listener);
    listener_init(listener, &choice);
    broken = hear(listener, text, take, ctx, &pictures);
    listener_read(listener, pictures.rgb, pictures.pixels);
    free(listener);
    free(pictures.rgb);
    free(pictures.pixels);
    return broken;
}
