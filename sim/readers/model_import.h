/* SPDX-License-Identifier: MIT
 *
 * From a file to a model, by assimp (OBJ, glTF, STL, PLY, ...), or of a map of a WAD (levels/level_import.h); quads and
 * n-gons are kept. */
#ifndef SIM_MODEL_IMPORT_H
#define SIM_MODEL_IMPORT_H

#include "base/error.h"
#include "model/model.h"

/* Reads a model file. Refuses, naming file and reason: missing, unreadable or unknown format, no
 * faces, NaN or infinite coordinates, an opacity that is NaN, indices out of range, more than 2^26 corners. On success
 * the caller owns *model, otherwise it is empty.
 *
 * Faces are numbered from 1; points and lines are none. In OBJ, STL and PLY files the order is that
 * of the file. Formats with a node tree (glTF, ...) are numbered node by node, parents first, then
 * by mesh of the node, then by face of the mesh. A mirroring transform turns its faces round.
 *
 * OBJ colours are taken as sRGB. Base colours of physically based materials (glTF) are linear
 * light, as that format says, and become sRGB here. Of the textures those of the colour and of the emission are read,
 * as opaque (picture.clear_faces); picture.wrap says what is seen beyond their borders. One that cannot be read is no
 * error.
 *
 * Opacity is MTL's `d` (or 1 - `Tr`); glTF's base colour's and vertex colours' alpha where alphaMode is BLEND, all or
 * nothing where it is MASK, and nothing where it is OPAQUE.
 *
 * Animations move nodes rigidly (motion_keys.h). Points are where the nodes' own transforms have them, or what keys
 * keep these at; all animations of the file run at once. Refused, by name: a scale that changes, what is sheared as it
 * moves, and, but in glTF, a node that has not its name alone. Notices, one a kind: nodes without a mesh, joints of
 * skins and morph targets are not moved; of several animations that move the same node the first counts. */
bool model_import(const char *path, struct model *model, struct error *err);

#endif
