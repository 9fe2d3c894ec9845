/* SPDX-License-Identifier: MIT
 *
 * Parts that were configured differently do not link. Their structs differ, so together they would overwrite each
 * other's memory. Functions that take such structs, and scenes, have a symbol that holds version and configuration:
 *
 *     undefined reference to `lim_init.needs_same_LIM_CONFIG.v0_1_0.fast_7.240px.4vertices.64cached.convex.cull'
 *
 * says with which configuration its caller was compiled; the renderer was compiled with another one, which
 * `nm limner.o | grep needs_same` shows. In C, C++ and debuggers the name stays lim_init. It costs nothing. */
#ifndef LIM_AGREE_H
#define LIM_AGREE_H

#include "config.h"

/* Settings that go together. */
LIM_STATIC_ASSERT(LIM_HAS_PLANES || LIM_HAS_MESHES,
                  "one order of drawing at least: LIM_HAS_NEAREST, _PAINTER, _CONVEX, "
                  "_SCANLINE, _DEPTH, _NEWELL, _MESH or _MESH_DEPTH must be 1");
LIM_STATIC_ASSERT(!LIM_HAS_MOVERS || LIM_HAS_WALKED, "LIM_HAS_MOVERS needs LIM_HAS_NEAREST or _SCANLINE");
LIM_STATIC_ASSERT(!(LIM_HAS_LIGHT || LIM_HAS_DEFORM) || LIM_HAS_MOVERS,
                  "LIM_HAS_LIGHT and LIM_HAS_DEFORM need LIM_HAS_MOVERS");
LIM_STATIC_ASSERT(!LIM_HAS_WIDE || SIZE_MAX > 0xFFFF,
                  "LIM_HAS_WIDE: a processor whose sizes have 16 bits has no room for such a scene");
LIM_STATIC_ASSERT(!LIM_HAS_LONG || (LIM_HAS_TREE && !LIM_8_BIT),
                  "LIM_HAS_LONG needs an order that walks the tree, and a processor of 32 bits");
LIM_STATIC_ASSERT(!LIM_HAS_LARGE || LIM_HAS_SLANTED, "LIM_HAS_LARGE needs LIM_HAS_SLANTED");
LIM_STATIC_ASSERT(!LIM_HAS_MASKED || (LIM_HAS_TEXTURE && LIM_HAS_TRANSPARENT),
                  "LIM_HAS_MASKED needs LIM_HAS_TEXTURE and LIM_HAS_TRANSPARENT");
LIM_STATIC_ASSERT(!LIM_HAS_SKY || LIM_HAS_TEXTURE, "LIM_HAS_SKY needs LIM_HAS_TEXTURE");
LIM_STATIC_ASSERT(!LIM_HAS_ANTIALIAS || LIM_HAS_SPANS, "LIM_HAS_ANTIALIAS needs an order that paints nearest first");
LIM_STATIC_ASSERT(!LIM_HAS_FILL || LIM_HAS_NEAREST || LIM_HAS_CONVEX,
                  "LIM_HAS_FILL needs LIM_HAS_NEAREST or LIM_HAS_CONVEX");
LIM_STATIC_ASSERT(!LIM_HAS_FRAMEBUFFER || LIM_HAS_NEAREST || LIM_HAS_PAINTER,
                  "LIM_HAS_FRAMEBUFFER needs LIM_HAS_NEAREST or LIM_HAS_PAINTER");
LIM_STATIC_ASSERT(!LIM_HAS_PORTALS || (LIM_HAS_TREE && LIM_HAS_CULL),
                  "LIM_HAS_PORTALS needs LIM_HAS_CULL and an order that walks the tree");
LIM_STATIC_ASSERT(!LIM_HAS_MESH_LEAVES || (LIM_HAS_LEAVES && LIM_HAS_TREE),
                  "LIM_HAS_MESH_LEAVES needs LIM_HAS_LEAVES and an order that walks the tree");
LIM_STATIC_ASSERT(LIM_HAS_LINES ||
                      (LIM_HAS_FILL && !LIM_HAS_HIDDEN && !LIM_HAS_MESHES && !LIM_HAS_TEXTURE && !LIM_HAS_DELTA),
                  "LIM_HAS_LINES may be 0 where LIM_HAS_FILL is 1, and nothing is linked that asks for lines");
LIM_STATIC_ASSERT(LIM_VIEW_CACHE_ENTRIES >= 8 && LIM_VIEW_CACHE_ENTRIES <= 256 &&
                      !(LIM_VIEW_CACHE_ENTRIES & (LIM_VIEW_CACHE_ENTRIES - 1)),
                  "LIM_VIEW_CACHE_ENTRIES must be a power of two, 8..256");
LIM_STATIC_ASSERT(LIM_MAX_SIDE_PX >= 8 && LIM_MAX_SIDE_PX <= 1024, "LIM_MAX_SIDE_PX must be 8..1024");
LIM_STATIC_ASSERT(LIM_MAX_VERTICES >= 3 && LIM_MAX_VERTICES <= 250, "LIM_MAX_VERTICES must be 3..250");

/* What a version promises: DESIGN.md. */
#define LIM_VERSION_MAJOR 0
#define LIM_VERSION_MINOR 1
#define LIM_VERSION_PATCH 0

