/* SPDX-License-Identifier: MIT
 *
 * What the orders keep, and what they put to use above the lines: lists, what moves, changes of the picture. As
 * stages.h, so that callers can place a renderer. Public are struct lim_light, struct lim_newell_options and the sizes
 * of memory, at the end. */
#ifndef LIM_ORDERS_H
#define LIM_ORDERS_H

#include "camera.h"
#include "config.h"
#include "scene.h"
#include "stages.h"
#include "target.h"

/* A directional light for movers: each polygon has one brightness, middle + swing * cosine of the angle between its
 * normal and the light. What stands still has its light baked into its colours. */
struct lim_light {
    bool on;                     /* else movers show the colours that they were compiled with */
    int16_t to_q14[3];           /* towards the light, in the static scene's axes, of length 1 */
    uint8_t middle_q8, swing_q8; /* middle + swing is 256 at most, so that nothing gets brighter than its colour */
};

LIM_C_BEGIN

/* The colour (RGB565 as a number) of a face with this normal, of any length but 0, in the axes that `to_q14` is in. */
uint16_t lim_light_shade(const struct lim_light *light, const int16_t to_q14[3], const int32_t normal[3],
                         uint16_t rgb565);

LIM_C_END

LIM_OPTIONAL_BEGIN

/* Lists, and what moves ------------------------------------------------------------------------------------------- */

/* A polygon of a mesh leaf that faces the eye. */
struct lim_mesh_entry {
    lim_index record; /* in scene->polygons */
    uint16_t next;    /* of those that are about as near, or LIM_NONE */
    uint16_t key;     /* what is drawn first has the lower one */
};
#define LIM_MESH_LEAF_LISTS(polygon_count) ((polygon_count) / 8 + 16)

/* How a mesh leaf is looked at. */
struct lim_mesh_leaf_seen {
    const struct lim_scene *scene;
    struct lim_view *view;
    bool back_to_front;
};

/* A mesh leaf that is being drawn (mesh_leaf.h). */
struct lim_mesh_leaf {
    struct lim_mesh_leaf_seen seen;
    const LIM_FLASH lim_index *run;
    struct lim_point *points; /* of its vertices, on the screen */
    uint16_t *nearness;       /* likewise, as struct lim_mesh has it */
    struct lim_mesh_entry *entries;
    uint16_t *lists;            /* in the order of drawing, by nearness */
    uint16_t list_count, list;  /* list: the one that is being drawn */
    uint16_t size, used;        /* entries */
    lim_index first;            /* its first vertex */
    uint8_t near_shift, extent; /* as struct lim_mesh has them */
    /* Where not all that face the eye have room at once: which of them are entries, from one place in the order of
     * drawing to before another. */
    bool is_partial;
    lim_word_s64 from, end;
};

/* An instance as this frame has it; in a long scene, in a frame of reference of its own (mover_long.h). */
struct lim_mover {
    struct lim_view view; /* in the object's coordinates, once lim_mover_view() has set its rows; the cache is shared */
    struct lim_eye eye;   /* likewise */
    int32_t centre_q12[3];   /* of the object's box, units of the static scene, |centre| + radius < 2^28 */
    int32_t radius_q12;      /* negative: it is left out */
    int32_t half_q12[3];     /* likewise: of a box along the scene's axes */
    int32_t own_half_q12[3]; /* and of one along its own */
    /* Of this walk (meet.c). */
    struct lim_rect rect;  /* its pixels are within */
    uint32_t against;      /* movers with which no order of drawing is right, modulo 32: crowd.c compares them */
    lim_index first, last; /* nodes on the way to the first and the last place that it reaches to */
    uint16_t next;         /* of those that are on their way, or LIM_NONE */
    uint8_t stage;         /* where it is on its way */
    uint8_t met;           /* enum lim_met, of the polygon that is being retained */
    bool crowded;          /* it is compared with any, or with what stands still */
    LIM_OPTIONAL(int16_t, to_q14, 3 * LIM_HAS_LIGHT); /* towards the light, in its own axes */
    /* Set with the view's rows. first_texture is LIM_NONE: it shows the colours of its records. */
    LIM_OPTIONAL(struct lim_texturing, texturing, LIM_HAS_TEXTURE);
};

/* What is due when a node's near subtree is done: route.h. */
struct lim_route_pending {
    lim_index node;
    uint8_t flags; /* of meet.c */
    int8_t side;   /* of the eye */
};

