/* SPDX-License-Identifier: MIT
 *
 * The simulator on a scene small enough to write by hand, a room of six walls: panel and plain
 * memory show the same, face numbers agree with the colours and with the reference picture. */
#include "accuracy/compare.h"
#include "render/ids.h"
#include "rigs/cmocka_ready.h"

#include <stdlib.h>
#include <string.h>

enum { WALLS = 6, WALL_WORDS = LIM_POLYGON_HEAD_WORDS + 4, HALF_UNITS = 1000 };

/* Wall w lies at x, y, z = -1000, then x, y, z = 1000; corner c has its bits 0, 1, 2 as x, y, z. */
static const lim_index WALL_CORNERS[WALLS][4] = {{0, 2, 6, 4}, {0, 4, 5, 1}, {0, 1, 3, 2},
                                                 {1, 5, 7, 3}, {2, 3, 7, 6}, {4, 6, 7, 5}};

static uint16_t wall_colour(size_t wall)
{
    return (uint16_t)(0x1234 * (wall + 1));
}

struct room {
    struct lim_vertex vertices[8];
    struct lim_node nodes[WALLS];
    lim_index polygons[WALLS * WALL_WORDS];
    uint32_t faces[WALLS]; /* 11, 12, ... */
    struct compiled compiled;
};

/* Every plane has the whole room on one side, so the tree is a chain. */
static void room_wall(struct room *room, uint16_t wall)
{
    bool is_low = wall < 3;
    lim_index next = wall + 1 < WALLS ? (lim_index)(wall + 1) : LIM_NO_INDEX, run = (lim_index)(wall * WALL_WORDS);
    lim_index *words = &room->polygons[run];
    room->nodes[wall] = (struct lim_node){.split.plane = (lim_index)(LIM_PLANE_X + wall % 3),
                                          .split.offset = (int16_t)(is_low ? -HALF_UNITS : HALF_UNITS),
                                          .front = is_low ? next : LIM_NO_INDEX,
                                          .back = is_low ? LIM_NO_INDEX : next,
                                          .front_run = is_low ? run : LIM_NO_INDEX,
                                          .back_run = is_low ? LIM_NO_INDEX : run,
                                          .box = LIM_NO_INDEX};
    words[0] = 4 | LIM_POLYGON_LAST;
    words[1] = wall_colour(wall);
    memcpy(words + LIM_POLYGON_HEAD_WORDS, WALL_CORNERS[wall], sizeof WALL_CORNERS[wall]);
    room->faces[wall] = 11u + wall;
}

static void room_init(struct room *room)
{
    memset(room, 0, sizeof *room);
    for (int c = 0; c < 8; c++)
        room->vertices[c] = (struct lim_vertex){(int16_t)(c & 1 ? HALF_UNITS : -HALF_UNITS),
                                                (int16_t)(c & 2 ? HALF_UNITS : -HALF_UNITS),
                                                (int16_t)(c & 4 ? HALF_UNITS : -HALF_UNITS)};
    for (uint16_t wall = 0; wall < WALLS; wall++)
        room_wall(room, wall);
    room->compiled = (struct compiled){
        .scene = {.vertices = room->vertices,
                  .nodes = room->nodes,
                  .polygons = room->polygons,
                  .vertex_count = 8,
                  .node_count = WALLS,
                  .polygon_words = WALLS * WALL_WORDS,
                  .polygon_count = WALLS,
                  .background = 0xF81F,
                  .limits = {.depth = WALLS, .vertices = 4, .retained_cells = 512, .gaps = 512, .active = 16}},
        .grid = {.units_per_m = 100.0},
        .faces = room->faces};
}

/* A view from within the room, the same for the same seed. */
static struct viewpoint random_viewpoint(unsigned seed)
{
    struct viewpoint viewpoint = {.line = 1};
    srand(seed);
    for (int i = 0; i < 3; i++) {
        viewpoint.eye_m[i] = rand() % 1800 / 100.0 - 9.0;
        viewpoint.target_m[i] = rand() % 4000 / 100.0 - 20.0;
    }
    return viewpoint;
}

