/* SPDX-License-Identifier: MIT
 *
 * What EXT_meshopt_compression has packed is what was packed: by the library's own encoder, which shares no code with
 * the decoder's callers. What is damaged, or not as long as it says, is refused. */
#include "readers/model_import.h"
#include "readers/source.h"
#include "rigs/cmocka_ready.h"

#include <jansson.h>
#include <math.h>
#include <meshoptimizer.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { POINTS = 6, TRIANGLES = 4, CORNERS = 3 * TRIANGLES, PACKED_MOST_B = 4096 };

static const short PLACES[POINTS][4] = {{0, 0, 0},     {100, 0, 3},    {0, 200, -7},
                                        {-300, 0, 11}, {5, -32000, 1}, {9, 9, 32000}};
static const unsigned INDICES[CORNERS] = {0, 1, 2, 2, 1, 3, 3, 4, 5, 0, 5, 2};

static char folder[] = "/tmp/limner-test-XXXXXX";

/* A file of two packed views in one buffer. */
struct packed {
    unsigned char bytes[PACKED_MOST_B];
    size_t positions_b, indices_b;
    const char *mode, *filter; /* of positions */
    const char *index_mode;
    int component;
    size_t stride_b, count, index_count;
};

static struct packed pack_shorts(void)
{
    struct packed out = {.mode = "ATTRIBUTES",
                         .filter = "NONE",
                         .index_mode = "INDICES",
                         .component = 5122,
                         .stride_b = sizeof PLACES[0],
                         .count = POINTS,
                         .index_count = CORNERS};
    out.positions_b = meshopt_encodeVertexBuffer(out.bytes, sizeof out.bytes, PLACES, POINTS, sizeof PLACES[0]);
    out.indices_b =
        meshopt_encodeIndexSequence(out.bytes + out.positions_b, sizeof out.bytes - out.positions_b, INDICES, CORNERS);
    return out;
}

static struct packed pack_floats(void)
{
    float places[POINTS][3];
    unsigned filtered[POINTS][3];
    struct packed out = {.mode = "ATTRIBUTES",
                         .filter = "EXPONENTIAL",
                         .index_mode = "TRIANGLES",
                         .component = 5126,
                         .stride_b = sizeof places[0],
                         .count = POINTS,
                         .index_count = CORNERS};
    for (int i = 0; i < POINTS; i++)
        for (int k = 0; k < 3; k++)
            places[i][k] = PLACES[i][k];
    meshopt_encodeFilterExp(filtered, POINTS, sizeof filtered[0], 24, places[0]);
    out.positions_b = meshopt_encodeVertexBuffer(out.bytes, sizeof out.bytes, filtered, POINTS, sizeof filtered[0]);
    out.indices_b =
        meshopt_encodeIndexBuffer(out.bytes + out.positions_b, sizeof out.bytes - out.positions_b, INDICES, CORNERS);
    return out;
}

static json_t *view(size_t at_b, size_t size_b, size_t stride_b, size_t count, const char *mode, const char *filter)
{
    return json_pack("{s:i, s:i, s:{s:{s:i, s:I, s:I, s:I, s:I, s:s, s:s}}}", "buffer", 1, "byteLength",
                     (int)(stride_b * count), "extensions", "EXT_meshopt_compression", "buffer", 0, "byteOffset",
                     (json_int_t)at_b, "byteLength", (json_int_t)size_b, "byteStride", (json_int_t)stride_b, "count",
                     (json_int_t)count, "mode", mode, "filter", filter);
}

static void put(const char *path, const struct packed *packed)
{
    char data[64];
    snprintf(data, sizeof data, "%s/packed.bin", folder);
    FILE *file = fopen(data, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(packed->bytes, 1, sizeof packed->bytes, file), sizeof packed->bytes);
    assert_int_equal(fclose(file), 0);
    json_t *root = json_pack(
        "{s:{s:s}, s:[s], s:[{s:[i]}], s:[{s:i}], s:[{s:[{s:{s:i}, s:i}]}], s:[{s:s, s:i}, {s:i, s:{s:{s:b}}}], "
        "s:[o, o], s:[{s:i, s:i, s:I, s:s}, {s:i, s:i, s:I, s:s}]}",
        "asset", "version", "2.0", "extensionsRequired", "EXT_meshopt_compression", "scenes", "nodes", 0, "nodes",
        "mesh", 0, "meshes", "primitives", "attributes", "POSITION", 0, "indices", 1, "buffers", "uri", "packed.bin",
        "byteLength", PACKED_MOST_B, "byteLength", 1000, "extensions", "EXT_meshopt_compression", "fallback", 1,
        "bufferViews", view(0, packed->positions_b, packed->stride_b, packed->count, packed->mode, packed->filter),
        view(packed->positions_b, packed->indices_b, 4, packed->index_count, packed->index_mode, "NONE"), "accessors",
        "bufferView", 0, "componentType", packed->component, "count", (json_int_t)POINTS, "type", "VEC3", "bufferView",
        1, "componentType", 5125, "count", (json_int_t)CORNERS, "type", "SCALAR");
    assert_non_null(root);
    assert_int_equal(json_dump_file(root, path, 0), 0);
    json_decref(root);
}

