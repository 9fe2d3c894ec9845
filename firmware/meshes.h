/* SPDX-License-Identifier: MIT
 *
 * What is kept of a mesh, a scene without a tree. As stages.h, so that callers can place a renderer. */
#ifndef LIM_MESHES_H
#define LIM_MESHES_H

#include "config.h"
#include "scene.h"
#include "stages.h"

LIM_OPTIONAL_BEGIN

/* Where a triangle comes among those that cross a line: what is painted first is lower. Its distance in the upper bits,
 * and its number, so that no two are equal and every pool makes the same picture. */
#if LIM_HAS_WIDE
typedef uint64_t lim_mesh_rank;
#else
typedef uint32_t lim_mesh_rank;
#endif

struct lim_mesh;

#define LIM_MESH_NEAREST ((lim_mesh_rank)-1) /* of the end of all lists, and nothing else */

/* A triangle's nearness, 1 / z, as a plane over the screen; modulo 2^32, which matters nowhere within it. */
struct lim_mesh_depth {
    uint32_t at_q16;       /* of the current line's first pixel; if LIM_HAS_TEXTURE, of the screen's */
    uint32_t x_q16, y_q16; /* what a pixel to the right, and a line down, adds */
    __extension__ union {
        __extension__ struct { /* unless LIM_HAS_TEXTURE */
            uint16_t turn;     /* the line on which an edge ends: that of the entry is the next line, always */
            uint8_t goes_on;   /* what the entry's was */
        };
        struct lim_mesh *mesh; /* if so */
    };
};

/* Where a boundary is on the current line, and what a line adds: what is stepped of a struct lim_edge. And both
 * boundaries, left and right: what lies together is loaded together. */
#if LIM_8_BIT
struct lim_mesh_edge {
    struct lim_edge whole;
};
struct lim_mesh_edges {
    struct lim_edge whole[2];
};
#else
struct lim_mesh_edge {
    lim_edge_at at, step;
};
struct lim_mesh_edges {
    lim_edge_at at[2], step[2];
};
#endif

/* Of a triangle over which texels do not advance evenly. */
union lim_mesh_gradients {
    struct lim_gradients gradients;
    union lim_mesh_gradients *next; /* of those that are free */
};

/* What a triangle shows, where the scene has textures: texels that advance evenly; or what level.w_bits says instead of
 * a level. What a line asks for lies together. */
struct lim_mesh_look {
    /* Paints pixels of a line, as lim_texels_painter does; who shows no level makes no use of `place`. */
    void (*show)(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);
    __extension__ union {                        /* C++ wants names for both */
        struct lim_texture_even even;            /* of pixel (0, -1): a line knows the number of the one below */
        __extension__ struct {                   /* or of what is no level */
            union lim_mesh_gradients *gradients; /* NULL: there was no room, they are made for each line */
            struct lim_mesh *mesh;
        };
    };
    struct lim_texture_level level;
};

enum lim_mesh_shown {
    LIM_MESH_LEVELS = 11, /* below: the width of a level */
    LIM_MESH_COLOUR = LIM_MESH_LEVELS,
    LIM_MESH_PERSPECTIVE,
    LIM_MESH_UNSET_CLIPPED, /* it has shown no pixel so far */
    LIM_MESH_UNSET          /* the same of one that is not clipped */
};

struct lim_mesh_line;

/* A picture as a triangle takes it: that of the last one, as the next one's mostly is the same, if not its palette. */
struct lim_mesh_picture {
    uint32_t sizes;                 /* of its texture, in one word; 0: none */
    uint16_t texels;                /* of struct lim_texture */
    uint8_t own_down, area_down;    /* by which a triangle's sizes in the texture and on the screen are compared */
    uint8_t up;                     /* from places to 16 bits */
    int8_t step_down;               /* of steps, without the zeros of a triangle's size */
    struct lim_texture_level level; /* the first one, without a palette */
};

/* What all triangles have in common; and room for gradients, at the end of the pool. */
struct lim_mesh_looks {
    union lim_mesh_gradients *free;
    const struct lim_mesh_line *line; /* which is painted */
    int16_t left, right;              /* of what is painted, where it may reach beyond the line */
    uint16_t whole_size;              /* of the pool; what lim_mesh.pool_size is less has become theirs */
    lim_index mask;                   /* lim_triangle_texture_mask() */
    uint32_t even;                    /* nearness at a quarter of a unit, times 3/2: as lim_mesh_rank_of() has it */
    struct lim_mesh_picture taken;
};

