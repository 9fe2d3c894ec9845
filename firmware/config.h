/* SPDX-License-Identifier: MIT
 *
 * What a build of the renderer contains. A scene's generated header states its needs and limits. A build says which
 * header that is, by LIM_CONFIG, -DLIM_CONFIG='"hall.h"', for all files; or by a file limner_config.h that includes
 * hall.h, where the compiler looks for <headers> (-I). Settings of its own come before (#define LIM_HAS_STATS 1).
 * Compilers without __has_include do not find it. With neither the renderer has all features, for any scene; it works,
 * and is large. Whatever a header leaves open gets the host's generous value here, so every flag is always defined.
 * agree.h sees that all files agree. */

#if !defined(LIM_CONFIG) && defined(__has_include)
#if __has_include(<limner_config.h>)
#define LIM_CONFIG <limner_config.h>
#endif
#endif

/* First it states its needs alone, also to a scene's header that comes before this one (LIM_READS_SETTINGS). Its
 * declarations come when the types are known: limner.h includes it again. */
#if defined(LIM_CONFIG) && !defined(LIM_SETTINGS_ARE_READ)
#define LIM_SETTINGS_ARE_READ
#define LIM_READS_CONFIG
#include LIM_CONFIG
#undef LIM_READS_CONFIG
#endif

#if !defined(LIM_CONFIG_H) && !defined(LIM_READS_SETTINGS)
#define LIM_CONFIG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Public headers are C11 and C++11. */
#ifdef __cplusplus
#define LIM_C_BEGIN extern "C" {
#define LIM_C_END }
#define LIM_STATIC_ASSERT(condition, text) static_assert(condition, text)
#define LIM_ALIGNOF(type) alignof(type)
#define LIM_ALIGNAS(size_b) alignas(size_b)
#define LIM_CAST(type, value) static_cast<type>(value)
#else
#define LIM_C_BEGIN
#define LIM_C_END
#define LIM_STATIC_ASSERT(condition, text) _Static_assert(condition, text)
#define LIM_ALIGNOF(type) _Alignof(type)
#define LIM_ALIGNAS(size_b) _Alignas(size_b)
#define LIM_CAST(type, value) ((type)(value))
#endif

/* Precision profiles. Within a profile every CPU and compiler paints the same pixels.
 *
 *   draft  16-bit rows and ratios, whole pixels
 *   fast   the same, 1/128 pixel
 *   fine   rows of 29 bits in two limbs, ratios of 19 bits, 1/512 pixel
 *   exact  the same rows, ratios of 27 bits, vertices with 8 further bits, 1/4096 pixel
 *
 * Formats are in stages.h, the arithmetic in transform.h and perspective.h; no other stage knows more than names. */
#define LIM_PROFILE_DRAFT 0
#define LIM_PROFILE_FAST 1
#define LIM_PROFILE_FINE 2
#define LIM_PROFILE_EXACT 3

#ifndef LIM_PROFILE
#define LIM_PROFILE LIM_PROFILE_FAST
#endif

#if LIM_PROFILE == LIM_PROFILE_DRAFT
#define LIM_PROFILE_SUB_BITS 0
#elif LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_PROFILE_SUB_BITS 7
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_PROFILE_SUB_BITS 9
#elif LIM_PROFILE == LIM_PROFILE_EXACT
#define LIM_PROFILE_SUB_BITS 12
#else
#error "unknown LIM_PROFILE"
#endif

/* Sub-pixel bits, 0..12: a profile's own unless a build says otherwise. */
#ifndef LIM_SUB_BITS
#define LIM_SUB_BITS LIM_PROFILE_SUB_BITS
#endif
#if LIM_SUB_BITS < 0 || LIM_SUB_BITS > 12
#error "LIM_SUB_BITS must be 0..12"
#endif

