/* SPDX-License-Identifier: MIT
 *
 * The worked examples of the depth sort: orders, swaps, splits, memory that runs out. Sets are given as one looks
 * at them: x to the right, y up, the depth ahead; the eye looks along -z, or along +z, which must not matter. */
#include "colour.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "rigs/set_rig.h"

#include <string.h>

/* As seen: x0 <= x <= x1, y0 <= y <= y1, depth = base + (slope_x x + slope_y y) / 4. */
static void add_plate(struct set *set, uint16_t name, bool along_plus_z, const int16_t rect[4], const int16_t depth[3])
{
    static const uint8_t corners[4][2] = {{0, 1}, {2, 1}, {2, 3}, {0, 3}};
    int16_t at[4][3];

    for (int i = 0; i < 4; i++) {
        at[i][0] = rect[corners[i][0]];
        at[i][1] = rect[corners[i][1]];
        at[i][2] = (int16_t)(depth[0] + (depth[1] * at[i][0] + depth[2] * at[i][1]) / 4);
    }
    set_add_seen(set, name, along_plus_z, 4, (const int16_t(*)[3])at);
}

#define RECT(x0, y0, x1, y1) ((const int16_t[4]){x0, y0, x1, y1})
#define DEPTH(base, slope_x, slope_y) ((const int16_t[3]){base, slope_x, slope_y})

/* S1 reaches farthest, but S2 lies behind the part of it that covers S2; and so do S2 and S3. */
static void make_three(struct set *set, bool along_plus_z)
{
    set_init(set);
    add_plate(set, '1', along_plus_z, RECT(-400, -400, 1600, 400), DEPTH(2000, 4, 0));
    add_plate(set, '2', along_plus_z, RECT(-400, -400, 200, 1200), DEPTH(2700, 0, 2));
    add_plate(set, '3', along_plus_z, RECT(-300, -300, 100, 100), DEPTH(3000, 0, 0));
}

static void with_depths_apart_farthest_points_are_right(void **state)
{
    struct set set;
    struct set_view view;

    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        const struct lim_camera camera = set_camera(sign);
        set_init(&set);
        add_plate(&set, 1, sign, RECT(-500, -500, 500, 500), DEPTH(1500, 1, 1));
        add_plate(&set, 2, sign, RECT(-900, -900, 300, 900), DEPTH(3000, -1, 1));
        add_plate(&set, 3, sign, RECT(-300, -900, 900, 600), DEPTH(2200, 1, 0));
        set_draw(&set, LIM_DEPTH, NULL, -1, &camera, &view);
        const struct compare_counts counts = set_compare(&set, &view, sign);
        assert_true(counts.wrong <= 12); /* edges through the centres of pixels */
        assert_int_equal(counts.beyond, 0);
        set_view_free(&view);
    }
}

static void by_farthest_point_they_are_1_2_3(void **state)
{
    struct set set;
    struct set_view view;
    char order[16];

    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        const struct lim_camera camera = set_camera(sign);
        make_three(&set, sign);
        set_draw(&set, LIM_DEPTH, NULL, -1, &camera, &view);
        set_order(&view, order);
        assert_string_equal(order, "123");
        set_view_free(&view);
    }
}

static void S1_S2_S3_become_S2_S1_S3_and_then_S3_S2_S1(void **state)
{
    struct set set;
    struct set_view view;
    char order[16];

    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        const struct lim_camera camera = set_camera(sign);
        make_three(&set, sign);
        set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
        set_order(&view, order);
        assert_string_equal(order, "321");
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        assert_int_equal(stats->swaps, 2);
        assert_int_equal(stats->splits, 0);
        set_view_free(&view);
    }
}

/* P and Q pass through each other along the line x = 0, depth 2000; Q reaches farther. */
static void make_crossing(struct set *set, bool along_plus_z)
{
    set_init(set);
    add_plate(set, 'Q', along_plus_z, RECT(-800, -400, 1200, 400), DEPTH(2000, 4, 0));
    add_plate(set, 'P', along_plus_z, RECT(-1000, -300, 800, 300), DEPTH(2000, -4, 0));
}

