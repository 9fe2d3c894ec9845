/* SPDX-License-Identifier: MIT
 *
 * glTF 2.0 as text with its buffer in base64, or as .glb: a mesh in a node below another one, both of which may turn,
 * scale and move it, by parts or by a matrix. Where it comes to is computed here in long double. */
#include "fuzz_writer.h"

#include <math.h>
#include <string.h>

enum { NODES = 2, TRIANGLES = 4, STRIP, FAN, UNSIGNED_BYTE = 5121, UNSIGNED_SHORT = 5123, UNSIGNED_INT = 5125 };
enum { JSON_MAX_B = 2048, VERTEX_B = 12, INDICES_MAX = 3 * WRITTEN_FACES_MAX };

struct motion {
    long double m[3][4];
};

struct buffer {
    uint8_t bytes[WRITTEN_VERTICES_MAX * 2 * VERTEX_B + 4 * INDICES_MAX];
    size_t size_b, stride_b, indices_at, index_count, index_b;
    unsigned mode;
};

static void put_word(struct buffer *buffer, uint32_t word, size_t size_b)
{
    for (size_t i = 0; i < size_b; i++)
        buffer->bytes[buffer->size_b++] = (uint8_t)(word >> 8 * i);
}

static void make_positions(struct written *written, struct buffer *buffer, struct fuzz_bytes *bytes)
{
    buffer->stride_b = fuzz_below(bytes, 2) ? VERTEX_B : 2 * VERTEX_B;
    for (size_t i = 0; i < written->vertex_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const float number = ldexpf((float)(int16_t)fuzz_u16(bytes), fuzz_below(bytes, 33) - 16);
            uint32_t word;
            memcpy(&word, &number, sizeof word);
            put_word(buffer, word, 4);
            written->vertices[i][axis] = (double)number;
        }
        for (size_t pad_b = VERTEX_B; pad_b < buffer->stride_b; pad_b += 4)
            put_word(buffer, 0x7FC00000, 4); /* what is between the vertices is nothing to anybody: NaN */
    }
}

/* Of a strip every other triangle would face backwards, and has its first two corners the other way round. */
static void make_indices(struct written *written, struct buffer *buffer, struct fuzz_bytes *bytes)
{
    static const size_t sizes_b[] = {1, 2, 4};
    size_t indices[INDICES_MAX];

    buffer->index_b = sizes_b[fuzz_below(bytes, 3)];
    buffer->mode = TRIANGLES + fuzz_below(bytes, 3);
    buffer->indices_at = buffer->size_b;
    const bool alone = buffer->mode == TRIANGLES;
    buffer->index_count = alone ? 3 * written->face_count : written->face_count + 2;
    for (size_t i = 0; i < buffer->index_count; i++) {
        indices[i] = alone ? written->faces[i / 3].vertices[i % 3] : fuzz_below(bytes, (unsigned)written->vertex_count);
        put_word(buffer, (uint32_t)indices[i], buffer->index_b);
    }
    for (size_t i = 0; i < written->face_count && !alone; i++)
        for (size_t k = 0; k < 3; k++) {
            const size_t in_strip = k < 2 && i % 2 ? i + 1 - k : i + k;
            written->faces[i].vertices[k] = indices[buffer->mode == STRIP ? in_strip : k ? i + k : 0];
        }
}

/* Nodes -------------------------------------------------------------------------------------- */

static void put_vector(struct written *written, const char *name, const double *vector, int count)
{
    written_put(written, ",\"%s\":[", name);
    for (int i = 0; i < count; i++) {
        if (i) written_put(written, ",");
        written_put_json(written, vector[i]);
    }
    written_put(written, "]");
}

/* v + 2 q x (q x v + w v), column by column. */
static void turn_by(const double q[4], struct motion *motion)
{
    for (int column = 0; column < 3; column++) {
        long double v[3] = {column == 0, column == 1, column == 2}, once[3];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            once[i] = q[j] * v[k] - q[k] * v[j] + q[3] * v[i];
        }
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            motion->m[i][column] = v[i] + 2 * (q[j] * once[k] - q[k] * once[j]);
        }
    }
}

