/* SPDX-License-Identifier: MIT
 *
 * Planes come from cross products, in integers; what is too long for a record is stored exactly beside it. */
#include "set_rig.h"

#include "cmocka_ready.h"
#include "colour.h"
#include "scene/plane.h"
#include "unpainted.h"

#include <stdlib.h>
#include <string.h>

void set_init(struct set *set)
{
    memset(set, 0, sizeof *set);
    set->leaf = (struct lim_node){{LIM_NO_INDEX, 0}, LIM_NO_INDEX, LIM_NO_INDEX, 0, LIM_NO_INDEX, LIM_NO_INDEX};
    set->scene = (struct lim_scene){.vertices = set->vertices,
                                    .nodes = &set->leaf,
                                    .planes = set->planes,
                                    .exact = set->exact,
                                    .polygons = set->polygons,
                                    .node_count = 1,
                                    .limits = {1, 4, 4000, 2000, 600, 300, 0}};
}

static int64_t common_divisor(int64_t a, int64_t b)
{
    while (b) {
        const int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a < 0 ? -a : a;
}

/* n . p = d through three corners, n towards who sees them counter-clockwise. */
static void plane_through(const int16_t (*corners)[3], int64_t n[3], int64_t *d)
{
    int64_t a[3], b[3], divisor = 0;

    for (int i = 0; i < 3; i++) {
        a[i] = corners[1][i] - corners[0][i];
        b[i] = corners[2][i] - corners[0][i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = a[j] * b[k] - a[k] * b[j];
        divisor = common_divisor(divisor, n[i]);
    }
    assert_true(divisor > 0);
    for (int i = 0; i < 3; i++)
        n[i] /= divisor;
    *d = n[0] * corners[0][0] + n[1] * corners[0][1] + n[2] * corners[0][2];
}

static lim_index add_plane(struct set *set, const int16_t (*corners)[3])
{
    struct lim_scene *scene = &set->scene;
    int64_t n[3], d;

    plane_through(corners, n, &d);
    const int64_t sum = llabs(n[0]) + llabs(n[1]) + llabs(n[2]);
    if (sum <= PLANE_SUM_MAX && llabs(d) <= LIM_PLANE_D_MAX) {
        set->planes[scene->plane_count] = plane_record(n, d);
    } else {
        set->exact[scene->exact_count] =
            (struct lim_plane_exact){{(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]}, (int32_t)(d >> 32), (uint32_t)d};
        set->planes[scene->plane_count] = plane_filter(n, d, scene->exact_count++);
    }
    return (uint16_t)(scene->plane_count++ * LIM_PLANE_WORDS);
}

void set_add(struct set *set, lim_index name, int count, const int16_t (*corners)[3])
{
    struct lim_scene *scene = &set->scene;
    lim_index *record = &set->polygons[scene->polygon_words];

    assert_true(scene->polygon_count < SET_POLYGONS && count >= 3 && count <= 4);
    if (scene->polygon_count++) set->polygons[set->last] &= (lim_index)~LIM_POLYGON_LAST;
    set->last = scene->polygon_words;
    record[0] = (lim_index)((unsigned)count | LIM_POLYGON_PLANE | LIM_POLYGON_LAST);
    if (set->alpha) record[0] |= LIM_POLYGON_ALPHA;
    record[1] = name;
    for (int i = 0; i < count; i++) {
        record[2 + i] = scene->vertex_count;
        set->vertices[scene->vertex_count++] = (struct lim_vertex){corners[i][0], corners[i][1], corners[i][2]};
    }
    record[2 + count] = add_plane(set, corners);
    record[3 + count] = 0;
    if (set->alpha) record[4 + count] = set->alpha;
    scene->polygon_words = (lim_index)(scene->polygon_words + lim_record_words(record[0]));
}

void set_add_seen(struct set *set, lim_index name, bool along_plus_z, int count, const int16_t (*corners)[3])
{
    int16_t units[4][3];

    for (int i = 0; i < count; i++) {
        units[i][0] = along_plus_z ? (int16_t)-corners[i][0] : corners[i][0];
        units[i][1] = corners[i][1];
        units[i][2] = along_plus_z ? corners[i][2] : (int16_t)-corners[i][2];
    }
    set_add(set, name, count, (const int16_t(*)[3])units);
}

struct lim_camera set_camera(bool along_plus_z)
{
    return (struct lim_camera){.yaw = along_plus_z ? UINT32_C(1) << 31 : 0,
                               .tan_x_q28 = UINT32_C(1) << 28,
                               .tan_y_q28 = UINT32_C(1) << 28,
                               .near_q8 = 256};
}

/* A piece takes an entry, and leaves two cuts. */
#define PIECE_B (sizeof(struct lim_sorted) + sizeof(struct lim_newell_polygon) + 2 * sizeof(struct lim_cut))

static void *lend(void *ctx, uint16_t y_px)
{
    return ((struct set_view *)ctx)->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)y_px;
    (void)x_px;
    ((struct set_view *)ctx)->done_px += n_px;
    return 0;
}

void set_draw(const struct set *set, enum lim_method method, const struct lim_newell_options *options, int pieces,
              const struct lim_camera *camera, struct set_view *view)
{
    const struct lim_scene *scene = &set->scene;
    const struct lim_target target = {.w_px = SET_SIDE_PX,
                                      .h_px = SET_SIDE_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = view,
                                      .lend = lend,
                                      .done = done};
    const size_t mem_b = lim_mem_b(scene, &target) + (pieces < 0 ? 0 : (size_t)pieces * PIECE_B);

    const uint16_t unpainted = unused_colour(scene);
    const size_t px = SET_SIDE_PX * SET_SIDE_PX;
    uint16_t *const pixels = &view->pixels[0][0];

    memset(view, 0, sizeof *view);
    wipe_pixels(pixels, px, unpainted);
    view->mem = malloc(mem_b);
    assert_non_null(view->mem);
    assert_int_equal(lim_init(&view->lim, scene, &target, view->mem, mem_b), LIM_OK);
    if (options) lim_newell_set(&view->lim, options);
    if (pieces >= 0) view->lim.sorter->newell->cut_size = (uint16_t)(2 * pieces);
    assert_int_equal(lim_frame(&view->lim, camera), LIM_OK);
    const struct lim_stats *stats = lim_stats(&view->lim);
    assert_int_equal(view->done_px, px);
    if (set->alpha) return;
    assert_int_equal(count_pixels(pixels, px, unpainted), 0);
    assert_int_equal(stats->pixels_background, count_pixels(pixels, px, scene->background));
    assert_true(stats->pixels_painted + stats->pixels_background >= px);
}

static void add_to_mesh(const struct set *set, const lim_index *record, struct mesh *mesh)
{
    const uint32_t count = record[0] & LIM_POLYGON_COUNT;

    mesh->polygons[mesh->polygon_count] = (struct mesh_polygon){
        .first = (uint32_t)mesh->corner_count, .count = count, .face = (uint32_t)++mesh->polygon_count};
    for (uint32_t i = 0; i < count; i++, mesh->corner_count++) {
        const struct lim_vertex *at = &set->vertices[record[LIM_POLYGON_HEAD_WORDS + i]];
        double *point = mesh->points[mesh->corner_count];
        mesh->corners[mesh->corner_count] = (uint32_t)mesh->corner_count;
        point[0] = at->x;
        point[1] = at->y;
        point[2] = at->z;
    }
}

struct compare_counts set_compare(const struct set *set, const struct set_view *view, bool along_plus_z)
{
    static double points[SET_VERTICES][3];
    static uint32_t corners[SET_VERTICES], faces[SET_SIDE_PX * SET_SIDE_PX];
    static struct mesh_polygon polygons[SET_POLYGONS + 1];
    struct mesh mesh = {.points = points, .corners = corners, .polygons = polygons};
    const struct viewpoint viewpoint = {.target_m = {0, 0, along_plus_z ? 1 : -1}};
    const struct lens lens = {.tan_x = 1, .tan_y = 1, .near_m = 1};
    struct reference reference;
    struct error err;

    for (lim_index at = 0; at < set->scene.polygon_words; at = (lim_index)(at + lim_record_words(set->polygons[at])))
        add_to_mesh(set, &set->polygons[at], &mesh);
    assert_true(reference_init(&reference, &mesh, SET_SIDE_PX, SET_SIDE_PX, &err));
    reference_draw(&reference, &viewpoint, &lens);
    for (int i = 0; i < SET_SIDE_PX * SET_SIDE_PX; i++)
        faces[i] = lim_memory_colour(view->pixels[i / SET_SIDE_PX][i % SET_SIDE_PX]);
    const struct compare_counts counts = compare_picture(faces, &reference, NULL, 1);
    reference_free(&reference);
    return counts;
}

void set_view_free(struct set_view *view)
{
    free(view->mem);
}

void set_order(const struct set_view *view, char *names)
{
    const struct lim_sorter *sorter = view->lim.sorter;
    size_t count = 0;

    for (uint16_t at = sorter->first; at != LIM_NONE; at = sorter->list[at].next)
        count++;
    names[count] = 0;
    for (uint16_t at = sorter->first; at != LIM_NONE; at = sorter->list[at].next)
        names[--count] = (char)view->lim.pass.scene->polygons[sorter->list[at].record + 1];
}