static struct lim_camera make_camera(const struct viewpoint *viewpoint, const struct lens *lens,
                                     const struct room *room)
{
    struct viewpoint copy = *viewpoint;
    struct camera_path path = {.name = "test.cam", .frames = &copy, .count = 1};
    struct lim_camera camera;
    struct error err;
    assert_true(camera_path_to_camera(&path, 0, lens, &room->compiled.grid, &camera, &err));
    return camera;
}

static struct lens make_lens(unsigned w_px, unsigned h_px)
{
    struct lens lens;
    struct error err;
    assert_true(lens_init(&lens, 75.0, 0.1, w_px, h_px, &err));
    return lens;
}

static uint16_t *picture_by(const struct room *room, enum simulator_panel panel, enum lim_method method, unsigned w_px,
                            unsigned h_px, const struct lim_camera *camera)
{
    struct simulator simulator;
    struct error err;
    size_t size_b = (size_t)w_px * h_px * sizeof(uint16_t);
    uint16_t *pixels = malloc(size_b);
    assert_non_null(pixels);
    assert_true(simulator_init(&simulator, &room->compiled.scene,
                               &(struct simulator_setup){w_px, h_px, method, panel, NULL}, &err));
    assert_int_equal(simulator.board != NULL, panel == SIMULATOR_PANEL);
    assert_true(simulator_frame(&simulator, camera, &err));
    memcpy(pixels, simulator.pixels, size_b);
    simulator_free(&simulator);
    return pixels;
}

static uint16_t *picture(const struct room *room, enum simulator_panel panel, enum lim_method method, unsigned w_px,
                         unsigned h_px, unsigned seed)
{
    struct lens lens = make_lens(w_px, h_px);
    struct viewpoint viewpoint = random_viewpoint(seed);
    struct lim_camera camera = make_camera(&viewpoint, &lens, room);

    return picture_by(room, panel, method, w_px, h_px, &camera);
}

/* Tests -------------------------------------------------------------------------------------- */

static void panel_and_memory_show_the_same_by_both_methods(void **state)
{
    (void)state;
    static const unsigned sizes[][2] = {{240, 240}, {240, 320}, {135, 240}, {1, 1}, {3, 7}};
    struct room room;
    room_init(&room);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        unsigned w_px = sizes[i][0], h_px = sizes[i][1], seed = (unsigned)i;
        uint16_t *expected = picture(&room, SIMULATOR_MEMORY, LIM_NEAREST_FIRST, w_px, h_px, seed);
        for (int panel = SIMULATOR_PANEL; panel <= SIMULATOR_FRAMEBUFFER; panel++) {
            for (int method = LIM_NEAREST_FIRST; method <= LIM_PAINTER; method++) {
                uint16_t *pixels =
                    picture(&room, (enum simulator_panel)panel, (enum lim_method)method, w_px, h_px, seed);
                assert_memory_equal(pixels, expected, (size_t)w_px * h_px * sizeof *pixels);
                free(pixels);
            }
        }
        free(expected);
    }
}

/* The picture clockwise by quarters on glass of w x h; edges may fall otherwise where they pass a pixel's centre. */
static void a_turned_camera_turns_the_picture(void **state)
{
    enum { W_PX = 96, H_PX = 64 };
    struct room room;

    (void)state;
    room_init(&room);
    for (unsigned seed = 1; seed < 6; seed++)
        for (unsigned turns = 0; turns < 4; turns++) {
            const unsigned w = turns % 2 ? H_PX : W_PX, h = turns % 2 ? W_PX : H_PX; /* of the picture */
            const struct lens lens = make_lens(w, h);
            const struct viewpoint viewpoint = random_viewpoint(seed);
            struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
            uint16_t *upright = picture_by(&room, SIMULATOR_MEMORY, LIM_NEAREST_FIRST, w, h, &camera);
            screen_turn_camera(&camera, (enum panel_rotation)turns);
            uint16_t *glass = picture_by(&room, SIMULATOR_MEMORY, LIM_NEAREST_FIRST, W_PX, H_PX, &camera);
            unsigned different = 0;
            for (unsigned y = 0; y < h; y++)
                for (unsigned x = 0; x < w; x++) {
                    const unsigned on_x[] = {x, h - 1 - y, w - 1 - x, y}, on_y[] = {y, x, h - 1 - y, w - 1 - x};
                    different += upright[y * w + x] != glass[on_y[turns] * W_PX + on_x[turns]];
                }
            if (different > W_PX * H_PX / 200) fail_msg("%u turns: %u pixels differ", turns, different);
            free(upright);
            free(glass);
        }
}

