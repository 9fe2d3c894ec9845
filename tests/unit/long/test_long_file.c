/* SPDX-License-Identifier: MIT
 *
 * .lim files of long scenes: what is written is read again, what is damaged is refused, and nothing that is accepted
 * leads a reader or the renderer astray. */
#include "compiler/compile.h"
#include "extremes/scales_models.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/lim_bytes.h"
#include "rigs/profiles.h"
#include "rigs/texture_rig.h"
#include "scene/lim_check.h"
#include "scene/lim_image.h"
#include "scene/method.h"
#include "scene/scene_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { HEADER_B = 152, VERTEX_B = 12, PLANE_B = 20, BOX_B = 24, NODE_B = 28, DRAWN_BY_AT_B = 148, DAMAGES = 3000 };

static char folder[32];
static char path[64];
static struct compiled scene;

static int compile_it(struct model *model)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .coordinates = COORDINATES_32};
    struct error err;

    if (!compile_part(model, NULL, &options, &scene, &err)) return -1;
    model_free(model);
    snprintf(folder, sizeof folder, "/tmp/test_long_file.XXXXXX");
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/long.lim", folder);
    return 0;
}

static int setup(void **state)
{
    struct model model = {0};

    (void)state;
    scales_all[1].build(&model); /* with planes of every kind, and fractions */
    return compile_it(&model);
}

/* Mappings on planes of every kind. */
static int setup_textured(void **state)
{
    static const double slanted[4][3] = {{-0.3, 0, 0}, {0.4, 0.1, 0}, {0.3, 0.6, -0.4}};
    static const double uvs[4][2] = {{0, 1}, {1, 1}, {1, 0}};
    struct random random = {3};
    struct model model = {0};

    (void)state;
    texture_rig_room(&model, texture_rig_picture(&model, 16, 16, &random), 3);
    texture_rig_face(&model, 1, 3, slanted, uvs);
    return compile_it(&model);
}

static int teardown(void **state)
{
    (void)state;
    compiled_free(&scene);
    unlink(path);
    return rmdir(folder);
}

static uint32_t word_at(const unsigned char *bytes, size_t at_b)
{
    return bytes[at_b] | (uint32_t)bytes[at_b + 1] << 8 | (uint32_t)bytes[at_b + 2] << 16 |
           (uint32_t)bytes[at_b + 3] << 24;
}

static size_t place_b(enum lim_section section, size_t index, size_t size_b, size_t field_b)
{
    return (size_t)lim_image_section_b(scene.image, section) + index * size_b + field_b;
}

static void what_is_written_is_read(void **state)
{
    struct compiled read;
    struct error err;

    (void)state;
    free(lim_bytes_of(&scene, path));
    if (!lim_file_read(path, &read, &err)) fail_msg("%s", err.text);
    assert_int_equal(read.image_b, scene.image_b);
    struct lim_file_header *header = read.image; /* the file alone says what the compiler chose */
    assert_int_equal(header->drawn_by, 1 + scene.report.draws);
    header->drawn_by = 0;
    assert_memory_equal((char *)read.image + LIM_FILE_CRC_FROM_B, (char *)scene.image + LIM_FILE_CRC_FROM_B,
                        scene.image_b - LIM_FILE_CRC_FROM_B);
    assert_true(read.grid.is_long);
    const struct lim_long *all = lim_scene_long(&read.scene), *written = lim_scene_long(&scene.scene);
    assert_non_null(all);
    assert_null(read.scene.vertices);
    assert_null(read.scene.planes);
    assert_null(read.scene.boxes);
    assert_true(scene.scene.plane_count > 10 && scene.scene.box_count > 10 && written->fractions);
    assert_memory_equal(all->vertices, written->vertices, scene.scene.vertex_count * sizeof *all->vertices);
    assert_memory_equal(all->planes, written->planes, scene.scene.plane_count * sizeof *all->planes);
    assert_memory_equal(all->boxes, written->boxes, scene.scene.box_count * sizeof *all->boxes);
    assert_memory_equal(all->fractions, written->fractions, scene.scene.vertex_count * sizeof *all->fractions);
    compiled_free(&read);
}

