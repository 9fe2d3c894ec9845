/* SPDX-License-Identifier: MIT
 *
 * Vertices as files have them, to the last bit, through the importer and through the reference's own readers; the
 * files are written here. What is expected is what a C compiler makes of the same digits. */
#include "gltf/vertex_table.h"
#include "model/model.h"
#include "readers/model_import.h"
#include "readers/source.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-test-XXXXXX";
static char path[64];

static void put_bytes(const char *name, const void *bytes, size_t size_b)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size_b, file), size_b);
    assert_int_equal(fclose(file), 0);
}

static void put(const char *name, const char *text)
{
    put_bytes(name, text, strlen(text));
}

/* The importer's model, which the reference's reader must agree with. */
static struct model both_read(void)
{
    struct model model;
    struct error err = {""};
    if (!model_import(path, &model, &err) || !source_take(path, &model, &err)) fail_msg("%s", err.text);
    return model;
}

static void assert_refused(const char *text)
{
    struct model model;
    struct error err = {""};
    char expected[256];
    snprintf(expected, sizeof expected, "%s%s", path, text);
    if (model_import(path, &model, &err)) fail_msg("not refused: %s", expected);
    assert_string_equal(err.text, expected);
}

static void assert_at(const struct model *model, size_t face, uint32_t corner, double x, double y, double z)
{
    const uint32_t point = model->corners[model->faces[face].first + corner];
    const double expected[3] = {x, y, z};
    for (int axis = 0; axis < 3; axis++)
        if (model->points[point][axis] != expected[axis])
            fail_msg("face %zu, corner %u: %.17g instead of %.17g", face + 1, corner, model->points[point][axis],
                     expected[axis]);
    if (!model->source_points) fail_msg("%s", model->notice);
    assert_memory_equal(model->source_points[point], model->points[point], sizeof expected);
}

/* Of the triangle that the files below hold. */
static void assert_far_triangle(void)
{
    struct model model = both_read();
    assert_int_equal(model.face_count, 1);
    assert_at(&model, 0, 0, 1000000.0123456789, -0.1, 0.5);
    assert_at(&model, 0, 1, 1000001.7, 123456.7890123456789, 5);
    assert_at(&model, 0, 2, 2.5e5, -1e-3, 7);
    model_free(&model);
}

static void obj_vertices_are_doubles(void **state)
{
    (void)state;
    put("a.obj", "v 1000000.0123456789 -0.1 .5\nv 1000001.7 123456.7890123456789 5.\nv +2.5e5 -1E-3 7\nf 1 2 3\n");
    assert_far_triangle();
}

/* Carriage returns, a continued line, a comment with numbers, a colour, a divisor, blanks in front, no last newline. */
static void every_way_to_write_an_obj_vertex_is_read(void **state)
{
    (void)state;
    put("b.OBJ", "\xEF\xBB\xBFv 1000000.0123456789 -0.1 .5 # 3 m above\r\n  v 1000001.7\\\r\n 123456.7890123456789\t5. "
                 ".1 .2 .3\r\n"
                 "v 2.5e5 -1E-3 7 2\r\n\r\ng some\r\nvn .1 .2 .3\r\nvt .5 .5\r\nf -3/1/1 -2/1/1 \\\r\n -1/1/1");
    assert_far_triangle();
    put("c.obj", "v 1000000.0123456789 -0.1 .5\rv 1000001.7 123456.7890123456789 5.\rv +2.5e5 -1E-3 7\rf 1//1 2//1 "
                 "3//1\rvn 0 0 1\r");
    assert_far_triangle();
}