/* Either of two flags or both, without an operator. So flags' lines have no comments, which some preprocessors keep. */
#define LIM_BOTH(a, b) LIM_BOTH_OF(a, b)
#define LIM_BOTH_OF(a, b) LIM_BOTH_##a##b
#define LIM_BOTH_00 0
#define LIM_BOTH_01 0
#define LIM_BOTH_10 0
#define LIM_BOTH_11 1
#define LIM_EITHER(a, b) LIM_EITHER_OF(a, b)
#define LIM_EITHER_OF(a, b) LIM_EITHER_##a##b
#define LIM_EITHER_00 0
#define LIM_EITHER_01 1
#define LIM_EITHER_10 1
#define LIM_EITHER_11 1

/* Features: 1 is linked, 0 is not. What a scene needs is in its header; hosts have everything.
 *
 * The order of drawing, enum lim_method: one of them at least. */
/* Nearest first: walk, spans, retained polygons. */
#ifndef LIM_HAS_NEAREST
#define LIM_HAS_NEAREST 1
#endif
/* Back to front into a framebuffer. */
#ifndef LIM_HAS_PAINTER
#define LIM_HAS_PAINTER 1
#endif
/* One convex solid: no tree walk, no spans. */
#ifndef LIM_HAS_CONVEX
#define LIM_HAS_CONVEX 1
#endif
/* All that is in view retained, lines from far to near: no spans. */
#ifndef LIM_HAS_SCANLINE
#define LIM_HAS_SCANLINE 1
#endif
/* All polygons sorted by their farthest points, spans. */
#ifndef LIM_HAS_DEPTH
#define LIM_HAS_DEPTH 1
#endif
/* The same, put right by comparing polygons and splitting them. */
#ifndef LIM_HAS_NEWELL
#define LIM_HAS_NEWELL 1
#endif

/* A mesh without a tree: triangles by distance. */
#ifndef LIM_HAS_MESH
#define LIM_HAS_MESH 1
#endif
/* The same with a line of depths. */
#ifndef LIM_HAS_MESH_DEPTH
#define LIM_HAS_MESH_DEPTH 1
#endif

/* Moving objects in the walk through a tree; hosts have them with every tree. */
#ifndef LIM_HAS_MOVERS
#define LIM_HAS_MOVERS LIM_EITHER(LIM_HAS_NEAREST, LIM_HAS_SCANLINE)
#endif

/* Movers whose corners their owner changes. No compiled scene knows of them: who wants them says so. */
#ifndef LIM_HAS_DEFORM
#define LIM_HAS_DEFORM LIM_HAS_MOVERS
#endif

/* A light that shades movers in each frame. */
#ifndef LIM_HAS_LIGHT
#define LIM_HAS_LIGHT LIM_HAS_MOVERS
#endif

/* What the scene's arrays hold. */

/* Bounds of subtrees, to be tested against the open view. */
#ifndef LIM_HAS_CULL
#define LIM_HAS_CULL 1
#endif
/* Planes off the axes. */
#ifndef LIM_HAS_SLANTED
#define LIM_HAS_SLANTED 1
#endif
/* LARGE planes: with an exact plane beside their filter. */
#ifndef LIM_HAS_LARGE
#define LIM_HAS_LARGE 1
#endif

