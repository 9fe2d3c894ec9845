/* SPDX-License-Identifier: MIT
 *
 * Writes nodes, runs of polygon records, planes and vertices in the order in which a walk comes
 * to them: each node, then its front subtree, then its back subtree. */
#include "compiler/encode.h"

#include "base/grow.h"
#include "base/rgb565.h"
#include "colour.h"
#include "compiler/encode_texture.h"
#include "compiler/encode_vertex.h"
#include "compiler/outline.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What encoding needs to remember on the way. */
struct encoder {
    const struct bsp *bsp;
    struct encoding *out;
    bool with_edges;
    struct grid_point *snapped; /* the exact points, rounded */
    struct vertex_encoder vertices;
    struct map planes;           /* group -> index */
    uint32_t *member;            /* of each group: a polygon in it */
    struct outline outline;      /* the piece at hand */
    uint16_t flags;              /* of its records */
    struct vertex_encoder *leaf; /* of the mesh leaf at hand, whose vertices are its own; NULL: there is none */
    struct texture_encoder textures;
    struct lim_plane_ref own;   /* with LIM_POLYGON_PLANE: their plane */
    struct texture_plane plane; /* of the records at hand */
};

/* Records ------------------------------------------------------------------------------------ */

static void word_add(struct encoding *out, size_t word)
{
    out->words = grow(out->words, out->word_count, &out->word_capacity, sizeof *out->words);
    out->words[out->word_count++] = (lim_index)word;
}

static bool outline_hides(const struct outline *outline)
{
    for (size_t i = 0; i < outline->count; i++)
        if (outline->hidden[i]) return true;
    return false;
}

static void edges_add_words(struct encoding *out, const struct outline *outline)
{
    for (size_t first = 0; first < outline->count; first += 16) {
        size_t word = 0;
        for (size_t k = first; k < outline->count && k < first + 16; k++)
            word |= (size_t)outline->hidden[k] << (k - first);
        word_add(out, word);
    }
}

/* In a mesh leaf its own, which whoever comes later may name, too. */
static uint32_t corner_encode(struct encoder *work, struct grid_point point)
{
    if (!work->leaf) return vertex_encode(&work->vertices, point);
    const uint32_t index = vertex_encode(work->leaf, point);
    vertex_encode_known(&work->vertices, point, index);
    return index;
}

static void record_add(struct encoder *work, const struct outline *outline, const struct mesh_polygon *polygon)
{
    struct encoding *out = work->out;
    out->faces = grow(out->faces, out->record_count, &out->face_capacity, sizeof *out->faces);
    out->faces[out->record_count++] = polygon->face;
    out->last_record = out->word_count;
    const bool with_edges = work->with_edges && outline_hides(outline);
    uint16_t texture[LIM_POLYGON_TEXTURE_WORDS];
    const bool is_textured = (!polygon->transparency || texture_is_masked(work->bsp->mesh, polygon)) &&
                             texture_encode(&work->textures, polygon, &work->plane, texture);
    word_add(out, outline->count | work->flags | (polygon->transparency ? LIM_POLYGON_ALPHA : 0u) |
                      (with_edges ? LIM_POLYGON_EDGES : 0u) | (is_textured ? LIM_POLYGON_TEXTURE : 0u));
    word_add(out, rgb565_nearest(polygon->mapping ? texture_flat_colour(work->bsp->mesh, polygon) : polygon->colour));
    for (size_t i = 0; i < outline->count; i++)
        word_add(out, corner_encode(work, outline->corners[i]));
    if (work->flags & LIM_POLYGON_PLANE) {
        word_add(out, work->own.plane);
        word_add(out, (lim_index)work->own.offset);
    }
    if (polygon->transparency) word_add(out, LIM_OPAQUE - polygon->transparency);
    if (with_edges) edges_add_words(out, outline);
    for (size_t i = 0; work->flags & LIM_POLYGON_MESH && i < LIM_POLYGON_MESH_WORDS; i++)
        word_add(out, 0); /* known in the end */
    work->flags &= (uint16_t)~LIM_POLYGON_MESH;
    for (size_t i = 0; is_textured && i < LIM_POLYGON_TEXTURE_WORDS; i++)
        word_add(out, texture[i]);
    out->widest = outline->count > out->widest ? outline->count : out->widest;
}

