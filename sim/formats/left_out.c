/* SPDX-License-Identifier: MIT */
#include "formats/left_out.h"

#include "model/note_words.h"

#include <assimp/material.h>

struct tally {
    size_t skins, morphs, lines, moved;
};

static void count_mesh(const struct aiMesh *mesh, struct tally *tally)
{
    tally->skins += mesh->mNumBones > 0;
    tally->morphs += mesh->mNumAnimMeshes > 0;
    for (unsigned i = 0; i < mesh->mNumFaces; i++)
        tally->lines += mesh->mFaces[i].mNumIndices == 1 || mesh->mFaces[i].mNumIndices == 2;
}

/* By a transform of texture coordinates that is none of nothing. */
static bool is_moved(const struct aiMaterial *material)
{
    static const enum aiTextureType types[] = {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR};
    struct aiUVTransform move;
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (aiGetMaterialUVTransform(material, AI_MATKEY_UVTRANSFORM(types[i], 0), &move) == aiReturn_SUCCESS &&
            (move.mTranslation.x != 0 || move.mTranslation.y != 0 || move.mScaling.x != 1 || move.mScaling.y != 1 ||
             move.mRotation != 0))
            return true;
    return false;
}

void left_out_tell(const struct aiScene *scene, struct model *model)
{
    struct tally tally = {0};
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        count_mesh(scene->mMeshes[i], &tally);
    for (unsigned i = 0; i < scene->mNumMaterials; i++)
        tally.moved += is_moved(scene->mMaterials[i]);
    if (tally.skins) model_note(model, "%zu " WORDS_SKINS, tally.skins);
    if (tally.morphs) model_note(model, "%zu " WORDS_MORPHS, tally.morphs);
    if (tally.lines) model_note(model, "%zu " WORDS_LINES, tally.lines);
    if (tally.moved) model_note(model, "%zu " WORDS_WHOLE_PICTURES, tally.moved);
    if (scene->mNumLights) model_note(model, WORDS_LIGHTS);
}