/* A corner of a mover in the static scene. */
struct lim_placed {
    uint16_t mover; /* or LIM_NONE */
    lim_index vertex;
    int32_t at_q12[3];
};
enum { LIM_PLACED_CORNERS = 32 };

/* Corners of a piece. */
struct lim_corners {
    uint8_t n;
    int32_t at_q12[LIM_PIECE_VERTICES][3]; /* |coordinate| <= 2^27 */
};

struct lim_movers {
    const struct lim_instance *instances; /* the caller's */
    uint16_t given, count;                /* of this frame, and how many of them there is room for */
    uint16_t most;                        /* instances that there is room for */
    uint16_t most_corners;                /* of a polygon */
    struct lim_mover *movers;
    struct lim_view_cached *cache;
    uint16_t cached; /* whose vertices the cache holds */
    struct lim_route_pending *stack, *object_stack;
    uint16_t object_depth;
    struct lim_camera camera;
    int32_t axes_q30[9];                          /* the camera's */
    int32_t ahead_q28[3];                         /* likewise */
    lim_word_s64 eye_ahead_q40;                   /* how far along that the eye is */
    struct lim_placed placed[LIM_PLACED_CORNERS]; /* of this frame, lately */
    LIM_OPTIONAL(struct lim_light, light, LIM_HAS_LIGHT);
    LIM_OPTIONAL(struct lim_texturing *, texturing, LIM_HAS_TEXTURE); /* of the frame; NULL: without textures */
    LIM_OPTIONAL(struct lim_cull, cull, LIM_HAS_CULL);                /* of the object that is being drawn whole */
    LIM_OPTIONAL(struct lim_mesh_leaf, leaf, LIM_HAS_MESH_LEAVES);    /* likewise */
    LIM_OPTIONAL(uint16_t, leaf_vertices, LIM_HAS_MESH_LEAVES);       /* the most that there is room for */
    LIM_OPTIONAL(uint16_t, leaf_polygons, LIM_HAS_MESH_LEAVES);
    LIM_OPTIONAL(const struct lim_eye *, far, LIM_HAS_LONG);   /* of a long scene that they move in, or NULL; then */
    LIM_OPTIONAL(struct lim_instance *, copies, LIM_HAS_LONG); /* `instances` are these, each in its frame */
};

/* How LIM_NEWELL works (newell.h). Zero is the default; either gives a right picture. */
struct lim_newell_options {
    bool planes_first; /* tests 3 and 4 before 1 and 2 */
    bool split_one;    /* only P, by Q's plane, where that does */
    uint32_t most;     /* comparisons of a list, after which it is painted as it is; 0: LIM_NEWELL_EFFORT (config.h) */
};

/* What LIM_NEWELL has to know of an entry of the sorted list beside its farthest point. */
struct lim_newell_polygon {
    int32_t near_qv;      /* view-space z of its nearest vertex */
    struct lim_rect rect; /* holds every pixel of it */
    lim_index node;       /* whose run it is in */
    uint16_t cuts;        /* the last cut that made this piece, or LIM_NONE: it is whole */
    bool eye_in_front;    /* of its plane */
    bool swapped : 1;     /* it goes before a P already */
    bool last : 1;        /* of its part of the list: what follows may be painted after all of that */
};

/* A piece lies on one side of the plane of another entry. */
struct lim_cut {
    uint16_t next; /* the cut before it, or LIM_NONE */
    uint16_t by;   /* that entry, and LIM_CUT_FRONT */
};
#define LIM_CUT_FRONT 0x8000u
#define LIM_SORTED_MAX 0x7FFFu /* entries of a list */

struct lim_newell {
    struct lim_newell_polygon *polygons; /* one an entry */
    struct lim_cut *cuts;
    uint16_t cut_size, cuts_used;
    struct lim_newell_options options;
    uint32_t left; /* comparisons of this list */
};

/* An entry of the list. */
struct lim_sorted {
    int32_t far_qv;   /* view-space z of its farthest vertex, as rows.c scales it */
    lim_index record; /* in scene->polygons */
    uint16_t next;    /* in the list, or LIM_NONE */
};

/* A list of the scene's polygons, once a frame. */
struct lim_sorter {
    struct lim_pass *pass;
    struct lim_sorted *list;
    uint16_t size, used;
    uint16_t first; /* of the list; once the frame is ordered, the nearest */
    LIM_OPTIONAL(struct lim_newell, newell, LIM_HAS_NEWELL);
};