static void make_turn(struct fuzz_bytes *bytes, double q[4])
{
    double length = 0;

    for (int i = 0; i < 4; i++) {
        q[i] = (int8_t)fuzz_u8(bytes);
        length = hypot(length, q[i]);
    }
    if (length == 0) q[3] = length = 1;
    for (int i = 0; i < 4; i++)
        q[i] /= length;
}

static void put_parts(struct written *written, unsigned parts, struct motion *motion, struct fuzz_bytes *bytes)
{
    double q[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1}, at[3] = {0, 0, 0};

    if (parts & 1) make_turn(bytes, q);
    for (int i = 0; i < 3; i++) {
        if (parts & 2) scale[i] = (1 + fuzz_below(bytes, 127)) / (fuzz_below(bytes, 8) ? 16.0 : -16.0);
        if (parts & 4) at[i] = (int32_t)fuzz_u32(bytes) / 3000.0;
    }
    if (parts & 1) put_vector(written, "rotation", q, 4);
    if (parts & 2) put_vector(written, "scale", scale, 3);
    if (parts & 4) put_vector(written, "translation", at, 3);
    turn_by(q, motion);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            motion->m[i][k] *= scale[k];
        motion->m[i][3] = at[i];
    }
}

/* A turn by quarters with a scale, as a matrix, which goes column by column. */
static void put_matrix(struct written *written, struct motion *motion, struct fuzz_bytes *bytes)
{
    const int first = fuzz_below(bytes, 3);
    double matrix[16] = {[15] = 1};

    for (int column = 0; column < 3; column++)
        matrix[4 * column + (first + column) % 3] = (1 + fuzz_below(bytes, 100)) / 8.0;
    for (int row = 0; row < 3; row++)
        matrix[12 + row] = (int16_t)fuzz_u16(bytes) / 7.0;
    put_vector(written, "matrix", matrix, 16);
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++)
            motion->m[row][column] = matrix[4 * column + row];
}

/* Whether it mirrors. */
static bool mirrors(const struct motion *motion)
{
    const long double(*m)[4] = (const long double(*)[4])motion->m;

    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
           0;
}

/* From the mesh's coordinates up to the scene's; the inner node comes first. */
static void move(struct written *written, const struct motion motions[NODES])
{
    for (size_t i = 0; i < written->vertex_count; i++) {
        long double p[3] = {written->vertices[i][0], written->vertices[i][1], written->vertices[i][2]};
        for (int node = NODES - 1; node >= 0; node--) {
            const long double from[3] = {p[0], p[1], p[2]};
            for (int row = 0; row < 3; row++) {
                const long double *m = motions[node].m[row];
                p[row] = m[0] * from[0] + m[1] * from[1] + m[2] * from[2] + m[3];
                written->reach_m = fmax(written->reach_m, fabs((double)p[row]));
                written->reach_m = fmax(written->reach_m, fabs((double)(m[0] * from[0])));
                written->reach_m = fmax(written->reach_m, fabs((double)(m[1] * from[1])));
                written->reach_m = fmax(written->reach_m, fabs((double)(m[2] * from[2])));
            }
        }
        for (int axis = 0; axis < 3; axis++)
            written->places[i][axis] = (double)p[axis];
    }
    for (size_t i = 0; i < written->face_count && mirrors(&motions[0]) != mirrors(&motions[1]); i++) {
        const size_t first = written->faces[i].vertices[0];
        written->faces[i].vertices[0] = written->faces[i].vertices[2];
        written->faces[i].vertices[2] = first;
    }
}