/* More of something than 16 bits count: indices of 32 bits. */
#ifndef LIM_HAS_WIDE
#if SIZE_MAX > 0xFFFF
#define LIM_HAS_WIDE 1
#else
#define LIM_HAS_WIDE 0
#endif
#endif
/* Coordinates of 32 bits, for scenes of many scales. */
#ifndef LIM_HAS_LONG
#define LIM_HAS_LONG LIM_BOTH(LIM_HAS_TREE, LIM_HAS_WIDE)
#endif
/* Leaves: ordered clusters and sets without a tree. */
#ifndef LIM_HAS_LEAVES
#define LIM_HAS_LEAVES 1
#endif
/* Leaves whose order is by distance. */
#ifndef LIM_HAS_MESH_LEAVES
#define LIM_HAS_MESH_LEAVES LIM_BOTH(LIM_HAS_LEAVES, LIM_HAS_TREE)
#endif
/* Polygons that what lies behind them shines through. */
#ifndef LIM_HAS_TRANSPARENT
#define LIM_HAS_TRANSPARENT 1
#endif
/* Polygons with a texture. */
#ifndef LIM_HAS_TEXTURE
#define LIM_HAS_TEXTURE 1
#endif
/* Textures of which some texels are clear. */
#ifndef LIM_HAS_MASKED
#define LIM_HAS_MASKED LIM_BOTH(LIM_HAS_TEXTURE, LIM_HAS_TRANSPARENT)
#endif
/* Textures that are a sky around the eye. */
#ifndef LIM_HAS_SKY
#define LIM_HAS_SKY LIM_HAS_TEXTURE
#endif
/* Lenses with a tangent below LIM_TAN_TELE_Q28 (camera.h) are as exact as others. */
#ifndef LIM_HAS_TELE
#define LIM_HAS_TELE 1
#endif
/* 1: lim_set_wireframe() is there. */
#ifndef LIM_HAS_WIREFRAME
#define LIM_HAS_WIREFRAME 1
#endif
/* 1: lim_set_antialias() is there. */
#ifndef LIM_HAS_ANTIALIAS
#define LIM_HAS_ANTIALIAS LIM_HAS_SPANS
#endif
/* 1: lim_set_delta() is there. */
#ifndef LIM_HAS_DELTA
#define LIM_HAS_DELTA 1
#endif
/* 1: lim_set_overlay() is there. */
#ifndef LIM_HAS_OVERLAY
#define LIM_HAS_OVERLAY 1
#endif
/* 1: what paints nearest first leaves out what round glass hides. */
#ifndef LIM_HAS_ROUND
#define LIM_HAS_ROUND LIM_HAS_SPANS
#endif

/* 1: a target may keep pixels in a format of its own, and has them filled piece by piece: lim_target.fill. */
#ifndef LIM_HAS_FILL
#define LIM_HAS_FILL LIM_EITHER(LIM_HAS_NEAREST, LIM_HAS_CONVEX)
#endif

/* 1: a target may have all its pixels in memory, lim_target.framebuffer, where polygons are painted as they come. */
#ifndef LIM_HAS_FRAMEBUFFER
#define LIM_HAS_FRAMEBUFFER LIM_EITHER(LIM_HAS_NEAREST, LIM_HAS_PAINTER)
#endif

/* The depth sort compares a list of n polygons at most LIM_NEWELL_EFFORT n^2 times, and a comparison for each piece: 1
 * to 65535. Random triangles through one another take up to 20. */
#ifndef LIM_NEWELL_EFFORT
#define LIM_NEWELL_EFFORT 256u
#endif

/* 0: no line is ever lent. */
#ifndef LIM_HAS_LINES
#define LIM_HAS_LINES 1
#endif
/* 1: lim_frame() counts its work in struct lim_stats. 0: the counters stay zero and cost nothing. */
#ifndef LIM_HAS_STATS
#define LIM_HAS_STATS 1
#endif

/* What the code is for; the same pixels. LIM_SIZE: what does nothing but save time is left out. LIM_BALANCE: likewise,
 * but for the loops that most of a frame's time goes into. LIM_SPEED: nothing is. By default what the compiler is asked
 * for: -Os asks for size. For LIM_BALANCE say both, -Os -DLIM_OPTIMISE=LIM_BALANCE. Objects of all kinds link. */
#define LIM_SPEED 0
#define LIM_BALANCE 1
#define LIM_SIZE 2
#ifndef LIM_OPTIMISE
#if defined(__OPTIMIZE_SIZE__)
#define LIM_OPTIMISE LIM_SIZE
#else
#define LIM_OPTIMISE LIM_SPEED
#endif
#endif

/* What is left out is asked by: of most code; of the hot loops, those that balanced code keeps. */
#define LIM_OPTIMISE_SIZE (LIM_OPTIMISE != LIM_SPEED)
#define LIM_HOT (LIM_OPTIMISE != LIM_SIZE)

/* 1: reciprocals come from a table of 514 bytes. 0: from two divisions, with the same bits, which cost a vertex a few
 * instructions. By default the table is left out where a core divides in hardware and code is to be short. */
