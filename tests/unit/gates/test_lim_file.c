/* SPDX-License-Identifier: MIT
 *
 * .lim files: what is written is read again; whatever is damaged is refused, and nothing that is
 * accepted can lead a reader out of its arrays. */
#include "compiler/compile_mesh.h"
#include "rigs/cmocka_ready.h"
#include "rigs/lim_bytes.h"
#include "rigs/mesh_rig.h"
#include "scene/lim_check.h"
#include "scene/lim_image.h"
#include "scene/plane.h"
#include "scene/scene_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/test_lim_file.XXXXXX";
static char path[64];
static struct compiled scene; /* with planes of every kind */
static struct compiled leafy; /* the same solids, with leaves */

static int setup(void **state)
{
    (void)state;
    struct random random = {5};
    struct mesh mesh = mesh_rig(3000.0);
    const double centre_m[3] = {0.0, 0.0, 0.0}, half_m[3] = {1.0, 2.0, 3.0};
    mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
    mesh_rig_solids(&mesh, &random, 8);
    scene = mesh_rig_compile(&mesh, "weighted-12", 0.01);
    const struct compile_options clusters = {.tolerance_units = 0.01, .splitter = "weighted-12", .tree = TREE_CLUSTERS};
    struct error err;
    if (!compile_mesh(&mesh, &clusters, &leafy, &err)) return -1;
    mesh_rig_free(&mesh);
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/scene.lim", folder);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    compiled_free(&scene);
    compiled_free(&leafy);
    unlink(path);
    return rmdir(folder);
}

static bool reads(struct error *err)
{
    struct compiled read;
    bool ok = lim_file_read(path, &read, err);
    if (!ok) assert_null(read.image);
    compiled_free(&read);
    return ok;
}

static void assert_unreadable(const char *reason)
{
    struct error err = {""};
    assert_false(reads(&err));
    if (strncmp(err.text, path, strlen(path)) != 0) fail_msg("'%s' does not begin with the path", err.text);
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
}

/* firmware/SCENE.md: the header's last field, which is in files alone. */
enum { DRAWN_BY_B = 148, HEADER_B = 152 };

static void what_is_written_is_read(void **state)
{
    (void)state;
    struct compiled read;
    struct error err;
    free(lim_bytes_of(&scene, path));
    if (!lim_file_read(path, &read, &err)) fail_msg("%s", err.text);
    assert_int_equal(read.image_b, scene.image_b);
    assert_memory_equal((char *)read.image + LIM_FILE_CRC_FROM_B, (char *)scene.image + LIM_FILE_CRC_FROM_B,
                        DRAWN_BY_B - LIM_FILE_CRC_FROM_B);
    assert_memory_equal((char *)read.image + HEADER_B, (char *)scene.image + HEADER_B, scene.image_b - HEADER_B);
    assert_int_equal(((char *)read.image)[DRAWN_BY_B], 1 + scene.report.draws);
    assert_int_equal(read.report.draws, scene.report.draws);
    assert_int_equal(read.scene.node_count, scene.scene.node_count);
    assert_memory_equal(&read.scene.limits, &scene.scene.limits, sizeof read.scene.limits);
    assert_memory_equal(read.faces, scene.faces, scene.scene.polygon_count * sizeof *read.faces);
    assert_memory_equal(&read.grid, &scene.grid, sizeof read.grid);
    assert_int_equal(read.report.polygons_in, 0);
    compiled_free(&read);
}

/* The first bytes as firmware/SCENE.md has them, whatever the host's byte order. */
static void the_file_is_little_endian(void **state)
{
    (void)state;
    unsigned char *bytes = lim_bytes_of(&scene, path);
    const unsigned char start[] = {0x89, 'L', 'I', 'M', '\r', '\n', 0x1A, '\n', 12, 0, 0, 0, 152, 0, 0, 0};
    assert_memory_equal(bytes, start, sizeof start);
    assert_int_equal(bytes[16] | bytes[17] << 8 | bytes[18] << 16, scene.image_b);
    assert_int_equal(bytes[30] | bytes[31] << 8, 0x40A7); /* 3000.0 = 2^11 * 1.46.. */
    assert_int_equal(bytes[56] | bytes[57] << 8, scene.scene.vertex_count);
    assert_int_equal((int16_t)(bytes[152] | bytes[153] << 8), scene.scene.vertices[0].x);
    free(bytes);
}