static struct outline outline_part(const struct outline *whole, size_t from, size_t count)
{
    struct outline part = {.count = count,
                           .corners = grow_zeroed(count, sizeof *part.corners),
                           .hidden = grow_zeroed(count, sizeof *part.hidden)};
    for (size_t i = 0; i < count; i++) {
        part.corners[i] = whole->corners[(from + i) % whole->count];
        part.hidden[i] = i + 1 == count || whole->hidden[(from + i) % whole->count]; /* the last one is the chord */
    }
    return part;
}

/* An outline with too many corners is halved; each level halves their number. */
static void outline_encode(struct encoder *work, const struct outline *outline, const struct mesh_polygon *polygon)
{
    if (outline->count <= LIM_MAX_VERTICES) {
        record_add(work, outline, polygon);
        return;
    }
    size_t from = outline_chord(outline), half = outline->count / 2;
    struct outline parts[2] = {outline_part(outline, from, half + 1),
                               outline_part(outline, from + half, outline->count - half + 1)};
    for (int i = 0; i < 2; i++) {
        outline_encode(work, &parts[i], polygon);
        outline_free(&parts[i]);
    }
}

static void outline_turn(struct outline *outline)
{
    for (size_t i = 0, j = outline->count; i + 1 < j; i++) {
        struct grid_point corner = outline->corners[i];
        outline->corners[i] = outline->corners[--j];
        outline->corners[j] = corner;
    }
    for (size_t i = 0, j = outline->count - 1; i + 1 < j; i++) { /* the last edge stays the last */
        bool hidden = outline->hidden[i];
        outline->hidden[i] = outline->hidden[--j];
        outline->hidden[j] = hidden;
    }
}

static void piece_encode(struct encoder *work, uint32_t index, bool back_run)
{
    const struct bsp_piece *piece = &work->bsp->pieces[index];
    const struct mesh_polygon *polygon = &work->bsp->mesh->polygons[piece->polygon];
    bool turned = work->bsp->coplanar->faces_back[piece->polygon] != back_run;
    if (turned && !polygon->two_sided) return;
    outline_trace(work->bsp, piece, work->snapped, &work->outline);
    if (turned && work->outline.count) outline_turn(&work->outline);
    if (work->outline.count) outline_encode(work, &work->outline, polygon);
}

/* A node's pieces, nearest first where they lie over one another as that side sees them. The caller frees them. */
static uint32_t *run_order(const struct bsp *bsp, const struct bsp_node *node, bool back_run)
{
    uint32_t *pieces = grow_zeroed(node->count, sizeof *pieces), *polygons = grow_zeroed(node->count, sizeof *polygons);
    bool *in_front = grow_zeroed(node->count, sizeof *in_front);
    for (size_t i = 0; i < node->count; i++) {
        polygons[i] = bsp->pieces[bsp->placed[node->first + i]].polygon;
        in_front[i] = bsp->coplanar->faces_back[polygons[i]] == back_run;
    }
    layers_order(&bsp->coplanar->layers, polygons, in_front, node->count, pieces);
    for (size_t i = 0; i < node->count; i++)
        pieces[i] = bsp->placed[node->first + pieces[i]];
    free(polygons);
    free(in_front);
    return pieces;
}

/* The records of a node's pieces that are seen from one side; their word offset or LIM_NO_INDEX. */
static size_t run_encode(struct encoder *work, const struct bsp_node *node, bool back_run)
{
    struct encoding *out = work->out;
    size_t first = out->word_count;
    work->flags = 0;
    uint32_t *pieces = run_order(work->bsp, node, back_run);
    for (size_t i = 0; i < node->count; i++)
        piece_encode(work, pieces[i], back_run);
    free(pieces);
    if (out->word_count == first) return LIM_NO_INDEX;
    out->words[out->last_record] |= LIM_POLYGON_LAST;
    return first;
}

