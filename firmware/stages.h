/* SPDX-License-Identifier: MIT
 *
 * What the stages keep: a struct for each that has any state, and the entries of the pools that they are lent. They are
 * complete here so that callers can place a renderer, and know its memory's size as a constant. Public is what frames
 * count; all else is private: a struct belongs to the stage whose header has its functions. What stands above the lines
 * is in orders.h. */
#ifndef LIM_STAGES_H
#define LIM_STAGES_H

#include "camera.h" /* first: where a type stands decides whether the proof of perspective_at() is found in time */
#include "config.h"
#include "scene.h"
#include "target.h"
#include "texturing.h"

struct lim_delta;
struct lim_crowd_cut;
struct lim_movers;
struct lim_open_strip;
LIM_OPTIONAL_BEGIN

/* Numbers --------------------------------------------------------------------------------------------------------- */

#define LIM_HAS_LIMBS (LIM_PROFILE >= LIM_PROFILE_FINE)      /* rows and ratios beyond 16 bits */
#define LIM_HAS_FRACTIONS (LIM_PROFILE == LIM_PROFILE_EXACT) /* vertices with 8 fraction bits */
#define LIM_TURNS_ROWS (LIM_HAS_TELE && !LIM_HAS_LIMBS)
#define LIM_DRAFT_MARGIN_BITS 8 /* what is outside by 2^-8 of half the screen stays outside in whole pixels too */
#define LIM_SUB (INT32_C(1) << LIM_SUB_BITS) /* sub-pixels in a pixel */

/* Screen coordinates span -w/2 .. 3w/2 because of the guard band. Up to this many pixels a side they fit
 * 16 bits, if they count from a pixel in the middle. Which one it is makes no difference to any picture. */
#define LIM_NARROW_SIDE_PX (32767 >> LIM_SUB_BITS)
#define LIM_WIDE (LIM_MAX_SIDE_PX > LIM_NARROW_SIDE_PX)
#define LIM_ORIGIN_PX (LIM_WIDE ? 0 : LIM_MAX_SIDE_PX / 2)

/* A screen coordinate in sub-pixels. */
#if LIM_WIDE
typedef int32_t lim_sub;
#else
typedef int16_t lim_sub;
#endif

/* A point on the screen; the centre of pixel (i, j) is at (i - LIM_ORIGIN_PX, j - LIM_ORIGIN_PX) * LIM_SUB. Aligned, so
 * that processors of 32 bits copy it as a word; else some of them would call memcpy(). */
struct lim_point {
    lim_sub x LIM_WORD_ALIGNED, y;
};

/* What frames count ----------------------------------------------------------------------------------------------- */

/* The tests of LIM_NEWELL in their textbook order, and where they are tried swapped. */
enum lim_newell_test {
    LIM_TEST_X,          /* 1: the extents in x do not overlap, in whole pixels */
    LIM_TEST_Y,          /* 2: nor those in y */
    LIM_TEST_P_BEHIND,   /* 3: P lies behind Q's plane */
    LIM_TEST_Q_IN_FRONT, /* 4: Q lies in front of P's plane */
    LIM_TEST_APART,      /* 5: the projections do not overlap */
    LIM_TEST_Q_BEHIND,   /* 3': Q lies behind P's plane */
    LIM_TEST_P_IN_FRONT, /* 4': P lies in front of Q's plane */
    LIM_TEST_P_PART,     /* 6: that part of P which lies in front of Q's plane does not overlap Q on the screen */
    LIM_TEST_P_REST,     /* 6': nor does that part which lies behind it */
    LIM_TESTS
};

/* Why an entry was left to its farthest point. */
enum lim_forced {
    LIM_FORCED_ROOM,    /* no memory for another piece */
    LIM_FORCED_CORNERS, /* a piece would have too many corners */
    LIM_FORCED_EFFORT,  /* no comparisons left */
    LIM_FORCED_REASONS
};

/* What it took to order a frame's polygons. */
struct lim_newell_stats {
    uint32_t comparisons;                   /* pairs whose extents in z overlap */
    uint32_t decided[LIM_TESTS];            /* which test settled how many of them */
    uint32_t swaps;                         /* a Q that goes before its P */
    uint32_t splits;                        /* polygons or pieces cut in two */
    uint32_t divisions;                     /* parts of the list that a plane divided */
    uint32_t stuck;                         /* of these: comparing found neither an order nor a polygon to split */
    uint32_t forced;                        /* entries left to their farthest points: the picture may be wrong there */
    uint32_t forced_by[LIM_FORCED_REASONS]; /* the same, by reason */
};