static void sizes_that_no_panel_has_are_rendered_into_memory(void **state)
{
    (void)state;
    static const unsigned sizes[][2] = {{1024, 1024}, {241, 5}, {5, 321}, {401, 299}};
    struct room room;
    room_init(&room);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        unsigned w_px = sizes[i][0], h_px = sizes[i][1];
        assert_false(simulator_panel_holds(NULL, w_px, h_px, &(struct error){0}));
        if (w_px < 100 || h_px < 100) continue; /* too thin for a lens */
        uint16_t *pixels = picture(&room, SIMULATOR_MEMORY, LIM_NEAREST_FIRST, w_px, h_px, 7);
        for (size_t p = 0; p < (size_t)w_px * h_px; p++)
            assert_int_not_equal(pixels[p], 0xF81F);
        free(pixels);
    }
}

static struct lim_stats stats_on(const struct room *room, enum simulator_panel panel, const struct lim_camera *camera)
{
    const struct simulator_setup setup = {96, 64, LIM_NEAREST_FIRST, panel, NULL};
    struct simulator simulator;
    struct error err;
    assert_true(simulator_init(&simulator, &room->compiled.scene, &setup, &err));
    assert_true(simulator_set_delta(&simulator, 1000, &err));
    assert_true(simulator_frame(&simulator, camera, &err));
    const struct lim_stats stats = *simulator_stats(&simulator);
    simulator_free(&simulator);
    return stats;
}

/* So are pools measured. */
static void unseen_frames_take_what_seen_ones_take(void **state)
{
    struct room room;

    (void)state;
    room_init(&room);
    for (unsigned seed = 1; seed < 6; seed++) {
        const struct lens lens = make_lens(96, 64);
        const struct viewpoint viewpoint = random_viewpoint(seed);
        const struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
        const struct lim_stats seen = stats_on(&room, SIMULATOR_MEMORY, &camera);
        const struct lim_stats unseen = stats_on(&room, SIMULATOR_UNSEEN, &camera);
        assert_true(seen.pixels_painted > 0 && seen.delta.runs_max > 0);
        assert_memory_equal(&unseen, &seen, sizeof seen);
    }
}

