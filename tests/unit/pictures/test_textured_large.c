/* SPDX-License-Identifier: MIT
 *
 * Scenes of more words of polygons than 16 bits count: there a mapping names its texture, and a record is kept by its
 * mapping. They show what the same scene shows by the places of its words. */
#include "compiler/encode_texture.h"
#include "core/core.h"
#include "model/mesh.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/profiles.h"
#include "rigs/texture_rig.h"
#include "scene/lim_check.h"

#include <stdlib.h>
#include <string.h>

enum { W_PX = 80, H_PX = 64, CAMERAS = 12, LARGE_WORDS = 70000, TILES = 105 };

/* A room of two pictures, each under two lights, and the same scene with room behind its records. */
struct rig {
    struct model model;
    struct mesh mesh;
    struct compiled scene;
    struct lim_scene large;
    lim_index *words;
    struct lim_mapping *mappings;
};

static void rig_start(struct rig *rig, const struct core *core)
{
    struct random random = {7};
    const uint32_t first = texture_rig_picture(&rig->model, 32, 32, &random);
    texture_rig_room(&rig->model, first, 2);
    texture_rig_picture(&rig->model, 64, 32, &random);
    for (size_t i = 0; i < rig->model.face_count; i++) {
        rig->model.faces[i].picture = first + (uint32_t)i % 2;
        rig->model.faces[i].colour = i < 3 ? 0xFFFFFF : 0x606060;
    }
    rig->model.pictures[1].faces = rig->model.pictures[0].faces;
    rig->scene = texture_rig_compile(&rig->model, &rig->mesh, core);
}

/* A mapping for each record, whatever else shows it: so none is shared. */
static void rig_enlarge(struct rig *rig)
{
    const struct lim_scene *scene = &rig->scene.scene;
    rig->large = *scene;
    rig->words = calloc(LARGE_WORDS, sizeof *rig->words);
    rig->mappings = calloc(scene->polygon_count, sizeof *rig->mappings);
    assert_true(rig->words && rig->mappings);
    memcpy(rig->words, scene->polygons, scene->polygon_words * sizeof *rig->words);
    uint16_t record = 0;
    for (size_t at = 0; at < scene->polygon_words; at += lim_record_words(scene->polygons[at]), record++) {
        lim_index *const end = &rig->words[at + lim_record_words(scene->polygons[at])];
        rig->mappings[record] = scene->mappings[end[-1]];
        rig->mappings[record].texture = (uint16_t)end[-2];
        end[-1] = record;
        end[-2] = 0; /* nobody reads it */
    }
    rig->large.polygons = rig->words;
    rig->large.polygon_words = LARGE_WORDS;
    rig->large.mappings = rig->mappings;
    rig->large.mapping_count = record;
}

static void rig_free(struct rig *rig)
{
    compiled_free(&rig->scene);
    mesh_free(&rig->mesh);
    model_free(&rig->model);
    free(rig->words);
    free(rig->mappings);
}

static void simulator_start(struct simulator *simulator, const struct lim_scene *scene, const struct core *core,
                            enum lim_method method)
{
    const struct simulator_setup setup = {
        .w_px = W_PX, .h_px = H_PX, .method = method, .panel = SIMULATOR_MEMORY, .core = core};
    struct error err;
    if (!simulator_init(simulator, scene, &setup, &err)) fail_msg("%s", err.text);
}

static void check_method(const struct rig *rig, const struct core *core, enum lim_method method)
{
    struct simulator small, large;
    struct error err;
    simulator_start(&small, &rig->scene.scene, core, method);
    simulator_start(&large, &rig->large, core, method);
    for (uint32_t i = 0; i < CAMERAS; i++) {
        const struct lim_camera camera = {
            .yaw = i * 0x17654321, .pitch = i * 0x03456789, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};
        if (!simulator_frame(&small, &camera, &err) || !simulator_frame(&large, &camera, &err))
            fail_msg("%s", err.text);
        assert_memory_equal(small.pixels, large.pixels, W_PX * H_PX * sizeof small.pixels[0]);
    }
    simulator_free(&small);
    simulator_free(&large);
}

static void large_scenes_show_the_same(void **state)
{
    (void)state;
    static const enum lim_method trees[] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_SCANLINE, LIM_DEPTH, LIM_NEWELL};
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++) {
        struct rig rig = {0};
        rig_start(&rig, profiles[i]);
        rig_enlarge(&rig);
        assert_int_equal(rig.scene.scene.texture_count, 4);
        for (size_t k = 0; k < sizeof trees / sizeof *trees; k++)
            check_method(&rig, profiles[i], trees[k]);
        rig_free(&rig);
    }
}