/* Two hosts of different byte order swap the same fields. */
static void swapping_reverses_fields_and_undoes_itself(void **state)
{
    (void)state;
    struct lim_file_header header;
    unsigned char *bytes = malloc(scene.image_b);
    assert_non_null(bytes);
    memcpy(bytes, scene.image, scene.image_b);
    memcpy(&header, bytes, sizeof header);
    lim_image_swap_sections(bytes, &header);
    lim_image_swap_header(bytes);
    assert_memory_equal(bytes, scene.image, LIM_FILE_MAGIC_B);
    assert_memory_equal(bytes + 8, ((unsigned char[]){0, 0, 0, 12, 0, 0, 0, 152}), 8);
    const unsigned char *plane = bytes + lim_image_section_b(&header, SECTION_PLANES);
    const struct lim_plane *first = &scene.scene.planes[0];
    assert_int_equal((int16_t)(plane[2] << 8 | plane[3]), lim_plane_x(first));
    assert_int_equal((uint16_t)(plane[10] << 8 | plane[11]), (uint16_t)first->slack_less_d);
    assert_int_equal((uint16_t)(plane[8] << 8 | plane[9]), (uint16_t)((uint32_t)first->slack_less_d >> 16));
    lim_image_swap_header(bytes);
    lim_image_swap_sections(bytes, &header);
    assert_memory_equal(bytes, scene.image, scene.image_b);
    free(bytes);
}

static void files_that_are_no_scenes_are_refused(void **state)
{
    (void)state;
    unlink(path);
    assert_unreadable("No such file");
    lim_bytes_write((const unsigned char *)"", 0, path);
    assert_unreadable("empty file");
    lim_bytes_write((const unsigned char *)"v 0 0 0\nv 1 0 0\n", 16, path);
    assert_unreadable("not a Limner scene");
    unlink(path);
    assert_int_equal(mkdir(path, 0777), 0);
    assert_unreadable("is a folder");
    rmdir(path);
}

static void files_cut_short_are_refused_at_any_length(void **state)
{
    (void)state;
    unsigned char *bytes = lim_bytes_of(&scene, path);
    for (size_t count = 1; count < scene.image_b; count += count < 200 ? 1 : 97) {
        lim_bytes_write(bytes, count, path);
        assert_unreadable("truncated");
    }
    lim_bytes_write(bytes, scene.image_b, path);
    FILE *file = fopen(path, "ab");
    assert_non_null(file);
    fputc(0, file);
    fclose(file);
    assert_unreadable("goes on behind its");
    free(bytes);
}

static void other_versions_are_refused_by_number(void **state)
{
    (void)state;
    unsigned char *bytes = lim_bytes_of(&scene, path);
    bytes[8] = LIM_FILE_VERSION + 1;
    lim_bytes_write(bytes, scene.image_b, path);
    assert_unreadable("version 13; this program reads version 12");
    free(bytes);
}

/* Every bit of the header, and one of every 50 bytes behind it. */
static void any_flipped_bit_is_noticed(void **state)
{
    (void)state;
    unsigned char *bytes = lim_bytes_of(&scene, path);
    struct error err;
    for (size_t bit = 0; bit < scene.image_b * 8; bit += bit < 152 * 8 ? 1 : 397) {
        bytes[bit / 8] ^= (unsigned char)(1 << bit % 8);
        lim_bytes_write(bytes, scene.image_b, path);
        assert_false(reads(&err));
        bytes[bit / 8] ^= (unsigned char)(1 << bit % 8);
    }
    free(bytes);
}

/* Promises broken one by one, with a right checksum ------------------------------------------- */

/* The file with one 16-bit field changed is refused for the reason. */
static void assert_field_refused(size_t at_b, uint16_t value, const char *reason)
{
    unsigned char *bytes = lim_bytes_of(&scene, path);
    bytes[at_b] = (unsigned char)value;
    bytes[at_b + 1] = (unsigned char)(value >> 8);
    lim_bytes_sign(bytes, scene.image_b);
    lim_bytes_write(bytes, scene.image_b, path);
    assert_unreadable(reason);
    free(bytes);
}

/* The same for a field of 32 bits: an index, or a word of a polygon. */
static void assert_index_refused(size_t at_b, lim_index value, const char *reason)
{
    unsigned char *bytes = lim_bytes_of(&scene, path);
    for (int i = 0; i < 4; i++)
        bytes[at_b + (size_t)i] = (unsigned char)(value >> 8 * i);
    lim_bytes_sign(bytes, scene.image_b);
    lim_bytes_write(bytes, scene.image_b, path);
    assert_unreadable(reason);
    free(bytes);
}

static size_t at_b(enum lim_section section, size_t index, size_t size_b, size_t field_b)
{
    return lim_image_section_b(scene.image, section) + index * size_b + field_b;
}

static size_t node_at_b(size_t index, size_t field)
{
    return at_b(SECTION_NODES, index, sizeof(struct lim_node), field * 4);
}

/* The first node that satisfies a condition on one field. */
static size_t node_with(size_t field, lim_index low, lim_index high)
{
    for (size_t i = 0; i < scene.scene.node_count; i++) {
        lim_index fields[7];
        memcpy(fields, &scene.scene.nodes[i], sizeof fields);
        if (fields[field] >= low && fields[field] <= high) return i;
    }
    fail();
    return 0;
}