static void bad_obj_vertices_are_refused_by_line(void **state)
{
    (void)state;
    put("d.obj", "v 0 0 0\n# v 1\nv 1 0x5 0\nv 0 1 0\nf 1 2 3\n");
    assert_refused(":3: '0x5' is not a decimal number up to 3.4e38");
    put("e.obj", "v 0 0 0\r\nv 1 0,5 0\r\nf 1 2 3\r\n");
    assert_refused(":2: '0,5' is not a decimal number up to 3.4e38");
    put("f.obj", "v 0 0 0\nv 1 2\nf 1 2 3\n");
    assert_refused(":2: a vertex of 2 numbers; it has three, a weight behind them or a colour of three");
    put("g.obj", "v 0 0 0\nv 1 \\\n 2 3 4 5\nf 1 2 3\n");
    assert_refused(":2: a vertex of 5 numbers; it has three, a weight behind them or a colour of three");
    put("h.obj", "v 0 0 0\nv 1 2 3 nan\nf 1 2 3\n");
    assert_refused(":2: 'nan' is not a decimal number up to 3.4e38");
    put("i.obj", "v 0 0 0\nv 1 2 1e39\nf 1 2 3\n");
    assert_refused(":2: '1e39' is not a decimal number up to 3.4e38");
}

static void ply_vertices_are_doubles(void **state)
{
    (void)state;
    put("a.ply", "ply\nformat ascii 1.0\ncomment far\nelement vertex 3\nproperty uchar red\nproperty float x\n"
                 "property double y\nproperty float32 z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "end_header\n255 1000000.0123456789 -0.1 .5\n0 1000001.7 123456.7890123456789 5.\n"
                 "7 +2.5e5 -1E-3 7\n3 0 1 2\n");
    assert_far_triangle();
    put("b.ply", "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float z\r\nproperty float y\r\n"
                 "property float x\r\nproperty int flags\r\nelement face 1\r\n"
                 "property list uchar int vertex_index\r\nend_header\r\n.5 -0.1 1000000.0123456789 9\r\n"
                 "5. 123456.7890123456789 1000001.7 9\r\n7 -1E-3 +2.5e5 9\r\n3 0 1 2\r\n");
    assert_far_triangle();
    put("c.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n");
    assert_refused(":11: 'zero' is not a decimal number up to 3.4e38");
}

static size_t append(char *bytes, size_t at, const void *what, size_t size_b, bool turned)
{
    for (size_t i = 0; i < size_b; i++)
        bytes[at + i] = ((const char *)what)[turned ? size_b - 1 - i : i];
    return at + size_b;
}

static size_t binary_ply(char *bytes, const char *order, bool turned)
{
    static const double points[3][3] = {
        {1000000.0123456789, -0.1, 0.5}, {1000001.7, 123456.7890123456789, 5}, {2.5e5, -1e-3, 7}};
    size_t at = (size_t)sprintf(bytes,
                                "ply\nformat binary_%s_endian 1.0\nelement vertex 3\n"
                                "property double x\nproperty double y\nproperty double z\nelement face 1\n"
                                "property list uchar int vertex_indices\nend_header\n",
                                order);
    for (int i = 0; i < 9; i++)
        at = append(bytes, at, &points[i / 3][i % 3], 8, turned);
    bytes[at++] = 3;
    for (int32_t i = 0; i < 3; i++)
        at = append(bytes, at, &i, 4, turned);
    return at;
}

static void binary_ply_vertices_are_doubles(void **state)
{
    char bytes[1024];
    (void)state;
    put_bytes("d.ply", bytes, binary_ply(bytes, "little", false));
    assert_far_triangle();
    put_bytes("d.ply", bytes, binary_ply(bytes, "big", true));
    assert_far_triangle();
}

