/* SPDX-License-Identifier: MIT
 *
 * Accuracy sees what is wrong: a renderer that lies about a plane or misplaces a vertex is found out.
 * And the table of it all: the front, CSV. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "measure/measure_table.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 96, FRAMES = 4 };

/* A scene and cameras around it. */
struct rig {
    struct measure_source source;
    struct compiled scene;
    struct camera_path path;
    struct lens lens;
};

static int set_up(void **state)
{
    static struct rig rig;
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};
    struct error err;

    rig = (struct rig){0};
    if (!measure_source_read(&rig.source, "tests/models/order.obj", &options, SIDE_PX, SIDE_PX, &err) ||
        !compile_mesh(&rig.source.mesh, &options, &rig.scene, &err) ||
        !lens_init(&rig.lens, 60, 0.1, SIDE_PX, SIDE_PX, &err) ||
        !camera_path_orbit(&rig.scene, &rig.lens, FRAMES, &rig.path, &err))
        fail_msg("%s", err.text);
    *state = &rig;
    return 0;
}

static int tear_down(void **state)
{
    struct rig *rig = *state;

    measure_source_free(&rig->source);
    compiled_free(&rig->scene);
    camera_path_free(&rig->path);
    return 0;
}

static struct accuracy accuracy_of(struct rig *rig, const struct core *core)
{
    const struct measure_views views = {.path = &rig->path, .lens = &rig->lens, .w_px = SIDE_PX, .h_px = SIDE_PX};
    const struct measure_candidate candidate = {core, &rig->scene};
    struct accuracy accuracy;
    struct error err;

    if (!measure_accuracy(&rig->source, &views, &candidate, 1, &accuracy, &err)) fail_msg("%s", err.text);
    return accuracy;
}

static void a_renderer_is_nearly_right(void **state)
{
    const struct accuracy fine = accuracy_of(*state, &core_fine);

    assert_int_equal(fine.pixels.frames, FRAMES);
    assert_int_equal(fine.pixels.total.holes, 0);
    assert_true(compare_wrong_percent(&fine.pixels.total) < 0.2);
    assert_true(fine.vertices > 0);
    assert_true(accuracy_vertex_rms_px(&fine) > 0 && fine.vertex_max_px < 0.1);
    assert_true(fine.vertex_max_px >= accuracy_vertex_rms_px(&fine));
    assert_int_equal(fine.sides, FRAMES * ((struct rig *)*state)->scene.scene.node_count);
    assert_int_equal(fine.sides_wrong, 0);
}

static void whole_pixels_are_worse_than_parts(void **state)
{
    const struct accuracy draft = accuracy_of(*state, &core_draft), fine = accuracy_of(*state, &core_fine);

    assert_true(accuracy_vertex_rms_px(&draft) > 0.2 && draft.vertex_max_px < 0.75);
    assert_true(draft.pixels.total.wrong > fine.pixels.total.wrong);
}

static bool project_a_pixel_off(void *lim, lim_index vertex, double at_px[2])
{
    if (!core_fine.project(lim, vertex, at_px)) return false;
    at_px[0] += 3.0;
    at_px[1] -= 4.0;
    return true;
}

static void a_misplaced_vertex_is_found_out(void **state)
{
    struct core off = core_fine;

    off.project = project_a_pixel_off;
    const struct accuracy accuracy = accuracy_of(*state, &off);
    assert_true(fabs(accuracy_vertex_rms_px(&accuracy) - 5.0) < 0.05);
    assert_true(fabs(accuracy.vertex_max_px - 5.0) < 0.1);
}

static int8_t side_of_a_liar(const struct lim_scene *scene, const struct lim_plane_ref *ref,
                             const struct lim_camera *camera)
{
    const int8_t side = core_fine.eye_side(scene, ref, camera);
    if (ref != &scene->nodes[0].split) return side;
    return side ? (int8_t)-side : 1;
}

static void a_wrong_side_is_found_out(void **state)
{
    struct core liar = core_fine;

    liar.eye_side = side_of_a_liar;
    assert_int_equal(accuracy_of(*state, &liar).sides_wrong, FRAMES);
}