enum { PLANE, OFFSET, FRONT, BACK, FRONT_RUN, BACK_RUN, BOX };

static void nodes_that_lie_are_refused(void **state)
{
    (void)state;
    const struct lim_scene *s = &scene.scene;
    size_t parent = node_with(FRONT, 1, LIM_NO_INDEX - 1), run = node_with(FRONT_RUN, 0, LIM_NO_INDEX - 1);
    size_t slanted = node_with(PLANE, 0, LIM_PLANE_X - 1);
    assert_index_refused(node_at_b(0, PLANE), LIM_NO_INDEX, "node 0: has no plane");
    assert_index_refused(node_at_b(slanted, OFFSET), 1, "an offset beside a plane of its own");
    assert_index_refused(node_at_b(slanted, PLANE), (lim_index)(s->nodes[slanted].split.plane + 1), "where none of ");
    assert_index_refused(node_at_b(slanted, PLANE), s->plane_count * LIM_PLANE_WORDS, "where none of ");
    assert_index_refused(node_at_b(parent, FRONT), s->node_count, "child ");
    assert_index_refused(node_at_b(parent, FRONT), (lim_index)parent, "child ");
    assert_index_refused(node_at_b(parent, FRONT), LIM_NO_INDEX, "has no parent");
    assert_index_refused(node_at_b(parent, BACK), s->nodes[parent].front, "has two parents");
    assert_index_refused(node_at_b(run, FRONT_RUN), s->polygon_words, "behind the last polygon");
    assert_index_refused(node_at_b(run, FRONT_RUN), LIM_NO_INDEX, "are drawn");
    assert_index_refused(node_at_b(run, BACK_RUN), s->nodes[run].front_run, "overlaps another");
    assert_index_refused(node_at_b(0, BOX), s->box_count, "box ");
}

/* The eye's distance from an axis plane has 32 bits: an offset of as many would overflow it. */
static void axis_planes_beyond_the_grid_are_refused(void **state)
{
    (void)state;
    const size_t node = node_with(PLANE, LIM_PLANE_X, LIM_PLANE_Z);
    const int32_t beyond[] = {INT16_MAX + 1, INT16_MIN - 1, INT32_MAX, INT32_MIN, 1 << 23, -(1 << 23)};
    for (size_t i = 0; i < sizeof beyond / sizeof *beyond; i++)
        assert_index_refused(node_at_b(node, OFFSET), (lim_index)beyond[i], "outside of the grid");
}

static void polygons_that_lie_are_refused(void **state)
{
    (void)state;
    const struct lim_scene *s = &scene.scene;
    size_t words = lim_image_section_b(scene.image, SECTION_POLYGONS);
    assert_index_refused(words, 0x8002, "2 vertices");
    assert_index_refused(words, (lim_index)(s->limits.vertices + 1), "vertices");
    assert_index_refused(words, (lim_index)(s->polygons[0] | 0x4000), "unknown flags");
    assert_index_refused(words, (lim_index)(s->polygons[0] | LIM_POLYGON_PLANE),
                         "a plane of its own beside its node's");
    assert_index_refused(words, (lim_index)(s->polygons[0] | LIM_POLYGON_ALPHA | LIM_POLYGON_TEXTURE),
                         "transparent and textured at once");
    assert_index_refused(words + 4, 0x10000, "its colour is 0x10000");
    assert_index_refused(at_b(SECTION_FACES, 1, sizeof *scene.faces, 0), 0, "polygon 1: of face 0");
    assert_index_refused(words + 8, s->vertex_count, "vertex ");
    assert_field_refused(at_b(SECTION_VERTICES, 3, 6, 2), 0x8000, "vertex 3: a coordinate is -32768");
}

/* The tests' helpers look at `scene`. */
static void exchange_scenes(void)
{
    const struct compiled kept = scene;
    scene = leafy;
    leafy = kept;
}

/* The word at which the first record of a leaf names its plane. */
static size_t plane_word_b(size_t leaf, bool offset)
{
    const lim_index run = scene.scene.nodes[leaf].front_run;
    const size_t words = LIM_POLYGON_HEAD_WORDS + (size_t)(scene.scene.polygons[run] & LIM_POLYGON_COUNT);
    return at_b(SECTION_POLYGONS, run + words + offset, sizeof(lim_index), 0);
}

