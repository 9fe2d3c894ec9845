/* SPDX-License-Identifier: MIT
 *
 * From a record to a polygon on the screen: which edges wireframe leaves out, of a fan's triangles and of what clipping
 * leaves; which triangles there are. Where corners lie test_view.c and test_exact.c say. */
#include "camera.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "screen/project.h"
#include "view/clip.h"

#include <string.h>

enum { POLYGONS = 4000 };

static bool is_hidden(const struct lim_screen_polygon *polygon, unsigned k)
{
    return polygon->hidden[k / 16] >> k % 16 & 1;
}

/* Corners that tell their index. */
static void any_non_monotone(struct lim_screen_polygon *non_monotone, struct random *random)
{
    memset(non_monotone, 0, sizeof *non_monotone);
    non_monotone->n =
        (uint8_t)(random_u64(random) % 2 ? random_in(random, 4, 20) : random_in(random, 4, CLIP_MAX_VERTICES));
    non_monotone->shape.apex = (uint8_t)(random_u64(random) % non_monotone->n);
    non_monotone->colour = (uint16_t)random_u64(random);
    *non_monotone->alpha = (uint8_t)random_u64(random);
    *non_monotone->texture = (uint16_t)random_u64(random);
    *non_monotone->antialiased = random_u64(random) & 1;
    for (unsigned k = 0; k < non_monotone->n; k++)
        non_monotone->at[k] = (struct lim_point){(lim_sub)k, (lim_sub)(k * k % 97)};
    for (size_t i = 0; i < sizeof non_monotone->hidden / sizeof *non_monotone->hidden; i++)
        non_monotone->hidden[i] = (uint16_t)random_u64(random);
}

/* A triangle's edge is the polygon's where it leads on to the next corner; others are not drawn. */
static void a_fan_hides_what_is_no_edge_of_the_polygon(void **state)
{
    struct random random = {201};
    struct lim_screen_polygon non_monotone, triangle;

    (void)state;
    for (int i = 0; i < POLYGONS; i++) {
        unsigned drawn = 0, edges = 0;
        any_non_monotone(&non_monotone, &random);
        memset(&triangle, i & 1 ? 0xFF : 0, sizeof triangle);
        for (unsigned k = 1; k + 2 <= non_monotone.n; k++) {
            lim_project_fan(&non_monotone, (uint8_t)k, &triangle);
            assert_int_equal(triangle.n, 3);
            const unsigned wanted[3] = {non_monotone.shape.apex, (non_monotone.shape.apex + k) % non_monotone.n,
                                        (non_monotone.shape.apex + k + 1) % non_monotone.n};
            for (unsigned e = 0; e < 3; e++) {
                const unsigned from = wanted[e], to = wanted[(e + 1) % 3];
                const bool is_edge = to == (from + 1) % non_monotone.n;
                assert_int_equal(triangle.at[e].x, from);
                assert_int_equal(is_hidden(&triangle, e), !is_edge || is_hidden(&non_monotone, from));
                edges += is_edge;
                drawn += !is_hidden(&triangle, e);
            }
            assert_int_equal(triangle.colour, non_monotone.colour);
            assert_int_equal(*triangle.alpha, *non_monotone.alpha);
            assert_int_equal(*triangle.texture, *non_monotone.texture);
            assert_int_equal(*triangle.antialiased, *non_monotone.antialiased);
        }
        assert_int_equal(edges, non_monotone.n);
        for (unsigned k = 0; k < non_monotone.n; k++)
            drawn -= !is_hidden(&non_monotone, k);
        assert_int_equal(drawn, 0);
    }
}

