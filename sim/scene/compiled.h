/* SPDX-License-Identifier: MIT
 *
 * A compiled scene on the host: what flash would hold, and what only the host wants to know. Made
 * by compile_mesh() or read from a .lim file; written as .lim or as C source. firmware/SCENE.md. */
#ifndef SIM_COMPILED_H
#define SIM_COMPILED_H

#include "base/error.h"
#include "long.h"
#include "model/mesh.h"
#include "scene.h"
#include "scene/method.h"
#include "scene/plane.h"

/* What portals would spare, or do. */
struct portal_report {
    bool tried, kept;
    char refused[96];                       /* why not tried; empty: not asked for */
    size_t zones, pvs, bytes;               /* rooms, different visible sets, flash that they take */
    size_t given_up;                        /* rooms from which everything counts as seen */
    double mean_polygons;                   /* that a visible set shows, from anywhere in closed cells */
    size_t cameras, different;              /* sampled pictures; those that differ with portals: none may */
    size_t polygons_before, polygons_after; /* reached in all of them */
    size_t vertices_before, vertices_after;
    double cost_before, cost_after; /* frame_cost_work() of all of them, the look-up included; NaN: not known */
};

/* What other trees than the smallest BSP tree were weighed against. */
struct tree_choice {
    /* UNKNOWN: nothing is predicted; LONG: there are too many polygons to try unasked; NEEDLESS: the BSP tree splits
     * too little to look on */
    enum { CHOICE_NONE, CHOICE_UNKNOWN, CHOICE_LONG, CHOICE_NEEDLESS, CHOICE_MADE } kind;
    bool replaced; /* by a tree that is cheaper to draw */
    double bsp_instructions;
    size_t bsp_flash_b;
};

/* Dense parts that are mesh leaves, and what was weighed for that (mesh_leaf_choice.h). */
enum { LEAF_PARTS_TOLD = 8 };
struct leaf_report {
    size_t count, polygons; /* of them, as the model has them */
    struct leaf_part {
        uint32_t face; /* the first one's number in the model file */
        size_t polygons;
    } parts[LEAF_PARTS_TOLD]; /* the first ones of them */
    bool tried;               /* a choice was made: what follows is set */
    size_t attempts;
    size_t dear_near; /* parts left to the tree because they cost more where the eye is near them */
    double instructions, without_instructions; /* predicted; NaN: no attempt was as cheap */
    double wrong_percent, bound_percent;       /* of the last attempt that was looked at; NaN: none was */
};

/* The cameras that it was made for; those of a file that whoever compiles it keeps as long. */
struct viewpoint;
struct path_report {
    char *name; /* the file's */
    const struct viewpoint *frames;
    size_t count; /* 0: sampled ones */
};

/* What drawing by scan lines was weighed against (order_choice.h). */
struct order_choice {
    bool tried;
    double nearest_instructions, scanline_most; /* beyond which scan lines are not taken */
    size_t nearest_mem_b;                       /* working memory on a 32-bit MCU */
};

/* What drawing as a mesh was weighed against, or it against that (mesh_choice.h). */
struct mesh_choice {
    bool tried;
    double tree_instructions, tree_wrong_percent;
    size_t tree_mem_b, tree_flash_b;
    double bound_percent;         /* of wrong pixels, of whichever cameras */
    double vertices_instructions; /* of a mesh's vertices alone: with more than the tree's, none was tried */
    struct mesh_trial {
        double instructions;  /* predicted */
        double wrong_percent; /* the worse of all and of portraits; NaN: as it is not cheaper, nobody looked */
        bool taken;
    } by_distance, by_depth;
    size_t cameras;
};

/* The share of pixels that show another face than the source does. */
struct predicted {
    double percent;                                 /* of all cameras */
    double near_percent;                            /* of those near faces of all sizes */
    double portrait_percent;                        /* of those that have all in view, where there are any */
    size_t cameras, near_cameras, portrait_cameras; /* how many of each */
    double grazing_percent;                         /* of cameras that look along faces, which no other figure has */
    size_t grazing_cameras;
    uint32_t worst_face;       /* of the file, the one in most wrong pixels; 0: not known */
    double worst_face_percent; /* of the wrong pixels that show it, or should */
};