static void leaves_that_lie_are_refused(void **state)
{
    (void)state;
    exchange_scenes();
    const struct lim_scene *s = &scene.scene;
    const size_t leaf = node_with(PLANE, LIM_NO_INDEX, LIM_NO_INDEX), inner = node_with(FRONT, 1, LIM_NO_INDEX - 1);
    const lim_index run = s->nodes[leaf].front_run, head = s->polygons[run];
    const size_t head_b = at_b(SECTION_POLYGONS, run, sizeof(lim_index), 0);
    const char *const neither = "has no plane, and is not a leaf either";
    assert_index_refused(node_at_b(leaf, OFFSET), 1, neither);
    assert_index_refused(node_at_b(leaf, FRONT), (lim_index)(leaf + 1), neither);
    assert_index_refused(node_at_b(leaf, BACK), (lim_index)(leaf + 1), neither);
    assert_index_refused(node_at_b(leaf, BACK_RUN), run, neither);
    assert_index_refused(node_at_b(leaf, FRONT_RUN), LIM_NO_INDEX, neither);
    assert_index_refused(node_at_b(inner, PLANE), LIM_NO_INDEX, neither);
    assert_index_refused(node_at_b(leaf, PLANE), LIM_PLANE_X, "a plane of its own beside its node's");
    assert_index_refused(node_at_b(leaf, FRONT_RUN), s->polygon_words, "behind the last polygon");
    assert_index_refused(head_b, head & (lim_index)~LIM_POLYGON_PLANE, "in a leaf, without a plane");
    assert_index_refused(head_b, (lim_index)((head & ~LIM_POLYGON_PLANE) | LIM_POLYGON_BACK), "without a plane");
    assert_index_refused(plane_word_b(leaf, false), LIM_NO_INDEX, "has no plane");
    assert_index_refused(plane_word_b(leaf, false), s->plane_count * LIM_PLANE_WORDS, "where none of ");
    assert_index_refused(plane_word_b(leaf, false), 1, "where none of ");
    exchange_scenes();
}

/* The first leaf whose first record lies on an axis plane, or on another. */
static size_t leaf_on(bool axis_plane)
{
    for (size_t i = 0; i < scene.scene.node_count; i++) {
        const struct lim_node *node = &scene.scene.nodes[i];
        if (node->split.plane != LIM_NO_INDEX) continue;
        const lim_index plane = lim_record_plane(&scene.scene.polygons[node->front_run])->plane;
        if ((plane >= LIM_PLANE_X) == axis_plane) return i;
    }
    fail();
    return 0;
}

static void a_slanted_plane_of_a_record_has_no_offset(void **state)
{
    (void)state;
    exchange_scenes();
    assert_index_refused(plane_word_b(leaf_on(false), true), 1, "an offset beside a plane of its own");
    exchange_scenes();
}

static void an_axis_plane_of_a_record_lies_in_the_grid(void **state)
{
    (void)state;
    exchange_scenes();
    const size_t leaf = leaf_on(true);
    assert_index_refused(plane_word_b(leaf, true), 0x8000, "an axis plane at 32768, outside of the grid");
    assert_index_refused(plane_word_b(leaf, true), 0x7FFFFFFF, "outside of the grid");
    exchange_scenes();
}

static void assert_d_refused(size_t exact, int64_t d)
{
    unsigned char *bytes = lim_bytes_of(&scene, path);
    for (int i = 0; i < 8; i++) /* the high half comes first */
        bytes[at_b(SECTION_EXACT, exact, 20, 12) + (size_t)(i ^ 4)] = (unsigned char)((uint64_t)d >> 8 * i);
    lim_bytes_sign(bytes, scene.image_b);
    lim_bytes_write(bytes, scene.image_b, path);
    assert_unreadable("out of bounds");
    free(bytes);
}

/* The index of an exact plane is there twice. */
static void assert_exact_refused(size_t plane, lim_index exact)
{
    unsigned char *bytes = lim_bytes_of(&scene, path);
    for (int i = 0; i < 4; i++)
        bytes[at_b(SECTION_PLANES, plane, 16, 12) + (size_t)i] = (unsigned char)(exact >> 8 * i);
    for (int i = 0; i < 2; i++)
        bytes[at_b(SECTION_PLANES, plane, 16, 4) + (size_t)i] = (unsigned char)(exact >> 8 * i);
    lim_bytes_sign(bytes, scene.image_b);
    lim_bytes_write(bytes, scene.image_b, path);
    assert_unreadable(": exact plane ");
    free(bytes);
}

/* The first plane with or without an exact one. */
static size_t plane_with(bool has_exact)
{
    for (size_t i = 0; i < scene.scene.plane_count; i++)
        if ((lim_plane_exact(&scene.scene.planes[i]) != LIM_NO_INDEX) == has_exact) return i;
    fail();
    return 0;
}