/* Scenes of one polygon whose flags are random, seen whole: what is projected has the record's flags. */
static void a_record_has_a_flag_an_edge(void **state)
{
    enum { MOST = 40 };
    static struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    static const struct lim_rect open = {0, 0, 200, 200};
    const struct lim_camera camera = {
        .eye_q8 = {0, 0, 1000 * 256}, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};
    struct random random = {202};
    struct lim_screen_polygon polygon;
    struct lim_stats stats = {0};
    struct lim_view view = {0};

    (void)state;
    lim_view_init(&view, 200, 200, cache);
    for (unsigned n = 3; n <= MOST; n++)
        for (int with_flags = 0; with_flags < 2; with_flags++) {
            lim_index record[LIM_POLYGON_HEAD_WORDS + MOST + 16] = {
                (lim_index)(n | (with_flags ? LIM_POLYGON_EDGES : 0) | LIM_POLYGON_LAST), 0xF800};
            struct lim_vertex vertices[MOST];
            for (unsigned k = 0; k < n; k++) {
                record[LIM_POLYGON_HEAD_WORDS + k] = k;
                vertices[k] = (struct lim_vertex){(int16_t)(k < n / 2 ? k * 8 : (n - k) * 8),
                                                  (int16_t)(k < n / 2 ? 8 * n : k * 8 - 8 * n), 0};
            }
            const struct lim_scene scene = {.vertices = vertices, .vertex_count = n, .polygons = record};
            lim_index *flags = record + lim_record_edges_at(record[0]);
            for (unsigned i = 0; i < (n + 15) / 16 && with_flags; i++)
                flags[i] = (uint16_t)random_u64(&random);
            assert_true(lim_view_begin(&view, &scene, &camera));
            memset(&polygon, 0xFF, sizeof polygon);
            if (!lim_project(&polygon, &view, &scene, record, &open, &stats)) continue;
            assert_int_equal(polygon.n, n);
            for (unsigned k = 0; k < n; k++)
                assert_int_equal(is_hidden(&polygon, k), with_flags && (flags[k / 16] >> k % 16 & 1));
        }
    assert_true(stats.polygons > MOST);
    assert_int_equal(stats.clipped, 0);
}

/* Whether a cut point lies between two corners, where it has to within rounding. */
static bool lies_between(const struct lim_view_point *at, const struct lim_view_point *a,
                         const struct lim_view_point *b)
{
    double along[3], to[3], dot = 0, square = 0, off = 0;

    for (int i = 0; i < 3; i++) {
        along[i] = (double)b->qv[i] - a->qv[i];
        to[i] = (double)at->qv[i] - a->qv[i];
        dot += along[i] * to[i];
        square += along[i] * along[i];
    }
    for (int i = 0; i < 3; i++)
        off += (to[i] - along[i] * dot / square) * (to[i] - along[i] * dot / square);
    return off < 100.0 * 100.0 && dot > -1e3 * 1e6 && dot < square + 1e3 * 1e6;
}

/* A square around the axis that one plane cuts: what is left of each edge is drawn if the edge is, the cut never. */
static void what_clipping_leaves_of_an_edge_keeps_its_flag_and_a_cut_has_none(void **state)
{
    enum { NEAR_QV = 1 << 16, SIDE_QV = 1 << 20 };
    static const int32_t shifts_qv[][3] = {{3 * SIDE_QV, 0, 2 * SIDE_QV},
                                           {-3 * SIDE_QV, 0, 2 * SIDE_QV},
                                           {0, 3 * SIDE_QV, 2 * SIDE_QV},
                                           {0, -3 * SIDE_QV, 2 * SIDE_QV}};
    unsigned cuts = 0;

    (void)state;
    for (size_t plane = 0; plane < sizeof shifts_qv / sizeof *shifts_qv; plane++)
        for (unsigned flags = 0; flags < 16; flags++)
            for (unsigned first = 0; first < 4; first++) {
                struct lim_clip_polygon polygons[2] = {{.n = 4}};
                struct lim_view_point whole[4];
                for (unsigned k = 0; k < 4; k++) {
                    const unsigned corner = (k + first) % 4;
                    whole[k] = (struct lim_view_point){.x_qv = shifts_qv[plane][0] +
                                                               (corner == 1 || corner == 2 ? 2 : -2) * SIDE_QV,
                                                       .y_qv = shifts_qv[plane][1] + (corner >= 2 ? 2 : -2) * SIDE_QV,
                                                       .z_qv = shifts_qv[plane][2],
                                                       .hidden = {flags >> k & 1}};
                    polygons[0].at[k] = whole[k];
                }
                const struct lim_clip_polygon *clipped = lim_clip(polygons, NEAR_QV);
                assert_int_equal(clipped->n, 4);
                for (unsigned k = 0; k < clipped->n; k++) {
                    const struct lim_view_point *from = &clipped->at[k], *to = &clipped->at[(k + 1) % clipped->n];
                    unsigned owner = 4;
                    for (unsigned e = 0; e < 4; e++)
                        if (lies_between(from, &whole[e], &whole[(e + 1) % 4]) &&
                            lies_between(to, &whole[e], &whole[(e + 1) % 4]))
                            owner = e;
                    assert_int_equal(*from->hidden, owner == 4 ? 1 : flags >> owner & 1);
                    cuts += owner == 4;
                }
            }
    assert_int_equal(cuts, 4 * 16 * 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fan_hides_what_is_no_edge_of_the_polygon),
        cmocka_unit_test(a_record_has_a_flag_an_edge),
        cmocka_unit_test(what_clipping_leaves_of_an_edge_keeps_its_flag_and_a_cut_has_none),
    };
    return cmocka_run_group_tests_name("project", tests, NULL, NULL);
}
