/* SPDX-License-Identifier: MIT
 *
 * model_import(): order, colours and transforms of what it accepts, and the line that each bad file
 * is refused with. The models are tests/models/. */
#include "model/model.h"
#include "readers/import.h"
#include "readers/model_import.h"
#include "rigs/cmocka_ready.h"

#include <fcntl.h>
#include <gd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct model imported(const char *path)
{
    struct model model;
    struct error err = {""};
    bool ok = model_import(path, &model, &err);
    if (!ok) fail_msg("%s", err.text);
    return model;
}

static const double *corner(const struct model *model, size_t face, uint32_t k)
{
    return model->points[model->corners[model->faces[face].first + k]];
}

static void assert_corner(const struct model *model, size_t face, uint32_t k, double x, double y, double z)
{
    const double *p = corner(model, face, k);
    if (p[0] != x || p[1] != y || p[2] != z)
        fail_msg("face %zu, corner %u is (%g, %g, %g)", face + 1, k, p[0], p[1], p[2]);
}

static void faces_keep_the_order_of_the_file(void **state)
{
    (void)state;
    struct model model = imported("tests/models/order.obj");
    const uint32_t colours[5] = {0xFF0000, 0x008000, 0xFF0000, 0xFF0000, 0x008000};
    assert_int_equal(model.face_count, 5);
    for (size_t i = 0; i < 5; i++) {
        assert_int_equal(model.faces[i].colour, colours[i]);
        assert_int_equal(model.faces[i].count, 3);
        assert_corner(&model, i, 0, (double)i + 1, 0, 0);
        assert_corner(&model, i, 1, (double)i + 1, 1, 0);
        assert_corner(&model, i, 2, (double)i + 1, 0, 1);
    }
    model_free(&model);
}

static void quads_stay_quads_and_are_light_grey_without_a_material(void **state)
{
    (void)state;
    struct model model = imported("tests/models/square.obj");
    assert_int_equal(model.face_count, 1);
    assert_int_equal(model.faces[0].count, 4);
    assert_int_equal(model.faces[0].colour, 0xC8C8C8);
    assert_false(model.faces[0].two_sided);
    model_free(&model);
}

static void corner_colours_are_averaged(void **state)
{
    (void)state;
    struct model model = imported("tests/models/corner_colours.obj");
    assert_int_equal(model.faces[0].colour, 0x555555);
    model_free(&model);
}

static void a_mirroring_node_turns_its_faces_round(void **state)
{
    (void)state;
    struct model model = imported("tests/models/nodes.gltf");
    assert_int_equal(model.face_count, 2);
    assert_corner(&model, 0, 0, 10, 0, 0);
    assert_corner(&model, 0, 1, 11, 0, 0);
    assert_corner(&model, 0, 2, 10, 1, 0);
    assert_corner(&model, 1, 0, 10, 6, 0);
    assert_corner(&model, 1, 1, 8, 5, 0);
    assert_corner(&model, 1, 2, 10, 5, 0);
    model_free(&model);
}

static void linear_base_colours_become_srgb_and_both_sides_are_asked_for(void **state)
{
    (void)state;
    struct model model = imported("tests/models/nodes.gltf");
    assert_int_equal(model.faces[0].colour, 0xFFBC00); /* 0.5 of the light is 188 in sRGB */
    assert_true(model.faces[0].two_sided);
    model_free(&model);
}

static void assert_transparencies(const char *path, const uint8_t *expected, size_t count, size_t clamped)
{
    struct model model = imported(path);
    assert_int_equal(model.face_count, count);
    for (size_t i = 0; i < count; i++)
        assert_int_equal(model.faces[i].transparency, expected[i]);
    assert_int_equal(model.alpha_clamped, clamped);
    model_free(&model);
}

/* d 0.5, Tr 0.75, d 1.5, d -0.5, nothing. */
static void opacities_of_mtl_are_taken_and_clamped(void **state)
{
    const uint8_t expected[] = {128, 191, 0, 255, 0};
    (void)state;
    assert_transparencies("tests/models/opacity.obj", expected, sizeof expected, 2);
}

/* The alpha 0.4: BLEND, OPAQUE, MASK below the cutoff 0.5, MASK above 0.3, BLEND times the vertices' mean 0.5, OPAQUE.
 */
