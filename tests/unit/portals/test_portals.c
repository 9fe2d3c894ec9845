/* SPDX-License-Identifier: MIT
 *
 * Cells and portals: no picture changes by them, and what cannot be seen is left out. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "eye.h"
#include "portals/flow.h"
#include "portals/pvs.h"
#include "render/simulator.h"
#include "rigs/closed_scene.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/room_scene.h"
#include "scene/lim_check.h"
#include "scene/scene_files.h"
#include "view/portals.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A scene drawn with what its portals show, and without. */
struct pair {
    struct lim_scene plain;
    struct simulator with, without;
    struct lens lens;
};

struct tally {
    size_t views, different, restricted, hidden;
};

static void pair_begin(struct pair *pair, const struct compiled *scene, const struct simulator_setup *setup)
{
    struct error err;

    pair->plain = scene->scene;
    pair->plain.place_count = 0;
    if (!simulator_init(&pair->with, &scene->scene, setup, &err) ||
        !simulator_init(&pair->without, &pair->plain, setup, &err) ||
        !lens_init(&pair->lens, 70, 0.1, setup->w_px, setup->h_px, &err))
        fail_msg("%s", err.text);
}

static void pair_end(struct pair *pair)
{
    simulator_free(&pair->with);
    simulator_free(&pair->without);
}

static void compare(struct pair *pair, const struct compiled *scene, struct viewpoint viewpoint, struct tally *tally)
{
    const struct camera_path path = {"random", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&path, 0, &pair->lens, &scene->grid, &camera, &err) ||
        !simulator_frame(&pair->with, &camera, &err) || !simulator_frame(&pair->without, &camera, &err))
        fail_msg("%s", err.text);
    const size_t pixels_b = simulator_pixel_count(&pair->with) * sizeof *pair->with.pixels;
    tally->views++;
    tally->hidden += simulator_stats(&pair->with)->hidden;
    tally->restricted += simulator_stats(&pair->with)->hidden > 0;
    tally->different += memcmp(pair->with.pixels, pair->without.pixels, pixels_b) != 0;
}

typedef bool compile_rooms(const struct room_scene *scene, enum portals_wanted portals, const struct core *core,
                           struct compiled *out, struct error *err);

/* Random buildings, `views` from each. */
static void look_around(compile_rooms *compile, const struct simulator_setup *setup, int scenes, int views,
                        uint64_t seed, struct tally *tally)
{
    struct random random = {seed};

    for (int s = 0; s < scenes; s++) {
        struct room_scene rooms;
        struct compiled scene;
        struct pair pair;
        struct error err;
        room_scene_random(&rooms, &random);
        if (!compile(&rooms, PORTALS_ON, setup->core, &scene, &err)) fail_msg("%s", err.text);
        pair_begin(&pair, &scene, setup);
        for (int v = 0; v < views; v++)
            compare(&pair, &scene, room_scene_view(&rooms, &random), tally);
        pair_end(&pair);
        compiled_free(&scene);
        room_scene_free(&rooms);
    }
}

static void nothing_visible_is_hidden_from_100000_eyes(void **state)
{
    const struct simulator_setup setup = {32, 24, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_fast};
    const int scenes = effort(50);
    struct tally tally = {0};

    (void)state;
    look_around(room_scene_compile, &setup, scenes, 2000, 4711, &tally);
    printf("# portals: %zu views of %d buildings, %zu differ; %zu with something left out, %.1f subtrees each\n",
           tally.views, scenes, tally.different, tally.restricted, (double)tally.hidden / (double)tally.restricted);
    assert_int_equal(tally.different, 0);
    assert_true(tally.views == (size_t)scenes * 2000);
    assert_true(tally.restricted * 5 > tally.views); /* or this test would say nothing */
}

