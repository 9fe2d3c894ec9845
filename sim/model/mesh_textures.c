/* SPDX-License-Identifier: MIT
 *
 * mesh_textures_make(): which pictures become textures, how large, and what there is to say about them. */
#include "model/mesh.h"

#include "base/grow.h"
#include "base/names.h"
#include "model/note_words.h"
#include "model/texture_cut.h"
#include "scene.h"

#include <stdio.h>
#include <string.h>

enum { BLOCKS_MAX = 0xFFFF, MOST_BITS = 10, RESIZED_TOLD = 8 };

static bool is_shown(const struct picture *picture)
{
    return picture->faces && picture->w_px;
}

/* How many levels --texture-budget leaves out of a texture. */
static unsigned levels_less(const struct picture *picture, uint8_t w_bits)
{
    return picture->w_bits_end && w_bits >= picture->w_bits_end ? w_bits + 1u - picture->w_bits_end : 0;
}

static size_t blocks_of(const struct picture *picture, uint8_t most_bits)
{
    uint8_t across, down;
    texture_bits_of(picture, most_bits, &across, &down);
    const unsigned less = levels_less(picture, across > down ? across : down);
    return texture_texels((uint8_t)(across - less), (uint8_t)(down - less)) / LIM_TEXEL_BLOCK;
}

/* Of all textures together, in blocks. */
static size_t blocks_at(const struct model *model, uint8_t most_bits)
{
    size_t blocks = 0;
    for (size_t i = 0; i < model->picture_count; i++) {
        const struct picture *picture = &model->pictures[i];
        if (is_shown(picture)) blocks += blocks_of(picture, most_bits);
    }
    return blocks;
}

static struct note *note_add(struct mesh *mesh)
{
    mesh->notes = grow(mesh->notes, mesh->note_count, &mesh->note_capacity, sizeof *mesh->notes);
    mesh->notes[mesh->note_count] = (struct note){.is_detail = false};
    return &mesh->notes[mesh->note_count++];
}

static void note_left_out(struct mesh *mesh, const struct picture *picture)
{
    struct note *note = note_add(mesh);
    note->is_loss = true;
    snprintf(note->text, sizeof note->text, "texture %s: %s; faces of a flat colour instead: %zu",
             name_end(picture->name).text, picture->reason, picture->faces);
}

static void note_opaque(struct mesh *mesh, const struct picture *picture)
{
    if (!picture->clear_faces) return;
    struct note *note = note_add(mesh);
    note->is_loss = true;
    snprintf(
        note->text, sizeof note->text,
        "texture %s: its transparency is not drawn; faces that it belongs to: %zu; a cut-out is, as of alphaMode MASK",
        name_end(picture->name).text, picture->clear_faces);
}

/* Whether it was. */
static bool is_resized(const struct picture *picture, const struct texture *texture)
{
    const unsigned w_px = 1u << (texture->transposed ? texture->h_bits : texture->w_bits);
    const unsigned h_px = 1u << (texture->transposed ? texture->w_bits : texture->h_bits);
    return w_px != picture->found_w_px || h_px != picture->found_h_px;
}

static void note_resized(struct mesh *mesh, const struct picture *picture, const struct texture *texture, bool crowded)
{
    const unsigned w_px = 1u << (texture->transposed ? texture->h_bits : texture->w_bits);
    const unsigned h_px = 1u << (texture->transposed ? texture->w_bits : texture->h_bits);
    struct note *note = note_add(mesh);
    snprintf(note->text, sizeof note->text, "texture %s: %lux%lu pixels, resized to %ux%u%s",
             name_end(picture->name).text, (unsigned long)picture->found_w_px, (unsigned long)picture->found_h_px, w_px,
             h_px,
             crowded && w_px * h_px < picture->found_w_px * picture->found_h_px
                 ? ": the scene's textures would be too large together"
                 : ", as sides are powers of two");
}

static void note_more(struct mesh *mesh, size_t count)
{
    struct note *note = note_add(mesh);
    snprintf(note->text, sizeof note->text, "textures that are resized as well: %zu", count);
}