/* Planes ------------------------------------------------------------------------------------- */

static size_t exact_add(struct encoding *out, const struct plane *plane)
{
    out->exact = grow(out->exact, out->exact_count, &out->exact_capacity, sizeof *out->exact);
    struct lim_plane_exact *exact = &out->exact[out->exact_count];
    for (int i = 0; i < 3; i++)
        exact->n[i] = (int32_t)plane->n[i];
    exact->d_lo = (uint32_t)plane->d;
    exact->d_hi = (int32_t)((plane->d - exact->d_lo) / (INT64_C(1) << 32));
    return out->exact_count++;
}

/* A plane as long as the bounds of scene.h allow is the same plane, and fewer eyes are too close to it for 16 bits. */
static struct lim_plane small_record(const struct plane *plane)
{
    const int64_t sum = llabs(plane->n[0]) + llabs(plane->n[1]) + llabs(plane->n[2]), d = llabs(plane->d);
    const int64_t by_sum = PLANE_SUM_MAX / sum, by_d = d ? LIM_PLANE_D_MAX / d : by_sum;
    const int64_t factor = by_sum < by_d ? by_sum : by_d;
    assert(factor >= 1); /* plane.c */
    const int64_t n[3] = {plane->n[0] * factor, plane->n[1] * factor, plane->n[2] * factor};
    return plane_record(n, plane->d * factor);
}

/* n . v of a vertex. */
static int64_t dot_long(const struct plane *plane, const struct lim_long_vertex *vertex)
{
    return plane->n[0] * vertex->at[0] + plane->n[1] * vertex->at[1] + plane->n[2] * vertex->at[2];
}

/* A vertex on the plane or as near as the grid has one: where the foot of `near` on it is rounded to. */
static uint32_t vertex_on_plane(struct encoder *work, const struct plane *plane, const double near[3])
{
    struct grid_point point;
    const double distance = plane_distance(plane, near);
    for (int i = 0; i < 3; i++)
        point.q8[i] = (int64_t)llround(near[i] - distance * (double)plane->n[i] / plane->length) * 256;
    return vertex_encode(&work->vertices, point);
}

static void long_plane_add(struct encoder *work, const struct plane *plane, const double near[3])
{
    struct encoding *out = work->out;
    const uint32_t vertex = vertex_on_plane(work, plane, near);
    const int64_t rest = plane->d - dot_long(plane, &out->long_vertices[vertex]);
    assert(rest >= INT32_MIN && rest <= INT32_MAX); /* 3/2 units at most, of 2^30 */
    out->long_planes = grow(out->long_planes, out->plane_count, &out->plane_capacity, sizeof *out->long_planes);
    out->long_planes[out->plane_count++] = (struct lim_long_plane){
        {(int32_t)plane->n[0], (int32_t)plane->n[1], (int32_t)plane->n[2]}, (int32_t)rest, vertex};
}

/* Of a long scene: a point of it, near what lies on it. */
static void point_of_group(const struct encoder *work, uint32_t group, double out[3])
{
    const struct bsp *bsp = work->bsp;
    const struct mesh *mesh = bsp->mesh;
    memset(out, 0, 3 * sizeof *out);
    if (group >= bsp->coplanar->count) return; /* a cut: of no polygon */
    memcpy(out, bsp->edges.points->approx[mesh->corners[mesh->polygons[work->member[group]].first]], 3 * sizeof *out);
}