/* Moves every vertex of the model but not of the scene. */
static void the_model_is_the_measure_and_not_the_scene(void **state)
{
    struct rig *rig = *state;
    const struct accuracy before = accuracy_of(rig, &core_fine);

    for (size_t i = 0; i < rig->source.mesh.point_count; i++)
        rig->source.mesh.points[i][1] += 0.4 / rig->scene.grid.units_per_m;
    const struct accuracy after = accuracy_of(rig, &core_fine);
    assert_int_equal(after.vertices, before.vertices);
    assert_true(after.vertex_sum2_px > before.vertex_sum2_px);
}

/* Tables ------------------------------------------------------------------------------------- */

static size_t fields(const char *line)
{
    size_t count = 1;
    bool quoted = false;
    for (; *line && *line != '\n'; line++) {
        quoted ^= *line == '"';
        count += *line == ',' && !quoted;
    }
    return count;
}

static void print(const struct measure_table *table, void (*write)(const struct measure_table *, FILE *), char *text,
                  size_t text_b)
{
    FILE *file = tmpfile();
    assert_non_null(file);
    write(table, file);
    rewind(file);
    text[fread(text, 1, text_b - 1, file)] = '\0';
    fclose(file);
}

static struct measure_row row(const struct core *core, size_t wrong, double instructions)
{
    struct measure_row row = {.core = core};
    row.accuracy.pixels.total = (struct compare_counts){.pixels = 1000, .wrong = wrong};
    row.costs[0] = (struct cost){.frames = 1, .mean = instructions, .vertex = NAN, .side = 20, .stage_count = 1};
    strcpy(row.costs[0].stages[0].name, "span");
    return row;
}

static void the_table_names_what_is_dominated(void **state)
{
    struct measure_row rows[] = {row(&core_draft, 9, 100), row(&core_fast, 4, 120), row(&core_fine, 4, 130)};
    const struct measure_cpu *cpus[] = {measure_cpu_find("m4")};
    struct measure_table table = {"rooms", 8, 8, {16, 0.5, 100.0, 0.25}, cpus, 1, NULL, rows, 3, {.count = 0}, NULL};
    char text[8192];

    (void)state;
    measure_table_judge(&table);
    assert_null(rows[0].dominated_by[0]);
    assert_null(rows[1].dominated_by[0]);
    assert_ptr_equal(rows[2].dominated_by[0], &core_fast);
    print(&table, measure_table_markdown, text, sizeof text);
    assert_non_null(strstr(text, "| dominated by fast |"));
    assert_non_null(strstr(text, "## Cortex-M4F"));
    assert_non_null(strstr(text,
                           "\nScales: the model is 100 m long, its smallest surface 0.25 m, 1 to 400. Coordinates "
                           "have 16 bits, a unit is 0.5 m.\n"));
}

static void csv_has_as_many_fields_in_every_line(void **state)
{
    struct measure_row rows[] = {row(&core_draft, 9, 100), row(&core_fast, 4, 120)};
    const struct measure_cpu *cpus[] = {measure_cpu_find("m4")};
    struct measure_table table = {"a \"big\", blue room", 8,   8, {32, 0.001, 5000.0, 0.0}, cpus, 1, NULL, rows, 2,
                                  {.count = 0},           NULL};
    char text[4096];

    (void)state;
    for (table.cpu_count = 0; table.cpu_count < 2; table.cpu_count++) {
        print(&table, measure_table_csv, text, sizeof text);
        const size_t wanted = fields(text);
        size_t lines = 0;
        for (char *line = text; *line; line = strchr(line, '\n') + 1, lines++)
            assert_int_equal(fields(line), wanted);
        assert_int_equal(lines, 3);
        assert_non_null(strstr(text, "\n\"a \"\"big\"\", blue room\",8,8,"));
    }
    print(&table, measure_table_stages_csv, text, sizeof text);
    assert_non_null(strstr(text, ",draft,"));
}

#define WITH_RIG(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_RIG(a_renderer_is_nearly_right),
        WITH_RIG(whole_pixels_are_worse_than_parts),
        WITH_RIG(a_misplaced_vertex_is_found_out),
        WITH_RIG(a_wrong_side_is_found_out),
        WITH_RIG(the_model_is_the_measure_and_not_the_scene),
        cmocka_unit_test(the_table_names_what_is_dominated),
        cmocka_unit_test(csv_has_as_many_fields_in_every_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