#ifndef LIM_RECIP_TABLE
#if LIM_OPTIMISE_SIZE && (defined(__ARM_FEATURE_IDIV) || defined(__riscv_div) || defined(__x86_64__))
#define LIM_RECIP_TABLE 0
#else
#define LIM_RECIP_TABLE 1
#endif
#endif

/* The walk through the tree serves three orders, of which two paint lines, a sorted list two others; spans serve all
 * that paint nearest first, and a vertex beside the view is left out by all that look for what is hidden. */
#define LIM_HAS_WALKED LIM_EITHER(LIM_HAS_NEAREST, LIM_HAS_SCANLINE)
#define LIM_HAS_TREE LIM_EITHER(LIM_HAS_WALKED, LIM_HAS_PAINTER)
#define LIM_HAS_SORTED LIM_EITHER(LIM_HAS_DEPTH, LIM_HAS_NEWELL)
#define LIM_HAS_SPANS LIM_EITHER(LIM_HAS_WALKED, LIM_HAS_SORTED)
#define LIM_HAS_HIDDEN (LIM_HAS_TREE || LIM_HAS_SORTED)

/* Meshes, by either order; and scenes that have planes, which all but meshes have. */
#define LIM_HAS_MESHES LIM_EITHER(LIM_HAS_MESH, LIM_HAS_MESH_DEPTH)
#define LIM_HAS_PLANES (LIM_HAS_HIDDEN || LIM_HAS_CONVEX)

/* Whether there is nothing that flat.c cannot paint: then pieces of lines are of interest to targets alone that keep
 * the picture. */
#define LIM_ALL_FLAT                                                                                                   \
    (!LIM_HAS_TRANSPARENT && !LIM_HAS_TEXTURE && !LIM_HAS_WIREFRAME && !LIM_HAS_ANTIALIAS && !LIM_HAS_DELTA)
#define LIM_HAS_SINKS (!LIM_ALL_FLAT || LIM_HAS_FILLED)

/* Whether polygons may be painted as they come, into a picture that the target keeps. */
#define LIM_HAS_FILLED ((LIM_HAS_FILL && LIM_HAS_NEAREST) || LIM_HAS_FRAMEBUFFER)

/* What nearest first leaves to the painter's order where its pools are too small, line by line. */
#define LIM_HAS_FALLBACK (LIM_HAS_SPANS && (LIM_HAS_TRANSPARENT || LIM_HAS_WIREFRAME))

/* Whether a line that is lent may turn out to be too much: it is painted anew, by the painter or in parts. */
#define LIM_HAS_LENT (LIM_HAS_FALLBACK || (LIM_HAS_SPANS && LIM_HAS_MOVERS && LIM_HAS_ANTIALIAS))

/* Whether anything is painted back to front. */
#define LIM_HAS_PAINTED (LIM_HAS_PAINTER || LIM_HAS_FALLBACK)

/* Portals say which boxes can be seen from where: what walks no tree, or tests no boxes, has no use for them. */
#ifndef LIM_HAS_PORTALS
#define LIM_HAS_PORTALS LIM_BOTH(LIM_HAS_TREE, LIM_HAS_CULL)
#endif

/* Whether the processor works on bytes: 32 bits are four steps then and 64 a call of the library, divisions take a step
 * for each bit, and multiplications by less than 16 bits pay. The same bits come of other instructions. */
#if defined(__AVR__)
#define LIM_8_BIT 1
#else
#define LIM_8_BIT 0
#endif

/* Whether the processor has an instruction to divide by. An Xtensa with the call0 convention is the LX106 of an
 * ESP8266, which has none (Tensilica's core-isa.h for it). */
#ifndef LIM_DIVIDES
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div)) || LIM_8_BIT ||  \
    defined(__XTENSA_CALL0_ABI__)
#define LIM_DIVIDES 0
#else
#define LIM_DIVIDES 1
#endif
#endif