/* Compiling ---------------------------------------------------------------------------------------- */

/* A chequered floor, 615 words more than 16 bits count, all of it with one mapping, in two lights. */
static void tiles_make(struct model *model)
{
    struct random random = {3};
    const uint32_t picture = texture_rig_picture(model, 16, 16, &random);
    for (int i = 0; i < TILES * TILES; i++) {
        const double x = i % TILES, z = i / (double)TILES - x / TILES;
        const double places[4][3] = {{x, 0, z}, {x, 0, z + 1}, {x + 1, 0, z + 1}, {x + 1, 0, z}};
        const double uvs[4][2] = {{x, z}, {x, z + 1}, {x + 1, z + 1}, {x + 1, z}};
        texture_rig_face(model, picture, 4, places, uvs);
        if (i % 2) model->faces[i].colour = 0x606060;
    }
}

static void mappings_of_large_scenes_are_of_one_texture(void **state)
{
    (void)state;
    struct model model = {0};
    struct mesh mesh = {0};
    struct error err = {""};
    tiles_make(&model);
    struct compiled compiled = texture_rig_compile(&model, &mesh, &core_fast);
    const struct lim_scene *scene = &compiled.scene;
    assert_true(scene->polygon_words > UINT16_MAX);
    if (!lim_check(scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(scene->texture_count, 2);
    for (size_t at = 0; at < scene->polygon_words; at += lim_record_words(scene->polygons[at])) {
        const lim_index *const end = &scene->polygons[at + lim_record_words(scene->polygons[at])];
        assert_int_equal(scene->mappings[end[-1]].texture, end[-2]);
    }
    size_t of_first = 0;
    for (size_t i = 0; i < scene->mapping_count; i++)
        of_first += scene->mappings[i].texture == 0;
    assert_in_range(of_first, 1, scene->mapping_count - 1);
    ((struct lim_mapping *)scene->mappings)[scene->polygons[lim_record_words(scene->polygons[0]) - 1]].texture ^= 1;
    assert_false(lim_check(scene, &err));
    assert_non_null(strstr(err.text, "where its mapping names"));
    compiled_free(&compiled);
    mesh_free(&mesh);
    model_free(&model);
}

/* Each of a thousand mappings is shown with three textures in turns. */
static void a_mapping_has_a_copy_for_each_texture(void **state)
{
    (void)state;
    enum { MAPPINGS = 1000, TEXTURES = 3, WORDS = 7 };
    struct encoding encoding = {0};
    encoding.word_count = MAPPINGS * TEXTURES * 2 * WORDS;
    encoding.words = calloc(encoding.word_count, sizeof *encoding.words);
    encoding.textures.mappings = calloc(MAPPINGS, sizeof *encoding.textures.mappings);
    encoding.textures.mapping_count = encoding.textures.mapping_capacity = MAPPINGS;
    assert_true(encoding.words && encoding.textures.mappings);
    for (int i = 0; i < MAPPINGS; i++)
        encoding.textures.mappings[i].at_zero_q16[0] = (uint16_t)i;
    for (int i = 0; i < MAPPINGS * TEXTURES * 2; i++) {
        lim_index *const record = &encoding.words[i * WORDS];
        record[0] = 3 | LIM_POLYGON_TEXTURE;
        record[WORDS - 2] = (lim_index)(5 + i / MAPPINGS % TEXTURES);
        record[WORDS - 1] = (lim_index)(i % MAPPINGS);
    }
    texture_name_by_mappings(&encoding);
    assert_int_equal(encoding.textures.mapping_count, MAPPINGS * TEXTURES);
    for (int i = 0; i < MAPPINGS * TEXTURES * 2; i++) {
        const lim_index *const record = &encoding.words[i * WORDS];
        const struct lim_mapping *mapping = &encoding.textures.mappings[record[WORDS - 1]];
        assert_int_equal(mapping->texture, 5 + i / MAPPINGS % TEXTURES);
        assert_int_equal(mapping->at_zero_q16[0], i % MAPPINGS);
    }
    encoding_free(&encoding);
}

static void too_many_mappings_are_refused_with_the_number(void **state)
{
    (void)state;
    struct error err = {""};
    const struct texture_arrays arrays = {.mapping_count = 65600};
    assert_false(texture_arrays_check(&arrays, &err));
    assert_string_equal(err.text, "scene too large: 65600 texture mappings, 65535 are the most (65 too many); "
                                  "--no-textures does without");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(large_scenes_show_the_same),
        cmocka_unit_test(mappings_of_large_scenes_are_of_one_texture),
        cmocka_unit_test(a_mapping_has_a_copy_for_each_texture),
        cmocka_unit_test(too_many_mappings_are_refused_with_the_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