static struct lim_plane_ref long_plane_ref(struct encoder *work, uint32_t group)
{
    const struct plane *plane = bsp_plane(work->bsp, group);
    const bool is_axis = plane->kind <= PLANE_Z;
    double near[3];
    point_of_group(work, group, near);
    if (is_axis)
        return (struct lim_plane_ref){LIM_PLANE_X + (lim_index)plane->kind,
                                      (lim_offset)vertex_on_plane(work, plane, near)};
    const uint32_t index = *map_at(&work->planes, group, (uint32_t)work->out->plane_count);
    if (index == work->out->plane_count) long_plane_add(work, plane, near);
    return (struct lim_plane_ref){index, 0};
}

static void plane_add(struct encoding *out, const struct plane *plane)
{
    out->planes = grow(out->planes, out->plane_count, &out->plane_capacity, sizeof *out->planes);
    out->planes[out->plane_count++] = plane->kind == PLANE_LARGE
                                          ? plane_filter(plane->n, plane->d, (lim_index)exact_add(out, plane))
                                          : small_record(plane);
}

/* Where a node or a record finds its plane. */
static struct lim_plane_ref plane_ref(struct encoder *work, uint32_t group)
{
    const struct plane *plane = bsp_plane(work->bsp, group);
    if (work->out->is_long) return long_plane_ref(work, group);
    if (plane->kind <= PLANE_Z)
        return (struct lim_plane_ref){LIM_PLANE_X + (lim_index)plane->kind, (lim_offset)plane->d};
    uint32_t index = *map_at(&work->planes, group, (uint32_t)work->out->plane_count);
    if (index == work->out->plane_count) plane_add(work->out, plane);
    return (struct lim_plane_ref){index * LIM_PLANE_WORDS, 0};
}

static struct texture_plane long_texture_plane_of(const struct encoder *work, struct lim_plane_ref ref)
{
    struct texture_plane out = {.ref = ref, .is_long = true};
    uint32_t vertex = (lim_index)ref.offset;
    if (ref.plane >= LIM_PLANE_X)
        out.n[ref.plane - LIM_PLANE_X] = ldexp(1, 30);
    else {
        const struct lim_long_plane *plane = &work->out->long_planes[ref.plane];
        for (int i = 0; i < 3; i++)
            out.n[i] = plane->n[i];
        out.d = plane->rest;
        vertex = plane->vertex;
    }
    for (int i = 0; i < 3; i++) {
        out.at[i] = work->out->long_vertices[vertex].at[i];
        out.d += out.n[i] * out.at[i];
    }
    return out;
}

static struct texture_plane texture_plane_of(const struct encoder *work, struct lim_plane_ref ref)
{
    struct texture_plane out = {.ref = ref};
    if (work->out->is_long) return long_texture_plane_of(work, ref);
    if (ref.plane >= LIM_PLANE_X) {
        out.n[ref.plane - LIM_PLANE_X] = LIM_MAPPING_UPRIGHT_N;
        out.d = LIM_MAPPING_UPRIGHT_N * (double)ref.offset;
        return out;
    }
    const struct lim_plane *plane = lim_plane_at(work->out->planes, ref.plane);
    out.n[0] = lim_plane_x(plane);
    out.n[1] = lim_plane_y(plane);
    out.n[2] = lim_plane_z(plane);
    out.d = lim_plane_d(plane);
    return out;
}

/* Nodes -------------------------------------------------------------------------------------- */

/* For each node of the tree the node that takes its place: itself if it has something to draw or
 * to divide, its only child otherwise, BSP_NONE if its whole subtree rounded to nothing. */
static uint32_t *find_heirs(struct encoder *work)
{
    const struct bsp *bsp = work->bsp;
    uint32_t *heirs = grow_zeroed(bsp->node_count, sizeof *heirs);
    for (uint32_t i = (uint32_t)bsp->node_count; i-- > 0;) {
        const struct bsp_node *node = &bsp->nodes[i];
        size_t drawn = 0;
        for (size_t k = 0; k < node->count; k++) {
            outline_trace(bsp, &bsp->pieces[bsp->placed[node->first + k]], work->snapped, &work->outline);
            drawn += work->outline.count > 0;
        }
        work->out->collapsed += node->count - drawn;
        uint32_t front = node->front == BSP_NONE ? BSP_NONE : heirs[node->front];
        uint32_t back = node->back == BSP_NONE ? BSP_NONE : heirs[node->back];
        bool needed = drawn || (front != BSP_NONE && back != BSP_NONE);
        heirs[i] = needed ? i : front != BSP_NONE ? front : back;
    }
    return heirs;
}

