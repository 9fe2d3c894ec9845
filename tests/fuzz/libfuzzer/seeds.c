/* SPDX-License-Identifier: MIT
 *
 * Inputs to begin with, where bytes at random would be long on their way: models and pictures that are as they should
 * be, maps, and reports. FOLDER gets a folder for each target, COUNT files for each of its formats. */
#define _XOPEN_SOURCE 700
#include "fuzz/fuzz_model.h"
#include "fuzz/fuzz_writer.h"

#include <gd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { BYTES_B = 600, SIDE_MAX_PX = 9, DUMP_BYTES = 10 };

static void put(const char *folder, const char *target, const char *name, unsigned number, const void *bytes,
                size_t size_b)
{
    char path[1024];

    snprintf(path, sizeof path, "%s/%s", folder, target);
    mkdir(path, 0777); /* may be there */
    snprintf(path, sizeof path, "%s/%s/seed-%s-%u", folder, target, name, number);
    FILE *file = fopen(path, "wb");
    const bool wrote = file && fwrite(bytes, 1, size_b, file) == size_b;
    if (file && fclose(file) == 0 && wrote) return;
    perror(path);
    exit(EXIT_FAILURE);
}

static void put_models(const char *folder, unsigned number, const uint8_t *bytes)
{
    static const char *const targets[WRITTEN_FORMATS] = {"obj", "ply", "stl", "off", "gltf", "gltf"};

    for (int format = 0; format < WRITTEN_FORMATS; format++) {
        struct fuzz_bytes left = {bytes, BYTES_B};
        struct written written;
        written_make(&written, (enum written_format)format, &left);
        put(folder, targets[format], written_name(written.format) + strlen("model."), number, written.file,
            written.size_b);
    }
}

static void put_map(const char *folder, unsigned number, const uint8_t *bytes)
{
    uint8_t map[4 * BYTES_B];

    put(folder, "wad", "map", number, map, fuzz_wad_seed(map, sizeof map, bytes));
}

static const char *const dump_options[] = {"--panel st7789 --running", "--panel st7567 --wires reset=-",
                                           "--panel ssd1306 --running --wires led=-", "--panel ili9341 --running"};

/* Bytes on the wires of a display, the first few as commands: a line for each change. */
static void put_dump(const char *folder, unsigned number, const uint8_t *bytes)
{
    char *text = NULL;
    size_t size_b = 0;
    FILE *file = open_memstream(&text, &size_b);
    unsigned time = 0;

    if (!file) exit(EXIT_FAILURE);
    fprintf(file, "%s\n$timescale 1 us $end\n$scope module top $end\n", dump_options[number % 4]);
    fputs("$var wire 1 a dc $end $var wire 1 b sck $end $var wire 1 c mosi $end $var wire 1 d cs $end\n", file);
    fputs("$var wire 1 e reset $end $upscope $end $enddefinitions $end\n#0 1d 0b 0a 0c 1e\n#1 0e\n#2 1e 0d\n", file);
    for (int i = 0; i < DUMP_BYTES; i++) {
        fprintf(file, "%ua\n", i > bytes[0] % DUMP_BYTES);
        for (int bit = 7; bit >= 0; bit--, time += 2)
            fprintf(file, "#%u %uc 0b\n#%u 1b\n", time + 3, bytes[i + 1] >> bit & 1u, time + 4);
    }
    fprintf(file, "#%u 1d\n", time + 5);
    if (fclose(file) != 0) exit(EXIT_FAILURE);
    put(folder, "vcd", "dump", number, text, size_b);
    free(text);
}