/* The bytes as firmware/SCENE.md has them, whatever the host's byte order. */
static void the_file_says_32_bits_and_has_them(void **state)
{
    unsigned char *bytes = lim_bytes_of(&scene, path);
    const struct lim_long *all = lim_scene_long(&scene.scene);

    (void)state;
    assert_int_equal(word_at(bytes, 12), HEADER_B);
    assert_int_equal(word_at(bytes, 144), 32);
    assert_int_equal(word_at(bytes, HEADER_B + 5 * VERTEX_B + 8), (uint32_t)all->vertices[5].at[2]);
    assert_int_equal(word_at(bytes, place_b(SECTION_PLANES, 3, PLANE_B, 0)), (uint32_t)all->planes[3].n[0]);
    assert_int_equal(word_at(bytes, place_b(SECTION_PLANES, 3, PLANE_B, 12)), (uint32_t)all->planes[3].rest);
    assert_int_equal(word_at(bytes, place_b(SECTION_PLANES, 3, PLANE_B, 16)), all->planes[3].vertex);
    assert_int_equal(word_at(bytes, place_b(SECTION_BOXES, 2, BOX_B, 12)), all->boxes[2].half[0]);
    free(bytes);
}

static void swapping_undoes_itself(void **state)
{
    unsigned char *bytes = malloc(scene.image_b);
    struct lim_file_header header;

    (void)state;
    assert_non_null(bytes);
    memcpy(bytes, scene.image, scene.image_b);
    memcpy(&header, bytes, sizeof header);
    lim_image_swap_sections(bytes, &header);
    lim_image_swap_header(bytes);
    const int32_t x = lim_scene_long(&scene.scene)->vertices[4].at[0];
    const unsigned char *swapped = bytes + place_b(SECTION_VERTICES, 4, VERTEX_B, 0);
    for (int i = 0; i < 4; i++)
        assert_int_equal(swapped[i], (uint8_t)((uint32_t)x >> 8 * (3 - i)));
    lim_image_swap_header(bytes);
    lim_image_swap_sections(bytes, &header);
    assert_memory_equal(bytes, scene.image, scene.image_b);
    free(bytes);
}

/* Promises broken one by one, with a right checksum ------------------------------------------- */

static void assert_word_refused(size_t at_b, uint32_t value, const char *reason)
{
    unsigned char *bytes = lim_bytes_of(&scene, path);
    struct compiled read;
    struct error err = {"accepted"};

    for (int i = 0; i < 4; i++)
        bytes[at_b + (size_t)i] = (unsigned char)(value >> 8 * i);
    lim_bytes_sign(bytes, scene.image_b);
    lim_bytes_write(bytes, scene.image_b, path);
    const bool ok = lim_file_read(path, &read, &err);
    compiled_free(&read);
    assert_false(ok);
    if (strncmp(err.text, path, strlen(path)) != 0) fail_msg("'%s' does not begin with the path", err.text);
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
    free(bytes);
}

static void other_bits_than_16_and_32_are_refused(void **state)
{
    static const uint32_t others[] = {0, 1, 8, 15, 17, 31, 33, 64, 0x80000020};

    (void)state;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_word_refused(144, others[i], "damaged: coordinates of ");
    assert_word_refused(DRAWN_BY_AT_B, METHOD_DRAWS + 1, "drawn by a method that this program does not know");
    assert_word_refused(144, 16, "damaged"); /* what follows is of other sizes then */
}

static void coordinates_beyond_the_grid_are_refused(void **state)
{
    (void)state;
    for (size_t field = 0; field < 3; field++) {
        const size_t vertex_b = place_b(SECTION_VERTICES, 7, VERTEX_B, 4 * field);
        assert_word_refused(vertex_b, (1u << 29) + 1, "vertex 7: a coordinate is beyond 2^29");
        assert_word_refused(vertex_b, 0u - (1u << 29) - 1, "vertex 7: a coordinate is beyond 2^29");
        assert_word_refused(vertex_b, 0x80000000u, "vertex 7: a coordinate is beyond 2^29");
        assert_word_refused(place_b(SECTION_BOXES, 3, BOX_B, 4 * field), (1u << 29) + 1, "box 3: beyond the grid");
        assert_word_refused(place_b(SECTION_BOXES, 3, BOX_B, 12 + 4 * field), (1u << 30) + 1, "box 3: beyond the grid");
        assert_word_refused(place_b(SECTION_BOXES, 3, BOX_B, 12 + 4 * field), UINT32_MAX, "box 3: beyond the grid");
    }
}