static void planes_and_boxes_that_lie_are_refused(void **state)
{
    (void)state;
    const struct lim_scene *s = &scene.scene;
    size_t large = plane_with(true), small = plane_with(false);
    const lim_index exact = lim_plane_exact(&s->planes[large]);
    assert_field_refused(at_b(SECTION_PLANES, large, 16, 0), (uint16_t)(lim_plane_x(&s->planes[large]) + 1),
                         "does not match its exact plane");
    assert_index_refused(at_b(SECTION_PLANES, large, 16, 12), s->exact_count, "two indices of its exact plane");
    assert_exact_refused(large, s->exact_count);
    assert_field_refused(at_b(SECTION_PLANES, large, 16, 10), 0x4001, "beyond 1073676289");
    assert_field_refused(at_b(SECTION_PLANES, large, 16, 10), 0x8000, "beyond 1073676289");
    assert_field_refused(at_b(SECTION_PLANES, small, 16, 0), 32767, "add up to");
    assert_field_refused(at_b(SECTION_PLANES, small, 16, 2), 32767, "add up to");
    assert_field_refused(at_b(SECTION_EXACT, exact, 20, 14), 0x7FFF, "out of bounds");
    assert_d_refused(exact, INT64_MIN);
    assert_field_refused(at_b(SECTION_BOXES, 2, 12, 8), 32769, "box 2: half is 32769");
    assert_field_refused(at_b(SECTION_BOXES, s->nodes[0].box, 12, 8), (uint16_t)(s->boxes[s->nodes[0].box].half[1] / 2),
                         "node 0: its box does not hold its polygons");
}

static void limits_and_grids_that_lie_are_refused(void **state)
{
    (void)state;
    const struct lim_limits *limits = &scene.scene.limits;
    assert_field_refused(118, (uint16_t)(limits->depth - 1), "lies deeper than the limit");
    assert_field_refused(120, (uint16_t)(limits->vertices - 1), "vertices");
    assert_field_refused(120, 251, "limit of 251 vertices");
    assert_field_refused(130, 1, "limit of 1 layers, and no polygon is transparent");
    assert_field_refused(132, 1, "limits of 1 vertices and 0 polygons of mesh leaves, and there is none");
    assert_field_refused(134, 1, "limits of 0 vertices and 1 polygons of mesh leaves, and there is none");
    assert_field_refused(136, 1, "depth from triangle 1 on, in a scene of polygons");
    assert_field_refused(140, 1, "depth from triangle 1 on, in a scene of polygons");
    assert_field_refused(30, 0x7FF8, "units per metre");
    assert_field_refused(38, 0x7FF0, "the origin is not finite");
}

/* The first byte behind a section that does not end at a multiple of 8. */
static void what_lies_between_sections_is_zero(void **state)
{
    (void)state;
    for (enum lim_section i = 0; i < SECTION_COUNT; i++) {
        const size_t end_b = (size_t)lim_image_section_end_b(scene.image, i);
        if (end_b == lim_image_section_b(scene.image, i + 1)) continue;
        assert_field_refused(end_b, 1, "not zero, between two sections");
        return;
    }
    fail();
}

/* What no compiled scene at hand can be made to say by changing one field ------------------------ */

