/* SPDX-License-Identifier: MIT
 *
 * What --camera says: a camera file, cameras at random in the scene's free space, or, without it, an orbit. */
#ifndef SIM_CAMERA_CHOICE_H
#define SIM_CAMERA_CHOICE_H

#include "cameras/camera_path.h"

enum { CAMERA_CHOICE_RANDOM = 64 }; /* frames, unless said */

enum camera_random {
    CAMERA_ANYWHERE,
    CAMERA_NEAR,    /* the model's faces */
    CAMERA_GRAZING, /* them */
    CAMERA_KINDS
};

struct camera_choice {
    const char *text;        /* as given; NULL: not given, so an orbit */
    size_t random_count;     /* 0: the text is a file's name */
    enum camera_random kind; /* of the random ones */
    const char *level; /* the model, if it is a map of a WAD: without text not an orbit, but its players and things */
    bool takes_times;  /* a file's cameras may have times of their own; else they are refused */
    uint32_t seed;     /* of the random ones */
    bool z_is_up;      /* in a glTF file, as in its model: --up z */
    double fov_deg;    /* what is shown, from top to bottom: a glTF file's cameras may have others */
};

/* --camera FILE, random:SEED[:FRAMES], near: or grazing: the same; a file of such a name is ./random:1. A FILE may be a
 * map of a WAD (levels/level_path.h): its players and things; or a glTF file: its cameras. */
bool camera_choice_parse(const char *text, struct camera_choice *out, struct error *err);

/* Reads the file, if it is one: before the scene is compiled, since that takes longer than to see a mistake. */
bool camera_choice_read(const struct camera_choice *choice, struct camera_path *out, struct error *err);

/* Plans, unless a file was read, the random cameras or an orbit of so many frames; of a map as many of its things. */
bool camera_choice_plan(const struct camera_choice *choice, const struct compiled *scene, const struct lens *lens,
                        size_t orbit_frames, struct camera_path *path, struct error *err);

#endif