/* The view that costs most of those that were searched, with pools that do not run out: not proved to be the worst. */
struct worst_report {
    size_t tries, tried;                 /* how many cameras at most, and how many it were; 0: not asked for */
    double work, work_mean, work_random; /* of it, of random cameras, of the worst of these: instructions where
                                            report.instructions are known */
    double eye_m[3], target_m[3], time_s;
    int32_t eye_q8[3], origin[3]; /* the same as the renderer has it */
    uint32_t yaw, pitch;
    unsigned cells, gaps, active; /* most that any view takes of these pools; not all of them this one */
};

struct compile_report {
    bool is_interior; /* model.is_interior */
    struct mesh_counts mesh;
    size_t polygons_in, polygons_out; /* before and after splitting */
    size_t splits;
    size_t left_out;  /* faces that options.drop_small left out */
    bool is_refused;  /* there is no scene, as it would not keep its promise (faithful.h) */
    size_t collapsed; /* pieces that the grid rounded to nothing */
    size_t covered;   /* polygons in one plane with a later one, which lies over a part of them */
    size_t unordered; /* polygons so near to others' planes that a method without a tree does not order them */
    size_t depth;
    size_t kinds[PLANE_KINDS]; /* nodes by enum plane_kind */
    size_t leaves;             /* nodes without a plane, whose polygons have an order */
    size_t mesh_leaves;        /* nodes without a plane, whose polygons are ordered by distance */
    size_t deep, near_deep;    /* of a mesh: triangles that have depth; that have it near the eye */
    enum tree_kind tree;       /* the kind that won */
    struct tree_choice choice;
    double worst_violation_units; /* certified: how far any vertex lies on the wrong side */
    char splitter[16];            /* the heuristic that won */
    bool antialias;               /* firmware can draw it with antialiased edges */
    bool mono;                    /* lit for black and white pixels */
    bool wireframe;               /* firmware can draw it as wireframe */
    uint16_t delta_runs;          /* firmware can send what changes alone, which takes so many runs; 0: it cannot */
    bool overlay;                 /* firmware can draw over its frames */
    bool tele;                    /* it draws as exactly through long lenses */
    bool round;                   /* firmware leaves out what round glass does not show */
    bool fill;                    /* firmware fills a picture that its target keeps */
    bool framebuffer;             /* firmware paints into a framebuffer */
    bool convex;                  /* one convex solid */
    bool moves;                   /* objects move in it */
    enum lim_method draws;        /* what firmware draws it with */
    unsigned w_px, h_px;          /* of the panel that the pools were measured for */
    struct path_report path;      /* method, tree and instructions are for these */
    size_t few_cameras;           /* that was done on so many cameras alone, as sorting takes long; 0: on all */
    const struct core *core;      /* the precision profile asked for */
    double near_m;                /* options.near_m */
    struct predicted wrong;       /* on sampled cameras; only if options.predict, else .percent is NaN */
    double reached_a_seen; /* facing polygons that frames reach, for each of which something is seen; 0: not known */
    double instructions; /* of a frame on a Cortex-M0+, predicted (frame_cost.h); NaN: neither nearest first nor by scan
                            lines, or not opaque and flat */
    struct order_choice order;
    struct mesh_choice as_mesh;
    struct leaf_report leaf_parts;
    struct worst_report worst;
    struct note *notes; /* on textures, for people; owned */
    size_t note_count;
    struct portal_report portals;
    size_t flash_b; /* bytes of all arrays and the struct lim_scene on a 32-bit MCU */
};

struct core;
struct moving;
struct original;

struct compiled {
    struct lim_scene scene;      /* its pointers lead into `image` */
    struct lim_long *of_32_bits; /* those of a long scene, owned; else NULL */
    struct moving *moving;       /* what moves in it, owned; NULL: nothing, or it is kept elsewhere */
    struct grid grid;
    uint32_t *faces;           /* polygon_count entries: face number (1-based) of each record, in order */
    struct original *original; /* the model's faces, shared; NULL: not known, as of a .lim file */
    uint32_t *groups;          /* mesh.merged_into, owned; NULL: not known, as of a .lim file */
    void *image;               /* the .lim file's bytes, owned */
    size_t image_b;
    struct compile_report report; /* all zero but .draws when read from a file */
};

void compiled_free(struct compiled *scene);

#endif