/* What became of a frame's instances. */
struct lim_mover_stats {
    uint32_t left_out;    /* without a mesh, beyond the number, too far away, or drawn by a method without a tree */
    uint32_t hidden;      /* out of view */
    uint32_t crowded;     /* found to be compared on lines, with what they reach through or each other, in all walks */
    uint32_t comparisons; /* of two polygons on one line */
    uint32_t cuts;        /* of these, that made one hide some of the other against their order */
};

/* What delta output sent of a frame. */
struct lim_delta_stats {
    uint32_t pixels;      /* sent */
    uint32_t windows;     /* opened for them; with pages, pieces of pages */
    uint16_t runs_max;    /* most of the runs that were kept at a time */
    uint16_t lines_whole; /* lines that were sent whole because the last frame's, or their own, were not kept */
};

/* What a frame did; all zero when LIM_HAS_STATS is 0. Lines that are left to the painter's order have no background. */
struct lim_stats {
    uint32_t nodes;            /* nodes visited */
    uint32_t records;          /* records of leaves, each of which has a plane to test; mesh: all triangles */
    uint32_t boxes, boxes_out; /* subtree bounds tested; of these out of the open view */
    uint32_t hidden;           /* subtrees that cannot be seen from where the eye is */
    uint32_t polygons;         /* polygons reached: front-facing, in a subtree that was not skipped */
    uint32_t polygons_seen;    /* of these, with at least one pixel */
    uint32_t vertices;         /* vertices transformed */
    uint32_t clipped;          /* polygons that met the near plane or the guard band */
    uint32_t non_monotone;     /* polygons that rounding made non-monotone, drawn as triangles */
    uint32_t lines;            /* lines of polygons that were stepped */
    uint32_t pixels_painted;   /* pixels written by polygons, as often as they are; not of pictures that targets keep */
    uint32_t pixels_deep;      /* of those, pixels at which depths were compared, whether they were written or not */
    uint32_t pixels_background; /* pixels filled with the background; convex: those that no face has painted, about */
    uint32_t divisions;         /* for the perspective of textures */
    uint32_t bands;             /* extra walks because a pool was exhausted; convex: faces' lines without room */
#if LIM_HAS_SORTED
    uint32_t sorted; /* entries of the sorted list, pieces included */
#endif
#if LIM_HAS_NEWELL
    struct lim_newell_stats newell;
#endif
#if LIM_HAS_MOVERS
    struct lim_mover_stats movers;
#endif
#if LIM_HAS_DELTA
    struct lim_delta_stats delta;
#endif
    uint16_t retained_cells_max, gaps_max, active_max; /* most used of each pool in one walk; convex: faces on a line */
    uint32_t active_max_b; /* what those take beside the memory that pass two does not need, at most */
    uint16_t layers_max;   /* most transparent pieces of one line, nearest first */
    uint32_t leaf_records, leaf_polygons_max; /* of `records`, those of mesh leaves; most of one, sorted at once */
};

/* View ------------------------------------------------------------------------------------------------------------ */

#if LIM_DUAL_MULTIPLY
typedef int16_t lim_row_entry;
#else
typedef int_fast16_t lim_row_entry;
#endif

/* A row of the view matrix. */
struct lim_row {
    lim_row_entry n_qv[3]; /* |entry| <= 32767 */
    int32_t shift_qv;      /* where the row puts the origin of the scene */
#if LIM_HAS_LIMBS
    lim_row_entry low_qv15[3]; /* what rounding took from the entries, 15 bits further: -2^14..2^14 */
#endif
#if LIM_HAS_LIMBS && LIM_LONG_MULTIPLY
    int32_t n_qv16[3]; /* both together, doubled */
#endif
};

