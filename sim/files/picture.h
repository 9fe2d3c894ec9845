/* SPDX-License-Identifier: MIT
 *
 * The pictures that an importer's materials name: read by libgd from files beside the model, or out of the
 * model itself. Runs in the importer's child process, because pictures may be as damaged as models. */
#ifndef SIM_PICTURE_H
#define SIM_PICTURE_H

#include "model/mipmap.h"

#include <assimp/scene.h>

/* PNG, JPEG, WebP, AVIF, GIF, BMP or TGA of 24 or 32 bits, as the bytes themselves say. What cannot be read has a
 * reason and no pixels; what may not be read ends the import (companion.h). */
void picture_read(const struct aiScene *scene, const char *name, struct picture *out);

/* What people know it by: of one inside the model its own name, too, if it has one. */
void picture_label(const struct aiScene *scene, const char *name, char label[PICTURE_NAME_B]);

/* The same of a file beside the model, and of a file's bytes. */
void picture_read_file(const char *name, struct picture *out);
void picture_read_bytes(const char *name, void *bytes, size_t size_b, struct picture *out);
/* Notes the files of all pictures that the materials name, of kinds that are not drawn and left out ones as well:
 * they are the model's, and no output takes their place (companion_note()). */
void pictures_note(const struct aiScene *scene);

/* --no-textures, for all of the process: one that cannot be read is no error, and faces have a colour each. */
void pictures_leave_out(void);
bool pictures_are_left_out(void);

/* --textures flat, likewise: faces have a colour each, the mean of what they show (readers/flat_texture.h). Whether
 * they are to, by either option. */
void pictures_take_means(void);
bool pictures_are_means(void);

/* --sky: faces of the material of this name are a sky, for all of the process; NULL: of none. The text must stay. */
void pictures_set_sky(const char *material);
const char *pictures_sky(void);

/* A copy that is seen around the eye. false: there are no pixels. */
bool picture_copy_as_sky(const struct picture *from, struct picture *out);

void picture_free(struct picture *picture);

/* How a material shows a texture: which set of coordinates goes with it, and what is seen beyond its borders. */
struct picture_use {
    struct aiString name;
    unsigned uv_set;
    uint8_t wrap[2]; /* enum picture_wrap, across and down */
};

/* The texture of a material's colour. false: it has none. */
bool picture_of_colour(const struct aiMaterial *material, struct picture_use *use);

/* The same of what it emits. */
bool picture_of_light(const struct aiMaterial *material, struct picture_use *use);

/* The texture of its opacity alone: map_d of MTL. false: it has none. */
bool picture_mask_of(const struct aiMaterial *material, struct aiString *name);

#endif