static lim_index child_index(const uint32_t *heirs, const uint32_t *numbers, uint32_t child)
{
    return child == BSP_NONE || heirs[child] == BSP_NONE ? LIM_NO_INDEX : numbers[heirs[child]];
}

/* A leaf's pieces in their order, with a record for each side from which one is seen. */
static size_t leaf_encode(struct encoder *work, const struct bsp_node *node)
{
    size_t first = work->out->word_count;
    for (size_t i = 0; i < node->count; i++) {
        const uint32_t index = work->bsp->placed[node->first + i];
        work->own = plane_ref(work, work->bsp->coplanar->group[work->bsp->pieces[index].polygon]);
        work->plane = texture_plane_of(work, work->own);
        for (int back = 0; back < 2; back++) {
            work->flags = (uint16_t)(LIM_POLYGON_PLANE | (back ? LIM_POLYGON_BACK : 0));
            piece_encode(work, index, back);
        }
    }
    work->out->words[work->out->last_record] |= LIM_POLYGON_LAST;
    return first;
}

/* The plane on which a polygon's texture lies. */
static void set_texture_plane(struct encoder *work, uint32_t polygon)
{
    if (work->bsp->mesh->polygons[polygon].mapping)
        work->plane = texture_plane_of(work, plane_ref(work, work->bsp->coplanar->group[polygon]));
}

/* What the first record says of a mesh leaf of `records` records whose vertices are the newest ones. The box is not
 * known yet. */
static void mesh_words_set(struct encoding *out, size_t run, size_t first_vertex, size_t records)
{
    const size_t at = (size_t)(lim_mesh_leaf_words(&out->words[run]) - out->words);
    const size_t vertices = out->vertex_count - first_vertex;
    out->words[at + LIM_MESH_LEAF_FIRST] = (lim_index)first_vertex;
    out->words[at + LIM_MESH_LEAF_COUNT] = (lim_index)vertices;
    out->words[at + LIM_MESH_LEAF_POLYGONS] = (lim_index)records;
    out->leaf_vertices = vertices > out->leaf_vertices ? vertices : out->leaf_vertices;
    out->leaf_polygons = records > out->leaf_polygons ? records : out->leaf_polygons;
}

/* A mesh leaf's pieces, with a record for each side from which one is seen, and vertices of their own. */
static size_t mesh_leaf_encode(struct encoder *work, const struct bsp_node *node)
{
    struct encoding *out = work->out;
    struct vertex_encoder vertices = {.out = out, .with_fractions = work->vertices.with_fractions};
    const size_t first = out->word_count, first_vertex = out->vertex_count, first_record = out->record_count;
    work->leaf = &vertices;
    work->flags = LIM_POLYGON_MESH;
    for (size_t i = 0; i < node->count; i++) {
        const uint32_t index = work->bsp->placed[node->first + i];
        set_texture_plane(work, work->bsp->pieces[index].polygon);
        for (int back = 0; back < 2; back++)
            piece_encode(work, index, back);
    }
    work->leaf = NULL;
    vertex_encoder_free(&vertices);
    out->words[out->last_record] |= LIM_POLYGON_LAST;
    mesh_words_set(out, first, first_vertex, out->record_count - first_record);
    return first;
}

static struct lim_node node_encode(struct encoder *work, const struct bsp_node *node)
{
    struct lim_node out = {.front = LIM_NO_INDEX, .back = LIM_NO_INDEX, .box = LIM_NO_INDEX};
    if (node->group == BSP_NONE) {
        out.split.plane = out.back_run = LIM_NO_INDEX;
        out.front_run = (lim_index)(node->is_mesh ? mesh_leaf_encode : leaf_encode)(work, node);
        return out;
    }
    out.split = plane_ref(work, node->group);
    work->plane = texture_plane_of(work, out.split);
    out.front_run = (lim_index)run_encode(work, node, false);
    out.back_run = (lim_index)run_encode(work, node, true);
    return out;
}