struct lim_rows {
    uint8_t tele_bits; /* the row of z is kept 2^tele_bits times as long: a narrow lens makes it short */
    LIM_OPTIONAL(uint8_t, zoom_bits, LIM_HAS_TELE * 2); /* a long lens sees |x| <= z / 2^zoom_bits[0], y likewise */
    struct lim_row row[3];                              /* x, y and z of view space */
    int32_t near_qv;    /* distance of the near plane in view space, >= PERSPECTIVE_Z_MIN_QV */
    uint32_t far_units; /* no vertex is farther from the eye */
    LIM_OPTIONAL(int32_t, turn_q32, LIM_TURNS_ROWS * 2);  /* of z, added to x and y: what rounding turned a row by */
    LIM_OPTIONAL(struct lim_long_eye, eye, LIM_HAS_LONG); /* of a long scene, whose rows put the eye at 0 */
};

/* One side of the screen. */
struct lim_side {
    int32_t px;
    int32_t middle_qs; /* half-pixels from the origin, and what makes the last shift round */
};

/* enum lim_view_code; of words both: lim_view_both(). */
#if LIM_8_BIT
typedef uint8_t lim_view_code_bits;
#else
typedef uint16_t lim_view_code_bits;
#endif

struct lim_view_cached {
    lim_index vertex; /* LIM_NO_INDEX: empty */
    lim_view_code_bits codes;
    struct lim_point at; /* meaningless when codes has LIM_VIEW_GUARD */
};

struct lim_view {
    struct lim_rows rows;
    struct lim_side width, height;
    struct lim_view_cached *cache;
    LIM_OPTIONAL(bool, antialiased, LIM_HAS_ANTIALIAS); /* polygons are drawn by their samples (samples.h) */
    uint32_t vertices;                                  /* transformed since lim_view_begin(), if LIM_HAS_STATS */
};

struct lim_cull_plane {
    int16_t n[3];          /* points inwards; two bits less than the view matrix, length <= 2^14 */
    uint16_t inside_depth; /* on stacks this deep or deeper all boxes are inside; LIM_NONE: none is known to be */
    int32_t offset;        /* plus the slack that makes it conservative */
};

struct lim_cull {
    struct lim_cull_plane sides[4]; /* left, right, top, bottom */
    uint16_t inside_depth;          /* of all four */
};

/* Has 16 bits, which is not worth a word's while, unless pairs of them are multiplied. */
#if LIM_8_BIT || LIM_DUAL_MULTIPLY
typedef int16_t lim_eye_reduced;
#else
typedef int32_t lim_eye_reduced;
#endif

struct lim_eye {
    int32_t at_q8[3]; /* units */
    /* What the filter needs, if LIM_HAS_FILTER. */
    lim_eye_reduced reduced[3]; /* floor(at / 2^shift), within 16 bits whatever the distance */
    lim_index near_end;         /* a lim_node.plane below this is decided by lim_eye_near_side() */
    uint8_t shift;              /* 0 inside the 16-bit cube of the scene */
    int32_t slack_rest;         /* what shifting takes from LIM_PLANE_SLACK */
    int32_t large_slack;        /* how far the filter of a LARGE plane can be off, in its own scale */
    const struct lim_scene *scene;
    const LIM_FLASH struct lim_plane *planes;             /* the scene's: a load less on the way to each */
    LIM_OPTIONAL(struct lim_long_eye, far, LIM_HAS_LONG); /* in a long scene, where at_q8 is 0 */
};

/* 64 bits that lie as words do: so what holds a part with some of them is not larger where that part is left out. */
#if defined(__GNUC__) && !LIM_8_BIT
typedef int64_t __attribute__((aligned(4))) lim_word_s64;
typedef uint64_t __attribute__((aligned(4))) lim_word_u64;
#else
typedef int64_t lim_word_s64;
typedef uint64_t lim_word_u64;
#endif

/* A plane of a scene, n . p = d. */
struct lim_plane_unpacked {
    int32_t n[3];
    lim_word_s64 d;
    lim_word_s64 slack;                         /* |n . p - d| up to this is on it: newell.h */
    bool narrow;                                /* n . p - d fits 32 bits for every vertex p: scene.h's bounds */
    uint8_t axis;                               /* of which n is 1, |d| < 2^15; or LIM_NO_AXIS */
    LIM_OPTIONAL(uint8_t, along, LIM_HAS_LONG); /* in a mover's frame: an axis of which n is LIM_FAR_AXIS; or that */
};

struct lim_portals {
    uint8_t *bits;   /* of boxes; NULL: the scene has no places */
    uint16_t *stack; /* of nodes: a scene with places has few enough */
};