static void put_nodes(struct written *written, struct fuzz_bytes *bytes)
{
    struct motion motions[NODES];

    for (int node = 0; node < NODES; node++) {
        const uint8_t kind = fuzz_below(bytes, 9);
        written_put(written, "%s{%s", node ? "," : ",\"nodes\":[", node ? "\"mesh\":0" : "\"children\":[1]");
        if (kind == 8)
            put_matrix(written, &motions[node], bytes);
        else
            put_parts(written, kind, &motions[node], bytes);
        written_put(written, "}");
    }
    written_put(written, "]");
    move(written, motions);
}

/* The file ----------------------------------------------------------------------------------- */

static void put_base64(struct written *written, const struct buffer *buffer)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    for (size_t i = 0; i < buffer->size_b; i += 3) {
        const size_t left_b = buffer->size_b - i;
        const uint32_t bits = (uint32_t)buffer->bytes[i] << 16 |
                              (left_b > 1 ? (uint32_t)buffer->bytes[i + 1] << 8 : 0) |
                              (left_b > 2 ? buffer->bytes[i + 2] : 0);
        written_put(written, "%c%c%c%c", digits[bits >> 18], digits[bits >> 12 & 63],
                    left_b > 1 ? digits[bits >> 6 & 63] : '=', left_b > 2 ? digits[bits & 63] : '=');
    }
}

static void put_json(struct written *written, const struct buffer *buffer, struct fuzz_bytes *bytes)
{
    const unsigned component = buffer->index_b == 1   ? UNSIGNED_BYTE
                               : buffer->index_b == 2 ? UNSIGNED_SHORT
                                                      : UNSIGNED_INT;

    written_put(written, "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}]");
    put_nodes(written, bytes);
    written_put(written, ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":%u}]}]",
                buffer->mode);
    written_put(written,
                ",\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"},"
                "{\"bufferView\":1,\"componentType\":%u,\"count\":%zu,\"type\":\"SCALAR\"}]",
                written->vertex_count, component, buffer->index_count);
    written_put(written,
                ",\"bufferViews\":[{\"buffer\":0,\"byteLength\":%zu,\"byteStride\":%zu},"
                "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}],\"buffers\":[{\"byteLength\":%zu",
                buffer->indices_at, buffer->stride_b, buffer->indices_at, buffer->size_b - buffer->indices_at,
                buffer->size_b);
    if (written->format == WRITTEN_GLTF) {
        written_put(written, ",\"uri\":\"data:application/octet-stream;base64,");
        put_base64(written, buffer);
        written_put(written, "\"");
    }
    written_put(written, "}]}");
}

/* What has been written so far becomes the first chunk, filled up with blanks, and the buffer the second. */
static void make_binary(struct written *written, const struct buffer *buffer)
{
    char json[JSON_MAX_B];
    const size_t json_b = written->size_b, filled_b = (json_b + 3) & ~(size_t)3,
                 buffer_b = (buffer->size_b + 3) & ~(size_t)3;

    memset(json, ' ', sizeof json);
    memcpy(json, written->file, json_b < sizeof json ? json_b : sizeof json);
    written->size_b = 0;
    written_put_bytes(written, "glTF", 4);
    written_put_whole(written, 2, 4, false);
    written_put_whole(written, 12 + 8 + filled_b + 8 + buffer_b, 4, false);
    written_put_whole(written, filled_b, 4, false);
    written_put_bytes(written, "JSON", 4);
    written_put_bytes(written, json, filled_b);
    written_put_whole(written, buffer_b, 4, false);
    written_put_bytes(written, "BIN\0", 4);
    written_put_bytes(written, buffer->bytes, buffer->size_b);
    written_put_bytes(written, "\0\0\0", buffer_b - buffer->size_b);
}

void written_gltf(struct written *written, struct fuzz_bytes *bytes)
{
    struct buffer buffer = {.size_b = 0};

    make_positions(written, &buffer, bytes);
    make_indices(written, &buffer, bytes);
    put_json(written, &buffer, bytes);
    if (written->format == WRITTEN_GLB) make_binary(written, &buffer);
}