/* Whether 32 x 32 -> 64 is an instruction; where it is a library call, limbs of 16 bits take its place. */
#if defined(__ARM_ARCH_6M__) || defined(__AVR__) || defined(__XTENSA_CALL0_ABI__)
#define LIM_LONG_MULTIPLY 0
#else
#define LIM_LONG_MULTIPLY 1
#endif

/* Whether two products of 16 bits and their sum are one instruction: then pairs of numbers are loaded at once. */
#if defined(__ARM_FEATURE_DSP)
#define LIM_DUAL_MULTIPLY 1
#else
#define LIM_DUAL_MULTIPLY 0
#endif

/* Planes off the axes are tried in 32 bits first. One convex solid has too few of them for that to pay elsewhere. */
#define LIM_HAS_FILTER (LIM_HAS_SLANTED && (LIM_HAS_HIDDEN || LIM_8_BIT))

/* Numbers below are written as such, without brackets: agree.h.
 * Longest side of any target, in pixels: 8..1024. Up to 340 edges have two fraction bits more. */
#ifndef LIM_MAX_SIDE_PX
#define LIM_MAX_SIDE_PX 1024
#endif

/* Most vertices of a polygon in the scene, before clipping: 3..250. */
#ifndef LIM_MAX_VERTICES
#define LIM_MAX_VERTICES 64
#endif

#define LIM_CUT_VERTICES 8

/* Most vertices of anything that is clipped: cutting polygons adds some. What would have more is left whole. */
#if !LIM_HAS_NEWELL
#define LIM_PIECE_VERTICES LIM_MAX_VERTICES
#elif LIM_MAX_VERTICES <= 250 - LIM_CUT_VERTICES
#define LIM_PIECE_VERTICES (LIM_MAX_VERTICES + LIM_CUT_VERTICES)
#else
#define LIM_PIECE_VERTICES 250
#endif

/* Vertices that VIEW remembers, a power of two: 8..256. With fewer, some are projected again. */
#ifndef LIM_VIEW_CACHE_ENTRIES
#define LIM_VIEW_CACHE_ENTRIES 64
#endif

/* Const scene data lives in flash. Only AVR needs another address space for it. C++ has none: there such a pointer has
 * the same bits, may be passed on to C, and must not be dereferenced (pgm_read_word() of avr-libc reads it). */
#if defined(__AVR__) && !defined(__cplusplus)
#define LIM_FLASH __flash
#else
#define LIM_FLASH
#endif
#define LIM_FLASH_AS(type, pointer) LIM_CAST(const LIM_FLASH type *, LIM_CAST(const LIM_FLASH void *, pointer))

/* Members that may be none, as an array: LIM_OPTIONAL(struct part, name, LIM_HAS_PART) is read as name->x where
 * LIM_HAS_PART was asked first.
 *
 * LIM_UNLIKELY: a condition that seldom holds. LIM_IN_EACH_CALLER: inlined in each, even where small code is asked for;
 * programs have but one of them. LIM_WORD_ALIGNED: of members that are copied together. */
#if defined(__GNUC__)
#define LIM_OPTIONAL(type, name, count) __extension__ type name[count]
#define LIM_UNLIKELY(condition) __builtin_expect(condition, 0)
#define LIM_IN_EACH_CALLER inline __attribute__((always_inline))
#define LIM_WORD_ALIGNED __attribute__((aligned(LIM_8_BIT ? 1 : 4)))
#else
#define LIM_OPTIONAL(type, name, count) type name[(count) ? (count) : 1]
#define LIM_UNLIKELY(condition) (condition)
#define LIM_IN_EACH_CALLER inline
#define LIM_WORD_ALIGNED
#endif

/* Around structs that have such members: pedantic C++ has none. The value before an absent one, in an initializer. */
#if defined(__cplusplus) && defined(__GNUC__)
#define LIM_OPTIONAL_BEGIN _Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wpedantic\"")
#define LIM_OPTIONAL_END _Pragma("GCC diagnostic pop")
#define LIM_LAST_VALUE(member, value)                                                                                  \
    value, {}