/* Bytes for scenes with places; the stack of nodes is one deeper than the tree. */
#define LIM_PORTALS_MEM_B(box_count, depth) (LIM_PORTALS_BITS_B(box_count) + (LIM_CAST(size_t, depth) + 2) / 2 * 4)
#define LIM_PORTALS_BITS_B(box_count) ((LIM_CAST(size_t, box_count) + 31) / 32 * 4)

/* Bytes for the bits of a scene: none for one without places. */
static inline size_t lim_portals_mem_b(const struct lim_scene *scene)
{
#if LIM_HAS_PORTALS
    return scene->place_count ? LIM_PORTALS_MEM_B(scene->box_count, scene->limits.depth) : 0;
#else
    (void)scene;
    return 0;
#endif
}

/* What comes when a node's near subtree is done: its own polygons, then its far subtree. LIM_NO_INDEX: nothing. */
struct lim_walk_pending {
    lim_index run, far;
};

struct lim_walk {
    struct lim_eye eye; /* here, not pointed to: its fields are read at every node */
    struct lim_walk_pending *stack;
    uint16_t depth;
    lim_index next; /* the subtree to enter, or LIM_NO_INDEX: the stack's top is due */
    bool back_to_front;
    const uint8_t *shown; /* a bit a box: its subtree may be seen; NULL: nothing is known, as without LIM_HAS_PORTALS */
    LIM_OPTIONAL(struct lim_portals, portals, LIM_HAS_PORTALS);
};

/* What stages share ----------------------------------------------------------------------------------------------- */

struct lim_pass {
    const struct lim_scene *scene;
    struct lim_target target;
    struct lim_view view;
    LIM_OPTIONAL(struct lim_cull, cull, LIM_HAS_CULL);
    LIM_OPTIONAL(struct lim_walk, walk, LIM_HAS_TREE);
    LIM_OPTIONAL(struct lim_eye, eye, LIM_HAS_PLANES && !LIM_HAS_TREE);
    LIM_OPTIONAL(struct lim_texturing, texturing, LIM_HAS_TEXTURE);
    LIM_OPTIONAL(struct lim_sky, sky, LIM_HAS_SKY);
    LIM_OPTIONAL(struct lim_wireframe, wireframe, LIM_HAS_WIREFRAME);
    LIM_OPTIONAL(const struct lim_overlay *, overlay, LIM_HAS_OVERLAY); /* the caller's, or NULL */
    LIM_OPTIONAL(struct lim_stats, stats, LIM_HAS_STATS);
};

/* Polygons on the screen ------------------------------------------------------------------------------------------ */

/* Where the edge is on the current line: lim_edge_x(). As quotient and remainder where the processor works on bytes,
 * else as a fixed-point number with LIM_EDGE_BITS fraction bits, wide enough for three screens. */
#if LIM_8_BIT
struct lim_edge {
    int32_t error;       /* M - x * denominator (edge.c), in -denominator+1 .. 0 */
    int32_t step_error;  /* what a line adds to it, 0 .. denominator-1 */
    int32_t denominator; /* lines from end to end, in sub-pixels */
    int16_t x, step_x;
    int16_t end;
    uint8_t next;
    uint8_t step_vertex;
};
#else
#if LIM_SUB_BITS > 9
#define LIM_EDGE_BITS 32
typedef int64_t lim_edge_at;
typedef uint64_t lim_edge_wrap; /* what it is summed in: steps below the last line may wrap */
#else
#define LIM_EDGE_BITS (LIM_MAX_SIDE_PX <= 340 ? 22 : 20)
typedef int32_t lim_edge_at;
typedef uint32_t lim_edge_wrap;
#endif
struct lim_edge {
    lim_edge_at at, step; /* on the current line, and what a line adds */
    int16_t end;          /* the line on which it hands over to the next edge, or is begun anew: see edge.c */
    uint8_t next;         /* the vertex from which that goes on */
    uint8_t step_vertex;  /* from there to the one after it, modulo their number: the left boundary runs forward */
};
#endif

/* Both boundaries of a polygon, on their way down. */
struct lim_edge_pair {
    struct lim_edge left, right;
};