/* Whether the frame has movers. */
static inline bool lim_moves(const struct lim_movers *movers)
{
    return LIM_HAS_MOVERS && movers->count > 0;
}

/* A way through a tree (route.h). */
struct lim_route {
    struct lim_pass *pass;
    const struct lim_scene *scene;
    const struct lim_eye *eye;
    struct lim_cull *cull; /* the open view in the scene's coordinates */
    const uint8_t *shown;  /* NULL: all (portals.h) */
    struct lim_route_pending *stack;
    uint16_t depth;
    lim_index next; /* the subtree to enter, or LIM_NO_INDEX */
    lim_index node; /* whose run was handed out last */
    int8_t side;    /* of the eye there */
    uint16_t list;  /* movers that are on their way, or LIM_NONE */
    struct lim_movers *movers;
};

/* Changes --------------------------------------------------------------------------------------------------------- */

struct lim_runs {
    uint32_t *line;  /* w_px: the runs that begin at each pixel, of the line that is drawn */
    uint32_t *ring;  /* of all lines */
    uint16_t size;   /* of the ring; one less can be in use */
    uint16_t head;   /* where its next run goes */
    uint16_t tail;   /* its oldest run: the last frame's, of the line that is drawn */
    uint16_t *first; /* h_px + 1: each line's first run, as this frame has it up to the line that is drawn, and as the
                        last frame had it below. A line that begins where the next one does is not known */
    uint16_t w_px, h_px;
};

/* How many are put together at a time: with fewer, more is sent and less is tried. */
enum { LIM_DELTA_RECTS = 32 };

struct lim_rects {
    uint32_t window_px; /* what a window costs, in pixels that could be sent instead */
    uint16_t count;
    uint16_t growing; /* so many, which come first, may still grow */
    uint16_t y;       /* the line that was added to last */
    struct lim_rect rect[LIM_DELTA_RECTS];
    uint32_t area_px[LIM_DELTA_RECTS];
};

struct lim_delta {
    struct lim_target target; /* the caller's */
    struct lim_stats *stats;
    struct lim_runs runs;
    struct lim_rects rects;   /* of lines that are kept; with pages: of the page, which is one line */
    struct lim_rect stream;   /* the window of lines that were sent at once, from the line that it takes next */
    struct lim_camera camera; /* of the last frame */
    bool still;               /* it is this frame's as well */
    bool known;               /* the panel shows the last frame */
    bool noted;               /* the line that is drawn was noted: all of its pieces */
    uint16_t y;               /* the line that was done last, all of it or a piece */
    uint16_t *line;           /* where it is painted, or NULL */
};

/* Orders ---------------------------------------------------------------------------------------------------------- */

struct lim_painter {
    struct lim_pass *pass;
    LIM_OPTIONAL(struct lim_sorter *, sorter, LIM_HAS_SORTED);
    LIM_OPTIONAL(uint16_t *, lent, LIM_HAS_FALLBACK); /* the line that nearest first could not finish, or NULL */
    LIM_OPTIONAL(struct lim_mesh_leaf *, leaf, LIM_HAS_MESH_LEAVES);
};

/* How far a frame is that lim_frame_begin() began. */
enum lim_ahead_stage {
    LIM_AHEAD_NONE, /* there is none */
    LIM_AHEAD_BEGUN,
    LIM_AHEAD_BUSY,      /* in pass one */
    LIM_AHEAD_DONE,      /* with pass one */
    LIM_AHEAD_EXHAUSTED, /* in pass one: a pool is */
    LIM_AHEAD_PAINTING   /* the target's functions are being called */
};

/* Pass one between two quanta. */
struct lim_progress {
    const LIM_FLASH lim_index *record; /* of a run, the next; NULL: another run is due */
    LIM_OPTIONAL(struct lim_route, route, LIM_HAS_MOVERS);
    uint16_t entry; /* of the sorted list, the next */
};

/* A polygon that a band of one pixel is left to, or may be (one_pixel.c). */
struct lim_pixel_polygon {
    struct lim_met_polygon met;
    int16_t x0, x1;  /* what it has of the line */
    uint16_t number; /* in the order of the walk; 0: there is none */
    uint16_t colour; /* there, as it lies in memory */
    uint8_t alpha;
    LIM_OPTIONAL(uint16_t, samples, LIM_HAS_ANTIALIAS); /* of the pixel, that no nearer one has; 0: there is none */
    LIM_OPTIONAL(uint32_t, share, LIM_HAS_ANTIALIAS);   /* lim_smooth_share() */
};

