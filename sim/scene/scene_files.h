/* SPDX-License-Identifier: MIT
 *
 * The files of compiled scenes, each as part of a set of outputs that is kept or discarded as a
 * whole. Names are paths without suffix. */
#ifndef SIM_SCENE_FILES_H
#define SIM_SCENE_FILES_H

#include "base/c_name.h"
#include "outputs/outputs.h"
#include "scene/compiled.h"

struct moving;
struct needs;

struct named_scene {
    const struct compiled *scene;
    const char *name;
    const struct moving *moving; /* what moves in it; NULL: nothing */
    const char *textures_of;     /* whose textures it shows; NULL: its own */
};

/* .lim files: versioned, checksummed, little-endian. A refused file is named with the reason:
 * missing, truncated, no Limner scene, wrong version, checksum, or an index out of range. */
bool lim_file_write(const struct compiled *scene, const char *path, struct error *err);
bool lim_file_read(const char *path, struct compiled *out, struct error *err);

/* Whether a path ends as those of .lim files do. */
bool lim_file_is_named(const char *path);

/* NAME.c and NAME.h: const arrays and the configuration for a firmware build. `name` is a path
 * without suffix; its last part prefixes the C symbols. */
bool c_source_write(const struct compiled *scene, const char *name, struct error *err);

/* NAME.lim, at the path given. */
bool lim_file_put(const struct compiled *scene, const char *path, struct outputs *outputs, struct error *err);

/* HEADER.h: the configuration that all the scenes share, and what a program has to know of each. */
bool c_header_put(const struct named_scene *scenes, size_t count, const char *header, struct outputs *outputs,
                  struct error *err);

/* HEADER.h without the configuration, for a renderer that has it inside (limner export). */
bool c_declarations_put(const struct named_scene *scenes, size_t count, const char *header, struct outputs *outputs,
                        struct error *err);

/* All that any of the scenes needs. */
struct needs c_header_needs(const struct named_scene *scenes, size_t count);

/* NAME.c: the arrays. It includes HEADER.h. */
bool c_source_put(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err);

/* What moves in a scene: NAME_object1.c, and so on, and NAME_movers.c, which includes HEADER.h. */
bool c_movers_put(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err);

/* The same objects as NAME_object1.lim, and so on. */
bool lim_movers_put(const struct named_scene *scene, struct outputs *outputs, struct error *err);

/* Whether some of what moves in it shows its textures. */
bool c_movers_share_textures(const struct named_scene *scene);

/* What NAME.h says of that. */
void c_movers_declare(FILE *file, const struct named_scene *scene, const struct c_name *name);

/* Keeps the outputs if `ok`, discards them otherwise; whether both went well. */
bool scene_files_finish(struct outputs *outputs, bool ok, struct error *err);

#endif