static void other_profiles_and_the_painter_agree(void **state)
{
    const struct simulator_setup setups[] = {{48, 48, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_fine},
                                             {48, 48, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_exact},
                                             {120, 80, LIM_PAINTER, SIMULATOR_MEMORY, &core_fast}};
    (void)state;
    for (size_t i = 0; i < sizeof setups / sizeof *setups; i++) {
        struct tally tally = {0};
        look_around(room_scene_compile, &setups[i], effort(6), 500, 99 + i, &tally);
        assert_int_equal(tally.different, 0);
        assert_true(tally.restricted > 0);
    }
}

/* Distances to planes then have 64 bits, and the near plane may be further off than 16 bits hold. */
static void with_coordinates_of_32_bits_nothing_visible_is_hidden(void **state)
{
    const struct simulator_setup setups[] = {{32, 24, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_fast},
                                             {48, 48, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_exact},
                                             {60, 40, LIM_PAINTER, SIMULATOR_MEMORY, &core_fine}};
    (void)state;
    for (size_t i = 0; i < sizeof setups / sizeof *setups; i++) {
        struct tally tally = {0};
        look_around(room_scene_compile_long, &setups[i], effort(16), 1000, 7 + i, &tally);
        assert_int_equal(tally.different, 0);
        assert_true(tally.restricted * 5 > tally.views);
    }
}

/* Solids through walls and one another: their insides are cells that nobody can be sure of. */
static void solids_through_one_another_do_no_harm(void **state)
{
    const struct simulator_setup setup = {40, 40, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, &core_fast};
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "auto", .keep_faces = true, .portals = PORTALS_ON};
    struct random random = {12};
    struct tally tally = {0};

    (void)state;
    for (int s = 0; s < 12 && (s < effort(12) || !tally.views); s++) {
        struct closed_scene closed;
        struct compiled scene;
        struct mesh mesh;
        struct pair pair;
        struct error err;
        closed_scene_make(&closed, &random);
        assert_true(mesh_clean(&closed.model, &mesh, &err) && mesh_insert_t_vertices(&mesh, &err));
        if (compile_mesh(&mesh, &options, &scene, &err)) { /* else: too much to follow, and said so */
            pair_begin(&pair, &scene, &setup);
            for (int v = 0; v < 400; v++)
                compare(&pair, &scene, closed_scene_viewpoint(&closed, &random), &tally);
            pair_end(&pair);
            compiled_free(&scene);
        }
        mesh_free(&mesh);
        closed_scene_free(&closed);
    }
    printf("# portals: %zu views of solids, %zu differ, %zu with something left out\n", tally.views, tally.different,
           tally.restricted);
    assert_true(tally.views > 0);
    assert_int_equal(tally.different, 0);
}

/* What is seen from a point -------------------------------------------------------------------- */

static bool unpack_at(const struct compiled *scene, const double at_m[3], uint32_t ball_units, uint8_t *bits)
{
    static uint16_t stack[256];
    const struct lim_portals portals = {bits, stack};
    struct lim_eye eye;
    int32_t at_q8[3];

    assert_true(scene->scene.limits.depth < 255);
    for (int i = 0; i < 3; i++)
        at_q8[i] = (int32_t)((at_m[i] - scene->grid.origin_m[i]) * scene->grid.units_per_m * 256.0);
    lim_eye_set(&eye, &scene->scene, at_q8);
    return lim_portals_unpack(&portals, &eye, ball_units);
}

/* Records of a colour below nodes that the bits show. */
static size_t count_shown(const struct lim_scene *scene, const uint8_t *bits, uint16_t colour)
{
    bool *hidden = calloc(scene->node_count, sizeof *hidden);
    size_t count = 0;

    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        const lim_index runs[2] = {node->front_run, node->back_run}, children[2] = {node->front, node->back};
        if (node->box != LIM_NO_INDEX && !lim_portals_show(bits, node->box)) hidden[i] = true;
        for (int k = 0; k < 2; k++) {
            if (children[k] != LIM_NO_INDEX && hidden[i]) hidden[children[k]] = true;
            if (runs[k] == LIM_NO_INDEX || hidden[i]) continue;
            for (const lim_index *at = &scene->polygons[runs[k]];; at += lim_record_words(*at)) {
                count += at[1] == colour;
                if (*at & LIM_POLYGON_LAST) break;
            }
        }
    }
    free(hidden);
    return count;
}