/* P1 and Q2 are the farther pieces, P2 and Q1 the nearer ones: of each polygon its first and second in the list. */
static void name_pieces(const struct set_view *view, char *names)
{
    char order[16];
    bool p_seen = false, q_seen = false;

    set_order(view, order);
    for (const char *at = order; *at; at++) {
        *names++ = *at;
        *names++ = *at == 'P' ? (p_seen ? '2' : '1') : (q_seen ? '1' : '2');
        if (*at == 'P')
            p_seen = true;
        else
            q_seen = true;
    }
    *names = 0;
}

static void two_that_pass_through_each_other_become_Q2_P1_P2_Q1(void **state)
{
    struct set set;
    struct set_view view;
    char names[32];

    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        const struct lim_camera camera = set_camera(sign);
        make_crossing(&set, sign);
        set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
        name_pieces(&view, names);
        assert_string_equal(names, "Q2P1P2Q1");
        assert_int_equal(lim_stats(&view.lim)->newell.splits, 2);
        set_view_free(&view);
    }
}

static void with_the_option_only_one_of_them_is_split(void **state)
{
    const struct lim_newell_options options = {.split_one = true};
    const struct lim_camera camera = set_camera(false);
    struct set set;
    struct set_view view, other;

    (void)state;
    make_crossing(&set, false);
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
    set_draw(&set, LIM_NEWELL, &options, -1, &camera, &other);
    assert_int_equal(lim_stats(&other.lim)->newell.splits, 1);
    assert_memory_equal(view.pixels, other.pixels, sizeof view.pixels);
    set_view_free(&view);
    set_view_free(&other);
}

/* Bars that rise from behind the one before to before the one after: 1 hides 2, 2 hides 3, 3 hides 1. */
static void make_ring_of(struct set *set, const uint16_t colours[3], uint8_t alpha, bool along_plus_z)
{
    static const int16_t bars[3][4][3] = {
        {{-1200, -900, 2300}, {1200, -900, 1700}, {1200, -500, 1700}, {-1200, -500, 2300}},
        {{700, -1200, 2300}, {1100, -1200, 2300}, {-100, 1200, 1700}, {-500, 1200, 1700}},
        {{-700, -1200, 1700}, {500, 1200, 2300}, {100, 1200, 2300}, {-1100, -1200, 1700}}};

    set_init(set);
    set->alpha = alpha;
    for (int i = 0; i < 3; i++)
        set_add_seen(set, colours[i], along_plus_z, 4, bars[i]);
}

static void make_ring(struct set *set, bool along_plus_z)
{
    static const uint16_t names[3] = {1, 2, 3};

    make_ring_of(set, names, 0, along_plus_z);
}

static void assert_right(const struct set *set, const struct set_view *view, bool along_plus_z)
{
    const struct compare_counts counts = set_compare(set, view, along_plus_z);

    assert_true(counts.wrong <= 4);
    assert_int_equal(counts.beyond, 0);
}

static void three_in_a_ring_end_are_split_and_look_as_the_reference(void **state)
{
    struct set set;
    struct set_view view;

    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        const struct lim_camera camera = set_camera(sign);
        make_ring(&set, sign);
        set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        assert_true(stats->splits >= 1);
        assert_int_equal(stats->forced, 0);
        assert_right(&set, &view, sign);
        set_view_free(&view);
        set_draw(&set, LIM_DEPTH, NULL, -1, &camera, &view);
        assert_true(set_compare(&set, &view, sign).holes > 20); /* no order of whole bars is right */
        set_view_free(&view);
    }
}

/* Three thin triangles, each wholly behind the plane of the next, so that only the flags of swapped ones tell. */
static void a_ring_of_swaps_is_found_by_its_flags(void **state)
{
    static const int16_t bars[3][3][3] = {{{-1400, -600, 2425}, {1400, -450, 1650}, {-1400, -300, 2275}},
                                          {{1220, -912, 2425}, {-310, 1437, 1650}, {960, -1062, 2275}},
                                          {{180, 1512, 2425}, {-1090, -987, 1650}, {440, 1362, 2275}}};
    const struct lim_camera camera = set_camera(false);
    struct set set;
    struct set_view view;

    (void)state;
    set_init(&set);
    for (int i = 0; i < 3; i++)
        set_add_seen(&set, (uint16_t)(i + 1), false, 3, bars[i]);
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
    assert_int_equal(lim_stats(&view.lim)->newell.swaps, 3);
    assert_int_equal(lim_stats(&view.lim)->newell.splits, 1);
    assert_int_equal(lim_stats(&view.lim)->newell.forced, 0);
    assert_right(&set, &view, false);
    set_view_free(&view);
}