/* Lines top <= y < bottom; none: top >= bottom. */
struct lim_span_extent {
    int16_t top, bottom;
};

/* What a polygon looks like to EDGE; lines are relative to nothing: line y is screen line y. */
struct lim_edge_shape {
    int16_t top, bottom; /* lines top <= y < bottom; may lie outside of the screen */
    int16_t left, right; /* pixels left <= x < right, likewise; set by lim_edge_bounds_sides() */
    uint8_t first;       /* a vertex on the top line */
    uint8_t apex;        /* if non-monotone: from which a fan of triangles covers the polygon */
    bool non_monotone;   /* its boundary turns more than twice: rounding bent it */
    LIM_OPTIONAL(int16_t, end_row, LIM_HAS_ANTIALIAS); /* the row of samples (samples.h) after its last, antialiased */
};

/* A boundary, in samples of a row, a quarter of a pixel each, from LIM_STRIP_BIAS_PX before the screen on (samples.h).
 */
struct lim_sample_edge {
    uint32_t x_q16, step_q16; /* x: on the last row; sums may wrap */
    int16_t end;              /* the row on which it hands over to the next edge */
    uint8_t next, step_vertex;
};

struct lim_sample_edges {
    struct lim_sample_edge left, right;
};

enum { CLIP_PLANES = 5, CLIP_MAX_VERTICES = LIM_PIECE_VERTICES + CLIP_PLANES };
#define LIM_FLAG_WORDS(count) (((count) + 15) / 16)

struct lim_screen_polygon {
    struct lim_edge_shape shape;
    uint16_t colour; /* as it lies in memory */
    uint8_t n;
    LIM_OPTIONAL(uint8_t, alpha, LIM_HAS_TRANSPARENT);
    LIM_OPTIONAL(uint16_t, hidden, LIM_HAS_WIREFRAME *LIM_FLAG_WORDS(CLIP_MAX_VERTICES)); /* an edge a bit: not drawn */
    LIM_OPTIONAL(bool, antialiased, LIM_HAS_ANTIALIAS); /* `shape` is of its samples */
    /* Where its record names its texture, or, lim_mappings_name_textures(), the mapping that does; LIM_NONE. */
    LIM_OPTIONAL(uint16_t, texture, LIM_HAS_TEXTURE);
    struct lim_point at[CLIP_MAX_VERTICES];
};

/* Lines ----------------------------------------------------------------------------------------------------------- */

/* Pixels x0 <= x < x1. */
struct lim_gap {
    uint16_t x0, x1;
    uint16_t next; /* in the pool, or LIM_NONE */
};

/* Antialiased, the gap's pixels are all open where it has no next; else those of the list that begins there are. */
struct lim_line {
    struct lim_gap gap; /* x0 == x1: the line is closed */
    uint16_t retained;  /* PAINT's list of polygons that start on this line, or LIM_NONE */
};

/* Of the pool, bytes a gap: antialiased, a struct lim_open_strip (strips.h). */
#define LIM_GAP_MEM_B (LIM_HAS_ANTIALIAS ? LIM_CAST(size_t, 20) : sizeof(struct lim_gap))

/* By which sizes memory is counted, with LIM_HAS_STATS: this processor's, or another's. In bytes: an element each (a
 * gap, 0: its own); the cache and the stack, in which polygons that cross a line lie, too. */
struct lim_counted {
    uint32_t cell_b, gap_b, active_b, idle_b;
    uint16_t line_gaps; /* of a line that scan lines paint, antialiased */
    bool is_apart;      /* what is counted as one memory is three: the host's elements are larger */
};

struct lim_spans {
    LIM_OPTIONAL(struct lim_counted, counted, LIM_HAS_STATS);
    struct lim_line *lines; /* one for each screen line */
    struct lim_gap *pool;   /* shares its memory with cells, and is used from its end down */
    LIM_OPTIONAL(struct lim_open_strip *, strips, LIM_HAS_ANTIALIAS); /* likewise, antialiased */
    uint16_t pool_size;                                               /* what all of that memory holds */
    LIM_OPTIONAL(uint16_t, strips_size, LIM_HAS_ANTIALIAS);
    uint16_t free;   /* list of gaps that were given back */
    uint16_t fresh;  /* gaps below this one were never used */
    uint16_t lowest; /* gaps below this one are cells, or polygons that cross a line: share.h */
    LIM_OPTIONAL(uint16_t, kept, LIM_HAS_ANTIALIAS); /* gaps that cells may not take */
    struct lim_retained *retained;                   /* whose cells they are */
    uint16_t open_lines;
    bool trimmed;                                      /* `open`, since it was drawn together */
    LIM_OPTIONAL(bool, has_strips, LIM_HAS_ANTIALIAS); /* gaps are of samples */
    struct lim_rect open;                              /* holds every open pixel */
};

