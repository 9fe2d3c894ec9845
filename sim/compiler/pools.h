/* SPDX-License-Identifier: MIT
 *
 * How large the renderer's pools must be: measured with the renderer itself. */
#ifndef SIM_POOLS_H
#define SIM_POOLS_H

#include "scene/compiled.h"

struct needs;

/* Sets scene->scene.limits and the image's, pools included: the most that any of 256 sampled cameras
 * and 64 portraits but the greediest needs at this size and precision (NULL: fast), and an eighth on top. Also sets
 * scene->report.instructions, the mean of those cameras. */
bool pools_measure(struct compiled *scene, const struct core *core, unsigned w_px, unsigned h_px, struct error *err);

/* The same for a scene that has all that for the order nearest first: raises its limits to what scan lines take as
 * well, and sets the report's `draws` and `instructions` to theirs; unless a frame takes more than so many
 * instructions (0: any number): then it stops, early where they are many more, and changes nothing. */
bool pools_measure_scanline(struct compiled *scene, const struct core *core, double instructions_most,
                            struct error *err);

/* Sizes of the structs in the caller's memory on a 32-bit MCU, of a firmware built for narrow screen
 * coordinates and for wide ones (profile.h). tests/targets/sizes.c asserts them. */
enum {
    MCU_CACHE_ENTRIES = 64,
    MCU_CACHED_B = 8,
    MCU_CACHED_WIDE_B = 12,
    MCU_LINE_B = 8,
    MCU_PENDING_B = 4,
    MCU_CELL_B = 4,
    MCU_CELL_WIDE_B = 8,
    MCU_GAP_B = 6,
    MCU_COVERED_B = 2, /* antialiased, of a line and of a gap */
    MCU_ACTIVE_B = 36,
    MCU_ACTIVE_SAMPLES_B = 16, /* more of them if it can be drawn with antialiased edges, which are longer */
    MCU_LONG_EDGES_B = 28,     /* more of them in profile exact, and none for samples: edges of 64 bits */
    MCU_LONG_EDGES_MIN_SUB_BITS = 10,
    MCU_LAYER_B = 8,
    MCU_TOP_B = 2,
    MCU_FACE_B = 6,
    MCU_SORTED_B = 8,
    MCU_NEWELL_B = 20,
    MCU_CUT_B = 4,
    MCU_ACTIVE_TEXTURE_B = 60,        /* more of them if the scene has textures */
    MCU_ACTIVE_TEXTURE_PADDING_B = 4, /* and in profile exact: edges of 64 bits are aligned */
    MCU_CROSSING_TEXTURE_B = 60,
    MCU_CROSSING_LONG_EDGES_B = 32, /* more of them in profile exact */
    MCU_CROSSING_B = 40,            /* and a point for each vertex */
    MCU_MOVER_B = 144,
    MCU_MOVER_FINE_B = 72,     /* more of them in the profiles fine and exact, at most: half on a Cortex-M0+ */
    MCU_MOVER_ANTIALIAS_B = 4, /* more of them if it can be drawn with antialiased edges */
    MCU_MOVER_LIGHT_B = 8,     /* more of them if light turns */
    MCU_ROUTE_B = 6,
    MCU_MOVED_B = 16, /* in flash */
    /* More of them in a wide scene (width.h): of an entry of the cache, a pending node, a mover, an entry of the sorted
     * list and what a depth sort knows of it; half as much of a face and of a pending node on a mover's way. */
    MCU_INDEX_B = 4,
    MCU_HEAD_CELLS = 2,
    MCU_CLIP_PLANES = 5
};

/* The limits that a firmware of these needs makes room for: firmware/pools.c. */
struct lim_limits pools_mcu_limits(const struct compiled *scene, const struct needs *needs);

/* The same for a scene that has its limits already, with all that moves in it; sets moving->limits.entries too. */
struct moving;
bool pools_measure_moving(struct compiled *scene, struct moving *moving, const struct core *core, unsigned w_px,
                          unsigned h_px, struct error *err);

/* Bytes that lim_init() wants on a 32-bit MCU for the panel, the precision and the method of scene->report,
 * and the least that it takes. This host's structs are larger. */
size_t pools_mcu_mem_b(const struct compiled *scene);
size_t pools_mcu_mem_min_b(const struct compiled *scene);

/* Likewise for lim_movers_init(): NAME_MOVERS_MEM_B of the generated header, or a little more. */
size_t pools_mcu_movers_mem_b(const struct compiled *scene, const struct moving *moving);

#endif
