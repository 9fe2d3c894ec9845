/* SPDX-License-Identifier: MIT
 *
 * The firmware's renderer on the host: a board whose panel is emulated. Frames go through the
 * real screen code, panel driver and byte stream into the emulated chip's memory, and are read
 * back from its glass; or, for sizes that no chip has, into plain memory. */
#ifndef SIM_SIMULATOR_H
#define SIM_SIMULATOR_H

#include "base/error.h"
#include "core/core.h"
#include "pictures/image.h"
#include "render/panel_board.h"

enum simulator_panel {
    SIMULATOR_ANY,   /* the first below that can hold the picture */
    SIMULATOR_PANEL, /* emulated: an ST7789, 240x320 at most, or the one that simulator_init_on() names */
    SIMULATOR_MEMORY,
    SIMULATOR_FRAMEBUFFER, /* memory that the renderer paints into as it likes: lim_target.framebuffer */
    SIMULATOR_UNSEEN       /* one line of memory, over and over: for frames of which only the statistics are asked */
};

/* What a picture is drawn with. */
struct simulator_setup {
    unsigned w_px, h_px;
    enum lim_method method;
    enum simulator_panel panel;
    const struct core *core; /* the precision profile; NULL: fast */
};

/* The renderer's memory. */
struct simulator_ram {
    size_t bytes;   /* 0: as much as the scene's limits ask for */
    double percent; /* or so much of what its pools take beyond the least; 0: all */
};

struct compiled;

struct simulator {
    const struct core *core;
    void *lim; /* the core's state */
    struct lim_target target;
    const struct lim_scene *scene;
    struct lim_scene *roomy; /* the same, with limits for this host's larger structs */
    double part;             /* of what the pools take beyond the least */
    void *mem;               /* lim's, mem_b of it */
    size_t mem_b;
    void *mover_mem;                      /* lim's for movers; NULL: there are none */
    const struct lim_instance *instances; /* of the frames to come, the caller's */
    uint16_t instance_count;
    bool antialias;            /* it is on */
    void *smooth_mem;          /* for antialiasing, or NULL */
    void *delta_mem;           /* for delta output, or NULL */
    uint16_t *pixels;          /* the last frame: RGB565 as numbers, row by row from the top left */
    size_t bus_b;              /* bytes sent to the panel for it */
    struct panel_board *board; /* NULL: plain memory */
    uint8_t *lines;            /* plain memory's, line_b each, or the unseen one; NULL with a panel */
    size_t line_b;
};

/* Whether an emulated panel can hold the picture; NULL: an ST7789. */
bool simulator_panel_holds(const struct panel_choice *choice, unsigned w_px, unsigned h_px, struct error *err);

/* Starts renderer and panel. The scene must outlive it, and *simulator stay where it is. */
bool simulator_init(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                    struct error *err);

/* On a panel of the caller's choice, if setup->panel is SIMULATOR_PANEL; NULL: an ST7789. */
bool simulator_init_on(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                       const struct panel_choice *choice, struct error *err);

/* On a target of the caller's, which must outlive it: frames are drawn by simulator_draw(), and not read back. */
bool simulator_init_to(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                       const struct lim_target *target, struct error *err);

/* Begins anew with other memory, no more than the scene's limits ask for, and before anything else is set. */
bool simulator_set_ram(struct simulator *simulator, const struct simulator_ram *ram, struct error *err);

/* How frames are drawn from now on. */
void simulator_set_wireframe(struct simulator *simulator, const struct lim_wireframe *wireframe);
/* Makes room for movers. From now on each frame has the instances; the array must outlive it, and may change. */
bool simulator_set_movers(struct simulator *simulator, const struct lim_instance *instances, size_t count,
                          const struct lim_movers_limits *limits, struct error *err);

/* Turns antialiasing on or off. false: the method has none. */
bool simulator_set_antialias(struct simulator *simulator, bool on, struct error *err);

/* Sends only what changes from frame to frame, with memory for `runs` of them; 0: all frames whole. */
bool simulator_set_delta(struct simulator *simulator, uint16_t runs, struct error *err);

/* The next frame is whole. */
void simulator_refresh(struct simulator *simulator);

/* Renders a frame into `pixels`. An error of the renderer or driver, or a complaint of the
 * emulated chip about the protocol, is an error here. */
bool simulator_frame(struct simulator *simulator, const struct lim_camera *camera, struct error *err);

/* Renders a frame into the target: 0, or the negative code of the renderer or the target. */
int simulator_draw(struct simulator *simulator, const struct lim_camera *camera);

/* What the last frame took. */
const struct lim_stats *simulator_stats(const struct simulator *simulator);

/* The last frame as a film of one; it stays the simulator's. */
struct film simulator_film(const struct simulator *simulator);
size_t simulator_pixel_count(const struct simulator *simulator);

void simulator_free(struct simulator *simulator);

/* simulator_set_movers() with what moves in the scene, if anything does. */
bool simulator_add_movers(struct simulator *simulator, const struct compiled *scene, struct error *err);

#endif
