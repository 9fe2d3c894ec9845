/* SPDX-License-Identifier: MIT
 *
 * Scenes as C source: built by the C compiler they hold what the compiled scene holds. */
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/scene_files.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/test_c_source.XXXXXX";

static int setup(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    return rmdir(folder);
}

static struct compiled compile_boxes(unsigned count, double yaw, double tolerance)
{
    struct mesh mesh = mesh_rig(3000.0);
    for (unsigned i = 0; i < count; i++) {
        const double centre_m[3] = {1.5 * i, 0.0, 0.0}, half_m[3] = {1.0, 2.0, 0.5 + i * 0.1};
        mesh_rig_box(&mesh, centre_m, half_m, yaw * i, 0.0);
    }
    mesh.grid.origin_m[0] = 1.0 / 3.0;
    struct compiled scene = mesh_rig_compile(&mesh, "auto", tolerance);
    mesh_rig_free(&mesh);
    return scene;
}

static void in_folder(const char *file, char path[128])
{
    snprintf(path, 128, "%s/%s", folder, file);
}

static void build_with(const char *name, const char *symbol, const char *flag)
{
    const char *cc = getenv("CC");
    char command[768];
    snprintf(command, sizeof command,
             "printf '#include \"%s.h\"\nextern const void *const shown;\nconst void *const shown = &%s;\n' | "
             "%s -std=c11 -Wall -Wextra -Wconversion -Wundef -Wmissing-declarations -Werror -Ifirmware -I%s %s "
             "-DLIM_CONFIG='\"%s.h\"' -shared -fPIC -o '%s/scene.so' '%s/%s.c' -x c -",
             name, symbol, cc ? cc : "cc", folder, flag, name, folder, folder, name);
    assert_int_equal(system(command), 0);
}

/* Builds NAME.c with all warnings, as configuration of itself too: as narrow as it is, then with this program's own
 * indices, and loads that. */
static void *build(const char *name, const char *symbol)
{
    char library[128];
    build_with(name, symbol, "");
    build_with(name, symbol, "-DLIM_HAS_WIDE=1");
    in_folder("scene.so", library);
    void *handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (!handle) fail_msg("%s", dlerror());
    unlink(library);
    return handle;
}

static void assert_same_array(const void *built, const void *compiled, size_t count, size_t size_b)
{
    assert_true((built != NULL) == (count > 0));
    if (count) assert_memory_equal(built, compiled, count * size_b);
}

static void assert_same_scene(const struct lim_scene *built, const struct lim_scene *compiled)
{
    const size_t counts_b = offsetof(struct lim_scene, limits) - offsetof(struct lim_scene, vertex_count);
    assert_same_array(built->vertices, compiled->vertices, compiled->vertex_count, sizeof *built->vertices);
    assert_same_array(built->nodes, compiled->nodes, compiled->node_count, sizeof *built->nodes);
    assert_same_array(built->planes, compiled->planes, compiled->plane_count, sizeof *built->planes);
    assert_same_array(built->exact, compiled->exact, compiled->exact_count, sizeof *built->exact);
    assert_same_array(built->boxes, compiled->boxes, compiled->box_count, sizeof *built->boxes);
    assert_same_array(built->polygons, compiled->polygons, compiled->polygon_words, sizeof *built->polygons);
    assert_memory_equal(&built->vertex_count, &compiled->vertex_count, counts_b);
    assert_memory_equal(&built->limits, &compiled->limits, sizeof built->limits);
}

static void remove_source(const char *name)
{
    char file[64], path[128];
    for (int i = 0; i < 2; i++) {
        snprintf(file, sizeof file, "%s.%c", name, "ch"[i]);
        in_folder(file, path);
        assert_int_equal(unlink(path), 0);
    }
}

static void assert_round_trip(const struct compiled *scene, const char *name, const char *symbol)
{
    char path[128];
    struct error err;
    in_folder(name, path);
    if (!c_source_write(scene, path, &err)) fail_msg("%s", err.text);
    void *handle = build(name, symbol);
    const struct lim_scene *const *built = dlsym(handle, "shown");
    if (!built) fail_msg("%s", dlerror());
    assert_same_scene(*built, &scene->scene);
    dlclose(handle);
    remove_source(name);
}

static void a_scene_survives_as_c_source(void **state)
{
    (void)state;
    struct compiled scene = compile_boxes(4, 0.3, 0.5);
    assert_true(scene.scene.plane_count > 0);
    assert_round_trip(&scene, "hall", "hall_scene");
    compiled_free(&scene);
}

static void exact_planes_survive_too(void **state)
{
    (void)state;
    struct compiled scene = compile_boxes(4, 0.3, 0.0);
    assert_true(scene.scene.exact_count > 0);
    assert_round_trip(&scene, "hall", "hall_scene");
    compiled_free(&scene);
}

static void empty_arrays_are_left_out(void **state)
{
    (void)state;
    struct compiled scene = compile_boxes(1, 0.0, 0.5);
    assert_int_equal(scene.scene.plane_count, 0);
    assert_round_trip(&scene, "box", "box_scene");
    compiled_free(&scene);
}

static void any_file_name_makes_a_symbol(void **state)
{
    (void)state;
    struct compiled scene = compile_boxes(1, 0.0, 0.5);
    assert_round_trip(&scene, "2nd-floor.v1", "scene_2nd_floor_v1_scene");
    assert_round_trip(&scene, "limbo", "limbo_scene");
    compiled_free(&scene);
}

/* lim_frame_begin() is the renderer's, and so is LIM_MEMORY. */
static void names_of_the_renderer_are_not_taken(void **state)
{
    (void)state;
    struct compiled scene = compile_boxes(1, 0.0, 0.5);
    assert_round_trip(&scene, "lim", "scene_lim_scene");
    assert_round_trip(&scene, "lim-frame", "scene_lim_frame_scene");
    assert_round_trip(&scene, "LIM", "scene_LIM_scene");
    compiled_free(&scene);
}

static void names_that_cannot_be_are_refused(void **state)
{
    (void)state;
    struct compiled scene = compile_boxes(1, 0.0, 0.5);
    struct error err;
    char path[128], name[100];
    in_folder("", path);
    assert_false(c_source_write(&scene, path, &err));
    assert_non_null(strstr(err.text, "names a folder"));
    memset(name, 'x', sizeof name);
    name[99] = '\0';
    assert_false(c_source_write(&scene, name, &err));
    assert_non_null(strstr(err.text, "too long"));
    compiled_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_survives_as_c_source),        cmocka_unit_test(exact_planes_survive_too),
        cmocka_unit_test(empty_arrays_are_left_out),           cmocka_unit_test(any_file_name_makes_a_symbol),
        cmocka_unit_test(names_of_the_renderer_are_not_taken), cmocka_unit_test(names_that_cannot_be_are_refused),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
