/* SPDX-License-Identifier: MIT
 *
 * The sizes on which the compiler's report of RAM rests are those of the renderer on this CPU.
 * Compiled for 32-bit MCUs with narrow and with wide screen coordinates; never linked. */
#include "limner.h"

#include "../../sim/scene/mcu_sizes.h"
#include "lines/mesh_clip.h"
#include "view/clip.h"

_Static_assert((int)MCU_CACHE_ENTRIES == (int)LIM_VIEW_CACHE_ENTRIES, "cache entries");
enum { INDEX_B = LIM_HAS_WIDE ? MCU_INDEX_B : 0 };
_Static_assert((LIM_WIDE ? MCU_CACHED_WIDE_B : MCU_CACHED_B) + INDEX_B == sizeof(struct lim_view_cached),
               "cache entry");
_Static_assert(MCU_LINE_B == sizeof(struct lim_line), "line");
_Static_assert(MCU_PENDING_B + INDEX_B == sizeof(struct lim_walk_pending), "pending node");
_Static_assert((LIM_WIDE ? MCU_CELL_WIDE_B : MCU_CELL_B) == sizeof(union lim_retained_cell), "retained cell");
_Static_assert(MCU_GAP_B + (LIM_HAS_ANTIALIAS ? MCU_GAP_SAMPLES_B : 0) == LIM_GAP_MEM_B, "gap");
enum {
    HAS_LONG_EDGES = LIM_SUB_BITS >= MCU_LONG_EDGES_MIN_SUB_BITS,
    FLAT_B = MCU_ACTIVE_B + (LIM_HAS_ANTIALIAS ? MCU_ACTIVE_SAMPLES_B : 0) +
             (LIM_HAS_TEXTURE ? MCU_ACTIVE_TEXTURE_B : 0) +
             (LIM_HAS_MOVERS ? MCU_ACTIVE_MOVES_B + (LIM_HAS_LONG ? MCU_ACTIVE_MOVES_LONG_B : 0) : 0),
    LONG_B = (FLAT_B + MCU_LONG_EDGES_B + MCU_LONG_EDGES_ALIGN_B - 1) / MCU_LONG_EDGES_ALIGN_B * MCU_LONG_EDGES_ALIGN_B,
    ACTIVE_B = HAS_LONG_EDGES ? LONG_B : FLAT_B
};
_Static_assert(ACTIVE_B == sizeof(struct lim_active), "active polygon");
_Static_assert(MCU_LAYER_B + (LIM_HAS_MASKED ? MCU_LAYER_MASKED_B : 0) == sizeof(struct lim_layer),
               "transparent piece of a line");
_Static_assert((int)MCU_HEAD_CELLS == (int)LIM_RETAINED_HEAD_CELLS, "head of a retained polygon");
_Static_assert((int)MCU_CLIP_PLANES == (int)CLIP_PLANES, "vertices that clipping adds");

_Static_assert(MCU_SORTED_B + INDEX_B == sizeof(struct lim_sorted), "entry of the sorted list");
_Static_assert(MCU_NEWELL_B == sizeof(struct lim_newell_polygon), "what a depth sort knows of an entry");
_Static_assert(MCU_CUT_B == sizeof(struct lim_cut), "cut");

enum {
    IS_FINE = LIM_PROFILE >= LIM_PROFILE_FINE,
    MOVER_B = MCU_MOVER_B + 2 * INDEX_B + (IS_FINE ? MCU_MOVER_FINE_B : 0) +
              (LIM_HAS_ANTIALIAS ? MCU_MOVER_ANTIALIAS_B : 0) + (LIM_HAS_LIGHT ? MCU_MOVER_LIGHT_B : 0) +
              (LIM_HAS_TEXTURE ? MCU_MOVER_TEXTURE_B : 0) + (LIM_HAS_SKY ? MCU_MOVER_SKY_B : 0) +
              (LIM_HAS_TELE && !IS_FINE ? MCU_MOVER_TELE_B : 0) + (LIM_HAS_LONG ? MCU_MOVER_LONG_B : 0)
};
/* CPUs that do not multiply to 64 bits keep finer rows in fewer bytes, and those that multiply pairs three rows and the
 * eye, whose three entries of 16 bits take two words, not three. */
enum { PAIRS_SAVE_B = LIM_DUAL_MULTIPLY ? 4 * 4 : 0 };
_Static_assert(IS_FINE ? MOVER_B >= sizeof(struct lim_mover) : MOVER_B == sizeof(struct lim_mover) + PAIRS_SAVE_B,
               "mover");
_Static_assert(MCU_ROUTE_B + INDEX_B == sizeof(struct lim_route_pending), "pending node on a mover's way");
_Static_assert(MCU_MOVED_B + (LIM_HAS_LONG ? MCU_MOVED_LONG_B : 0) == sizeof(struct lim_moved),
               "object and its motion");
_Static_assert(!LIM_HAS_LONG || MCU_INSTANCE_LONG_B == sizeof(struct lim_instance), "copy of an instance");

#if LIM_HAS_MESHES
_Static_assert(MCU_MESH_ACTIVE_B(HAS_LONG_EDGES, LIM_HAS_WIDE, LIM_HAS_MESH_DEPTH, LIM_HAS_TEXTURE) ==
                   sizeof(struct lim_mesh_active),
               "triangle that crosses a line");
_Static_assert((LIM_WIDE ? MCU_CELL_WIDE_B : MCU_CELL_B) == sizeof(struct lim_point), "point of a mesh");
_Static_assert(MCU_MESH_NEARNESS_B == sizeof *((struct lim_mesh *)0)->nearness, "nearness of a vertex");
_Static_assert(MCU_MESH_DEPTH_B == sizeof *((struct lim_mesh_depths *)0)->line_q16, "pixel of a line of depths");
_Static_assert((int)MCU_MESH_LEAST_ACTIVE == MESH_FAN + 1, "least pool of a mesh");
#endif

#if LIM_HAS_MESH_LEAVES
_Static_assert((LIM_HAS_WIDE ? MCU_MESH_ENTRY_WIDE_B : MCU_MESH_ENTRY_B) == sizeof(struct lim_mesh_entry),
               "polygon of a mesh leaf");
_Static_assert((LIM_WIDE ? MCU_CELL_WIDE_B : MCU_CELL_B) == sizeof(struct lim_point), "point of a mesh leaf");
#endif

#if LIM_HAS_CONVEX
_Static_assert(MCU_TOP_B == sizeof *((struct lim_convex *)0)->tops, "head of a line's faces");
_Static_assert(MCU_FACE_B + INDEX_B / 2 == sizeof(struct lim_face), "face");
enum { FLAGS_B = LIM_HAS_WIREFRAME ? (CLIP_MAX_VERTICES + 15) / 16 * 2 : 0 };
/* Parts that not every scene has share padding. What is antialiased is never drawn as a convex solid. */
enum {
    CROSSING_B = MCU_CROSSING_B + (HAS_LONG_EDGES ? MCU_CROSSING_LONG_EDGES_B : 0) +
                 (LIM_HAS_TEXTURE ? MCU_CROSSING_TEXTURE_B : 0) +
                 CLIP_MAX_VERTICES * (LIM_WIDE ? MCU_CELL_WIDE_B : MCU_CELL_B) + (FLAGS_B + 3) / 4 * 4
};
_Static_assert(LIM_HAS_ANTIALIAS ||
                   (CROSSING_B >= sizeof(struct lim_crossing) && CROSSING_B <= sizeof(struct lim_crossing) + 4),
               "face that crosses a line");
#endif