/* The tree's nodes come in the order wanted already; only the needed ones are numbered. */
static void nodes_encode(struct encoder *work, const uint32_t *heirs)
{
    const struct bsp *bsp = work->bsp;
    struct encoding *out = work->out;
    uint32_t *numbers = grow_zeroed(bsp->node_count, sizeof *numbers);
    for (uint32_t i = 0; i < bsp->node_count; i++)
        if (heirs[i] == i) numbers[i] = (uint32_t)out->node_count++;
    out->nodes = grow_zeroed(out->node_count, sizeof *out->nodes);
    for (uint32_t i = 0; i < bsp->node_count; i++) {
        if (heirs[i] != i) continue;
        struct lim_node node = node_encode(work, &bsp->nodes[i]);
        node.front = child_index(heirs, numbers, bsp->nodes[i].front);
        node.back = child_index(heirs, numbers, bsp->nodes[i].back);
        out->nodes[numbers[i]] = node;
    }
    free(numbers);
}

/* BSP_PIECES_MAX keeps everything else far below what 32 bits count. */
static bool check_counts(const struct encoding *out, struct error *err)
{
    if (out->node_count == 0) return error_set(err, "nothing is left of the scene on its grid");
    if (!encoding_check_count(out->leaf_vertices, "vertices of a mesh leaf", err)) return false;
    return encoding_check_count(out->depth, "levels of the tree", err) && texture_arrays_check(&out->textures, err);
}

/* Parents come before children. */
static size_t tree_depth(const struct encoding *out)
{
    size_t *depths = grow_zeroed(out->node_count, sizeof *depths), deepest = 0;
    for (size_t i = 0; i < out->node_count; i++) {
        const lim_index children[2] = {out->nodes[i].front, out->nodes[i].back};
        deepest = depths[i] + 1 > deepest ? depths[i] + 1 : deepest;
        for (int k = 0; k < 2; k++)
            if (children[k] != LIM_NO_INDEX) depths[children[k]] = depths[i] + 1;
    }
    free(depths);
    return deepest;
}

bool encode_bsp(const struct bsp *bsp, bool with_fractions, bool with_edges, struct encoding *out, struct error *err)
{
    const struct exact_points *points = bsp->edges.points;
    struct encoder work = {
        .bsp = bsp, .out = out, .with_edges = with_edges, .vertices = {.out = out, .with_fractions = with_fractions}};
    *out = (struct encoding){.is_long = bsp->mesh->grid.is_long};
    work.member = grow_zeroed(bsp->coplanar->count + 1, sizeof *work.member);
    for (uint32_t i = (uint32_t)bsp->mesh->polygon_count; i-- > 0;)
        work.member[bsp->coplanar->group[i]] = i;
    texture_encoder_init(&work.textures, bsp->mesh, &out->textures);
    work.snapped = grow_zeroed(points->count, sizeof *work.snapped);
    for (uint32_t i = 0; i < points->count; i++)
        work.snapped[i] = exact_snap(points, i, with_fractions ? 8 : 0);
    uint32_t *heirs = find_heirs(&work);
    nodes_encode(&work, heirs);
    texture_encoder_finish(&work.textures);
    if (out->word_count > UINT16_MAX) texture_name_by_mappings(out);
    out->depth = tree_depth(out);
    bool ok = check_counts(out, err);
    if (ok) encode_boxes(out);
    free(heirs);
    free(work.snapped);
    free(work.member);
    outline_free(&work.outline);
    vertex_encoder_free(&work.vertices);
    map_free(&work.planes);
    texture_encoder_free(&work.textures);
    return ok;
}