/* A retained polygon is two head cells and one cell a vertex; if it is transparent, one more with its alpha; in
 * wireframe, as many as the flags of its edges take, an edge a bit. A piece of one (piece.h) has n = 0, its alpha in
 * the place of `first`, and a cell a line, bottom to top: x its first pixel, y the one after its last. */
union lim_retained_cell {
    struct {
        uint16_t next; /* the polygon retained before this one that starts on the same line */
        uint8_t n, first;
    } link;
    struct {
        uint16_t bottom; /* the line after its last, with LIM_RETAINED_TRANSPARENT or LIM_RETAINED_TEXTURE */
        uint16_t colour; /* as it lies in memory; with LIM_RETAINED_TEXTURE lim_screen_polygon.texture */
    } look;
    struct lim_point at;
    struct {
        uint16_t owner, spare; /* a mover, or LIM_STILL_MET */
    } met;
    uint32_t word;
    uint16_t alpha;
    uint16_t hidden[sizeof(struct lim_point) / 2];
};

enum { LIM_RETAINED_HEAD_CELLS = 2 };
#define LIM_RETAINED_TRANSPARENT 0x8000u
#define LIM_RETAINED_TEXTURE 0x4000u
#define LIM_RETAINED_MET 0x2000u /* cells before it tell of movers: meet.h */

struct lim_retained {
    union lim_retained_cell *cells;
    uint16_t used;
    uint16_t size;    /* in this band: cells from here on are for others */
    uint16_t end;     /* likewise in this frame */
    uint16_t whole;   /* all cells of the memory that gaps share */
    uint16_t pending; /* cells that are written before they are used, and that gaps may not take */
    LIM_OPTIONAL(uint16_t, told, LIM_HAS_MOVERS); /* cells before the next polygon, which tell of movers (meet.h) */
    LIM_OPTIONAL(uint16_t, last, LIM_HAS_MOVERS); /* the last polygon of which they told */
    bool overhangs;                               /* a polygon may reach beyond the screen's left or right side */
    bool transparent, textured, masked;           /* one of the polygons is; what is masked is not transparent */
};

/* A polygon that movers may have to be compared with, or one of theirs. */
struct lim_met_polygon {
    uint16_t owner; /* the mover, LIM_STILL_MET, or LIM_NONE: neither, or none */
    lim_index record;
    lim_index node; /* of what stands still: of whose run it is */
};

/* near / z at the centre of a pixel, at the screen's first one and what a step adds; modulo 2^32. A long scene's are in
 * Q60. */
#if LIM_HAS_LONG
typedef lim_word_u64 lim_near_word;
typedef int64_t lim_near_difference;
#else
typedef uint32_t lim_near_word;
typedef int32_t lim_near_difference;
#endif
enum { LIM_NEAR_FAR_BITS = 30 };
struct lim_near_plane {
    lim_near_word at_q30, x_q30, y_q30;
};

/* Of a polygon of something that moves, or that it has met. */
struct lim_near {
    struct lim_near_plane plane; /* if it is known */
    lim_near_word row_q30;       /* likewise: on this line, at the screen's first pixel */
    struct lim_active *next;     /* of movers', or of what stands still: from near to far, or NULL */
    struct lim_crowd_cut *cuts;  /* of this line */
    struct lim_active *group;    /* of the first of an object's: behind its last, or NULL */
    int16_t x0, x1;              /* of this line: what it has of the screen */
    int16_t group_x0, group_x1;  /* likewise: what a group has lies between */
    int16_t y;                   /* the line of which these are */
    uint16_t owner;              /* the mover, LIM_STILL_MET, or LIM_NONE: it is not compared */
    uint16_t still[2];           /* polygons that stand still and that it was asked of lately, */
    uint8_t met[2];              /* and what each is to it: enum lim_met */
    bool known;
};
#define LIM_STILL_MET (LIM_NONE - 1u)
enum { LIM_CROWD_CUT_B = 12 }; /* of a struct lim_crowd_cut, where pointers have 32 bits */