static const char *path_in_folder(void)
{
    static char path[64];
    snprintf(path, sizeof path, "%s/a.gltf", folder);
    return path;
}

static void assert_read(const struct packed *packed)
{
    struct model model;
    struct error err = {""};
    put(path_in_folder(), packed);
    if (!model_import(path_in_folder(), &model, &err) || !source_take(path_in_folder(), &model, &err))
        fail_msg("%s", err.text);
    assert_int_equal(model.face_count, TRIANGLES);
    for (size_t i = 0; i < TRIANGLES; i++) {
        size_t first = 0; /* triangles may begin at another corner than they did */
        const uint32_t *corners = &model.corners[model.faces[i].first];
        while (first < 2 && model.points[corners[0]][0] != PLACES[INDICES[3 * i + first]][0])
            first++;
        for (size_t k = 0; k < 3; k++)
            for (int axis = 0; axis < 3; axis++)
                assert_float_equal(model.points[corners[k]][axis], PLACES[INDICES[3 * i + (first + k) % 3]][axis], 0);
    }
    model_free(&model);
}

static void assert_refused(const struct packed *packed, const char *why)
{
    struct model model;
    struct error err = {""};
    put(path_in_folder(), packed);
    if (model_import(path_in_folder(), &model, &err)) fail_msg("not refused: %s", why);
    if (!strstr(err.text, why)) fail_msg("%s: instead of %s", err.text, why);
}

static void what_is_packed_is_read(void **state)
{
    (void)state;
    const struct packed shorts = pack_shorts(), floats = pack_floats();
    assert_read(&shorts);
    assert_read(&floats);
}

/* Each byte that is there is needed. */
static void what_is_cut_is_refused(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct packed packed = i ? pack_floats() : pack_shorts();
        packed.indices_b--;
        assert_refused(&packed, "view 1 of its buffers: it is packed, and damaged");
        packed = i ? pack_floats() : pack_shorts();
        packed.positions_b--;
        assert_refused(&packed, "view 0 of its buffers: it is packed, and damaged");
    }
}

static void what_claims_more_is_refused(void **state)
{
    (void)state;
    struct packed packed = pack_floats();
    packed.index_count += 3;
    assert_refused(&packed, "view 1 of its buffers: it is packed, and damaged");
    packed = pack_shorts();
    packed.positions_b = sizeof packed.bytes + 1;
    assert_refused(&packed, "view 0 of its buffers: it is packed, and leads out of its buffer");
    packed = pack_shorts();
    packed.count = (size_t)1 << 31;
    assert_refused(&packed, "view 0 of its buffers: it is packed in a way that is not read");
}

/* Ways that the library would end the program for. */
static void what_has_no_such_way_is_refused(void **state)
{
    static const size_t strides_b[] = {0, 6, 260};
    (void)state;
    for (size_t i = 0; i < sizeof strides_b / sizeof *strides_b; i++) {
        struct packed packed = pack_shorts();
        packed.stride_b = strides_b[i];
        assert_refused(&packed, "view 0 of its buffers: it is packed in a way that is not read (ATTRIBUTES, NONE)");
    }
    struct packed packed = pack_floats();
    packed.index_count = CORNERS - 1;
    assert_refused(&packed, "view 1 of its buffers: it is packed in a way that is not read (TRIANGLES, NONE)");
    packed = pack_floats();
    packed.filter = "COLOR";
    assert_refused(&packed, "view 0 of its buffers: it is packed in a way that is not read (ATTRIBUTES, COLOR)");
    packed.filter = "OCTAHEDRAL"; /* which is for four or eight bytes */
    assert_refused(&packed, "view 0 of its buffers: it is packed in a way that is not read (ATTRIBUTES, OCTAHEDRAL)");
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    char path[64];
    (void)state;
    remove(path_in_folder());
    snprintf(path, sizeof path, "%s/packed.bin", folder);
    remove(path);
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_packed_is_read),
        cmocka_unit_test(what_is_cut_is_refused),
        cmocka_unit_test(what_claims_more_is_refused),
        cmocka_unit_test(what_has_no_such_way_is_refused),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
