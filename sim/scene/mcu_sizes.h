/* SPDX-License-Identifier: MIT
 *
 * Sizes on 32-bit MCUs. This header includes nothing: tests/targets/sizes.c is compiled for such MCUs, and asserts its
 * numbers. */
#ifndef SIM_MCU_SIZES_H
#define SIM_MCU_SIZES_H

/* Sizes of the structs in the caller's memory on a 32-bit MCU, of a firmware built for narrow screen
 * coordinates and for wide ones (firmware/stages.h). */
enum {
    MCU_CACHE_ENTRIES = 64,
    MCU_CACHED_B = 8,
    MCU_CACHED_WIDE_B = 12,
    MCU_LINE_B = 8,
    MCU_PENDING_B = 4,
    MCU_CELL_B = 4,
    MCU_CELL_WIDE_B = 8,
    MCU_GAP_B = 6,
    MCU_GAP_SAMPLES_B = 14, /* more of them if it can be drawn with antialiased edges */
    MCU_ACTIVE_B = 36,
    MCU_ACTIVE_SAMPLES_B = 4,     /* more of them if it can be drawn with antialiased edges */
    MCU_ACTIVE_MOVES_B = 48,      /* more of them if something moves */
    MCU_ACTIVE_MOVES_LONG_B = 16, /* and more if it does so in a scene of many scales */
    MCU_LONG_EDGES_B = 28,        /* more of them in profile exact: edges of 64 bits */
    MCU_LONG_EDGES_ALIGN_B = 8,
    MCU_LONG_EDGES_MIN_SUB_BITS = 10,
    MCU_LAYER_B = 8,
    MCU_LAYER_MASKED_B = 8, /* more of them if textures are masked */
    MCU_TOP_B = 2,
    MCU_FACE_B = 6,
    MCU_SORTED_B = 8,
    MCU_NEWELL_B = 20,
    MCU_CUT_B = 4,
    MCU_ACTIVE_TEXTURE_B = 88, /* more of them if the scene has textures */
    MCU_CROSSING_TEXTURE_B = 88,
    MCU_CROSSING_LONG_EDGES_B = 32, /* more of them in profile exact */
    MCU_CROSSING_B = 40,            /* and a point for each vertex */
    MCU_MESH_NEARNESS_B = 2,        /* of a vertex */
    MCU_MESH_DEPTH_B = 4,           /* of a pixel of a line of depths */
    MCU_MESH_LEAST_ACTIVE = 7,
    MCU_MESH_ENTRY_B = 6, /* a polygon of a mesh leaf */
    MCU_MESH_ENTRY_WIDE_B = 8,
    MCU_MOVER_B = 192,
    MCU_MOVER_FINE_B = 72,     /* more of them in the profiles fine and exact, at most: half on a Cortex-M0+ */
    MCU_MOVER_ANTIALIAS_B = 4, /* more of them if it can be drawn with antialiased edges */
    MCU_MOVER_LIGHT_B = 4,     /* more of them if light turns */
    MCU_MOVER_TEXTURE_B = 88,  /* more of them if the scene has textures */
    MCU_MOVER_SKY_B = 4,       /* and more if one of these is a sky */
    MCU_MOVER_TELE_B = 8,      /* more of them for long lenses, in the profiles draft and fast */
    MCU_MOVER_LONG_B = 40,     /* more of them in a scene of many scales: where the eye is, in 32 bits */
    MCU_INSTANCE_LONG_B = 68,  /* and a copy of its struct lim_instance */
    MCU_ROUTE_B = 4,
    MCU_MOVED_B = 16,     /* in flash */
    MCU_MOVED_LONG_B = 4, /* and more of them in a scene of many scales */
    /* More of them in a wide scene (width.h): of an entry of the cache, a pending node, also on a mover's way, and an
     * entry of the sorted list; twice as much of a mover, half as much of a face. */
    MCU_INDEX_B = 4,
    MCU_HEAD_CELLS = 2,
    MCU_TOLD_CELLS = 2, /* before the head of what moves, or is met; of the latter one more for each 16 movers */
    MCU_CLIP_PLANES = 5
};

/* A triangle that crosses a line: with edges of 64 bits, as in profile exact; in a wide scene; with its depths; with
 * what it shows of a texture. Numbers of 64 bits are aligned. */
#define MCU_MESH_ACTIVE_B(is_long, is_wide, has_depth, has_texture)                                                    \
    ((is_long) || (is_wide)                                                                                            \
         ? (((is_long) ? 56 : 32) + ((is_wide) ? 8 : 4) + 8 + MCU_MESH_MORE_B(has_depth, has_texture) + 7) / 8 * 8     \
         : 40 + MCU_MESH_MORE_B(has_depth, has_texture))
#define MCU_MESH_MORE_B(has_depth, has_texture) (((has_depth) ? 16 : 0) + ((has_texture) ? 32 : 0))

#endif
