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

#include "profile.h"
#include "version.h"

#if LIM_PROFILE == LIM_PROFILE_DRAFT
#define LIM_AGREED_PROFILE ".draft_"
#elif LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_AGREED_PROFILE ".fast_"
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_AGREED_PROFILE ".fine_"
#else
#define LIM_AGREED_PROFILE ".exact_"
#endif
#if LIM_HAS_NEAREST
#define LIM_AGREED_NEAREST ".nearest"
#else
#define LIM_AGREED_NEAREST
#endif
#if LIM_HAS_PAINTER
#define LIM_AGREED_PAINTER ".painter"
#else
#define LIM_AGREED_PAINTER
#endif
#if LIM_HAS_CONVEX
#define LIM_AGREED_CONVEX ".convex"
#else
#define LIM_AGREED_CONVEX
#endif
#if LIM_HAS_SCANLINE
#define LIM_AGREED_SCANLINE ".scanline"
#else
#define LIM_AGREED_SCANLINE
#endif
#if LIM_HAS_DEPTH
#define LIM_AGREED_DEPTH ".depth"
#else
#define LIM_AGREED_DEPTH
#endif
#if LIM_HAS_NEWELL
#define LIM_AGREED_NEWELL ".newell"
#else
#define LIM_AGREED_NEWELL
#endif
#if LIM_HAS_MOVERS
#define LIM_AGREED_MOVERS ".movers"
#else
#define LIM_AGREED_MOVERS
#endif
#if LIM_HAS_DEFORM
#define LIM_AGREED_DEFORM ".deform"
#else
#define LIM_AGREED_DEFORM
#endif
#if LIM_HAS_LIGHT
#define LIM_AGREED_LIGHT ".light"
#else
#define LIM_AGREED_LIGHT
#endif
#if LIM_HAS_CULL
#define LIM_AGREED_CULL ".cull"
#else
#define LIM_AGREED_CULL
#endif
#if LIM_HAS_SLANTED
#define LIM_AGREED_SLANTED ".slanted"
#else
#define LIM_AGREED_SLANTED
#endif
#if LIM_HAS_LARGE
#define LIM_AGREED_LARGE ".large"
#else
#define LIM_AGREED_LARGE
#endif
#if LIM_HAS_WIDE
#define LIM_AGREED_WIDE ".wide"
#else
#define LIM_AGREED_WIDE
#endif
#if LIM_HAS_LEAVES
#define LIM_AGREED_LEAVES ".leaves"
#else
#define LIM_AGREED_LEAVES
#endif
#if LIM_HAS_TRANSPARENT
#define LIM_AGREED_TRANSPARENT ".transparent"
#else
#define LIM_AGREED_TRANSPARENT
#endif
#if LIM_HAS_TEXTURE
#define LIM_AGREED_TEXTURE ".texture"
#else
#define LIM_AGREED_TEXTURE
#endif
#if LIM_HAS_WIREFRAME
#define LIM_AGREED_WIREFRAME ".wireframe"
#else
#define LIM_AGREED_WIREFRAME
#endif
#if LIM_HAS_ANTIALIAS
#define LIM_AGREED_ANTIALIAS ".antialias"
#else
#define LIM_AGREED_ANTIALIAS
#endif
#if LIM_HAS_DELTA
#define LIM_AGREED_DELTA ".delta"
#else
#define LIM_AGREED_DELTA
#endif
#if LIM_HAS_STREAM
#define LIM_AGREED_STREAM ".stream"
#else
#define LIM_AGREED_STREAM
#endif
#if LIM_HAS_ROUND
#define LIM_AGREED_ROUND ".round"
#else
#define LIM_AGREED_ROUND
#endif
#if LIM_HAS_FILL
#define LIM_AGREED_FILL ".fill"
#else
#define LIM_AGREED_FILL
#endif
#if LIM_HAS_FRAMEBUFFER
#define LIM_AGREED_FRAMEBUFFER ".framebuffer"
#else
#define LIM_AGREED_FRAMEBUFFER
#endif
#if LIM_HAS_LINES
#define LIM_AGREED_LINES ".lines"
#else
#define LIM_AGREED_LINES
#endif
#if LIM_HAS_STATS
#define LIM_AGREED_STATS ".stats"
#else
#define LIM_AGREED_STATS
#endif
#if LIM_HAS_PORTALS
#define LIM_AGREED_PORTALS ".portals"
#else
#define LIM_AGREED_PORTALS
#endif

#define LIM_AGREED_TEXT(number) LIM_AGREED_QUOTE(number)
#define LIM_AGREED_QUOTE(number) #number
#define LIM_AGREED_VERSION                                                                                             \
    ".v" LIM_AGREED_TEXT(LIM_VERSION_MAJOR) "_" LIM_AGREED_TEXT(LIM_VERSION_MINOR) "_" LIM_AGREED_TEXT(                \
        LIM_VERSION_PATCH)
#define LIM_AGREED_NUMBERS                                                                                             \
    LIM_AGREED_PROFILE LIM_AGREED_TEXT(LIM_SUB_BITS) "." LIM_AGREED_TEXT(LIM_MAX_SIDE_PX) "px." LIM_AGREED_TEXT(       \
        LIM_MAX_VERTICES) "vertices." LIM_AGREED_TEXT(LIM_VIEW_CACHE_ENTRIES) "cached"
#define LIM_AGREED_FLAGS                                                                                               \
    LIM_AGREED_NEAREST LIM_AGREED_PAINTER LIM_AGREED_CONVEX LIM_AGREED_SCANLINE LIM_AGREED_DEPTH LIM_AGREED_NEWELL     \
        LIM_AGREED_MOVERS LIM_AGREED_DEFORM LIM_AGREED_LIGHT LIM_AGREED_CULL LIM_AGREED_SLANTED LIM_AGREED_LARGE       \
            LIM_AGREED_WIDE LIM_AGREED_LEAVES LIM_AGREED_TRANSPARENT LIM_AGREED_TEXTURE LIM_AGREED_WIREFRAME           \
                LIM_AGREED_ANTIALIAS LIM_AGREED_DELTA LIM_AGREED_STREAM LIM_AGREED_ROUND LIM_AGREED_FILL               \
                    LIM_AGREED_FRAMEBUFFER LIM_AGREED_LINES LIM_AGREED_STATS LIM_AGREED_PORTALS

/* After the declaration of a function or of a scene, before the semicolon. */
#if defined(__GNUC__)
#define LIM_AGREES(name)                                                                                               \
    __asm__(LIM_AGREED_TEXT(__USER_LABEL_PREFIX__) #name                                                               \
            ".needs_same_LIM_CONFIG" LIM_AGREED_VERSION LIM_AGREED_NUMBERS LIM_AGREED_FLAGS)
#else
#define LIM_AGREES(name)
#endif

#endif
