/* SPDX-License-Identifier: MIT
 *
 * The smaller readers of text, and command lines; the first byte says which. What they refuse they refuse in one line,
 * and what they take is within the bounds that they promise. */
#include "base/binary.h"
#include "base/input_file.h"
#include "base/parse.h"
#include "cameras/camera_choice.h"
#include "cli/options.h"
#include "displays/port_choice.h"
#include "export/boot2.h"
#include "export/esp_image.h"
#include "export/uf2.h"
#include "files/decimal.h"
#include "fuzz_room.h"
#include "fuzz_words.h"
#include "measure/link_map.h"
#include "measure/measure_request.h"
#include "pictures/hashes.h"
#include "scene/moving.h"
#include "scene/scene_files.h"

#include <float.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BINARY_MAX_B = 256 };

static const char *read_hashes(struct fuzz_bytes *bytes)
{
    static const uint64_t hashes[] = {0, 1, 0xFFFFFFFFFFFFFFFF};
    const uint8_t count = fuzz_below(bytes, 4);
    const char *path = fuzz_as_file(bytes->at, bytes->left_b);
    struct error err;

    return hashes_check(hashes, count, path, &err) ? NULL : fuzz_check_refusal(err.text, path);
}

/* Hashes are read as they were written, and one that differs is found. */
static const char *write_hashes(struct fuzz_bytes *bytes)
{
    const uint16_t pixels[] = {fuzz_u16(bytes), fuzz_u16(bytes)};
    uint64_t hashes[] = {fuzz_u32(bytes), hash_pixels(pixels, 2), ~(uint64_t)fuzz_u32(bytes) << fuzz_below(bytes, 33)};
    char text[128] = "";
    struct error err;

    FILE *file = fmemopen(text, sizeof text, "w");
    const bool written = file && hashes_write(hashes, 3, file);
    if (!file || fclose(file) != 0 || !written) return "hashes cannot be written";
    const char *path = fuzz_as_file((const uint8_t *)text, strlen(text));
    if (!hashes_check(hashes, 3, path, &err)) return "hashes were read otherwise than written";
    hashes[fuzz_below(bytes, 3)]++;
    return hashes_check(hashes, 3, path, &err) ? "another hash was taken for the same" : NULL;
}

static const char *check_sections(const struct link_map *map)
{
    for (size_t i = 0; i < map->count; i++) {
        const struct link_section *section = &map->sections[i];
        if (!section->size_b || !section->name[0] || !section->object[0]) return "a section of nothing";
        if (i && section->start < section[-1].start) return "sections out of order";
    }
    return map->count ? NULL : "a map without a section";
}

static const char *read_link_map(struct fuzz_bytes *bytes)
{
    const char *path = fuzz_as_file(bytes->at, bytes->left_b);
    struct link_map map;
    struct error err;

    if (!link_map_read(path, &map, &err)) return fuzz_check_refusal(err.text, path);
    const char *broken = check_sections(&map);
    link_map_free(&map);
    return broken;
}

static const char *read_binary(struct fuzz_bytes *bytes)
{
    const char *path = fuzz_as_file(bytes->at, bytes->left_b);
    struct binary binary;
    struct error err;

    if (!binary_read(path, BINARY_MAX_B, &binary, &err)) return fuzz_check_refusal(err.text, path);
    const bool same = binary.size_b == bytes->left_b && memcmp(binary.bytes, bytes->at, binary.size_b) == 0;
    free(binary.bytes);
    return same ? NULL : "a file was read otherwise than it is";
}

/* getopt() forgets the line that it was in the middle of. */
static void begin_options(void)
{
    char name[] = "fuzz", *items[] = {name, NULL};

    optind = 0;
    (void)getopt(1, items, "");
}

static const char *check_options(const struct options *options)
{
    if (!options->scene_path) return "a command without a scene";
    if (options->setup.w_px < 1 || options->setup.w_px > PARSE_SIDE_MAX_PX || options->setup.h_px < 1 ||
        options->setup.h_px > PARSE_SIDE_MAX_PX)
        return "a picture out of range";
    if (!(options->compile.near_m >= 0) || !isfinite(options->frames_per_s)) return "a number out of range";
    return options->setup.core ? NULL : "a picture in no precision";
}

