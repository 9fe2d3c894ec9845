/* SPDX-License-Identifier: MIT
 *
 * What the golden tests draw, and how: scenes of sim/scenes and one with textures, in every profile, by every method
 * and with what firmware can do beside. What came of it is written line by line, and compared with a file that was
 * written the same way before. GOLDEN_FRAMES=write writes the file anew: what changes in it is explained where it is
 * committed. */
#ifndef TESTS_GOLDEN_STAGE_H
#define TESTS_GOLDEN_STAGE_H

#include "cameras/camera_path.h"
#include "model/model.h"
#include "render/simulator.h"
#include "scene/moving.h"

enum { GOLDEN_W_PX = 88, GOLDEN_H_PX = 64, GOLDEN_FRAMES = 3, GOLDEN_HASH = 0x811C9DC5 };

enum golden_special { GOLDEN_PLAIN, GOLDEN_ANTIALIAS, GOLDEN_DELTA, GOLDEN_WIREFRAME, GOLDEN_FRAMEBUFFER };

struct golden_way {
    const char *name; /* NULL behind the last */
    enum lim_method method;
    enum golden_special special;
};
extern const struct golden_way golden_ways[];

struct golden_stage {
    const char *name;
    struct model model; /* of a scene that is made here, with its mesh */
    struct mesh mesh;
    struct compiled scene;
    struct moving moving;
    struct camera_path path;
    struct lens lens;
    bool is_set; /* without a tree: for what sorts */
};

/* Opens a scene, 0 and up. false: there are no more. */
bool golden_open(struct golden_stage *stage, size_t scene);
void golden_close(struct golden_stage *stage);

/* A simulator of the stage. false: there is none of it with this method or scene. Free it in either case. */
bool golden_begin(struct simulator *simulator, struct golden_stage *stage, const struct core *core,
                  const struct golden_way *way, unsigned w_px, unsigned h_px);

/* Turns on what the way asks for, after each init of the renderer. */
bool golden_turn_on(struct simulator *simulator, struct golden_stage *stage, const struct golden_way *way);

/* Fowler, Noll and Vo's hash of 32 bits; it begins as GOLDEN_HASH. */
uint32_t golden_hash(uint32_t hash, const void *bytes, size_t count);
uint32_t golden_hash_frame(uint32_t hash, const struct simulator *simulator);

/* The lines that are to be as in the file. */
void golden_put(const char *format, ...) __attribute__((format(printf, 1, 2)));
void golden_compare(const char *path);

#endif
