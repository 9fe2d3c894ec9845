/* SPDX-License-Identifier: MIT
 *
 * The renderer in each of its precision profiles. Target firmware has one; the host has all, each
 * built from the same sources and reached through such a table. */
#ifndef SIM_CORE_H
#define SIM_CORE_H

#include "limner.h"

/* What of its texture a pixel shows. */
struct core_texel_at {
    uint16_t x_px, y_px;
    double uv[2]; /* in pictures, modulo 1 */
    unsigned level;
    bool divided; /* it is the result of a division, not between two */
};
typedef void core_texel(void *ctx, const struct core_texel_at *at);

struct core {
    size_t shared_b;    /* CORE_SHARED_B; the first, for one that is loaded (measure/sub_bits.h) may have another */
    const char *name;   /* "fast"; "fast_4" has other sub-pixel bits than its profile's own */
    uint8_t profile;    /* LIM_PROFILE_... */
    uint8_t sub_bits;   /* of a pixel */
    bool is_profile;    /* the profile as firmware has it: one of draft, fast, fine, exact */
    uint16_t narrow_px; /* up to so many pixels a side a firmware's screen coordinates fit 16 bits */
    size_t lim_b;       /* of the state, struct lim in its own build */
    size_t (*mem_b)(const struct lim_scene *scene, const struct lim_target *target);
    size_t (*mem_min_b)(const struct lim_scene *scene, const struct lim_target *target);
    /* lim_init(), lim_frame(), lim_bands() and lim_stats(); `lim` is lim_b bytes of the caller's. */
    int (*init)(void *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b);
    void (*newell)(void *lim, const struct lim_newell_options *options); /* lim_newell_set() */
    int (*frame)(void *lim, const struct lim_camera *camera);
    void (*light)(void *lim, const struct lim_light *light); /* lim_light_set() */
    /* lim_movers_mem_b(), lim_movers_init() and lim_movers_frame(). */
    size_t (*movers_mem_b)(const struct lim_scene *scene, const struct lim_movers_limits *limits);
    int (*movers_init)(void *lim, void *mem, size_t mem_b, const struct lim_movers_limits *limits);
    int (*movers_frame)(void *lim, const struct lim_camera *camera, const struct lim_instance *instances,
                        uint16_t count);
    /* A frame in parts: lim_movers_begin(), which is lim_frame_begin() without instances, lim_frame_work() and
     * lim_frame_paint(). */
    int (*begin)(void *lim, const struct lim_camera *camera, const struct lim_instance *instances, uint16_t count);
    bool (*work)(void *lim);
    int (*paint)(void *lim);
    uint32_t (*bands)(const void *lim);
    const struct lim_stats *(*stats)(const void *lim);
    void (*set_wireframe)(void *lim, const struct lim_wireframe *wireframe);
    int (*set_antialias)(void *lim, void *mem, size_t mem_b);          /* lim_set_antialias() */
    int (*set_delta)(void *lim, void *mem, size_t mem_b);              /* lim_set_delta() */
    void (*set_overlay)(void *lim, const struct lim_overlay *overlay); /* lim_set_overlay() */
    void (*refresh)(void *lim);                                        /* lim_refresh() */
    /* For measurements: where the camera of the last frame puts a vertex, in pixels, the centre of the first
     * one at 0 (false: it is left to clipping); which side of a plane an eye is on, as WALK decides it. */
    bool (*project)(void *lim, lim_index vertex, double at_px[2]);
    int8_t (*eye_side)(const struct lim_scene *scene, const struct lim_plane_ref *ref, const struct lim_camera *camera);
    void (*count_as)(void *lim, const struct lim_counted *counted, size_t counted_b); /* lim_inspect_count_as() */
    /* Each pixel that a record may cover, and the texel there as the last frame would paint it. */
    void (*texels)(void *lim, lim_index record, core_texel *take, void *ctx);
};

/* The sizes of what a core and its caller share. */
#define CORE_SHARED_B                                                                                                  \
    (sizeof(struct core) + sizeof(struct lim_scene) + sizeof(struct lim_target) + sizeof(struct lim_camera) +          \
     sizeof(struct lim_stats))

extern const struct core core_draft, core_fast, core_fine, core_exact;

/* All of them, cheapest first; NULL behind the last. */
extern const struct core *const cores[];

/* By name, or NULL. */
const struct core *core_find(const char *name);

#endif
