/* SPDX-License-Identifier: MIT
 *
 * How a program begins: all of its memory in one declaration, and one function of its own, which sends pixels. A
 * scene's header has both fitted to the scene:
 *
 *     HALL_MEMORY(240, 240);
 *     err = hall_begin(&hall_memory, send, NULL);
 *     if (!err) err = lim_frame(hall_memory.lim, &camera);
 *
 * lim_set_wireframe() and lim_set_antialias() come after hall_begin(), as after lim_init(). Who wants a line to be
 * painted while another one is on its way, or to send what changes alone (lim_set_delta() asks for windows), makes a
 * struct lim_target instead (target.h). */
#ifndef LIM_BEGIN_H
#define LIM_BEGIN_H

#include "agree.h"
#include "errors.h"
#include "scene.h"
#include "target.h"

LIM_C_BEGIN

struct lim;

/* Sends n_px pixels from (x_px, y_px) to the right, in RGB565, each as the bus wants it: the byte with the red bits
 * first. `pixels` may be written to again as soon as it returns. Lines come from the top down, the pieces of a line
 * from left to right, together all pixels of a frame, each once. 0; or a negative code, which ends the frame, and comes
 * back from lim_frame(). */
typedef int lim_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px); /* program's */

/* Bytes of a line. */
#define LIM_LINE_B(w_px) (((w_px)*2u + 3u) / 4u * 4u)

/* What paints into memory and sends it. */
struct lim_sender {
    lim_send *send;
    void *ctx;          /* handed to send() */
    uint16_t *lines;    /* aligned to 4 bytes */
    size_t lines_b;     /* LIM_LINE_B(w_px) or more */
    uint16_t stride_px; /* private: from a line to the next; 0: there is one for all */
};

/* Makes *target of it; *sender must outlive whoever uses the target. With memory for all h_px lines each has its own,
 * and where LIM_HAS_FRAMEBUFFER is 1 they are the target's framebuffer; else there is one line, whatever lines_b.
 * LIM_ERR_MEMORY: for a line, or for LIM_PAINTER for all of them, lines_b is too little. */
LIM_MUST_CHECK int lim_sender_target(struct lim_sender *sender, uint16_t w_px, uint16_t h_px, enum lim_method method,
                                     struct lim_target *target) LIM_AGREES(lim_sender_target);

/* A renderer's memory, and that of its lines. All of it outlives the renderer. */
struct lim_memory {
    struct lim *lim;
    struct lim_sender *sender;
    void **pools;    /* of lim_init() */
    void **movers;   /* of lim_movers_init() */
    uint16_t *lines; /* aligned to 4 bytes */
    size_t pools_b, movers_b, lines_b;
    uint16_t w_px, h_px; /* of the display */
};

/* Declares a block of static memory, and `name`, a constant struct lim_memory that says where it is. Scenes' headers
 * have it with their own numbers. Arguments are constants. */
#define LIM_MEMORY(name, width_px, height_px, pool_b, mover_b, line_count)                                             \
    LIM_STATIC_ASSERT((width_px) >= 1 && (height_px) >= 1 && (width_px) <= LIM_MAX_SIDE_PX &&                          \
                          (height_px) <= LIM_MAX_SIDE_PX,                                                              \
                      "a side of this display is 0, or longer than what the scene was compiled for: limner compile "   \
                      "--size WxH");                                                                                   \
    LIM_STATIC_ASSERT(UINT64_C(1) * LIM_LINE_B(width_px) * (line_count) <= SIZE_MAX / 2,                               \
                      "all lines of this display together are more than the processor can address");                   \
    LIM_OPTIONAL_BEGIN                                                                                                 \
    static struct name##_block {                                                                                       \
        struct lim lim;                                                                                                \
        struct lim_sender sender;                                                                                      \
        void *pools[LIM_POINTERS(pool_b) + LIM_POINTERS(mover_b)];                                                     \
        LIM_ALIGNAS(4) uint16_t lines[(size_t)LIM_LINE_B(width_px) / 2 * (line_count)];                                \
    } name##_block;                                                                                                    \
    LIM_OPTIONAL_END                                                                                                   \
    static const struct lim_memory name = {&name##_block.lim,                                                          \
                                           &name##_block.sender,                                                       \
                                           name##_block.pools,                                                         \
                                           name##_block.pools + LIM_POINTERS(pool_b),                                  \
                                           name##_block.lines,                                                         \
                                           LIM_POINTERS(pool_b) * sizeof(void *),                                      \
                                           LIM_POINTERS(mover_b) * sizeof(void *),                                     \
                                           sizeof name##_block.lines,                                                  \
                                           width_px,                                                                   \
                                           height_px}
#define LIM_POINTERS(size_b) (((size_b) + sizeof(void *) - 1) / sizeof(void *))

/* lim_init() in that memory, on a display that send() sends to. What moves needs lim_movers_init() after it, as
 * hall_begin() does by itself. LIM_ERR_MEMORY, or what lim_init() returns. */
LIM_MUST_CHECK int lim_begin(const struct lim_memory *memory, const struct lim_scene *scene, enum lim_method method,
                             lim_send *send, void *ctx) LIM_AGREES(lim_begin);

LIM_C_END

#endif