/* For #if: 0.1.0 is 0x000100. */
#define LIM_VERSION (LIM_VERSION_MAJOR * 0x10000 + LIM_VERSION_MINOR * 0x100 + LIM_VERSION_PATCH)

#if LIM_PROFILE == LIM_PROFILE_DRAFT
#define LIM_AGREED_PROFILE ".draft_"
#elif LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_AGREED_PROFILE ".fast_"
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_AGREED_PROFILE ".fine_"
#else
#define LIM_AGREED_PROFILE ".exact_"
#endif

/* `word` where a flag, which is 0 or 1, is 1. */
#define LIM_AGREED(flag, word) LIM_AGREED_OF(flag, word)
#define LIM_AGREED_OF(flag, word) LIM_AGREED_##flag(word)
#define LIM_AGREED_0(word)
#define LIM_AGREED_1(word) word

#define LIM_AGREED_TEXT(number) LIM_AGREED_QUOTE(number)
#define LIM_AGREED_QUOTE(number) #number
#define LIM_AGREED_VERSION                                                                                             \
    ".v" LIM_AGREED_TEXT(LIM_VERSION_MAJOR) "_" LIM_AGREED_TEXT(LIM_VERSION_MINOR) "_" LIM_AGREED_TEXT(                \
        LIM_VERSION_PATCH)
#define LIM_AGREED_NUMBERS                                                                                             \
    LIM_AGREED_PROFILE LIM_AGREED_TEXT(LIM_SUB_BITS) "." LIM_AGREED_TEXT(LIM_MAX_SIDE_PX) "px." LIM_AGREED_TEXT(       \
        LIM_MAX_VERTICES) "vertices." LIM_AGREED_TEXT(LIM_VIEW_CACHE_ENTRIES) "cached"
#define LIM_AGREED_FLAGS                                                                                               \
    LIM_AGREED(LIM_HAS_NEAREST, ".nearest")                                                                            \
    LIM_AGREED(LIM_HAS_PAINTER, ".painter")                                                                            \
    LIM_AGREED(LIM_HAS_CONVEX, ".convex")                                                                              \
    LIM_AGREED(LIM_HAS_SCANLINE, ".scanline")                                                                          \
    LIM_AGREED(LIM_HAS_DEPTH, ".depth")                                                                                \
    LIM_AGREED(LIM_HAS_NEWELL, ".newell")                                                                              \
    LIM_AGREED(LIM_HAS_MESH, ".mesh")                                                                                  \
    LIM_AGREED(LIM_HAS_MESH_DEPTH, ".mesh_depth")                                                                      \
    LIM_AGREED(LIM_HAS_MOVERS, ".movers")                                                                              \
    LIM_AGREED(LIM_HAS_DEFORM, ".deform")                                                                              \
    LIM_AGREED(LIM_HAS_LIGHT, ".light")                                                                                \
    LIM_AGREED(LIM_HAS_CULL, ".cull")                                                                                  \
    LIM_AGREED(LIM_HAS_SLANTED, ".slanted")                                                                            \
    LIM_AGREED(LIM_HAS_LARGE, ".large")                                                                                \
    LIM_AGREED(LIM_HAS_WIDE, ".wide")                                                                                  \
    LIM_AGREED(LIM_HAS_LONG, ".long")                                                                                  \
    LIM_AGREED(LIM_HAS_LEAVES, ".leaves")                                                                              \
    LIM_AGREED(LIM_HAS_MESH_LEAVES, ".mesh_leaves")                                                                    \
    LIM_AGREED(LIM_HAS_TRANSPARENT, ".transparent")                                                                    \
    LIM_AGREED(LIM_HAS_TEXTURE, ".texture")                                                                            \
    LIM_AGREED(LIM_HAS_MASKED, ".masked")                                                                              \
    LIM_AGREED(LIM_HAS_SKY, ".sky")                                                                                    \
    LIM_AGREED(LIM_HAS_TELE, ".tele")                                                                                  \
    LIM_AGREED(LIM_HAS_WIREFRAME, ".wireframe")                                                                        \
    LIM_AGREED(LIM_HAS_ANTIALIAS, ".antialias")                                                                        \
    LIM_AGREED(LIM_HAS_DELTA, ".delta")                                                                                \
    LIM_AGREED(LIM_HAS_OVERLAY, ".overlay")                                                                            \
    LIM_AGREED(LIM_HAS_ROUND, ".round")                                                                                \
    LIM_AGREED(LIM_HAS_FILL, ".fill")                                                                                  \
    LIM_AGREED(LIM_HAS_FRAMEBUFFER, ".framebuffer")                                                                    \
    LIM_AGREED(LIM_HAS_LINES, ".lines")                                                                                \
    LIM_AGREED(LIM_HAS_STATS, ".stats")                                                                                \
    LIM_AGREED(LIM_HAS_PORTALS, ".portals")

/* After the declaration of a function or of a scene, before the semicolon. */
#if defined(__GNUC__)
#define LIM_AGREES(name)                                                                                               \
    __asm__(LIM_AGREED_TEXT(__USER_LABEL_PREFIX__) #name                                                               \
            ".needs_same_LIM_CONFIG" LIM_AGREED_VERSION LIM_AGREED_NUMBERS LIM_AGREED_FLAGS)
#else
#define LIM_AGREES(name)
#endif

#endif