/* A ridge towards the eye, and a valley: neighbours that share an edge, whose extents in z overlap. One of the shared
 * corners is a unit off, as rounding leaves them. */
static void neighbours_that_share_an_edge_pass_the_plane_tests(void **state)
{
    const struct lim_camera camera = set_camera(false);

    (void)state;
    for (int slope = -2; slope <= 2; slope += 4) {
        const int16_t left[3][3] = {{-900, 0, (int16_t)(2000 + 400 * slope)}, {0, -700, 2000}, {0, 700, 2000}};
        const int16_t right[3][3] = {{900, 0, (int16_t)(2000 + 390 * slope)}, {0, 700, 2001}, {0, -700, 2000}};
        struct set set;
        struct set_view view;
        set_init(&set);
        set_add_seen(&set, 1, false, 3, left);
        set_add_seen(&set, 2, false, 3, right);
        const struct lim_newell_options options = {.planes_first = true};
        set_draw(&set, LIM_NEWELL, &options, -1, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        assert_int_equal(stats->comparisons, 1);
        assert_int_equal(stats->decided[LIM_TEST_P_BEHIND] + stats->decided[LIM_TEST_Q_IN_FRONT], 1);
        assert_right(&set, &view, false);
        set_view_free(&view);
    }
}

/* The plane y = 0 holds the eye. */
static void a_polygon_seen_edge_on_is_dropped(void **state)
{
    const int16_t edge_on[3][3] = {{-900, 0, 1000}, {900, 0, 1000}, {0, 0, 3000}};
    const struct lim_camera camera = set_camera(false);
    struct set set;
    struct set_view view;
    char order[16];

    (void)state;
    make_three(&set, false);
    set_add_seen(&set, 'E', false, 3, edge_on);
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
    set_order(&view, order);
    assert_string_equal(order, "321");
    set_view_free(&view);
}

/* With room for 0, 1, 2 .. splits the frame ends and is whole; from some number on it is right. */
static void without_room_to_split_the_rest_goes_by_farthest_points(void **state)
{
    const struct lim_camera camera = set_camera(false);
    struct set set;
    int pieces = 0;

    (void)state;
    make_ring(&set, false);
    for (;; pieces++) {
        struct set_view view;
        set_draw(&set, LIM_NEWELL, NULL, pieces, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        const bool enough = stats->forced == 0;
        assert_true(stats->splits <= (uint32_t)pieces);
        assert_true(set_compare(&set, &view, false).beyond == 0 || !enough);
        set_view_free(&view);
        if (enough) break;
    }
    assert_in_range(pieces, 1, 6);
}

enum { PANES = 300 };

/* Glass behind the bars: more layers on each line than idle memory holds. */
static void add_panes(struct set *set)
{
    for (int i = 0; i < PANES; i++) {
        const int16_t z = (int16_t)(2400 + 10 * i), out = (int16_t)(z * 2 / 3);
        const int16_t corners[4][3] = {
            {(int16_t)-out, (int16_t)-out, z}, {out, (int16_t)-out, z}, {out, out, z}, {(int16_t)-out, out, z}};
        set_add_seen(set, (lim_index)(0x0841 * (i % 31)), false, 4, corners);
    }
}

/* Pieces of glass: blended from the stack of layers, and, without room for it, line by line far to near. */
static void what_shines_through_pieces_needs_no_memory_either(void **state)
{
    static const uint16_t colours[3] = {0xF800, 0x07E0, 0x001F};
    const struct lim_camera camera = set_camera(false);
    struct set set, opaque;
    struct set_view plenty, least, solid;

    (void)state;
    make_ring_of(&opaque, colours, 0, false);
    set_draw(&opaque, LIM_NEWELL, NULL, -1, &camera, &solid);
    make_ring_of(&set, colours, 100, false);
    add_panes(&set);
    set.scene.limits.layers = 100 + PANES;
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &plenty);
    assert_int_equal(lim_stats(&plenty.lim)->bands, 0);
    assert_true(lim_stats(&plenty.lim)->newell.splits > 0);
    assert_in_range(lim_stats(&plenty.lim)->layers_max, PANES + 2, PANES + 12);
    assert_memory_not_equal(plenty.pixels, solid.pixels, sizeof plenty.pixels);
    set.scene.limits = (struct lim_limits){1, 4, 0, 0, 0, set.scene.limits.pieces, 1, 0, 0};
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &least);
    assert_true(lim_stats(&least.lim)->bands > 10);
    assert_memory_equal(plenty.pixels, least.pixels, sizeof plenty.pixels);
    set_view_free(&plenty);
    set_view_free(&least);
    set_view_free(&solid);
}