#else
#define LIM_OPTIONAL_BEGIN
#define LIM_OPTIONAL_END
#define LIM_LAST_VALUE(member, value) .member = value
#endif

/* Memory is cut up in words of four bytes. */
#define LIM_MEM_ALIGNED_B(size_b) (((size_b) + 3) & ~LIM_CAST(size_t, 3))

/* Of functions that can fail. */
#define LIM_MUST_CHECK __attribute__((warn_unused_result))

/* LIM_ALONE: not inlined, but not rare, as a loop that wants all registers for itself. LIM_IF_CALLED: of a static
 * function that calls what may not be linked; where nothing calls it, it is left out even without an optimizer. */
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define LIM_ALONE __attribute__((noinline))
#define LIM_IF_CALLED
#elif defined(__GNUC__)
#define LIM_ALONE
#define LIM_IF_CALLED inline
#else
#define LIM_ALONE
#define LIM_IF_CALLED
#endif

/* Inlined wherever it is called, unless small code is asked for; the second, of hot loops, unless the smallest is.
 * LIM_RARE: code for the rare case, out of line, so that the common one stays short; a call makes small code larger. */
#if defined(__GNUC__) && !LIM_OPTIMISE_SIZE
#define LIM_INLINE inline __attribute__((always_inline))
#else
#define LIM_INLINE inline
#endif
#if defined(__GNUC__) && LIM_HOT
#define LIM_HOT_INLINE inline __attribute__((always_inline))
#define LIM_RARE __attribute__((noinline, cold))
#else
#define LIM_HOT_INLINE inline
#define LIM_RARE
#endif

/* LIM_INLINE of much arithmetic by 32 bits, which takes kilobytes a call where registers have 8. */
#if LIM_8_BIT
#define LIM_INLINE_32 LIM_ALONE
#else
#define LIM_INLINE_32 LIM_INLINE
#endif

/* Before a loop of n turns, which are written out. */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__)
#define LIM_PRAGMA(words) _Pragma(#words)
#define LIM_UNROLLED_BY(n) LIM_PRAGMA(GCC unroll n)
#else
#define LIM_UNROLLED_BY(n)
#endif
#if LIM_OPTIMISE_SIZE
#define LIM_UNROLLED(n)
#else
#define LIM_UNROLLED(n) LIM_UNROLLED_BY(n)
#endif
#if LIM_HOT
#define LIM_HOT_UNROLLED(n) LIM_UNROLLED_BY(n)
#else
#define LIM_HOT_UNROLLED(n)
#endif

/* Stops the program where a debugger sees it: by the instruction that is made for this, without any library. Without a
 * debugger a Cortex-M comes to its HardFault handler, a RISC-V to its trap handler, a Linux program ends by a signal.
 * An AVR stays where it is, with interrupts off: its `break` is for debuggers alone. */
#if defined(__AVR__)
#define LIM_TRAP()                                                                                                     \
    __extension__({                                                                                                    \
        for (;;)                                                                                                       \
            __asm__ volatile("cli\n\tbreak");                                                                          \
    })
#elif defined(__GNUC__)
#define LIM_TRAP() __builtin_trap()
#else
static inline void lim_trap(void)
{
    for (;;)
        continue;
}
#define LIM_TRAP() lim_trap()
#endif

/* A caller's bug ends here. Functions that are called once, or once a frame, evaluate the condition. Define LIM_ASSERT,
 * for all files, to have something else happen: assert(condition); or ((void)0), and bugs go unnoticed. */
#ifndef LIM_ASSERT
#define LIM_ASSERT(condition) ((condition) ? (void)0 : LIM_TRAP())
#endif

/* A bug of the renderer, or a scene that no compiler wrote. It stands where a frame spends its time, so it is evaluated
 * only if a build says -DLIM_DEBUG_ASSERT=LIM_ASSERT, as the tests with sanitizers do. */
#ifndef LIM_DEBUG_ASSERT
#define LIM_DEBUG_ASSERT(condition) ((void)0)
#endif

#endif