/* A scene in place of the one that is named, and cameras that are few and no file's. */
static const char *check_load(struct options *options)
{
    static const char model[] = "v 0 0 -3\nv 4 0 -3\nv 0 4 -3\nv 0 0 -7\nf 1 2 3\nf 1 2 4\n";
    struct compiled scene = {0};
    struct moving moving = {0};
    struct camera_path path = {0};
    struct lens lens;
    struct error err;

    if (options->cameras.text && (options->cameras.random_count < 1 || options->cameras.random_count > 3)) return NULL;
    if (options->setup.w_px > 64 || options->setup.h_px > 64) return NULL;
    options->orbit_frames = 3;
    const bool is_compiled = options_scene_is_compiled(options);
    const char *name = is_compiled ? "options.lim" : "options.obj";
    const char *place = fuzz_as_named_file(name, (const uint8_t *)model, sizeof model - 1);
    if (is_compiled && !lim_file_write(fuzz_room(), place, &err)) return "a scene cannot be written";
    options->scene_path = place;
    const bool ok = options_load(options, &scene, &moving, &lens, &path, &err);
    const char *broken = ok ? path.count ? NULL : "no camera" : fuzz_check_refusal(err.text, NULL);
    camera_path_free(&path);
    moving_free(&moving);
    compiled_free(&scene);
    return broken;
}

static const char *read_options(struct fuzz_bytes *bytes)
{
    struct fuzz_words words;
    struct options options = {0};
    struct error err;

    const enum options_set set = fuzz_below(bytes, 2) ? OPTIONS_VIEW : OPTIONS_RENDER;
    const struct arguments arguments = fuzz_words(bytes, &words);
    if (!arguments.count) return NULL;
    begin_options();
    if (!options_parse(arguments.count, arguments.items, set, &options, &err))
        return fuzz_check_refusal(err.text, NULL);
    const char *broken = check_options(&options);
    return broken ? broken : check_load(&options);
}

static const char *read_request(struct fuzz_bytes *bytes)
{
    struct fuzz_words words;
    struct measure_request request = {0};
    struct error err;

    const enum measure_of of = fuzz_below(bytes, 2) ? MEASURE_METHODS : MEASURE_PRECISIONS;
    const struct arguments arguments = fuzz_words(bytes, &words);
    if (!arguments.count) return NULL;
    begin_options();
    if (!measure_request_parse(arguments.count, arguments.items, of, &request, &err))
        return fuzz_check_refusal(err.text, NULL);
    if (request.core_count < 1 || request.core_count > MEASURE_CORES_MAX) return "a measurement of no core";
    return request.cpu_count <= MEASURE_REQUEST_CPUS_MAX ? NULL : "more processors than there is room for";
}

/* Whatever reads a value of an option that the two above do not have. */
static const char *read_values(struct fuzz_bytes *bytes)
{
    struct error err = {"-"};
    struct camera_choice cameras;
    uint32_t whole = 7;
    double number = 1;

    char *text = fuzz_string(bytes);
    bool ok = !parse_whole("--frames", text, 5, 50, &whole, &err) || (whole >= 5 && whole <= 50);
    ok = ok && (!parse_bound("--max-error", text, "%", &number, &err) || number > 0);
    ok = ok && (!parse_tolerance(text, &number, &err) || (number >= 0 && number <= 1024));
    if (camera_choice_parse(text, &cameras, &err)) ok = ok && cameras.text == text;
    free(text);
    return ok ? fuzz_check_refusal(err.text, NULL) : "a value out of range was taken";
}

/* What strtod() takes whole and finite, if it has none of the letters that only other numbers have. */
static const char *read_decimal(struct fuzz_bytes *bytes)
{
    const struct fuzz_bytes word = fuzz_part(bytes, '\n');
    char *text = fuzz_string(&word), *end;
    double value = 0;

    const size_t length = strlen(text);
    const double expected = strtod(text, &end);
    const bool is_number =
        length && *end == '\0' && strspn(text, "0123456789+-.eE") == length && fabs(expected) <= (double)FLT_MAX;
    const bool ok = decimal_parse(text, length, &value);
    const bool is_same = value == expected || (value == 0 && fabs(expected) < 1.4012984643248171e-45);
    free(text);
    if (ok != is_number) return ok ? "something else was taken for a decimal" : "a decimal was refused";
    return !ok || is_same ? NULL : "a decimal is another number";
}

/* What an ESP32-C3 loads is as long as its parts say, and each segment is RAM that it has. */
static const char *check_esp_image(const struct esp_image *image, const struct esp_chip *chip)
{
    size_t at = 24;

    if (image->size_b % 16 || image->bytes[0] != 0xE9) return "an image of no such form";
    for (unsigned i = 0; i < image->bytes[1]; i++) {
        uint32_t header[2];
        memcpy(header, image->bytes + at, sizeof header);
        const uint32_t in_code_b = header[0] - chip->code_at, in_data_b = header[0] - chip->data_at;
        const uint32_t at_b = in_code_b < chip->ram_b ? in_code_b : in_data_b;
        if (at_b >= chip->ram_b || header[1] > chip->ram_b - at_b) return "a segment outside of RAM";
        at += sizeof header + header[1];
    }
    return at / 16 * 16 + 16 + 32 == image->size_b ? NULL : "an image of another length than its segments have";
}

