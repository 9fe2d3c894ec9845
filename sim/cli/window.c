/* SPDX-License-Identifier: MIT
 *
 * The SDL2 window of `limner view`: the frame three times as large, keys held down fly. Built
 * without SDL2 (LIM_HAVE_SDL2 0), it only says that it cannot. SDL opens windows also where nobody sees them: those are
 * none, unless LIMNER_UNSEEN asks for them. */
#include "cli/fly.h"

#if LIM_HAVE_SDL2

#include <SDL.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SCALE = 3, FRAME_MS = 20 };

struct window {
    SDL_Window *window;
    SDL_Renderer *renderer;
    SDL_Texture *texture;
};

static const struct {
    SDL_Scancode scancode;
    enum fly_key key;
} KEYS[] = {
    {SDL_SCANCODE_W, FLY_FORWARD},        {SDL_SCANCODE_S, FLY_BACK},     {SDL_SCANCODE_A, FLY_LEFT},
    {SDL_SCANCODE_D, FLY_RIGHT},          {SDL_SCANCODE_R, FLY_UP},       {SDL_SCANCODE_F, FLY_DOWN},
    {SDL_SCANCODE_LEFT, FLY_TURN_LEFT},   {SDL_SCANCODE_UP, FLY_LOOK_UP}, {SDL_SCANCODE_DOWN, FLY_LOOK_DOWN},
    {SDL_SCANCODE_RIGHT, FLY_TURN_RIGHT},
};

static bool is_set(const char *variable)
{
    const char *value = getenv(variable);
    return value && *value;
}

/* Whether whoever started the program sees what this driver shows. SDL falls back on "offscreen" where there is no
 * display; and on KMSDRM, the screen of the machine itself, which nobody sees over SSH, unless they ask for it. */
static bool is_seen(const char *driver)
{
    if (is_set("LIMNER_UNSEEN")) return true;
    if (!driver || strcmp(driver, "dummy") == 0 || strcmp(driver, "offscreen") == 0) return false;
    const bool is_remote = is_set("SSH_CONNECTION") || is_set("SSH_TTY");
    return strcmp(driver, "KMSDRM") != 0 || !is_remote || is_set("SDL_VIDEODRIVER");
}

const bool window_is_built = true;

static bool window_open(struct window *window, int w_px, int h_px)
{
    char title[160]; /* with the keys, which nobody knows yet */
    snprintf(title, sizeof title, "Limner: %s", FLY_HELP);
    if (SDL_Init(SDL_INIT_VIDEO) != 0 || !is_seen(SDL_GetCurrentVideoDriver())) return false;
    window->window = SDL_CreateWindow(title, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, SCALE * w_px,
                                      SCALE * h_px, SDL_WINDOW_RESIZABLE);
    window->renderer = window->window ? SDL_CreateRenderer(window->window, -1, 0) : NULL;
    if (!window->renderer || SDL_RenderSetLogicalSize(window->renderer, w_px, h_px) != 0) return false;
    window->texture =
        SDL_CreateTexture(window->renderer, SDL_PIXELFORMAT_RGB565, SDL_TEXTUREACCESS_STREAMING, w_px, h_px);
    return window->texture != NULL;
}

static void window_close(struct window *window)
{
    if (window->texture) SDL_DestroyTexture(window->texture);
    if (window->renderer) SDL_DestroyRenderer(window->renderer);
    if (window->window) SDL_DestroyWindow(window->window);
    SDL_Quit();
}

static bool window_show(struct window *window, const struct film *frame, struct error *err)
{
    if (SDL_UpdateTexture(window->texture, NULL, frame->pixels, (int)(frame->w_px * sizeof frame->pixels[0])) != 0 ||
        SDL_RenderClear(window->renderer) != 0 || SDL_RenderCopy(window->renderer, window->texture, NULL, NULL) != 0)
        return error_set(err, "window: %s", SDL_GetError());
    SDL_RenderPresent(window->renderer);
    return true;
}

/* Takes what has happened since; false when the user wants to leave. Exposed windows redraw. */
static bool take_events(struct flight *flight, bool *changed)
{
    for (SDL_Event event; SDL_PollEvent(&event);) {
        if (event.type == SDL_QUIT) return false;
        if (event.type == SDL_WINDOWEVENT) *changed = true;
        if (event.type != SDL_KEYDOWN) continue;
        SDL_Scancode key = event.key.keysym.scancode;
        if (key == SDL_SCANCODE_ESCAPE || key == SDL_SCANCODE_Q) return false;
        if (key == SDL_SCANCODE_X && !event.key.repeat) flight_key(flight, FLY_WALLS);
    }
    return true;
}

static bool take_keys(struct flight *flight)
{
    const Uint8 *held = SDL_GetKeyboardState(NULL);
    bool moved = false;
    for (size_t i = 0; i < sizeof KEYS / sizeof KEYS[0]; i++) {
        if (!held[KEYS[i].scancode]) continue;
        flight_key(flight, KEYS[i].key);
        moved = true;
    }
    return moved;
}

static bool fly_in(struct window *window, struct flight *flight, struct error *err)
{
    for (bool changed = true; take_events(flight, &changed); SDL_Delay(FRAME_MS)) {
        changed |= take_keys(flight) || flight->moving;
        if (!changed) continue;
        if (!flight_frame(flight, err)) return false;
        struct film frame = simulator_film(flight->simulator);
        if (!window_show(window, &frame, err)) return false;
        changed = false;
    }
    return true;
}

enum flight_end window_fly(struct flight *flight, struct error *err)
{
    struct window window = {0};
    enum flight_end end = FLIGHT_IMPOSSIBLE;
    if (window_open(&window, flight->simulator->target.w_px, flight->simulator->target.h_px))
        end = fly_in(&window, flight, err) ? FLIGHT_ENDED : FLIGHT_FAILED;
    window_close(&window);
    return end;
}

#else

const bool window_is_built = false;

enum flight_end window_fly(struct flight *flight, struct error *err)
{
    (void)flight;
    (void)err;
    return FLIGHT_IMPOSSIBLE;
}

#endif