static void planes_that_lie_are_refused(void **state)
{
    const struct lim_long *all = lim_scene_long(&scene.scene);

    (void)state;
    for (size_t field = 0; field < 3; field++) {
        const size_t normal_b = place_b(SECTION_PLANES, 2, PLANE_B, 4 * field);
        assert_word_refused(normal_b, (1u << 30) + 1, "plane 2: its normal is out of bounds");
        assert_word_refused(normal_b, 0x80000000u, "plane 2: its normal is out of bounds");
    }
    assert_word_refused(place_b(SECTION_PLANES, 2, PLANE_B, 16), scene.scene.vertex_count, "plane 2: at vertex ");
    assert_word_refused(place_b(SECTION_PLANES, 2, PLANE_B, 16), UINT32_MAX, "plane 2: at vertex ");
    struct lim_long_plane *plane = (struct lim_long_plane *)(uintptr_t)&all->planes[2]; /* the scene's own memory */
    const struct lim_long_plane kept = *plane;
    memset(plane->n, 0, sizeof plane->n);
    assert_word_refused(place_b(SECTION_PLANES, 2, PLANE_B, 0), 0, "plane 2: its normal is out of bounds");
    *plane = kept;
}

/* The first node on an axis plane, or on another. */
static size_t node_on(bool axis_plane)
{
    for (size_t i = 0; i < scene.scene.node_count; i++) {
        const lim_index plane = scene.scene.nodes[i].split.plane;
        if (plane != LIM_NO_INDEX && (plane >= LIM_PLANE_X) == axis_plane) return i;
    }
    fail();
    return 0;
}

static void nodes_that_lie_are_refused(void **state)
{
    const size_t axis = node_on(true), slanted = node_on(false);

    (void)state;
    assert_word_refused(place_b(SECTION_NODES, axis, NODE_B, 4), scene.scene.vertex_count, "its plane is number ");
    assert_word_refused(place_b(SECTION_NODES, axis, NODE_B, 4), 0x80000000u, "its plane is number ");
    assert_word_refused(place_b(SECTION_NODES, slanted, NODE_B, 0), scene.scene.plane_count, "its plane is number ");
    assert_word_refused(place_b(SECTION_NODES, slanted, NODE_B, 4), 1, "an offset beside a plane of its own");
}

/* Mappings ------------------------------------------------------------------------------------ */

enum { PLACES_B = 20, MAPPING_B = 20, MAPPING_PLANE_B = 12, MAPPING_SCALE_B = 17 };

/* The first mapping on an axis plane, or on another. */
static size_t mapping_on(bool axis_plane)
{
    for (size_t i = 0; i < scene.scene.mapping_count; i++)
        if (!(scene.scene.mappings[i].scale & LIM_MAPPING_UPRIGHT) != axis_plane) return i;
    fail();
    return 0;
}

static void mappings_that_are_written_are_read(void **state)
{
    struct compiled read;
    struct error err;
    unsigned char *bytes = lim_bytes_of(&scene, path);
    const size_t count = scene.scene.mapping_count;
    const struct lim_long_mapping *places = lim_scene_long(&scene.scene)->mappings;

    (void)state;
    assert_true(count > 6);
    assert_int_equal(word_at(bytes, 56 + 4 * SECTION_UVS), count);
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(word_at(bytes, place_b(SECTION_UVS, 5, PLACES_B, 4 * i)),
                         (uint32_t)places[5].uv[i / 2][i % 2]);
    assert_int_equal(word_at(bytes, place_b(SECTION_UVS, 5, PLACES_B, 16)),
                     (uint16_t)places[5].level_q4 | (uint32_t)places[5].bits << 16);
    if (!lim_file_read(path, &read, &err)) fail_msg("%s", err.text);
    assert_null(*read.scene.uvs);
    assert_memory_equal(lim_scene_long(&read.scene)->mappings, places, count * sizeof *places);
    assert_memory_equal(read.scene.mappings, scene.scene.mappings, count * sizeof *scene.scene.mappings);
    compiled_free(&read);
    free(bytes);
}