/* How a band of one pixel is collected: as any; one polygon alone is retained, the nearest; or none is, but the nearest
 * is found that has samples, or is opaque, or the farthest layer before the one that was found last. */
enum lim_by_pixel {
    LIM_BY_PIXEL_NOT,
    LIM_BY_PIXEL_RETAINED,
    LIM_BY_PIXEL_SAMPLES,
    LIM_BY_PIXEL_OPAQUE,
    LIM_BY_PIXEL_LAYERS
};

enum { LIM_POLYGONS_PER_SHRINK = 20 }; /* the open view is drawn together this often */

struct lim_nearest {
    struct lim_pass *pass;
    LIM_OPTIONAL(struct lim_sorter *, sorter, LIM_HAS_SORTED);
    LIM_OPTIONAL(struct lim_movers *, movers, LIM_HAS_MOVERS);
    LIM_OPTIONAL(struct lim_painter *, painter, LIM_HAS_FALLBACK); /* for lines for which a pool is too small */
    LIM_OPTIONAL(struct lim_mesh_leaf *, leaf, LIM_HAS_MESH_LEAVES);
    struct lim_spans spans;
    struct lim_retained retained;
    struct lim_paint paint;
    uint32_t bands;       /* lim_bands() */
    uint16_t top, bottom; /* lines of the band; its bottom rises where a pool is too small (room.c) */
    LIM_OPTIONAL(uint16_t, line_gaps, LIM_HAS_ANTIALIAS); /* for a line that scan lines paint, antialiased */
    uint8_t since_shrink;                                 /* polygons since the open view was drawn together */
    bool retains_all;                                     /* by scan lines, in this band */
    bool fills;                                           /* polygons are painted as they come */
    LIM_OPTIONAL(bool, moves, LIM_HAS_MOVERS);            /* what comes is a mover's: it closes nothing */
    LIM_OPTIONAL(uint8_t, by_pixel,
                 LIM_HAS_MOVERS); /* enum lim_by_pixel, in this band; and in the next one, if not 0: */
    LIM_OPTIONAL(uint8_t, asked_pixel, LIM_HAS_MOVERS);
    LIM_OPTIONAL(struct lim_pixel_polygon, found, LIM_HAS_MOVERS);
    LIM_OPTIONAL(struct lim_pixel_polygon, last, LIM_HAS_MOVERS);  /* of the walk before */
    LIM_OPTIONAL(struct lim_pixel_polygon, comes, LIM_HAS_MOVERS); /* the one that is collected */
    LIM_OPTIONAL(uint16_t, numbered, LIM_HAS_MOVERS);              /* those that have come */
    LIM_OPTIONAL(uint16_t *, pixels, LIM_HAS_MOVERS);              /* their line */
    struct lim_progress progress;
};

/* A polygon that faces the eye and meets the screen. */
struct lim_face {
    lim_index record;                        /* word offset into lim_scene.polygons */
    uint16_t next;                           /* in a list, or LIM_NONE */
    uint16_t crossing;                       /* its entry in the pool, or LIM_NONE */
    LIM_OPTIONAL(bool, seen, LIM_HAS_STATS); /* it has painted a pixel */
};

/* A face that crosses the current line, and where its boundaries are unless it is non-monotone. Free for another
 * one on the lines from polygon.shape.bottom on. */
struct lim_crossing {
    struct lim_screen_polygon polygon;
    struct lim_edge_pair pair;
    LIM_OPTIONAL(struct lim_gradients, gradients, LIM_HAS_TEXTURE); /* if it has a texture */
};

struct lim_convex {
    struct lim_pass *pass;
    uint16_t *tops; /* for each line the faces that start on it, or LIM_NONE */
    struct lim_crossing *pool;
    struct lim_face *faces; /* those of this frame from the farthest to the nearest: from `farthest` to memory's end */
    uint16_t pool_used;     /* entries that this frame has used, free again or not */
    uint16_t farthest;
    uint16_t first;                                          /* of the faces that cross the current line, or LIM_NONE */
    LIM_OPTIONAL(struct lim_piece_look, look, LIM_HAS_FILL); /* of the current line */
};