static void note_faces(struct mesh *mesh, const char *what, size_t count)
{
    if (!count) return;
    struct note *note = note_add(mesh);
    note->is_detail = true;
    snprintf(note->text, sizeof note->text, "%s: %zu", what, count);
}

static void note_cropped(struct mesh *mesh, const struct picture *picture)
{
    if (!picture->whole_w_px) return;
    struct note *note = note_add(mesh);
    note->is_detail = true;
    snprintf(note->text, sizeof note->text, "texture %s: %lux%lu of its %lux%lu pixels, faces show no others",
             name_end(picture->name).text, (unsigned long)picture->w_px, (unsigned long)picture->h_px,
             (unsigned long)picture->whole_w_px, (unsigned long)picture->whole_h_px);
}

static void note_budget(struct mesh *mesh, const struct model *model)
{
    if (*model->textures_became) snprintf(note_add(mesh)->text, sizeof mesh->notes->text, "%s", model->textures_became);
    for (size_t i = 0; i < model->picture_count; i++) {
        if (!*model->pictures[i].became) continue;
        struct note *note = note_add(mesh);
        note->is_detail = true;
        snprintf(note->text, sizeof note->text, "texture %s: shown as %s", name_end(model->pictures[i].name).text,
                 model->pictures[i].became);
    }
}

bool mesh_textures_enlarge(const struct model *model, struct mesh *mesh, struct error *err)
{
    for (size_t i = 0; i < model->picture_count; i++) {
        const struct picture *picture = &model->pictures[i];
        if (!mesh->textures[i].texel_count) continue;
        texture_free(&mesh->textures[i]);
        if (!texture_make(picture, MOST_BITS, &mesh->textures[i]))
            return error_set(err, "texture %s: out of memory", name_end(picture->name).text);
    }
    return true;
}

uint8_t mesh_texture_bits(const struct model *model)
{
    uint8_t most_bits = MOST_BITS;
    while (most_bits > 0 && blocks_at(model, most_bits) > BLOCKS_MAX)
        most_bits--;
    return most_bits;
}

bool mesh_textures_make(const struct model *model, struct mesh *mesh, struct error *err)
{
    const uint8_t most_bits = model->texture_bits ? model->texture_bits : mesh_texture_bits(model);
    size_t resized = 0;
    if (blocks_at(model, most_bits) > BLOCKS_MAX)
        return error_set(err, "scene too large: %zu textures, %d are the most", model->picture_count, BLOCKS_MAX);
    if (model->picture_count) mesh->textures = grow_zeroed(model->picture_count, sizeof *mesh->textures);
    mesh->texture_count = model->picture_count;
    for (size_t i = 0; i < model->picture_count; i++) {
        const struct picture *picture = &model->pictures[i];
        note_opaque(mesh, picture);
        if (!picture->faces) continue;
        if (!picture->w_px && !picture->left_out)
            return error_set(err, "texture %s: %s" WORDS_WITHOUT, name_end(picture->name).text, picture->reason);
        if (!picture->w_px) {
            note_left_out(mesh, picture);
            continue;
        }
        if (!texture_make(picture, most_bits, &mesh->textures[i]))
            return error_set(err, "texture %s: out of memory", name_end(picture->name).text);
        note_cropped(mesh, picture);
        const bool was_resized = is_resized(picture, &mesh->textures[i]);
        texture_cut(&mesh->textures[i], levels_less(picture, mesh->textures[i].w_bits));
        if (!was_resized || *picture->became) continue;
        if (resized++ < RESIZED_TOLD) note_resized(mesh, picture, &mesh->textures[i], most_bits < MOST_BITS);
    }
    note_faces(mesh, "faces that show one colour of their texture, and have that", model->flat_faces);
    note_faces(mesh, "faces that have the mean colour of their texture's part", model->mean_faces);
    note_budget(mesh, model);
    if (resized > RESIZED_TOLD) note_more(mesh, resized - RESIZED_TOLD);
    return true;
}