static void alpha_modes_of_gltf_decide_what_alpha_means(void **state)
{
    const uint8_t expected[] = {153, 0, 255, 0, 204, 0};
    (void)state;
    assert_transparencies("tests/models/alpha_modes.gltf", expected, sizeof expected, 0);
}

static void benchmark_scenes_import_whole(void **state)
{
    (void)state;
    const char *const paths[3] = {"sim/scenes/rooms.obj", "sim/scenes/rooms-tilted.obj", "sim/scenes/teapot.obj"};
    const size_t faces[3] = {1392, 1392, 992};
    for (int i = 0; i < 3; i++) {
        struct model model = imported(paths[i]);
        assert_int_equal(model.face_count, faces[i]);
        model_free(&model);
    }
}

static void assert_refused(const char *path, const char *line)
{
    struct model model;
    struct error err = {""};
    assert_false(model_import(path, &model, &err));
    assert_string_equal(err.text, line);
    assert_null(model.points);
    assert_null(model.corners);
    assert_null(model.faces);
}

static void opacities_that_are_no_numbers_are_refused(void **state)
{
    (void)state;
    assert_refused("tests/models/opacity_nan.obj", "opacity_nan.mtl:5: 'nan' is not a decimal number up to 3.4e38");
}

static void files_that_are_no_models_are_refused(void **state)
{
    (void)state;
    assert_refused("tests/models/missing.obj", "tests/models/missing.obj: No such file or directory");
    assert_refused("tests/models", "tests/models: is a folder, not a file");
    assert_refused("/dev/null", "/dev/null: is a device, not a regular file");
    assert_refused("tests/models/empty.obj", "tests/models/empty.obj: the file is empty");
    assert_refused("tests/models/text.obj", "tests/models/text.obj: there are no faces in it");
    assert_refused("tests/models/junk.xyzzy", "tests/models/junk.xyzzy: not in a format that the importer knows; glTF, "
                                              "OBJ, PLY, STL and others are: limner formats");
}

static void models_without_faces_are_refused(void **state)
{
    (void)state;
    assert_refused("tests/models/no_faces.obj", "tests/models/no_faces.obj: there are no faces in it");
}

static void coordinates_that_are_no_numbers_are_refused(void **state)
{
    (void)state;
    assert_refused("tests/models/nan.obj", "tests/models/nan.obj:4: 'nan' is not a decimal number up to 3.4e38");
    assert_refused("tests/models/infinite.obj",
                   "tests/models/infinite.obj:4: 'inf' is not a decimal number up to 3.4e38");
}

static void indices_out_of_range_are_refused(void **state)
{
    (void)state;
    assert_refused("tests/models/index_high.obj",
                   "tests/models/index_high.obj:5: vertex index 4 of a face is out of range, there are 3");
    assert_refused("tests/models/index_low.obj",
                   "tests/models/index_low.obj:5: vertex index -4 of a face is out of range, there are 3");
    assert_refused("tests/models/index_zero.obj",
                   "tests/models/index_zero.obj:5: vertex index 0 of a face is out of range, there are 3");
    assert_refused("tests/models/index_high.ply",
                   "tests/models/index_high.ply: face 2: vertex index 4 is out of range, there are 4");
    assert_refused("tests/models/index_high.gltf",
                   "tests/models/index_high.gltf: vertex indices of some faces are out of range");
}

