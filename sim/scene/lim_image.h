/* SPDX-License-Identifier: MIT
 *
 * The bytes of a .lim file, as firmware/SCENE.md specifies them: a header and sections with
 * the structs of scene.h, indices of 32 bits, little-endian. In memory an image has the host's byte order, so that a
 * struct lim_scene can point into it. */
#ifndef SIM_LIM_IMAGE_H
#define SIM_LIM_IMAGE_H

#include "scene/compiled.h"
#include "scene/encoding.h"

enum { LIM_FILE_VERSION = 12, LIM_FILE_ALIGN_B = 8, LIM_FILE_MAGIC_B = 8 };

extern const unsigned char lim_file_magic[LIM_FILE_MAGIC_B];

/* Sections in the order of the file. */
enum lim_section {
    SECTION_VERTICES,
    SECTION_NODES,
    SECTION_PLANES,
    SECTION_EXACT,
    SECTION_BOXES,
    SECTION_POLYGONS,
    SECTION_FACES,
    SECTION_FRACTIONS,
    SECTION_UVS, /* of a long scene: lim_long.mappings */
    SECTION_MAPPINGS,
    SECTION_TEXTURES,
    SECTION_PALETTES,
    SECTION_TEXELS, /* in blocks */
    SECTION_PLACES,
    SECTION_PVS,
    SECTION_COUNT
};

struct lim_file_header {
    unsigned char magic[LIM_FILE_MAGIC_B];
    uint32_t version;
    uint32_t header_b;
    uint32_t file_b;
    uint32_t crc32;     /* of all bytes of the file behind this field, as zlib's crc32() */
    double units_per_m; /* IEEE 754 */
    double origin_m[3];
    uint32_t counts[SECTION_COUNT]; /* elements in each section */
    uint16_t background;            /* RGB565 as a number */
    uint16_t limits[9];             /* the fields of struct lim_limits in their order */
    uint32_t deep_from;             /* of a mesh; else 0 */
    uint32_t near_deep_from;        /* likewise */
    uint32_t coordinate_bits;       /* 16; 32: vertices, planes and boxes are those of long.h */
    uint32_t drawn_by;              /* 1 + enum lim_method, what the compiler chose; 0: not said */
};

enum { LIM_FILE_CRC_FROM_B = 24 }; /* the first byte that crc32 covers */

/* Where a section begins, and, for SECTION_COUNT, the size of the file. */
uint64_t lim_image_section_b(const struct lim_file_header *header, enum lim_section section);

/* Where its last element ends; what follows up to the next section is zero. */
uint64_t lim_image_section_end_b(const struct lim_file_header *header, enum lim_section section);

/* The bytes of a .lim file with the encoded scene, in this host's byte order, and the struct
 * lim_scene that leads into it: sets everything in *out but the report. */
void lim_image_make(const struct encoding *encoding, const struct grid *grid, struct compiled *out);

/* Points *scene into the image. */
void lim_image_bind(void *image, struct compiled *scene);

/* Gives a scene visible sets, or none: makes its image anew. The arrays stay the caller's. */
void lim_image_set_pvs(struct compiled *scene, const struct lim_place *places, size_t place_count, const uint8_t *pvs,
                       size_t pvs_bytes);

/* Gives a scene other textures, palettes and texels: makes its image anew. The arrays stay the caller's. */
void lim_image_set_textures(struct compiled *scene, const struct texture_arrays *arrays);

/* Sets the limits of the scene and of its image. */
void lim_image_set_limits(struct compiled *scene, const struct lim_limits *limits);

/* When a triangle of a mesh has depth. */
enum lim_deep { LIM_DEEP_NEVER, LIM_DEEP_NEAR, LIM_DEEP_ALWAYS, LIM_DEEP_COUNT };

/* Of a mesh: first triangles without depth, then those that have it near the eye, then those that always have it; each
 * kind in the order that it has. `deep`: of each triangle, enum lim_deep. */
void lim_image_set_deep(struct compiled *scene, const uint8_t *deep);

/* Turns the header, or the sections that a header in this host's order describes, between this
 * host's byte order and the other one. */
void lim_image_swap_header(void *image);
void lim_image_swap_sections(void *image, const struct lim_file_header *header);

uint32_t lim_image_crc32(const void *image, size_t image_b);

#endif