static void put_pictures(const char *folder, unsigned number, const uint8_t *bytes)
{
    const int w_px = 1 + bytes[0] % SIDE_MAX_PX, h_px = 1 + bytes[1] % SIDE_MAX_PX;
    gdImagePtr image = bytes[2] & 1 ? gdImageCreateTrueColor(w_px, h_px) : gdImageCreate(w_px, h_px);
    const int background = gdImageColorAllocate(image, bytes[3], bytes[4], bytes[5]);
    const int ink = gdImageColorAllocate(image, bytes[6], bytes[7], bytes[8]);
    int size_b;

    gdImageFilledRectangle(image, 0, 0, w_px, h_px, background);
    gdImageLine(image, 0, 0, w_px, h_px / 2, ink);
    gdImageInterlace(image, bytes[2] >> 1 & 1);
    void *const files[] = {gdImagePngPtr(image, &size_b)};
    put(folder, "picture", "png", number, files[0], (size_t)size_b);
    gdFree(files[0]);
    void *jpeg = gdImageJpegPtr(image, &size_b, bytes[9] % 100);
    put(folder, "picture", "jpeg", number, jpeg, (size_t)size_b);
    gdFree(jpeg);
    void *gif = gdImageGifPtr(image, &size_b);
    put(folder, "picture", "gif", number, gif, (size_t)size_b);
    gdFree(gif);
    void *bmp = gdImageBmpPtr(image, &size_b, bytes[2] >> 2 & 1);
    put(folder, "picture", "bmp", number, bmp, (size_t)size_b);
    gdFree(bmp);
    gdImageDestroy(image);
}