static const char *read_program(struct fuzz_bytes *bytes, const struct esp_chip *chip)
{
    const struct binary file = {(uint8_t *)(uintptr_t)bytes->at, bytes->left_b};
    struct elf_program program;
    struct esp_image image;
    struct error err;

    if (!elf_program_read(&file, chip->machine, &program, &err) || !esp_image_make(&image, chip, &program, &err))
        return fuzz_check_refusal(err.text, NULL);
    const char *wrong = check_esp_image(&image, chip);
    free(image.bytes);
    return wrong;
}

/* UF2 and the RP2040's second stage: of a binary file, its bytes in their places. */
static const char *read_image(struct fuzz_bytes *bytes)
{
    struct error err;
    uint8_t block[UF2_BLOCK_B], sealed[BOOT2_B];
    const struct fuzz_bytes name = fuzz_part(bytes, '\n');
    char *text = fuzz_string(&name);
    const struct uf2_family *family = uf2_family_find(text, &err);
    const struct esp_chip *chip = family ? NULL : esp_chip_find(text, &(struct error){""});

    free(text);
    if (chip) return read_program(bytes, chip);
    if (!family) return fuzz_check_refusal(err.text, "--family");
    for (uint32_t i = 0; i < uf2_block_count(bytes->left_b); i++) {
        const size_t at_b = (size_t)i * UF2_PAYLOAD_B, left_b = bytes->left_b - at_b;
        uf2_block(block, family, bytes->at, bytes->left_b, i);
        if (memcmp(block + 32, bytes->at + at_b, left_b < UF2_PAYLOAD_B ? left_b : UF2_PAYLOAD_B) != 0)
            return "a block of other bytes than the image has there";
    }
    if (!bytes->left_b || bytes->left_b > BOOT2_CODE_B) return NULL;
    boot2_seal(sealed, bytes->at, bytes->left_b);
    return memcmp(sealed, bytes->at, bytes->left_b) == 0 ? NULL : "code was changed when it was sealed";
}

static const char *read_port(struct fuzz_bytes *bytes)
{
    struct fuzz_words words;
    struct port_choice choice;
    struct error err;
    struct arguments arguments = fuzz_words(bytes, &words);

    if (!port_choice_parse(&choice, &arguments, &err)) return fuzz_check_refusal(err.text, NULL);
    const struct port port = port_choice_stand_in(&choice);
    (void)port;
    return choice.kind == PORT_LINUX || choice.kind == PORT_HID ? NULL : "a port of no kind";
}

/* Lines of a file, a pipe, a folder, a device. What is no stream of bytes is refused, and so are NUL bytes and lines
 * that are too long. */
static const char *read_lines(struct fuzz_bytes *bytes)
{
    enum { LINE_MOST_B = 40 };
    static const char *const others[] = {"/", "/dev/null", "/dev/fd/999", "/nowhere", "/dev/zero"};
    const uint8_t kind = fuzz_below(bytes, 9);
    const char *path = kind < 5 ? others[kind] : fuzz_as_file(bytes->at, bytes->left_b);
    char by_number[32];
    struct error err = {""};

    snprintf(by_number, sizeof by_number, "/dev/fd/%s", strrchr(path, '/') + 1);
    if (kind >= 7) path = by_number;
    struct input_lines lines = {.path = path, .line_most_b = LINE_MOST_B, .file = input_open_stream(path, &err)};
    if (!lines.file) return kind < 5 ? fuzz_check_refusal(err.text, path) : "a file was refused";
    if (kind < 5) return "something that is no file was opened";
    while (input_line(&lines, &err))
        if (lines.length > LINE_MOST_B || strlen(lines.line) != lines.length) return "a line out of range";
    input_lines_free(&lines);
    input_close_stream(lines.file);
    return err.text[0] ? fuzz_check_refusal(err.text, path) : NULL;
}

static const char *run(const uint8_t *input, size_t size_b)
{
    static const char *(*const readers[])(struct fuzz_bytes * bytes) = {
        read_hashes,  read_link_map, read_binary, read_options, read_request, read_values,
        write_hashes, read_decimal,  read_image,  read_port,    read_lines};
    struct fuzz_bytes bytes = {input, size_b};

    return readers[fuzz_below(&bytes, sizeof readers / sizeof *readers)](&bytes);
}

const struct fuzz_target fuzz_text = {"text", run, NULL};