static void wall_straight_ahead_is_in_the_middle(void **state)
{
    (void)state;
    static const double targets_m[WALLS][3] = {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct room room;
    room_init(&room);
    struct lens lens = make_lens(240, 240);
    struct simulator simulator;
    struct error err;
    assert_true(
        simulator_init(&simulator, &room.compiled.scene, &(struct simulator_setup){.w_px = 240, .h_px = 240}, &err));
    assert_non_null(simulator.board);
    for (size_t wall = 0; wall < WALLS; wall++) {
        struct viewpoint viewpoint = {.line = 1};
        memcpy(viewpoint.target_m, targets_m[wall], sizeof viewpoint.target_m);
        struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
        assert_true(simulator_frame(&simulator, &camera, &err));
        assert_int_equal(simulator.pixels[120 * 240 + 120], wall_colour(wall));
        assert_in_range(simulator.bus_b, 2 * 240 * 240, 2 * 240 * 240 + 64);
    }
    simulator_free(&simulator);
}

static void face_numbers_agree_with_the_colours(void **state)
{
    (void)state;
    struct room room;
    room_init(&room);
    for (int method = LIM_NEAREST_FIRST; method <= LIM_PAINTER; method++) {
        uint16_t *pixels = picture(&room, SIMULATOR_PANEL, (enum lim_method)method, 240, 240, 5);
        struct lens lens = make_lens(240, 240);
        struct viewpoint viewpoint = random_viewpoint(5);
        struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
        struct ids ids;
        struct error err;
        assert_true(ids_init(&ids, &room.compiled,
                             &(struct simulator_setup){.w_px = 240, .h_px = 240, .method = (enum lim_method)method},
                             &err));
        assert_true(ids_frame(&ids, &camera, &err));
        for (size_t i = 0; i < 240 * 240; i++)
            assert_int_equal(pixels[i], wall_colour(ids.faces[i] - 11));
        assert_int_equal(room.polygons[1], wall_colour(0)); /* the original scene is untouched */
        ids_free(&ids);
        free(pixels);
    }
}

static void face_numbers_are_written_little_endian(void **state)
{
    (void)state;
    struct room room;
    room_init(&room);
    for (size_t wall = 0; wall < WALLS; wall++)
        room.faces[wall] = 0x01020304;
    struct lens lens = make_lens(1, 1);
    struct viewpoint viewpoint = random_viewpoint(1);
    struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
    struct ids ids;
    struct error err;
    unsigned char bytes[5];
    assert_true(ids_init(&ids, &room.compiled, &(struct simulator_setup){.w_px = 1, .h_px = 1}, &err));
    assert_true(ids_frame(&ids, &camera, &err));
    FILE *file = tmpfile();
    assert_true(ids_write(&ids, file));
    rewind(file);
    assert_int_equal(fread(bytes, 1, sizeof bytes, file), 4);
    assert_memory_equal(bytes, ((unsigned char[]){4, 3, 2, 1}), 4);
    fclose(file);
    ids_free(&ids);
}

static void room_mesh(const struct room *room, struct mesh *mesh, double points[8][3], uint32_t corners[WALLS * 4],
                      struct mesh_polygon polygons[WALLS])
{
    for (int c = 0; c < 8; c++)
        for (int axis = 0; axis < 3; axis++)
            points[c][axis] = (c >> axis & 1 ? 10.0 : -10.0);
    for (uint32_t wall = 0; wall < WALLS; wall++) {
        polygons[wall] = (struct mesh_polygon){.first = 4 * wall, .count = 4, .face = room->faces[wall]};
        for (uint32_t i = 0; i < 4; i++)
            corners[4 * wall + i] = WALL_CORNERS[wall][i];
    }
    *mesh = (struct mesh){.points = points,
                          .point_count = 8,
                          .corners = corners,
                          .corner_count = WALLS * 4,
                          .polygons = polygons,
                          .polygon_count = WALLS,
                          .grid = room->compiled.grid};
}

static void frames_agree_with_the_reference_picture(void **state)
{
    (void)state;
    struct room room;
    room_init(&room);
    double points[8][3];
    uint32_t corners[WALLS * 4];
    struct mesh_polygon polygons[WALLS];
    struct mesh mesh;
    room_mesh(&room, &mesh, points, corners, polygons);
    struct reference reference;
    struct ids ids;
    struct error err;
    struct lens lens = make_lens(200, 120);
    assert_true(reference_init(&reference, &mesh, 200, 120, &err));
    assert_true(ids_init(&ids, &room.compiled, &(struct simulator_setup){.w_px = 200, .h_px = 120}, &err));
    struct comparison sum = {0};
    for (unsigned seed = 0; seed < 100; seed++) {
        struct viewpoint viewpoint = random_viewpoint(seed);
        struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
        assert_true(ids_frame(&ids, &camera, &err));
        reference_draw(&reference, &viewpoint, &lens);
        struct compare_counts counts = compare_picture(ids.faces, &reference, NULL, 0.01);
        comparison_add(&sum, &counts);
    }
    assert_true(compare_wrong_percent(&sum.total) < 0.05);
    assert_int_equal(sum.total.beyond, 0);
    assert_int_equal(sum.total.holes, 0);
    ids_free(&ids);
    reference_free(&reference);
}

static void complaint_of_the_panel_is_an_error(void **state)
{
    (void)state;
    struct room room;
    room_init(&room);
    struct lens lens = make_lens(24, 24);
    struct viewpoint viewpoint = random_viewpoint(1);
    struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
    struct simulator simulator;
    struct error err;
    assert_true(
        simulator_init(&simulator, &room.compiled.scene, &(struct simulator_setup){.w_px = 24, .h_px = 24}, &err));
    static const uint8_t stray[] = {1, 2, 3};
    struct bus bus = emulated_port_bus(simulator.board->module.port);
    assert_int_equal(bus_write(&bus, stray, sizeof stray), 0);
    assert_false(simulator_frame(&simulator, &camera, &err));
    assert_memory_equal(err.text, "emulated st7789: ", strlen("emulated st7789: "));
    simulator_free(&simulator);
}

static void error_of_the_renderer_is_passed_on(void **state)
{
    (void)state;
    struct room room;
    room_init(&room);
    struct lens lens = make_lens(24, 24);
    struct viewpoint viewpoint = random_viewpoint(1);
    struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
    struct simulator simulator;
    struct error err;
    assert_true(
        simulator_init(&simulator, &room.compiled.scene, &(struct simulator_setup){.w_px = 24, .h_px = 24}, &err));
    camera.near_q8 = 0;
    assert_false(simulator_frame(&simulator, &camera, &err));
    assert_string_equal(err.text, "renderer: the camera's position or lens is out of range (-1004)");
    simulator_free(&simulator);
}

static int failing_flush(struct panel *panel)
{
    (void)panel;
    return -7;
}

/* The renderer does not know what became of pixels that were on their way. */
static void a_frame_that_did_not_arrive_is_followed_by_a_whole_one(void **state)
{
    (void)state;
    struct room room;
    room_init(&room);
    const struct viewpoint viewpoint = random_viewpoint(1);
    const struct lens lens = make_lens(24, 24);
    const struct lim_camera camera = make_camera(&viewpoint, &lens, &room);
    struct simulator simulator;
    struct error err;
    const struct simulator_setup setup = {.w_px = 24, .h_px = 24, .panel = SIMULATOR_PANEL};
    assert_true(simulator_init(&simulator, &room.compiled.scene, &setup, &err));
    assert_true(simulator_set_delta(&simulator, 1000, &err));
    assert_true(simulator_frame(&simulator, &camera, &err));
    const size_t whole_b = simulator.bus_b;
    struct panel *panel = simulator.board->display.panel;
    const struct panel_ops *ops = panel->ops;
    struct panel_ops failing = *ops;
    failing.flush = failing_flush;
    panel->ops = &failing;
    assert_false(simulator_frame(&simulator, &camera, &err));
    panel->ops = ops;
    assert_true(simulator_frame(&simulator, &camera, &err));
    assert_int_equal(simulator.bus_b, whole_b);
    assert_true(simulator_frame(&simulator, &camera, &err));
    assert_int_equal(simulator.bus_b, 0);
    simulator_free(&simulator);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(panel_and_memory_show_the_same_by_both_methods),
        cmocka_unit_test(a_turned_camera_turns_the_picture),
        cmocka_unit_test(sizes_that_no_panel_has_are_rendered_into_memory),
        cmocka_unit_test(unseen_frames_take_what_seen_ones_take),
        cmocka_unit_test(wall_straight_ahead_is_in_the_middle),
        cmocka_unit_test(face_numbers_agree_with_the_colours),
        cmocka_unit_test(face_numbers_are_written_little_endian),
        cmocka_unit_test(frames_agree_with_the_reference_picture),
        cmocka_unit_test(complaint_of_the_panel_is_an_error),
        cmocka_unit_test(error_of_the_renderer_is_passed_on),
        cmocka_unit_test(a_frame_that_did_not_arrive_is_followed_by_a_whole_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