/* Where a word must be there as a whole. The first byte says what it is (fuzz_text.c, fuzz_report.c). */
static const struct {
    const char *target, *text;
} texts[] = {
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noption: --size=9x9\noption: --profile=exact\n"
               "outcome: drawn\nlist\n\xFF"
               "0scene/a.obj\nv 1 2 3\n\xFF"
               "0frames.hashes\n0 0123456789abcdef\n\xFF"
               "0cameras.cam\n0 0 0 0 0 0\n"},
    {"report",
     "0report.txt\nlimner report 1\nscene: scene/b/c.gltf\noption: --cameras=cameras.cam\noption: --ids=faces.ids\n"
     "outcome: refused scene/b/c.gltf: for a reason\nlist\n\xFF"
     "0scene/b/c.gltf\n{}\xFF"
     "0cameras.cam\n0 0 0 0 0 0\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noutcome: crashed signal 11\nlist\n\xFF"
               "0scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noption: --gif=a.gif\noutcome: crashed\nlist\n\xFF"
               "0scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noption: --trust-paths\noutcome: crashed\nlist\n\xFF"
               "0scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noption: b.obj\noutcome: crashed\nlist\n\xFF"
               "0scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noutcome: drawn\nlist\n\xFF"
               "0scene/a.obj\n\xFF"
               "0scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/../a.obj\noutcome: crashed\nlist\n\377"
               "0scene/../a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/../../escaped\noutcome: crashed\nlist\n\377"
               "0scene/../../escaped\nx"},
    {"report", "0report.txt\nlimner report 1\nscene: scene/a.obj\noutcome: lost\nlist\n\xFF"
               "0scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 1\nfile: 3 01234567 scene/a.obj\n\xFF"
               "0scene/a.obj\nabc"},
    {"report", "0report.txt\nlimner report 1\nfile: 3 scene/a.obj\n"},
    {"report", "0report.txt\nlimner report 2\n"},
    {"report", "0report.txt\nlimner report 1\n\377"
               "0report.txt\n\xFF"},
    {"report", "2report.txt\nlimner report 1\n"},
    {"report", "5report.txt\nlimner report 1\n"},
    {"report", "0scene/a.obj\n"},
    {"report", "raw"},
    {"report", "rawlimner report 1\n"},
    {"text", "\x07-12.5e-3\n"},
    {"text", "\x07.e5\n"},
    {"text", "\x07inf\n"},
    {"text", "\x07+0001.5E+30\n"},
    {"text", "\x08rp2040\nsome code and some more of it"},
    {"text", "\x08none\n"},
    {"text", "\x09play --spi /dev/spidev0.0 --dc gpiochip0:24 --backlight gpiochip0:18 --cs-high --no-cs\n"},
    {"text",
     "\x09play --spi /dev/spidev0.0 --dc=gpiochip0:24 --reset gpiochip0:25 --select gpiochip0:8 --te gpiochip0:7 "
     "--mode 3 --no-cs\n"},
    {"text", "\x09play --hid 0001 --dc 3 --reset 4 --cs 1\n"},
    {"text", "\x09play --hid --dc 3 --select 1 --te 5\n"},
    {"text", "\x0A\x05 a line\nand another\r\n"},
    {"text", "\x0A\x07 a line\nand another\r\n"},
    {"text", "\x0A\x06 a line that is longer than forty bytes, which are the most here\n"},
    {"text", "\x0A\x10"},
    {"text", "\x0A\x01"},
    {"text", "\x0A\x02"},
    {"text", "\x0A\x03"},
    {"text", "\x0A\x04"},
    {"gltf",
     "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"
     "\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":"
     "6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5123,"
     "\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
     "\"buffers\":[{\"byteLength\":44,\"uri\":\"model%2Ebin\"}]}\012"},
    {"gltf",
     "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"
     "\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":"
     "6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5123,"
     "\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
     "\"buffers\":[{\"byteLength\":44,\"uri\":\"none.bin\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":"
             "0,\"componentType\":5123},\"values\":{\"bufferView\":1}}}],\"buffers\":[{\"byteLength\":44,\"uri\":"
             "\"data:;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"sparse\":{\"count\":4,\"indices\":{\"bufferView\":"
             "0,\"componentType\":5123},\"values\":{\"bufferView\":1}}}],\"buffers\":[{\"byteLength\":44,\"uri\":"
             "\"data:;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5120,\"count\":3,\"type\":\"VEC3\",\"normalized\":true}],\"buffers\":[{\"byteLength\":"
             "44,\"uri\":\"data:;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5122,\"count\":3,\"type\":\"VEC3\",\"normalized\":true}],\"buffers\":[{\"byteLength\":"
             "44,\"uri\":\"data:;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5121,\"count\":3,\"type\":\"VEC3\",\"normalized\":true}],\"buffers\":[{\"byteLength\":"
             "44,\"uri\":\"data:;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5123,\"count\":3,\"type\":\"VEC3\"}],\"buffers\":[{\"byteLength\":44,\"uri\":\"data:;"
             "base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf",
     "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"
     "\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0,\"extensions\":{\"KHR_draco_mesh_compression\":{}}"
     "}]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],"
     "\"accessors\":[{\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
     "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"buffers\":[{\"byteLength\":44,\"uri\":\"data:;base64,"
     "AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf", "{\"asset\":{\"version\":\"1.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],\"bufferViews\":[{"
             "\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],\"accessors\":[{"
             "\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
             "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"buffers\":[{\"byteLength\":44,\"uri\":\"data:;"
             "base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"gltf",
     "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"matrix\":[1,0,"
     "0,0,0,1,0,0,0,0,1,0,5,6,7,1]}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],"
     "\"bufferViews\":[{\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],"
     "\"accessors\":[{\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},{\"bufferView\":1,"
     "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"buffers\":[{\"byteLength\":44,\"uri\":\"data:;base64,"
     "AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=\"}]}"},
    {"text", "\012\010a line\n"},
    {"text", "\003\002x a.lim --drop-small --camera random:2:2 --newell most=9,planes\n"},
    {"text", "\003\002x a.lim --camera near:2:2 --size 8x8 --stats --compare --antialias --delta=3\n"},
    {"text", "\003\001x a.lim --size 8x8 --tree bsp\n"},
    {"text", "\003\002x a.obj --size 8x8 --camera a.cam\n"},
    {"text", "\003\002x a.obj --size 8x8 --drop-small --newell most=20 --camera random:1:1\n"},
    {"text", "\004\002x a.obj --drop-small --cores all\n"},
    {"text", "\011play --hid\n"},
    {"text", "\011play --hid 12 --spi x\n"},
    {"text", "\011play --hid 12 --te 5\n"},
    {"text", "\011play --hid 12 --no-cs\n"},
    {"text", "\011play --spi x --dc a:1 --reset a:1\n"},
    {"text", "\011play --spi x --dc a:1 --cs 5\n"},
    {"text", "\011play --spi x --dc a:1 --no-cs --cs-high\n"},
    {"text", "\011play --spi x --dc a:1 --te a:2 --mode 3\n"},
    {"text", "\011play --spi x --mode 9\n"},
    {"text", "\011play --spi x --dc a:1\n"},
    {"text", "\011play --dc a:1\n"},
    {"obj", "mtllib a.mtl\nv 0 0 0\\\r\n\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n"},
    {"obj", "v 1 2 3 4 5\nf 1 1 1\n"},
    {"ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty strange "
     "w\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"},
    {"ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
            "tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty "
            "float w\nelement face 0\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0 5\n1 1 1 1 1\n"},
    {"stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\nvertex 1 0 0\nvertex 0 1 "
            "0\nendloop\nendfacet\nendsolid a\n"},
    {"stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1"},
    {"off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"off", "OFF # a comment\n\n# another\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"off", "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n3 0 1 2\n"},
    {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2"},
    {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3/"},
    {"obj", "v 0 0 0\nv 1 0"},
    {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
    {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n# f 1 2 3"},
    {"ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
            "face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0"},
    {"ply", "ply\nformat ascii 1.0\n"},
    {"ply", "ply\nproperty\nformat\n"},
    {"ply", "ply\nelement\n"},
    {"ply", "ply\nelement vertex 3\nproperty\nend_header\n"},
    {"ply", "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
            "float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\nabcdefgh"},
    {"ply",
     "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
     "z\nelement face 1\nproperty list uchar int vertex_index\nend_header\nabcdefghabcdefghabcdefghabcdefghabcd"},
    {"ply", "ply\nformat none 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
            "face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"stl", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAABBBBBBBBBBBBBBBBBBBBBB"
            "BBBBBBBBBBBBBBBBBBBBBBBBBBBB"},
    {"stl",
     "solid aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\nfacet\n"},
    {"text", "\x09play --hid 1 --spi 2\n"},
    {"text", "\x09play --hid 77 --dc 1 --reset 2 --backlight 3\n"},
};

static void put_texts(const char *folder)
{
    for (unsigned i = 0; i < sizeof texts / sizeof *texts; i++)
        put(folder, texts[i].target, "text", i, texts[i].text, strlen(texts[i].text));
}

/* A glTF file whose buffer is a file of its own, behind a byte 0xFF: corners 0, 1, 2 of a triangle. */
static void put_buffer_beside(const char *folder)
{
    static const char model[] =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":8,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},"
        "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"buffers\":[{\"byteLength\":44,\"uri\":\"model.bin\"}]}\xFF";
    static const char buffer[44] = {[2] = 1, [4] = 2, [22] = (char)0x80, [23] = 0x3F, [38] = (char)0x80, [39] = 0x3F};
    char file[sizeof model - 1 + sizeof buffer];

    memcpy(file, model, sizeof model - 1);
    memcpy(file + sizeof model - 1, buffer, sizeof buffer);
    put(folder, "gltf", "beside", 0, file, sizeof file);
}

int main(int argc, char **argv)
{
    const unsigned count = argc == 3 ? (unsigned)strtoul(argv[2], NULL, 10) : 0;
    uint32_t state = 1;

    if (!count) {
        fputs("seeds: FOLDER COUNT\n", stderr);
        return EXIT_FAILURE;
    }
    put_texts(argv[1]);
    put_buffer_beside(argv[1]);
    for (unsigned number = 0; number < count; number++) {
        uint8_t bytes[BYTES_B];
        for (size_t i = 0; i < sizeof bytes; i++)
            bytes[i] = (uint8_t)((state = state * 1664525 + 1013904223) >> 24);
        put_models(argv[1], number, bytes);
        put_pictures(argv[1], number, bytes);
        put_map(argv[1], number, bytes);
        put_dump(argv[1], number, bytes);
    }
    return EXIT_SUCCESS;
}