enum { RED = 0xFF0000, GREEN = 0x00FF00, BLUE = 0x0000FF, GREY = 0x808080 };
enum { RED565 = 0xF800, GREEN565 = 0x07E0, BLUE565 = 0x001F };

/* The cell with a point, as the tree has it. */
static uint32_t cell_at(const struct compiled *scene, const double at_m[3])
{
    struct lim_eye eye;
    int32_t at_q8[3];
    uint32_t index = 0;

    for (int i = 0; i < 3; i++)
        at_q8[i] = (int32_t)((at_m[i] - scene->grid.origin_m[i]) * scene->grid.units_per_m * 256.0);
    lim_eye_set(&eye, &scene->scene, at_q8);
    for (;;) {
        const struct lim_node *node = &scene->scene.nodes[index];
        const bool behind = lim_eye_side(&eye, &node->split) < 0;
        const lim_index child = behind ? node->back : node->front;
        if (child == LIM_NO_INDEX) return cell_of(index, behind);
        index = child;
    }
}

/* Polygons of a colour that may be seen from the zone around a point, before anything is stored. They come in the order
 * of nodes, those that face the front first. */
static size_t count_seen(const struct compiled *scene, const double at_m[3], uint16_t colour)
{
    struct cells cells;
    struct zones zones;
    struct flow flow;
    struct error err;
    size_t count = 0, record = 0;

    assert_true(cells_find(&scene->scene, &cells, &err));
    zones_find(&cells, &zones);
    flow_init(&flow, &cells, &zones, 1.0 / 128.0);
    flow.work_max = pvs_usual_effort.zone_work;
    bool *visible = calloc(cells.record_count, sizeof *visible);
    assert_true(flow_see(&flow, zones.of_cell[cell_at(scene, at_m)], visible));
    for (size_t i = 0; i < scene->scene.node_count; i++) {
        const lim_index runs[2] = {scene->scene.nodes[i].front_run, scene->scene.nodes[i].back_run};
        for (int k = 0; k < 2; k++) {
            if (runs[k] == LIM_NO_INDEX) continue;
            for (const lim_index *at = &scene->scene.polygons[runs[k]];; at += lim_record_words(*at)) {
                count += visible[record++] && at[1] == colour;
                if (*at & LIM_POLYGON_LAST) break;
            }
        }
    }
    assert_int_equal(record, cells.record_count);
    free(visible);
    flow_free(&flow);
    zones_free(&zones);
    cells_free(&cells);
    return count;
}

/* What is stored shows all that is seen. Fills bits. */
static void check_stored(const struct compiled *scene, const double at_m[3], uint8_t *bits)
{
    const uint16_t colours[] = {RED565, GREEN565, BLUE565};

    assert_true(unpack_at(scene, at_m, 10, bits));
    for (size_t i = 0; i < sizeof colours / sizeof *colours; i++)
        assert_true(count_shown(&scene->scene, bits, colours[i]) >= count_seen(scene, at_m, colours[i]));
}

/* Rooms A (x 0..4) and B (5..9), in the thick wall between a door at z 1.5..2.5. In B stands a green box across from
 * the door, and a red heap in the corner beside the door. */