/* The importer library loses a first byte that is a newline. */
static void a_ply_that_begins_with_a_newlines_byte_is_read(void **state)
{
    static const float points[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    char bytes[512];
    size_t at = (size_t)sprintf(bytes, "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                                       "property float y\nproperty float z\nelement face 1\n"
                                       "property list uchar int vertex_indices\nend_header\n");
    const size_t first = at;
    (void)state;
    at = append(bytes, at, points, sizeof points, false);
    bytes[first] = '\n';
    bytes[at++] = 3;
    for (int32_t i = 0; i < 3; i++)
        at = append(bytes, at, &i, 4, false);
    put_bytes("e.ply", bytes, at);
    struct model model = both_read();
    assert_at(&model, 0, 0, ldexp(10, -149), 0, 0);
    assert_at(&model, 0, 2, 0, 1, 0);
    model_free(&model);
}

/* Where something else than a coordinate comes first, and where coordinates are too narrow for stand-ins. */
static void a_ply_may_begin_with_any_byte(void **state)
{
    static const char *const heads[] = {"property uchar red\nproperty float x\nproperty float y\nproperty float z\n",
                                        "property short x\nproperty short y\nproperty short z\n"};
    (void)state;
    for (int kind = 0; kind < 2; kind++)
        for (int byte = 0; byte < 256; byte++) {
            char bytes[512];
            size_t at = (size_t)sprintf(bytes,
                                        "ply\nformat binary_little_endian 1.0\nelement vertex 3\n%selement face 1\n"
                                        "property list uchar uchar vertex_indices\nend_header\n",
                                        heads[kind]);
            for (int i = 0; i < 3; i++) {
                const float wide[3] = {i == 1, i == 2, 0};
                const int16_t narrow[3] = {(int16_t)byte, i == 1, i == 2};
                if (!kind) bytes[at++] = (char)byte;
                at = kind ? append(bytes, at, narrow, sizeof narrow, false)
                          : append(bytes, at, wide, sizeof wide, false);
            }
            at = append(bytes, at, "\3\0\1\2", 4, false);
            put_bytes("f.ply", bytes, at);
            struct model model = both_read();
            assert_at(&model, 0, 1, kind ? byte : 1, kind ? 1 : 0, 0);
            model_free(&model);
        }
}

static void stl_vertices_are_doubles(void **state)
{
    (void)state;
    put("a.stl",
        "solid vertex of a hill\nfacet normal 0 0 1\nouter loop\nvertex 1000000.0123456789 -0.1 .5\n"
        "  vertex 1000001.7 123456.7890123456789 5.\nvertex +2.5e5 -1E-3 7\nendloop\nendfacet\nendsolid vertex\n");
    assert_far_triangle();
    put("b.stl", "solid\r\nfacet normal 0 0 1 outer loop vertex 1000000.0123456789 -0.1 .5 vertex 1000001.7\r\n"
                 "123456.7890123456789 5. vertex +2.5e5 -1E-3 7 endloop endfacet\r\nendsolid\r\n");
    assert_far_triangle();
    put("c.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1\nvertex 0 1 0\nendloop\nendfacet\n"
                 "endsolid a\n");
    assert_refused(":6: 'vertex' is not a decimal number up to 3.4e38");
}

static void off_vertices_are_doubles(void **state)
{
    struct error err;
    struct model model;
    (void)state;
    put("a.off", "OFF # far\n3 1 0\n# the first\n1000000.0123456789 -0.1 .5\n1000001.7 123456.7890123456789 5. # 8\n"
                 "+2.5e5 -1E-3 7\n3 0 1 2 255 0 0\n");
    if (!model_import(path, &model, &err)) fail_msg("%s", err.text);
    assert_int_equal(model.face_count, 1);
    const double *last = model.points[model.corners[2]];
    assert_true(last[0] == 2.5e5 && last[1] == -1e-3 && last[2] == 7);
    assert_true(model.points[model.corners[1]][1] == 123456.7890123456789);
    model_free(&model);
}

static void off_faces_that_would_be_wrong_are_refused(void **state)
{
    struct model model;
    struct error err = {""};
    (void)state;
    put("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
    assert_refused(":6: '3' is no whole number below 3");
    put("c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n10 0 1 2 0 1 2 0 1 2 0\n");
    if (!model_import(path, &model, &err)) fail_msg("%s", err.text);
    assert_int_equal(model.faces[0].count, 10);
    model_free(&model);
    put("d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
    assert_refused(":5: the file ends before its vertices");
}

/* glTF --------------------------------------------------------------------------------------- */

/* A triangle (0 0 0) (1 0 0) (0 1 0), in a buffer that is part of the file, below nodes given as JSON. */
static void put_gltf(const char *name, const char *nodes)
{
    char text[2048];
    snprintf(text, sizeof text,
             "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [%s],\n"
             "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}],\n"
             "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}],\n"
             "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],\n"
             "\"buffers\": [{\"byteLength\": 36, \"uri\": \"data:application/octet-stream;base64,"
             "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}\n",
             nodes);
    put(name, text);
}

static void gltf_nodes_are_doubles(void **state)
{
    (void)state;
    put_gltf("a.gltf", "{\"mesh\": 0, \"translation\": [1000000.7, -1000000.3, 0.1]}");
    struct model model = both_read();
    assert_at(&model, 0, 0, 1000000.7, -1000000.3, 0.1);
    assert_at(&model, 0, 1, 1000001.7, -1000000.3, 0.1);
    model_free(&model);
    put_gltf("b.gltf", "{\"mesh\": 0, \"matrix\": [0,2.5,0,0, -2.5,0,0,0, 0,0,2.5,0, 123456.789,1e-3,-7e5,1]}");
    model = both_read();
    assert_at(&model, 0, 1, 123456.789, 2.501, -7e5);
    assert_at(&model, 0, 2, 123454.289, 1e-3, -7e5);
    model_free(&model);
}

/* A turn about y by an angle whose half has the sine 0.6, a scale, a mirroring child; expected by hand. */
static void chains_of_gltf_nodes_are_doubles(void **state)
{
    static const double expected[3][3] = {{1000000.7 + 2 * 0.28 * 10, 0.1, 5 - 2 * 0.96 * 10},
                                          {1000000.7 + 2 * 0.28 * 10, 2.1, 5 - 2 * 0.96 * 10},
                                          {1000000.7 + 2 * 0.28 * 9, 0.1, 5 - 2 * 0.96 * 9}};
    (void)state;
    put_gltf("c.gltf", "{\"children\": [1], \"translation\": [1000000.7, 0.1, 5], \"rotation\": [0, 0.6, 0, 0.8], "
                       "\"scale\": [2, 2, 2]}, {\"mesh\": 0, \"translation\": [10, 0, 0], \"scale\": [-1, 1, 1]}");
    struct model model = both_read();
    for (uint32_t k = 0; k < 3; k++) { /* mirrored: turned round */
        const double *at = model.points[model.corners[k == 0 ? 2 : k == 1 ? 0 : 1]];
        for (int axis = 0; axis < 3; axis++)
            if (fabs(at[axis] - expected[k][axis]) > 1e-9)
                fail_msg("corner %u: %.12g instead of %.12g", k, at[axis], expected[k][axis]);
    }
    assert_non_null(model.source_points);
    model_free(&model);
}

/* A folder may be called %2e%2e, which decoded would lead out. The other file is not the model's to name. */
static void the_reference_reads_the_file_that_the_importer_read(void **state)
{
    static const char text[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": "
        "0}],\n"
        " \"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}],\n"
        " \"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}],\n"
        " \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],\n"
        " \"buffers\": [{\"byteLength\": 36, \"uri\": \"%2e%2e/a.bin\"}]}\n";
    static const float own[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, other[9] = {5, 5, 5};
    char below[64];
    (void)state;
    snprintf(below, sizeof below, "%s/below", folder);
    assert_int_equal(mkdir(below, 0700), 0);
    snprintf(below, sizeof below, "%s/below/%%2e%%2e", folder);
    assert_int_equal(mkdir(below, 0700), 0);
    put_bytes("a.bin", other, sizeof other);
    put_bytes("below/%2e%2e/a.bin", own, sizeof own);
    put("below/a.gltf", text);
    struct model model = both_read();
    assert_at(&model, 0, 0, 0, 0, 0);
    assert_at(&model, 0, 1, 1, 0, 0);
    model_free(&model);
}

static void damaged_gltf_is_refused(void **state)
{
    struct model model;
    struct error err = {""};
    (void)state;
    put_gltf("d.gltf", "{\"mesh\": 0, \"translation\": [1e300, 0, 0]}");
    assert_false(model_import(path, &model, &err));
    assert_non_null(strstr(err.text, "its transform is beyond float32"));
    put_gltf("e.gltf", "{\"mesh\": 0}");
    assert_true(model_import(path, &model, &err));
    put("e.gltf", "{\"asset\": {\"version\": \"2.0\"},\n \"nodes\": [}\n");
    assert_false(source_take(path, &model, &err));
    assert_non_null(strstr(err.text, "e.gltf:2: "));
    model_free(&model);
}

/* The two readers --------------------------------------------------------------------------- */

static void assert_disagree(struct model *model, const char *text)
{
    struct error err = {""};
    assert_false(source_take(path, model, &err));
    if (!strstr(err.text, text)) fail_msg("%s", err.text);
    assert_null(model->source_points);
}

static void a_disagreement_of_the_readers_is_an_error(void **state)
{
    struct model model;
    struct error err = {""};
    (void)state;
    put("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4 3\n");
    assert_true(model_import(path, &model, &err));
    double *corner = model.points[model.corners[model.faces[1].first + 2]];
    corner[2] += 1e-9;
    assert_disagree(&model, "face 2: the importer and the reference's reader have its corner 3 1e-09 m apart");
    corner[2] = NAN;
    assert_disagree(&model, "face 2: the importer and the reference's reader have its corner 3");
    corner[2] = 1;
    model.faces[1].count = 3;
    assert_disagree(&model, "face 2: the importer finds 3 corners, the reference's reader 4");
    model.face_count = 1;
    assert_disagree(&model, "the importer finds 1 faces in it, the reference's reader 2");
    model.face_count = 2;
    model.faces[1].count = 4;
    assert_true(source_take(path, &model, &err));
    assert_ptr_equal(source_view(&model).points, model.source_points);
    model_free(&model);
}

static void a_format_without_a_reader_is_told(void **state)
{
    struct model model;
    struct error err = {""};
    (void)state;
    put("e.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_true(model_import(path, &model, &err) && source_take(path, &model, &err));
    assert_null(model.source_points);
    assert_non_null(strstr(model.notice, "the reference has the importer's vertices"));
    model_free(&model);
}

static void put_binary_stl(double at_m)
{
    char bytes[84 + 50] = "binary";
    size_t at = append(bytes, 80, &(uint32_t){1}, 4, false) + 12;
    for (int i = 0; i < 3; i++) {
        const float corner[3] = {(float)(at_m + (i == 1)), i == 2, 0};
        at = append(bytes, at, corner, sizeof corner, false);
    }
    put_bytes("far.stl", bytes, sizeof bytes);
}

/* A side of 1 m makes units of 1/65534 m; float32 numbers are 2^-20 m apart from 8 m on, 2^-19 m from 16 m. */
static void coarse_float32_is_told_in_metres(void **state)
{
    (void)state;
    put_binary_stl(1e6);
    struct model model = both_read();
    assert_non_null(strstr(model.notice, "float32 numbers, which are 0.0625 m apart"));
    assert_at(&model, 0, 1, 1000001, 0, 0);
    model_free(&model);
    put_binary_stl(8);
    model = both_read();
    assert_string_equal(model.notice, "");
    model_free(&model);
    put("far.obj", "v 1e6 0 0\nv 1000001 0 0\nv 1e6 1 0\nf 1 2 3\n");
    model = both_read();
    assert_string_equal(model.notice, "");
    model_free(&model);
}

/* Keys of an animation lead 10^6 m out, in float32: 1/16 m. */
static void coarse_keys_are_told_in_metres(void **state)
{
    static const char text[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [0, 1]}],\n"
        "\"nodes\": [{\"mesh\": 0}, {\"mesh\": 0, \"name\": \"far\", \"translation\": [3, 0, 0]}],\n"
        "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}],\n"
        "\"animations\": [{\"channels\": [{\"sampler\": 0, \"target\": {\"node\": 1, \"path\": \"translation\"}}],\n"
        "\"samplers\": [{\"input\": 1, \"output\": 2}]}],\n"
        "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"},\n"
        "{\"bufferView\": 1, \"componentType\": 5126, \"count\": 2, \"type\": \"SCALAR\", \"min\": [0], \"max\": "
        "[1]},\n"
        "{\"bufferView\": 2, \"componentType\": 5126, \"count\": 2, \"type\": \"VEC3\"}],\n"
        "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}, {\"buffer\": 0, \"byteOffset\": 36, \"byteLength\": "
        "8},\n"
        "{\"buffer\": 0, \"byteOffset\": 44, \"byteLength\": 24}],\n"
        "\"buffers\": [{\"byteLength\": 68, \"uri\": \"data:application/octet-stream;base64,"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AJHRJAAAAAAAAAAAQJHRJAAAAAAAAAAA=\"}]}\n";
    (void)state;
    put("keys.gltf", text);
    struct model model = both_read();
    assert_int_equal(model.mover_count, 1);
    assert_non_null(strstr(model.notice, "float32 numbers, which are 0.0625 m apart"));
    model_free(&model);
}

/* As float32 they are what they are; what is computed with one is none. */
static void stand_ins_are_told_from_other_numbers(void **state)
{
    struct vertex_table table = {0};
    (void)state;
    for (int i = 1; i <= 100000; i++) {
        unsigned in[3];
        vertex_table_add(&table, (const double[3]){i, 0.1 * i, -i}, in);
        const float out[3] = {(float)in[0], (float)in[1], (float)in[2]};
        const double *found = vertex_table_find(&table, (double)out[0], (double)out[1], (double)out[2]);
        assert_true(found && found[0] == i && found[1] == 0.1 * i && found[2] == -i);
        assert_null(vertex_table_find(&table, in[0], in[1], in[2] + 1.0));
        assert_null(vertex_table_find(&table, in[0], in[1] + 0.5, in[2]));
        assert_null(vertex_table_find(&table, 2.0 * in[0], 2.0 * in[1], 2.0 * in[2]));
    }
    assert_null(vertex_table_find(&table, 0, 0, 0));
    assert_null(vertex_table_find(&table, NAN, 1, 1));
    assert_null(vertex_table_find(&table, -1, 1, 1));
    vertex_table_free(&table);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    char command[64];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(obj_vertices_are_doubles),
        cmocka_unit_test(every_way_to_write_an_obj_vertex_is_read),
        cmocka_unit_test(bad_obj_vertices_are_refused_by_line),
        cmocka_unit_test(ply_vertices_are_doubles),
        cmocka_unit_test(binary_ply_vertices_are_doubles),
        cmocka_unit_test(a_ply_that_begins_with_a_newlines_byte_is_read),
        cmocka_unit_test(a_ply_may_begin_with_any_byte),
        cmocka_unit_test(stl_vertices_are_doubles),
        cmocka_unit_test(off_vertices_are_doubles),
        cmocka_unit_test(off_faces_that_would_be_wrong_are_refused),
        cmocka_unit_test(gltf_nodes_are_doubles),
        cmocka_unit_test(chains_of_gltf_nodes_are_doubles),
        cmocka_unit_test(the_reference_reads_the_file_that_the_importer_read),
        cmocka_unit_test(damaged_gltf_is_refused),
        cmocka_unit_test(a_disagreement_of_the_readers_is_an_error),
        cmocka_unit_test(a_format_without_a_reader_is_told),
        cmocka_unit_test(coarse_float32_is_told_in_metres),
        cmocka_unit_test(coarse_keys_are_told_in_metres),
        cmocka_unit_test(stand_ins_are_told_from_other_numbers),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