static void mappings_that_lie_are_refused(void **state)
{
    const size_t axis = mapping_on(true), slanted = mapping_on(false);
    const struct lim_long_mapping *places = &lim_scene_long(&scene.scene)->mappings[2];
    const uint32_t level_bits = (uint16_t)places->level_q4 | (uint32_t)places->bits << 16;

    (void)state;
    for (size_t field = 0; field < 4; field++) {
        assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 4 * field), INT32_MAX, "mapping 2: a vector is too long");
        assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 4 * field), 0x80000000u,
                            "mapping 2: a vector is too long");
    }
    assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 16), (level_bits & 0xFFFF) | 15u << 16,
                        "mapping 2: places of 15 bits");
    assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 16), (level_bits & 0xFFFF) | 63u << 16,
                        "mapping 2: places of 63 bits");
    assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 16), level_bits | 1u << 24, "mapping 2: 1 where zero is");
    assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 16), (level_bits & 0xFFFF0000u) | 1024,
                        "mapping 2: no picture has 1024 / 16 levels");
    assert_word_refused(place_b(SECTION_UVS, 2, PLACES_B, 16), (level_bits & 0xFFFF0000u) | 0x8000,
                        "mapping 2: no picture has -32768 / 16 levels");
    assert_word_refused(place_b(SECTION_MAPPINGS, axis, MAPPING_B, MAPPING_PLANE_B), scene.scene.vertex_count,
                        ": its plane is number ");
    assert_word_refused(place_b(SECTION_MAPPINGS, axis, MAPPING_B, MAPPING_PLANE_B), UINT32_MAX,
                        ": its plane is number ");
    assert_word_refused(place_b(SECTION_MAPPINGS, slanted, MAPPING_B, MAPPING_PLANE_B), scene.scene.plane_count,
                        ": its plane is number ");
    assert_word_refused(place_b(SECTION_MAPPINGS, axis, MAPPING_B, MAPPING_SCALE_B - 1), 0xC000u,
                        "there is no such axis");
    assert_word_refused(56 + 4 * SECTION_UVS, 0, "damaged: the header contradicts itself");
    assert_word_refused(56 + 4 * SECTION_UVS, scene.scene.mapping_count - 1, "damaged: the header contradicts itself");
}

/* Damage at random ---------------------------------------------------------------------------- */

static void draw_everything(const struct compiled *read, struct random *random)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    const struct simulator_setup setup = {.w_px = 24, .h_px = 18, .core = profiles[random_u64(random) % count]};
    struct simulator simulator;
    struct error err;

    if (!simulator_init(&simulator, &read->scene, &setup, &err)) return;
    for (int k = 0; k < 3; k++) {
        struct lim_camera camera = {.tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28};
        const int64_t reach = INT64_C(1) << random_in(random, 0, 29);
        for (int i = 0; i < 3; i++)
            camera.origin[i] = (int32_t)random_in(random, -reach, reach);
        camera.yaw = (uint32_t)random_u64(random);
        camera.pitch = (uint32_t)random_u64(random);
        camera.near_q8 = INT32_C(1) << random_in(random, 0, 24);
        (void)simulator_frame(&simulator, &camera, &err);
    }
    simulator_free(&simulator);
}

static void damage_is_refused_or_harmless(void **state)
{
    struct random random = {181};
    unsigned char *whole = lim_bytes_of(&scene, path), *bytes = malloc(scene.image_b);
    int accepted = 0;

    (void)state;
    assert_non_null(bytes);
    for (int i = 0; i < effort(DAMAGES); i++) {
        struct compiled read;
        struct error err;
        memcpy(bytes, whole, scene.image_b);
        for (int64_t changes = random_in(&random, 1, 3); changes > 0; changes--)
            bytes[random_in(&random, 24, (int64_t)scene.image_b - 1)] = (unsigned char)random_u64(&random);
        lim_bytes_sign(bytes, scene.image_b);
        lim_bytes_write(bytes, scene.image_b, path);
        if (!lim_file_read(path, &read, &err)) continue;
        accepted++;
        draw_everything(&read, &random);
        compiled_free(&read);
    }
    printf("# %d of %d damaged files are accepted, and drawn\n", accepted, effort(DAMAGES));
    assert_in_range(accepted, effort(DAMAGES) / 20, effort(DAMAGES) * 19 / 20);
    free(whole);
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),
        cmocka_unit_test(the_file_says_32_bits_and_has_them),
        cmocka_unit_test(swapping_undoes_itself),
        cmocka_unit_test(other_bits_than_16_and_32_are_refused),
        cmocka_unit_test(coordinates_beyond_the_grid_are_refused),
        cmocka_unit_test(planes_that_lie_are_refused),
        cmocka_unit_test(nodes_that_lie_are_refused),
        cmocka_unit_test(damage_is_refused_or_harmless),
    };

    const struct CMUnitTest textured[] = {
        cmocka_unit_test(mappings_that_are_written_are_read),
        cmocka_unit_test(swapping_undoes_itself),
        cmocka_unit_test(mappings_that_lie_are_refused),
        cmocka_unit_test(damage_is_refused_or_harmless),
    };

    return cmocka_run_group_tests_name("files of long scenes", tests, setup, teardown) ||
           cmocka_run_group_tests_name("files of long scenes with textures", textured, setup_textured, teardown);
}