static void two_rooms(struct room_scene *rooms)
{
    const double xs[3][2] = {{0, 4}, {5, 9}, {4, 5}}, z[2] = {0, 4}, door[2] = {1.5, 2.5};
    const double low[3] = {8, 0, 1.8}, high[3] = {8.6, 0.6, 2.3};

    room_scene_begin(rooms);
    for (int i = 0; i < 2; i++) {
        room_scene_floor(rooms, xs[i], z, 2.5, GREY);
        room_scene_wall(rooms, 0, xs[i][0], 1, z, i ? door : NULL, GREY);
        room_scene_wall(rooms, 0, xs[i][1], -1, z, i ? NULL : door, GREY);
        room_scene_wall(rooms, 2, 0, 1, xs[i], NULL, GREY);
        room_scene_wall(rooms, 2, 4, -1, xs[i], NULL, GREY);
    }
    const double y[2] = {0, 2};
    room_scene_floor(rooms, xs[2], door, 2, GREY);
    room_scene_quad(rooms, 2, door[0], 1, xs[2], y, GREY);
    room_scene_quad(rooms, 2, door[1], -1, xs[2], y, GREY);
    room_scene_box(rooms, low, high, GREEN);
    for (int k = 0; k < 3; k++) {
        const double at = 0.1 + 0.2 * k, low_red[3] = {5.1, at, 3.5}, high_red[3] = {5.4, at + 0.1, 3.9};
        room_scene_box(rooms, low_red, high_red, RED);
    }
}