/* Memory ---------------------------------------------------------------------------------------------------------- */

/* Bytes that lim_init() cuts up, for each order: constant expressions when their arguments are. A scene's header has
 * its own with the scene's limits filled in: NAME_SCENE_MEM_B(h_px). */
#define LIM_MEM_B(h_px, depth, cell_count, gap_count, active_count)                                                    \
    LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(struct lim_line) +     \
                      (depth) * sizeof(struct lim_walk_pending) + (cell_count) * sizeof(union lim_retained_cell) +     \
                      (gap_count)*LIM_GAP_MEM_B + (active_count) * sizeof(struct lim_active))
/* Beside LIM_MEM_B(), if the scene has transparent polygons. */
#define LIM_LAYERS_MEM_B(layer_count) ((layer_count) * sizeof(struct lim_layer))
/* `piece_count`: how often a frame's polygons can be split. */
#define LIM_DEPTH_MEM_B(h_px, polygon_count, cell_count, gap_count, active_count)                                      \
    (LIM_MEM_B(h_px, 0, cell_count, gap_count, active_count) + (polygon_count) * sizeof(struct lim_sorted))
#define LIM_NEWELL_MEM_B(h_px, polygon_count, piece_count, cell_count, gap_count, active_count)                        \
    (LIM_DEPTH_MEM_B(h_px, (polygon_count) + (piece_count), cell_count, gap_count, active_count) +                     \
     ((polygon_count) + (piece_count)) * sizeof(struct lim_newell_polygon) +                                           \
     (piece_count) * (2 * sizeof(struct lim_cut)))

#define LIM_PAINTER_MEM_B(depth)                                                                                       \
    LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) +                                        \
                      (depth) * sizeof(struct lim_walk_pending))

#define LIM_CONVEX_MEM_B(h_px, polygon_count, active_count)                                                            \
    LIM_MEM_ALIGNED_B(LIM_MEM_ALIGNED_B(LIM_CONVEX_POOL_AT_B(h_px) + (polygon_count) * sizeof(struct lim_face)) +      \
                      (active_count) * sizeof(struct lim_crossing))
/* Where the crossings begin, whose edges may have 64 bits. */
#define LIM_CONVEX_POOL_AT_B(h_px)                                                                                     \
    ((LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(uint16_t)) +         \
      LIM_ALIGNOF(struct lim_crossing) - 1) &                                                                          \
     ~(LIM_ALIGNOF(struct lim_crossing) - 1))

/* For lim_movers_init(): `depth` of the static scene, `object_depth` and the rest as struct lim_movers_limits. */
#define LIM_MOVERS_MEM_B(depth, instance_count, object_depth)                                                          \
    LIM_MEM_ALIGNED_B((instance_count) * (sizeof(struct lim_mover) + LIM_HAS_LONG * sizeof(struct lim_instance)) +     \
                      LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) +                                        \
                      (LIM_CAST(size_t, depth) + (object_depth)) * sizeof(struct lim_route_pending))

/* Beside that of a scene with mesh leaves, or of movers: `vertex_count` and `polygon_count` as limits.leaf_... */
#define LIM_MESH_LEAF_MEM_B(vertex_count, polygon_count)                                                               \
    LIM_MEM_ALIGNED_B(LIM_CAST(size_t, vertex_count) * (sizeof(struct lim_point) + sizeof(uint16_t)) +                 \
                      LIM_CAST(size_t, polygon_count) * sizeof(struct lim_mesh_entry) +                                \
                      ((polygon_count) ? LIM_MESH_LEAF_LISTS(LIM_CAST(size_t, polygon_count)) * sizeof(uint16_t) : 0))

/* What lim_set_antialias() borrows: a line's sums, and which samples are closed where that has to do without gaps. */
#define LIM_ANTIALIAS_MEM_B(w_px) LIM_MEM_ALIGNED_B(LIM_CAST(size_t, w_px) * (sizeof(uint32_t) + sizeof(uint16_t)))

#define LIM_DELTA_MEM_B(w_px, h_px, run_count)                                                                         \
    ((sizeof(struct lim_delta) + (LIM_CAST(size_t, w_px) + (run_count)) * sizeof(uint32_t) +                           \
      (LIM_CAST(size_t, h_px) + 1) * sizeof(uint16_t) + 3) &                                                           \
     ~LIM_CAST(size_t, 3))

LIM_OPTIONAL_END

#endif