/* Bands: what the least memory holds of gaps and retained polygons; the order stays what it is. */
static void any_memory_beside_gives_the_same_picture(void **state)
{
    const struct lim_camera camera = set_camera(false);
    struct set set;
    struct set_view plenty, least;

    (void)state;
    make_ring(&set, false);
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &plenty);
    assert_int_equal(lim_stats(&plenty.lim)->bands, 0);
    set.scene.limits = (struct lim_limits){1, 4, 0, 0, 0, set.scene.limits.pieces, 0, 0, 0};
    set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &least);
    assert_true(lim_stats(&least.lim)->bands > 4);
    assert_int_equal(lim_stats(&least.lim)->newell.splits, lim_stats(&plenty.lim)->newell.splits);
    assert_memory_equal(plenty.pixels, least.pixels, sizeof plenty.pixels);
    set_view_free(&plenty);
    set_view_free(&least);
}

/* A wall, and a plate that comes through it along the upper side of a line: above that the plate is nearer, or below.
 * Of each what is seen, one cell a line that it has, and what goes before them, is all that is retained. */
static void of_a_piece_its_own_lines_are_retained(void **state)
{
    static const int16_t wall[4][3] = {
        {-1200, -1200, 1024}, {1200, -1200, 1024}, {1200, 1200, 1024}, {-1200, 1200, 1024}};
    const struct lim_camera camera = set_camera(false);

    (void)state;
    for (int line = 4; line < SET_SIDE_PX - 4; line++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const int y = (SET_SIDE_PX / 2 - line) * 32;
            const int16_t top = (int16_t)(1024 + sign * (1600 - y) / 4),
                          bottom = (int16_t)(1024 - sign * (1600 + y) / 4);
            const int16_t plate[4][3] = {
                {-1700, -1600, bottom}, {1700, -1600, bottom}, {1700, 1600, top}, {-1700, 1600, top}};
            struct set set;
            struct set_view view;
            set_init(&set);
            set_add_seen(&set, 1, false, 4, wall);
            set_add_seen(&set, 2, false, 4, plate);
            set_draw(&set, LIM_NEWELL, NULL, -1, &camera, &view);
            assert_int_equal(lim_stats(&view.lim)->newell.splits, 2);
            assert_int_equal(lim_stats(&view.lim)->polygons_seen, 2);
            assert_int_equal(lim_stats(&view.lim)->retained_cells_max, 2 * LIM_RETAINED_HEAD_CELLS + SET_SIDE_PX);
            for (int i = 0; i < SET_SIDE_PX; i++)
                assert_int_equal(lim_memory_colour(view.pixels[i][9]), (i < line) == (sign < 0) ? 2 : 1);
            set_view_free(&view);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_depths_apart_farthest_points_are_right),
        cmocka_unit_test(by_farthest_point_they_are_1_2_3),
        cmocka_unit_test(what_shines_through_pieces_needs_no_memory_either),
        cmocka_unit_test(any_memory_beside_gives_the_same_picture),
        cmocka_unit_test(S1_S2_S3_become_S2_S1_S3_and_then_S3_S2_S1),
        cmocka_unit_test(two_that_pass_through_each_other_become_Q2_P1_P2_Q1),
        cmocka_unit_test(with_the_option_only_one_of_them_is_split),
        cmocka_unit_test(three_in_a_ring_end_are_split_and_look_as_the_reference),
        cmocka_unit_test(a_ring_of_swaps_is_found_by_its_flags),
        cmocka_unit_test(neighbours_that_share_an_edge_pass_the_plane_tests),
        cmocka_unit_test(a_polygon_seen_edge_on_is_dropped),
        cmocka_unit_test(of_a_piece_its_own_lines_are_retained),
        cmocka_unit_test(without_room_to_split_the_rest_goes_by_farthest_points),
    };

    return cmocka_run_group_tests_name("newell", tests, NULL, NULL);
}
