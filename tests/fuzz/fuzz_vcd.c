/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a value change dump, after a line of options: it is refused in one line that names it, or what its wires
 * carry is heard by the emulated chip, which complains in one line or not at all; whatever was heard, there is a
 * picture. Glass of more pixels than a test has time for is left alone. */
#include "fuzz_words.h"
#include "glass/capture_file.h"

#include <stdlib.h>

enum { PIXELS_MAX = 64 * 1024, FRAMES_MAX = 4 };

static const char NAME[] = "dump.vcd";

struct hearing {
    struct listener listener;
    unsigned frames;
    uint8_t rgb[3 * PIXELS_MAX];
    uint16_t pixels[PIXELS_MAX];
};

static bool on_frame(void *ctx, struct error *err)
{
    struct hearing *hearing = ctx;

    (void)err;
    listener_read(&hearing->listener, hearing->rgb, hearing->pixels);
    return ++hearing->frames < FRAMES_MAX;
}

static const char *hear(const struct fuzz_bytes *text, const struct module_choice *module,
                        const struct capture_choice *choice)
{
    struct hearing *hearing = malloc(sizeof *hearing);
    struct capture capture = {.choice = choice,
                              .module = module,
                              .listener = &hearing->listener,
                              .path = NAME,
                              .on_frame = on_frame,
                              .ctx = hearing};
    FILE *file = text->left_b ? fmemopen((void *)(uintptr_t)text->at, text->left_b, "rb") : NULL;
    struct error err = {""};

    hearing->frames = 0;
    listener_init(&hearing->listener, module);
    const bool ok = !file || capture_read(&capture, CAPTURE_VCD, file, &err);
    listener_read(&hearing->listener, hearing->rgb, hearing->pixels);
    if (file) fclose(file);
    free(hearing);
    return ok ? NULL : fuzz_check_refusal(err.text, NAME);
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes text = {input, size_b};
    struct fuzz_words words;
    struct arguments arguments = fuzz_words(&text, &words);
    struct module_choice module = {0};
    struct capture_choice choice = {0};
    const char *broken = NULL;
    struct error err;

    if (!module_choice_parse(&module, &arguments, &err) || !capture_choice_parse(&choice, &arguments, &err))
        broken = fuzz_check_refusal(err.text, "--");
    else if (module.module.w_px * module.module.h_px <= PIXELS_MAX)
        broken = hear(&text, &module, &choice);
    wire_names_free(&choice.names);
    return broken;
}

const struct fuzz_target fuzz_vcd = {"vcd", run, NULL};