static void assert_scene_refused(const struct lim_scene *wrong, const char *reason)
{
    struct error err = {""};
    assert_false(lim_check(wrong, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
}

static void exact_planes_that_nobody_names_are_checked(void **state)
{
    (void)state;
    struct lim_scene wrong = scene.scene;
    struct lim_plane_exact *exact = malloc((wrong.exact_count + (size_t)1) * sizeof *exact);
    struct error err;
    assert_non_null(exact);
    memcpy(exact, wrong.exact, wrong.exact_count * sizeof *exact);
    exact[wrong.exact_count++] = (struct lim_plane_exact){{0, 0, 1}, 0, 1 << 16};
    wrong.exact = exact;
    assert_true(lim_check(&wrong, &err));
    exact[wrong.exact_count - 1].d_lo = 1 << 17;
    assert_scene_refused(&wrong, "out of bounds");
    exact[wrong.exact_count - 1] = (struct lim_plane_exact){{0, 0, 0}, 0, 0};
    assert_scene_refused(&wrong, "out of bounds");
    free(exact);
}

static void more_boxes_than_nodes_are_refused(void **state)
{
    (void)state;
    struct lim_scene wrong = scene.scene;
    struct lim_box *boxes = calloc(wrong.node_count + (size_t)1, sizeof *boxes);
    assert_non_null(boxes);
    memcpy(boxes, wrong.boxes, wrong.box_count * sizeof *boxes);
    wrong.boxes = boxes;
    wrong.box_count = wrong.node_count + 1;
    assert_scene_refused(&wrong, "nodes");
    free(boxes);
}

/* One leaf of triangles, all in the plane x = 0. */
static void sets_hold_what_can_be_sorted(void **state)
{
    (void)state;
    enum { MOST = 32767, WORDS = LIM_POLYGON_HEAD_WORDS + 3 + 2 };
    const struct lim_vertex vertices[3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const lim_index none = LIM_NO_INDEX;
    const struct lim_node leaf = {{none, 0}, none, none, 0, none, none};
    lim_index *words = malloc((MOST + 1) * WORDS * sizeof *words);
    struct error err;
    assert_non_null(words);
    for (size_t i = 0; i <= MOST; i++)
        memcpy(&words[i * WORDS], ((lim_index[WORDS]){3 | LIM_POLYGON_PLANE, 0, 0, 1, 2, LIM_PLANE_X, 0}),
               WORDS * sizeof *words);
    struct lim_scene set = {.vertices = vertices, .nodes = &leaf, .polygons = words, .vertex_count = 3};
    set.node_count = 1;
    set.limits.vertices = 3;
    for (lim_index more = 0; more <= 1; more++) {
        set.polygon_count = MOST + more;
        set.polygon_words = set.polygon_count * WORDS;
        words[(MOST - 1) * WORDS] |= LIM_POLYGON_LAST;
        if (more) words[(MOST - 1) * WORDS] &= ~LIM_POLYGON_LAST;
        words[MOST * WORDS] |= LIM_POLYGON_LAST;
        if (!more && !lim_check(&set, &err)) fail_msg("%s", err.text);
    }
    assert_scene_refused(&set, "a set of 32768 polygons");
    free(words);
}

/* A triangle with flags for its edges has three of them. */
static void flags_of_edges_that_are_not_there_are_refused(void **state)
{
    (void)state;
    const struct lim_vertex vertices[3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const lim_index none = LIM_NO_INDEX;
    const struct lim_node node = {{LIM_PLANE_X, 0}, none, none, 0, none, none};
    lim_index words[] = {3 | LIM_POLYGON_EDGES | LIM_POLYGON_LAST, 0xFFFF, 0, 1, 2, 7};
    struct lim_scene edged = {.vertices = vertices, .nodes = &node, .polygons = words, .vertex_count = 3};
    struct error err;
    edged.node_count = 1;
    edged.limits.vertices = 3;
    edged.limits.depth = 1;
    edged.polygon_count = 1;
    edged.polygon_words = 6;
    if (!lim_check(&edged, &err)) fail_msg("%s", err.text);
    words[5] = 8;
    assert_scene_refused(&edged, "flags of more edges than it has");
    words[5] = 0x10000;
    assert_scene_refused(&edged, "flags of more edges than it has");
}

static void spare_fields_of_textures_are_zero(void **state)
{
    (void)state;
    struct lim_texture texture = {.levels = 1};
    struct lim_mapping mapping = {.scale = LIM_MAPPING_UPRIGHT};
    const struct lim_scene textured = {.textures = &texture,
                                       .mappings = &mapping,
                                       .texture_count = 1,
                                       .mapping_count = 1,
                                       .palette_colours = 256,
                                       .texel_blocks = 1};
    struct error err = {""};
    if (!lim_check_textures(&textured, &err)) fail_msg("%s", err.text);
    texture.place_bits = 1;
    assert_false(lim_check_textures(&textured, &err));
    texture.place_bits = 0;
    mapping.texture = 1;
    assert_false(lim_check_textures(&textured, &err));
}

/* An alpha and a texture go together where that has clear texels, and nowhere else. */
static void masked_textures_and_alphas_go_together(void **state)
{
    (void)state;
    const struct lim_vertex vertices[3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const lim_index none = LIM_NO_INDEX;
    const struct lim_node node = {{LIM_PLANE_X, 0}, none, none, 0, none, none};
    const lim_index masked[] = {3 | LIM_POLYGON_ALPHA | LIM_POLYGON_TEXTURE | LIM_POLYGON_LAST, 0, 0, 1, 2, 99, 0, 0};
    const lim_index plain[] = {3 | LIM_POLYGON_TEXTURE | LIM_POLYGON_LAST, 0, 0, 1, 2, 0, 0};
    struct lim_texture texture = {.levels = 1, .place_bits = LIM_TEXTURE_MASKED};
    struct lim_mapping mapping = {.uv = {{1, 0}, {0, 0}}, .scale = LIM_MAPPING_UPRIGHT};
    struct lim_scene scene_of = {.vertices = vertices,
                                 .nodes = &node,
                                 .polygons = masked,
                                 .vertex_count = 3,
                                 .node_count = 1,
                                 .polygon_words = 8,
                                 .polygon_count = 1,
                                 .limits = {.depth = 1, .vertices = 3, .layers = 1},
                                 .textures = &texture,
                                 .mappings = &mapping,
                                 .texture_count = 1,
                                 .mapping_count = 1,
                                 .palette_colours = 256,
                                 .texel_blocks = 1};
    struct error err;
    if (!lim_check(&scene_of, &err)) fail_msg("%s", err.text);
    texture.place_bits = 0;
    assert_scene_refused(&scene_of, "transparent and textured at once");
    texture.place_bits = LIM_TEXTURE_SKY;
    assert_scene_refused(&scene_of, "transparent and textured at once");
    scene_of.polygons = plain;
    scene_of.polygon_words = 7;
    scene_of.limits.layers = 0;
    for (int16_t times = 0; times <= 17; times = (int16_t)(times + 17)) {
        mapping.uv[0][0] = times;
        assert_scene_refused(&scene_of, times ? "a sky that goes 17 times round" : "a sky that goes 0 times round");
    }
    mapping.uv[0][0] = 16;
    if (!lim_check(&scene_of, &err)) fail_msg("%s", err.text);
    texture.place_bits = LIM_TEXTURE_MASKED;
    assert_scene_refused(&scene_of, "a masked texture, and no alpha");
    texture.place_bits = LIM_TEXTURE_MASKED | LIM_TEXTURE_SKY;
    assert_scene_refused(&scene_of, "places of 192 bits");
}

/* What the renderer relies on where a mesh has textures. */
static void meshes_with_textures_are_checked(void **state)
{
    (void)state;
    struct lim_vertex vertices[3] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
    struct lim_uv uvs[3] = {{0, 0}, {20000, 0}, {0, -20000}};
    lim_index words[4] = {0, 1, 2, 0};
    struct lim_texture texture = {.levels = 1, .place_bits = 15};
    const struct lim_box box = {{4, 4, 0}, {5, 5, 0}};
    struct lim_scene mesh = {.vertices = vertices,
                             .boxes = &box,
                             .polygons = words,
                             .vertex_count = 3,
                             .box_count = 1,
                             .polygon_words = 4,
                             .polygon_count = 1,
                             .limits = {.vertices = 3},
                             .textures = &texture,
                             .texture_count = 1,
                             .palette_colours = 256,
                             .texel_blocks = 1,
                             .uvs = {uvs}};
    struct error err = {""};
    if (!lim_check(&mesh, &err)) fail_msg("%s", err.text);
    words[3] = 1;
    assert_scene_refused(&mesh, "texture 1 of 1");
    words[3] = 0;
    uvs[2].v = 20000, uvs[1].v = -20000;
    assert_scene_refused(&mesh, "too far apart");
    uvs[1].v = 0;
    texture.place_bits = 16;
    assert_scene_refused(&mesh, "places of 16 bits");
    texture.place_bits = 0;
    *mesh.uvs = NULL;
    assert_scene_refused(&mesh, "1 textures, and without places");
    *mesh.uvs = uvs;
    mesh.texture_count = 0;
    assert_scene_refused(&mesh, "0 textures, and with places");
}

/* What the renderer relies on; each alone is refused, and names what it is. */
static void mappings_out_of_range_are_refused(void **state)
{
    (void)state;
    const struct {
        struct lim_texture texture;
        struct lim_mapping mapping;
        const char *what;
    } cases[] = {
        {{.levels = 1}, {.scale = 0}, "plane at word 0"},
        {{.levels = 1}, {.scale = LIM_MAPPING_UPRIGHT | 3 << LIM_MAPPING_AXIS_SHIFT}, "no such axis"},
        {{.levels = 1}, {.scale = LIM_MAPPING_UPRIGHT, .plane = 40000}, "outside of the grid"},
        {{.levels = 1}, {.scale = LIM_MAPPING_UPRIGHT, .uv = {{16384, -16384}, {0, 0}}}, "too long"},
        {{.levels = 1, .h_bits = 1}, {.scale = LIM_MAPPING_UPRIGHT}, "higher than wide"},
        {{.levels = 2, .w_bits = 1}, {.scale = LIM_MAPPING_UPRIGHT}, "2 levels"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct lim_scene textured = {.textures = &cases[i].texture,
                                           .mappings = &cases[i].mapping,
                                           .texture_count = 1,
                                           .mapping_count = 1,
                                           .palette_colours = 256,
                                           .texel_blocks = 1};
        struct error err = {""};
        assert_false(lim_check_textures(&textured, &err));
        if (!strstr(err.text, cases[i].what)) fail_msg("%s: %s", cases[i].what, err.text);
    }
}

/* Random damage with a right checksum --------------------------------------------------------- */

/* What a walk may touch, in all: it ends, and every index is in range. */
static void walk_everything(const struct lim_scene *s)
{
    size_t records = 0, checksum = 0;
    for (size_t i = 0; i < s->node_count; i++) {
        const lim_index runs[2] = {s->nodes[i].front_run, s->nodes[i].back_run};
        int64_t n[3], d;
        if (s->nodes[i].split.plane != LIM_NO_INDEX) {
            plane_exact(s, &s->nodes[i].split, n, &d);
            checksum += (size_t)d;
        }
        assert_true(s->nodes[i].front == LIM_NO_INDEX || (s->nodes[i].front > i && s->nodes[i].front < s->node_count));
        assert_true(s->nodes[i].back == LIM_NO_INDEX || (s->nodes[i].back > i && s->nodes[i].back < s->node_count));
        assert_true(s->nodes[i].box == LIM_NO_INDEX || s->nodes[i].box < s->box_count);
        for (int k = 0; k < 2; k++)
            for (const lim_index *at = runs[k] == LIM_NO_INDEX ? NULL : &s->polygons[runs[k]]; at; records++) {
                for (size_t v = 0; v < (*at & LIM_POLYGON_COUNT); v++)
                    checksum += (size_t)s->vertices[at[2 + v]].x;
                at = *at & LIM_POLYGON_LAST ? NULL : at + lim_record_words(*at);
            }
    }
    assert_int_equal(records, s->polygon_count);
    assert_true(checksum != 1);
}

static void damage_is_refused_or_harmless(void **state)
{
    (void)state;
    struct random random = {77};
    unsigned char *whole = lim_bytes_of(&scene, path), *bytes = malloc(scene.image_b);
    assert_non_null(bytes);
    int accepted = 0;
    for (int i = 0; i < 1500; i++) {
        memcpy(bytes, whole, scene.image_b);
        for (int64_t changes = random_in(&random, 1, 3); changes > 0; changes--)
            bytes[random_in(&random, 24, (int64_t)scene.image_b - 1)] = (unsigned char)random_u64(&random);
        lim_bytes_sign(bytes, scene.image_b);
        lim_bytes_write(bytes, scene.image_b, path);
        struct compiled read;
        struct error err;
        if (!lim_file_read(path, &read, &err)) continue;
        accepted++;
        walk_everything(&read.scene);
        compiled_free(&read);
    }
    assert_in_range(accepted, 50, 1450); /* colours and most coordinates may be anything */
    free(whole);
    free(bytes);
}

static void damaged_leaves_are_too(void **state)
{
    exchange_scenes();
    damage_is_refused_or_harmless(state);
    exchange_scenes();
}

/* Writing ------------------------------------------------------------------------------------ */

static void what_cannot_be_written_leaves_nothing_behind(void **state)
{
    (void)state;
    struct error err;
    unlink(path);
    assert_int_equal(mkdir(path, 0777), 0);
    assert_false(lim_file_write(&scene, path, &err));
    assert_non_null(strstr(err.text, path));
    assert_int_equal(rmdir(path), 0); /* still empty */
    assert_false(lim_file_write(&scene, "/proc/limner.lim", &err));
    assert_non_null(strstr(err.text, "/proc/limner.lim"));
    assert_false(lim_file_write(&scene, "/dev/full", &err));
    assert_non_null(strstr(err.text, "/dev/full"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),
        cmocka_unit_test(the_file_is_little_endian),
        cmocka_unit_test(swapping_reverses_fields_and_undoes_itself),
        cmocka_unit_test(files_that_are_no_scenes_are_refused),
        cmocka_unit_test(files_cut_short_are_refused_at_any_length),
        cmocka_unit_test(other_versions_are_refused_by_number),
        cmocka_unit_test(any_flipped_bit_is_noticed),
        cmocka_unit_test(nodes_that_lie_are_refused),
        cmocka_unit_test(axis_planes_beyond_the_grid_are_refused),
        cmocka_unit_test(polygons_that_lie_are_refused),
        cmocka_unit_test(leaves_that_lie_are_refused),
        cmocka_unit_test(a_slanted_plane_of_a_record_has_no_offset),
        cmocka_unit_test(an_axis_plane_of_a_record_lies_in_the_grid),
        cmocka_unit_test(planes_and_boxes_that_lie_are_refused),
        cmocka_unit_test(limits_and_grids_that_lie_are_refused),
        cmocka_unit_test(what_lies_between_sections_is_zero),
        cmocka_unit_test(exact_planes_that_nobody_names_are_checked),
        cmocka_unit_test(more_boxes_than_nodes_are_refused),
        cmocka_unit_test(sets_hold_what_can_be_sorted),
        cmocka_unit_test(flags_of_edges_that_are_not_there_are_refused),
        cmocka_unit_test(spare_fields_of_textures_are_zero),
        cmocka_unit_test(masked_textures_and_alphas_go_together),
        cmocka_unit_test(meshes_with_textures_are_checked),
        cmocka_unit_test(mappings_out_of_range_are_refused),
        cmocka_unit_test(damage_is_refused_or_harmless),
        cmocka_unit_test(damaged_leaves_are_too),
        cmocka_unit_test(what_cannot_be_written_leaves_nothing_behind),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