/* Many pictures of the most pixels that there may be take more time than a file of some bytes is given. */
static void what_takes_too_long_is_given_up(void **state)
{
    (void)state;
    enum { PICTURES = 48 };
    char folder[] = "/tmp/limner-import-XXXXXX", path[64], expected[256];
    assert_non_null(mkdtemp(folder));
    gdImagePtr picture = gdImageCreate(4096, 4096);
    gdImageColorAllocate(picture, 255, 0, 0);
    int size_b;
    void *bytes = gdImagePngPtr(picture, &size_b);
    gdImageDestroy(picture);
    snprintf(path, sizeof path, "%s/a.mtl", folder);
    FILE *materials = fopen(path, "w");
    snprintf(path, sizeof path, "%s/a.obj", folder);
    FILE *model = fopen(path, "w");
    fprintf(model, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n");
    for (int i = 0; i < PICTURES; i++) {
        fprintf(materials, "newmtl m%d\nmap_Kd %d.png\n", i, i);
        fprintf(model, "usemtl m%d\nf 1/1 2/1 3/1\n", i);
        snprintf(path, sizeof path, "%s/%d.png", folder, i);
        FILE *file = fopen(path, "wb");
        fwrite(bytes, 1, (size_t)size_b, file);
        fclose(file);
    }
    fclose(materials);
    fclose(model);
    gdFree(bytes);
    snprintf(path, sizeof path, "%s/a.obj", folder);
    snprintf(expected, sizeof expected, "%s: damaged, truncated or too much: the importer finds no end in it (3 s)",
             path);
    assert_refused(path, expected);
    for (int i = 0; i < PICTURES; i++) {
        snprintf(path, sizeof path, "%s/%d.png", folder, i);
        assert_int_equal(unlink(path), 0);
    }
    snprintf(path, sizeof path, "%s/a.mtl", folder);
    assert_int_equal(unlink(path), 0);
    snprintf(path, sizeof path, "%s/a.obj", folder);
    assert_int_equal(unlink(path), 0);
    assert_int_equal(rmdir(folder), 0);
}

/* The importer library never returns from this one. */
static void a_header_without_an_end_is_refused(void **state)
{
    (void)state;
    assert_refused("tests/models/truncated.ply", "tests/models/truncated.ply: truncated: it ends within its header");
}

/* Every prefix of a file is either a model or refused with one line that names it. */
static void truncated_files_never_do_harm(void **state)
{
    (void)state;
    char text[512], folder[] = "/tmp/limner-test-XXXXXX", path[64];
    FILE *whole = fopen("tests/models/order.obj", "r");
    assert_non_null(whole);
    size_t size_b = fread(text, 1, sizeof text, whole);
    fclose(whole);
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/cut.obj", folder);
    int file = open(path, O_WRONLY | O_CREAT, 0600);
    assert_true(file >= 0);
    for (size_t length = 1; length <= size_b; length++) {
        struct model model;
        struct error err = {""};
        assert_int_equal(pwrite(file, &text[length - 1], 1, (off_t)length - 1), 1);
        if (import_model(path, &model, &err))
            assert_true(model.face_count >= 1 && model.face_count <= 5);
        else
            assert_true(strstr(err.text, path) == err.text && !strchr(err.text, '\n'));
        model_free(&model);
    }
    close(file);
    unlink(path);
    rmdir(folder);
}

/* In this process, where a sanitizer sees it: what the child process leaves to its end. */
static void importing_leaks_nothing(void **state)
{
    (void)state;
    const char *const paths[3] = {"tests/models/order.obj", "tests/models/nodes.gltf", "tests/models/nan.obj"};
    for (int i = 0; i < 3; i++) {
        struct model model;
        struct error err;
        assert_int_equal(import_model(paths[i], &model, &err), i < 2);
        model_free(&model);
    }
}

static void errors_are_one_line(void **state)
{
    (void)state;
    struct error err;
    assert_false(error_set(&err, "%s: bad\r\n\tthing", "a\nb"));
    assert_string_equal(err.text, "a b: bad   thing");
    assert_false(error_prefix(&err, "file\n"));
    assert_string_equal(err.text, "file : a b: bad   thing");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_keep_the_order_of_the_file),
        cmocka_unit_test(quads_stay_quads_and_are_light_grey_without_a_material),
        cmocka_unit_test(corner_colours_are_averaged),
        cmocka_unit_test(a_mirroring_node_turns_its_faces_round),
        cmocka_unit_test(linear_base_colours_become_srgb_and_both_sides_are_asked_for),
        cmocka_unit_test(opacities_of_mtl_are_taken_and_clamped),
        cmocka_unit_test(alpha_modes_of_gltf_decide_what_alpha_means),
        cmocka_unit_test(opacities_that_are_no_numbers_are_refused),
        cmocka_unit_test(benchmark_scenes_import_whole),
        cmocka_unit_test(files_that_are_no_models_are_refused),
        cmocka_unit_test(models_without_faces_are_refused),
        cmocka_unit_test(coordinates_that_are_no_numbers_are_refused),
        cmocka_unit_test(indices_out_of_range_are_refused),
        cmocka_unit_test(a_header_without_an_end_is_refused),
        cmocka_unit_test(what_takes_too_long_is_given_up),
        cmocka_unit_test(truncated_files_never_do_harm),
        cmocka_unit_test(importing_leaks_nothing),
        cmocka_unit_test(errors_are_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