struct lim_active {
    struct lim_active *next; /* in a list, or NULL */
    union {
        struct lim_edge_pair pair;
        LIM_OPTIONAL(struct lim_sample_edges, samples, LIM_HAS_ANTIALIAS);
    };
    uint16_t polygon;                                 /* its first cell: farther ones have greater ones */
    uint16_t turn;                                    /* the line on which its edges change, or its bottom */
    uint16_t bottom;                                  /* antialiased, the row after its last */
    uint16_t colour;                                  /* as it lies in memory */
    LIM_OPTIONAL(uint32_t, share, LIM_HAS_ANTIALIAS); /* the colour of a sample: lim_smooth_share() */
    LIM_OPTIONAL(struct lim_gradients, gradients, LIM_HAS_TEXTURE); /* if it has a texture */
    LIM_OPTIONAL(struct lim_near, near, LIM_HAS_MOVERS);
};

struct lim_actives {
    uint8_t *pool;     /* memory for these alone; the cache of vertices and the lines follow it */
    uint8_t *at, *end; /* what was never used, here or between cells and gaps */
    LIM_OPTIONAL(uint32_t, between_b, LIM_HAS_STATS);          /* there in all, as it is counted */
    uint16_t fresh;                                            /* taken from there, if LIM_HAS_ANTIALIAS */
    uint16_t used;                                             /* at this time, if LIM_HAS_STATS or LIM_HAS_MOVERS */
    bool in_pool;                                              /* `at` is in the pool, or behind it */
    LIM_OPTIONAL(struct lim_active *, moving, LIM_HAS_MOVERS); /* those that are compared (crowd.h), nearest first: */
    LIM_OPTIONAL(struct lim_active *, met, LIM_HAS_MOVERS);    /* movers', and what stands still */
    LIM_OPTIONAL(uint16_t, cut_count, LIM_HAS_MOVERS);         /* the cuts that they have on this line */
    LIM_OPTIONAL(bool, crowded, LIM_HAS_MOVERS);               /* cuts have taken idle memory */
    LIM_OPTIONAL(bool, grouped, LIM_HAS_MOVERS);               /* lim_near.group is set */
    LIM_OPTIONAL(uint8_t *, cuts_end, LIM_HAS_MOVERS);         /* what is idle behind them */
    LIM_OPTIONAL(struct lim_movers *, movers, LIM_HAS_MOVERS);
    struct lim_active *first, *free; /* lists through `next`: what crosses the line, and what was given back */
};

struct lim_layers {
    struct lim_layer *pool, *own; /* of this line: `own`, or idle memory */
    uint16_t size, own_size, used;
    bool exhausted, in_idle;                                 /* some did not fit; what was idle is overwritten */
    LIM_OPTIONAL(struct lim_masked, masked, LIM_HAS_MASKED); /* of the pieces that are pushed next */
    LIM_OPTIONAL(const struct lim_texturing *, texturing, LIM_HAS_MASKED);
    LIM_OPTIONAL(int16_t, y, LIM_HAS_MASKED); /* the line */
};

struct lim_smooth {
    uint32_t *sums;    /* of a pixel's closed samples: their number from bit 28 on, red 19, green 9, blue 0; 0 between
                        * lines. NULL: off */
    uint16_t *covered; /* the closed samples of a line that is drawn alone */
    uint16_t *line;    /* the memory of that line, or NULL */
    uint16_t open_px;  /* how many of its pixels are open */
};

struct lim_paint {
    struct lim_pass *pass;
    LIM_OPTIONAL(struct lim_delta *, delta, LIM_HAS_DELTA); /* or NULL */
    LIM_OPTIONAL(uint16_t *, lent, LIM_HAS_LENT);           /* the line that could not be finished, or NULL */
    struct lim_actives actives;
    uint16_t background; /* as it lies in memory */
    LIM_OPTIONAL(struct lim_layers, layers, LIM_HAS_TRANSPARENT);
    LIM_OPTIONAL(struct lim_smooth, smooth, LIM_HAS_ANTIALIAS);
};

LIM_OPTIONAL_END

#endif