static void a_door_shows_what_is_across_and_hides_the_corner_beside_it(void **state)
{
    const double in_a[3] = {0.5, 1.6, 2.0}, in_b[3] = {7.0, 1.6, 2.0}, outside[3] = {2.0, 9.0, 2.0};
    struct room_scene rooms;
    struct compiled scene;
    struct error err;
    uint8_t bits[64] = {0};

    (void)state;
    two_rooms(&rooms);
    if (!room_scene_compile(&rooms, PORTALS_ON, NULL, &scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(count_seen(&scene, in_a, RED565), 0);
    assert_true(count_seen(&scene, in_a, GREEN565) >= 3);      /* front, top, a side or two; its back is culled */
    assert_int_equal(count_seen(&scene, in_b, RED565), 3 * 6); /* the room's corners see all sides */
    check_stored(&scene, in_b, bits);
    check_stored(&scene, in_a, bits);
    assert_true(count_shown(&scene.scene, bits, RED565) <= 6); /* what shares a box with something seen */
    assert_false(unpack_at(&scene, outside, 10, bits));        /* nothing is known of the world outside */
    compiled_free(&scene);
    room_scene_free(&rooms);
}

static void a_ball_through_a_wall_sees_what_is_behind_it(void **state)
{
    const double at_wall[3] = {3.9, 1.6, 3.5}, in_door[3] = {4.1, 1.0, 2.0};
    struct room_scene rooms;
    struct compiled scene;
    struct error err;
    uint8_t bits[64] = {0};

    (void)state;
    two_rooms(&rooms);
    if (!room_scene_compile(&rooms, PORTALS_ON, NULL, &scene, &err)) fail_msg("%s", err.text);
    const double unit_m = 1 / scene.grid.units_per_m;
    assert_true(unpack_at(&scene, at_wall, (uint32_t)(0.05 / unit_m), bits));
    assert_true(count_shown(&scene.scene, bits, RED565) <= 6);
    assert_false(unpack_at(&scene, at_wall, (uint32_t)(0.11 / unit_m), bits)); /* it is in the wall's matter */
    assert_true(unpack_at(&scene, in_door, (uint32_t)(0.2 / unit_m), bits));   /* room and doorway: their sum */
    assert_true(count_shown(&scene.scene, bits, RED565) >= count_seen(&scene, in_door, RED565));
    assert_true(count_seen(&scene, in_door, RED565) > 6);
    compiled_free(&scene);
    room_scene_free(&rooms);
}

/* A screen across a room that only its one side shows: red stands behind it, blue before. */
static void a_screen_hides_only_from_where_it_is_seen(void **state)
{
    const double x[2] = {0, 8}, z[2] = {0, 4}, y[2] = {0, 2.5};
    const double before[3] = {1, 1.2, 2}, behind[3] = {7, 1.2, 2};
    struct room_scene rooms;
    struct compiled scene;
    struct error err;
    uint8_t bits[64] = {0};

    (void)state;
    room_scene_begin(&rooms);
    room_scene_floor(&rooms, x, z, 2.5, GREY);
    for (int k = 0; k < 2; k++) {
        room_scene_wall(&rooms, 0, x[k], k ? -1 : 1, z, NULL, GREY);
        room_scene_wall(&rooms, 2, z[k], k ? -1 : 1, x, NULL, GREY);
    }
    room_scene_quad(&rooms, 0, 4, -1, y, z, GREY);
    for (int k = 0; k < 3; k++) {
        const double at = 0.5 + 0.3 * k;
        const double low_blue[3] = {2, at, 1}, high_blue[3] = {2.5, at + 0.1, 1.5};
        const double low_red[3] = {6, at, 1}, high_red[3] = {6.5, at + 0.1, 1.5};
        room_scene_box(&rooms, low_blue, high_blue, BLUE);
        room_scene_box(&rooms, low_red, high_red, RED);
    }
    if (!room_scene_compile(&rooms, PORTALS_ON, NULL, &scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(count_seen(&scene, before, RED565), 0);
    assert_int_equal(count_seen(&scene, before, BLUE565), 3 * 6);
    assert_int_equal(count_seen(&scene, behind, RED565), 3 * 6);
    assert_true(count_seen(&scene, behind, BLUE565) >= 3 * 5); /* but the sides that face away */
    check_stored(&scene, before, bits);
    check_stored(&scene, behind, bits);
    compiled_free(&scene);
    room_scene_free(&rooms);
}

/* Storage -------------------------------------------------------------------------------------- */

/* One node, a cell in front of it that has a visible set. */
static struct lim_scene scene_of(const struct lim_place *place, const uint8_t *packed, size_t packed_b, uint16_t boxes)
{
    static const struct lim_node node = {{LIM_PLANE_X, 0}, LIM_NO_INDEX, LIM_NO_INDEX, 0, LIM_NO_INDEX, LIM_NO_INDEX};
    return (struct lim_scene){.nodes = &node,
                              .node_count = 1,
                              .places = place,
                              .place_count = 1,
                              .pvs = packed,
                              .pvs_bytes = (uint16_t)packed_b,
                              .box_count = boxes,
                              .limits = {.depth = 1}};
}

static bool unpack(const struct lim_scene *scene, uint8_t *bits)
{
    static uint16_t stack[2];
    const int32_t at_q8[3] = {25600, 0, 0};
    const struct lim_portals portals = {bits, stack};
    struct lim_eye eye;

    lim_eye_set(&eye, scene, at_q8);
    return lim_portals_unpack(&portals, &eye, 1);
}

static void what_is_packed_is_unpacked(void **state)
{
    const struct lim_place place = {0, 0};
    struct random random = {3};

    (void)state;
    for (int round = 0; round < 20000; round++) {
        uint8_t bytes[600] = {0}, packed[1200], bits[604];
        const size_t count = (size_t)random_in(&random, 1, 600);
        for (size_t i = 0; i < count; i++)
            if (random_u64(&random) % (1 + (uint64_t)round % 50) == 0) bytes[i] = (uint8_t)random_u64(&random);
        const struct lim_scene scene = scene_of(&place, packed, pvs_pack(bytes, count, packed), (uint16_t)(8 * count));
        memset(bits, 0xAA, sizeof bits);
        assert_true(unpack(&scene, bits));
        assert_memory_equal(bits, bytes, count);
    }
}

/* The unpacker ends at the end of bits and bytes alike: a guard behind both stays as it is. */
static void a_hostile_pvs_stays_within_its_bits(void **state)
{
    struct random random = {8};

    (void)state;
    for (int round = 0; round < 20000; round++) {
        const size_t packed_b = (size_t)random_in(&random, 1, 40);
        uint8_t *packed = malloc(packed_b); /* exactly: AddressSanitizer watches its end */
        uint8_t bits[64];
        const uint16_t boxes = (uint16_t)random_in(&random, 1, 256);
        const struct lim_place place = {0, (uint16_t)random_in(&random, 0, (int64_t)packed_b + 2)};
        for (size_t i = 0; i < packed_b; i++)
            packed[i] = random_u64(&random) % 3 ? 0 : (uint8_t)random_u64(&random);
        const struct lim_scene scene = scene_of(&place, packed, packed_b, boxes);
        memset(bits, 0xAA, sizeof bits);
        (void)unpack(&scene, bits);
        for (size_t i = LIM_PORTALS_BITS_B(boxes); i < sizeof bits; i++)
            assert_int_equal(bits[i], 0xAA);
        free(packed);
    }
}

static void refused(const struct compiled *scene, const struct lim_place *places, size_t place_count,
                    const uint8_t *pvs, size_t pvs_bytes, const char *reason)
{
    struct lim_scene damaged = scene->scene;
    struct error err;

    damaged.places = places;
    damaged.place_count = (uint16_t)place_count;
    damaged.pvs = pvs;
    damaged.pvs_bytes = (uint16_t)pvs_bytes;
    assert_false(lim_check(&damaged, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' does not say '%s'", err.text, reason);
}

static void damaged_places_and_pvs_are_refused(void **state)
{
    const struct lim_place beyond = {0xFFF0, LIM_NONE};
    const uint8_t too_many[2] = {0, 255}, none[2] = {0, 0}, cut[1] = {0}, few[1] = {1};
    struct room_scene rooms;
    struct compiled scene;
    struct error err;

    (void)state;
    two_rooms(&rooms);
    if (!room_scene_compile(&rooms, PORTALS_ON, NULL, &scene, &err)) fail_msg("%s", err.text);
    assert_true(lim_check(&scene.scene, &err));
    assert_true(scene.scene.box_count > 8);
    assert_true(scene.scene.place_count > 0);
    const uint16_t cell = scene.scene.places[0].cell;
    const struct lim_place twice[2] = {{cell, LIM_NONE}, {cell, LIM_NONE}}, far = {cell, 700}, first = {cell, 0};
    const struct lim_node *root = &scene.scene.nodes[0];
    const struct lim_place divided = {root->front == LIM_NO_INDEX, LIM_NONE};
    refused(&scene, &divided, 1, few, 1, "is divided further");
    refused(&scene, twice, 2, few, 1, "does not come after");
    refused(&scene, &beyond, 1, few, 1, "cell 65520");
    refused(&scene, &far, 1, few, 1, "visible set at byte 700 of 1");
    refused(&scene, &first, 1, too_many, 2, "does not end with the boxes");
    refused(&scene, &first, 1, none, 2, "does not end with the boxes");
    refused(&scene, &first, 1, cut, 1, "does not end with the boxes");
    refused(&scene, &first, 1, few, 1, "does not end with the boxes");
    scene.scene.box_count = 0;
    compiled_free(&scene);
    room_scene_free(&rooms);
}

static void a_file_keeps_places_and_pvs(void **state)
{
    char path[] = "/tmp/test_portals.XXXXXX";
    struct room_scene rooms;
    struct compiled scene, read;
    struct error err;

    (void)state;
    two_rooms(&rooms);
    if (!room_scene_compile(&rooms, PORTALS_ON, NULL, &scene, &err)) fail_msg("%s", err.text);
    const int file = mkstemp(path);
    assert_true(file >= 0 && fclose(fdopen(file, "wb")) == 0);
    if (!lim_file_write(&scene, path, &err) || !lim_file_read(path, &read, &err)) fail_msg("%s", err.text);
    assert_int_equal(read.scene.place_count, scene.scene.place_count);
    assert_int_equal(read.scene.pvs_bytes, scene.scene.pvs_bytes);
    assert_memory_equal(read.scene.places, scene.scene.places, scene.scene.place_count * sizeof *scene.scene.places);
    assert_memory_equal(read.scene.pvs, scene.scene.pvs, scene.scene.pvs_bytes);
    remove(path);
    compiled_free(&read);
    compiled_free(&scene);
    room_scene_free(&rooms);
}

/* Scenes without ------------------------------------------------------------------------------- */

static void refusal(const struct room_scene *rooms, enum tree_kind tree, const char *reason)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "auto", .tree = tree, .portals = PORTALS_ON};
    struct compiled scene;
    struct mesh mesh;
    struct error err;

    assert_true(mesh_clean(&rooms->model, &mesh, &err) && mesh_insert_t_vertices(&mesh, &err));
    assert_false(compile_mesh(&mesh, &options, &scene, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' does not say '%s'", err.text, reason);
    mesh_free(&mesh);
}

static void what_has_no_closed_cells_is_refused(void **state)
{
    const double x[2] = {0, 4}, z[2] = {0, 4}, low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    struct room_scene rooms;

    (void)state;
    room_scene_begin(&rooms);
    room_scene_box(&rooms, low, high, RED);
    refusal(&rooms, TREE_AUTO, "one convex solid");
    room_scene_floor(&rooms, x, z, 2.5, GREY);
    refusal(&rooms, TREE_AUTO, "none of its cells is closed");
    room_scene_free(&rooms);
    two_rooms(&rooms);
    refusal(&rooms, TREE_CLUSTERS, "between cells of a BSP tree; this has none");
    room_scene_free(&rooms);
}

/* The renderer numbers cells, two a node, in 16 bits: told before anything is drawn with places. */
static void too_many_nodes_are_refused(void **state)
{
    static struct lim_node nodes[16385];
    struct lim_scene scene = {.nodes = nodes, .node_count = 16384, .box_count = 1};
    struct error err;

    (void)state;
    assert_true(pvs_may_be(&scene, &err));
    scene.node_count++;
    assert_false(pvs_may_be(&scene, &err));
    assert_non_null(strstr(err.text, "too many nodes for portals: 16385, 16384 are the most"));
}

/* Left to itself the compiler leaves out what does not pay, and the scene is as it would be without. */
static void what_does_not_pay_is_left_out(void **state)
{
    struct room_scene rooms;
    struct compiled off, automatic;
    struct error err;

    (void)state;
    two_rooms(&rooms);
    if (!room_scene_compile(&rooms, PORTALS_OFF, NULL, &off, &err) ||
        !room_scene_compile(&rooms, PORTALS_AUTO, NULL, &automatic, &err))
        fail_msg("%s", err.text);
    assert_non_null(strstr(automatic.report.portals.refused, "at best they would spare"));
    assert_false(automatic.report.portals.kept);
    assert_int_equal(off.image_b, automatic.image_b);
    assert_memory_equal(off.image, automatic.image, off.image_b);
    compiled_free(&off);
    compiled_free(&automatic);
    room_scene_free(&rooms);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_visible_is_hidden_from_100000_eyes),
        cmocka_unit_test(other_profiles_and_the_painter_agree),
        cmocka_unit_test(with_coordinates_of_32_bits_nothing_visible_is_hidden),
        cmocka_unit_test(solids_through_one_another_do_no_harm),
        cmocka_unit_test(a_door_shows_what_is_across_and_hides_the_corner_beside_it),
        cmocka_unit_test(a_ball_through_a_wall_sees_what_is_behind_it),
        cmocka_unit_test(a_screen_hides_only_from_where_it_is_seen),
        cmocka_unit_test(what_is_packed_is_unpacked),
        cmocka_unit_test(a_hostile_pvs_stays_within_its_bits),
        cmocka_unit_test(damaged_places_and_pvs_are_refused),
        cmocka_unit_test(a_file_keeps_places_and_pvs),
        cmocka_unit_test(what_has_no_closed_cells_is_refused),
        cmocka_unit_test(too_many_nodes_are_refused),
        cmocka_unit_test(what_does_not_pay_is_left_out),
    };

    return cmocka_run_group_tests_name("portals", tests, NULL, NULL);
}