/* A triangle that crosses the current line. */
struct lim_mesh_active {
    struct lim_mesh_active *next;
    struct lim_mesh_edges edges;
    struct lim_mesh_edge lower; /* if `goes_on`: what follows the upper one of two edges, on the line where it does */
    lim_mesh_rank rank;
    uint16_t turn;   /* the line on which an edge ends */
    uint16_t bottom; /* the line below its last */
    uint16_t colour; /* as it lies in memory */
    uint8_t goes_on; /* enum lim_mesh_turn */
    uint8_t part;    /* of the fan of triangles that stands for what clipping made non-monotone; 0: there is none */
    LIM_OPTIONAL(struct lim_mesh_depth, depth, LIM_HAS_MESH_DEPTH);
    LIM_OPTIONAL(struct lim_mesh_look, look, LIM_HAS_TEXTURE);
    LIM_OPTIONAL(bool, seen, LIM_HAS_STATS); /* it has painted a pixel */
};

/* How it goes on where an edge ends. */
enum lim_mesh_turn {
    LIM_MESH_LEFT,  /* `lower` takes the left edge's place */
    LIM_MESH_RIGHT, /* or the right one's */
    LIM_MESH_ANEW,  /* edges are found anew: it was clipped, or is long */
    LIM_MESH_DEEP /* it has depth, and nothing has textures: its edges have changed places, so that it has no pixels but
                     by its depth */
};

/* A line that is painted: pixels x0 <= x < x1, of memory that begins at x = 0. */
struct lim_mesh_line {
    uint16_t *pixels;
    uint16_t x0, x1, y;
};

/* A line of depths. */
struct lim_mesh_depths {
    uint32_t *line_q16; /* the nearness that is painted, of what has depth */
    uint16_t y;         /* whose line it is; LIM_NONE: of none */
    lim_index from;     /* triangles from this one on have depth */
};

/* Triangles that cross the line, and have no room in the pool: from far to near, linked by their numbers. */
struct lim_mesh_crowd {
    lim_index first, last; /* LIM_NO_INDEX: there are none */
    lim_mesh_rank rank;    /* of the last one */
};

struct lim_mesh {
    struct lim_pass *pass;
    struct lim_point *points; /* of all vertices, on the screen */
    uint16_t *nearness; /* of all vertices: 1 / z, at least 1; 0: before the near plane or beyond the guard band */
    lim_index *links;   /* from a triangle to the next one that begins on the same line, or of the crowd */
    lim_index *tops;    /* for each line the first that begins there, or LIM_NO_INDEX */
    struct lim_mesh_active *pool, *free;
    struct lim_mesh_active *first;  /* of those that cross the line, in their order */
    struct lim_mesh_active *begins; /* of those that begin on it, likewise */
    struct lim_mesh_active end;     /* of all lists */
    struct lim_mesh_crowd crowd;
    uint16_t pool_size, unused; /* unused: entries from here on */
    uint8_t near_shift;         /* of lim_view_all(), or lim_view_refine() */
    uint8_t extent;             /* enum lim_view_extent */
    uint16_t nearest;           /* where that is LIM_VIEW_CLIPPED: nearness of all that is linked, OR'ed */
    uint32_t parts;             /* lim_bands() */
    LIM_OPTIONAL(struct lim_mesh_depths, depths, LIM_HAS_MESH_DEPTH);
    LIM_OPTIONAL(struct lim_mesh_looks, looks, LIM_HAS_TEXTURE);
};

/* Memory ---------------------------------------------------------------------------------------------------------- */

/* By distance; `active_count` as lim_limits.active. */
#define LIM_MESH_MEM_B(h_px, vertex_count, triangle_count, active_count)                                               \
    LIM_MEM_ALIGNED_B((active_count) * sizeof(struct lim_mesh_active) +                                                \
                      (vertex_count) * (sizeof(struct lim_point) + sizeof(uint16_t)) +                                 \
                      (LIM_CAST(size_t, triangle_count) + (h_px)) * sizeof(lim_index))
/* Beside LIM_MESH_MEM_B(), with a line of depths. */
#define LIM_MESH_DEPTH_MEM_B(w_px) LIM_MEM_ALIGNED_B((w_px) * sizeof(uint32_t))

LIM_OPTIONAL_END

#endif
