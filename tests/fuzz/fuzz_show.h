/* SPDX-License-Identifier: MIT
 *
 * Two frames of a scene, one after the other, in a look and by some means. The look is what may be seen of how a scene
 * is drawn. Means are what may not: where the pixels go, how much memory there is, whether frames are drawn in parts,
 * whether changes alone are sent, whether the display failed in the frame before. */
#ifndef TESTS_FUZZ_SHOW_H
#define TESTS_FUZZ_SHOW_H

#include "core/core.h"
#include "fuzz.h"
#include "fuzz_panel.h"

enum { FUZZ_FRAMES = 2 };

struct fuzz_subject {
    const struct lim_scene *scene;
    struct lim_camera cameras[FUZZ_FRAMES];            /* legal */
    const struct lim_instance *instances[FUZZ_FRAMES]; /* NULL: nothing moves */
    uint16_t instance_count, w_px, h_px;
    struct lim_movers_limits limits;
    struct lim_light light;
};

struct fuzz_look {
    const struct core *core;
    enum lim_method method;
    struct lim_wireframe wireframe;
    struct lim_newell_options newell;
    bool antialias, is_round;
    uint16_t overlay; /* where something lies over the frames; 0: nothing does */
    bool refreshes;   /* before the second frame */
};

struct fuzz_means {
    enum fuzz_sink sink;
    uint8_t memory;   /* of what the scene asks for above the least: 0 nothing, 255 all */
    uint8_t quanta;   /* 0: frames are drawn at once; else begun, so many quanta of work done, and painted */
    uint8_t page_px;  /* 0: frames are sent whole; else fuzz_panel_init()'s */
    uint8_t runs;     /* room for so many, where changes are sent */
    uint8_t fails_at; /* which call of the target fails in the first frame; 0: none */
};

/* The picture of both frames; on a panel that was never shown a frame, the first one is none. */
struct fuzz_pictures {
    struct fuzz_panel panels[FUZZ_FRAMES]; /* copies: no memory is theirs */
    bool is_shown[FUZZ_FRAMES];
};

/* From bytes. */
struct fuzz_look fuzz_look_from(struct fuzz_bytes *bytes);
void fuzz_means_both_from(struct fuzz_bytes *bytes, struct fuzz_means means[2]);

/* The broken promise, or NULL. *is_refused: the scene is none for the method, rightly. */
const char *fuzz_show(const struct fuzz_subject *subject, const struct fuzz_look *look, const struct fuzz_means *means,
                      struct fuzz_pictures *pictures, bool *is_refused);

/* The same look by two means must be the same pictures. */
const char *fuzz_show_both(const struct fuzz_subject *of, const struct fuzz_look *look,
                           const struct fuzz_means means[2]);

#endif
