/* SPDX-License-Identifier: MIT
 *
 * Fuzz targets: what to do with bytes of anybody's making. libFuzzer drives them (fuzz_main.c) and
 * the host suite replays their corpora (test_fuzz_corpus.c), so a target says what broke instead of ending
 * the program. Memory errors are the sanitizers' to find. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>

struct fuzz_target {
    const char *name; /* and of its folder in tests/fuzz/corpus */
    /* NULL: every promise was kept; else the one that was not. */
    const char *(*run)(const uint8_t *bytes, size_t size_b);
    /* Makes a mutated input whole again (sizes, checksums), in place, at most max_b long; returns its
     * length. NULL: every input is as good as another. */
    size_t (*mend)(uint8_t *bytes, size_t size_b, size_t max_b);
};

extern const struct fuzz_target fuzz_camera, fuzz_camera_file, fuzz_lim_file, fuzz_render, fuzz_features, fuzz_mesh,
    fuzz_movers, fuzz_obj, fuzz_gltf, fuzz_ply, fuzz_stl, fuzz_off, fuzz_picture, fuzz_wire_log, fuzz_qemu, fuzz_text,
    fuzz_written, fuzz_report, fuzz_vcd, fuzz_wad, fuzz_long, fuzz_long_movers, fuzz_touch;

/* All of them; NULL behind the last. */
extern const struct fuzz_target *const fuzz_targets[];

/* By name, or NULL. */
const struct fuzz_target *fuzz_find(const char *name);

/* What is left of an input. Behind its end everything is 0. */
struct fuzz_bytes {
    const uint8_t *at;
    size_t left_b;
};

uint8_t fuzz_u8(struct fuzz_bytes *bytes);
uint16_t fuzz_u16(struct fuzz_bytes *bytes); /* little-endian, as are the others */
uint32_t fuzz_u32(struct fuzz_bytes *bytes);

/* 0 .. n - 1, from one byte; n is 1..256. */
uint8_t fuzz_below(struct fuzz_bytes *bytes, unsigned n);

/* A path under which the bytes can be read as a file, until the next call. */
const char *fuzz_as_file(const uint8_t *bytes, size_t size_b);

/* The same where readers want a suffix or a neighbour: a file of that name in a folder that is removed when the program
 * ends. The path holds until the next call. */
const char *fuzz_as_named_file(const char *name, const uint8_t *bytes, size_t size_b);

/* Takes what comes before the next byte `mark` off the bytes, and the mark; without a mark, all. */
struct fuzz_bytes fuzz_part(struct fuzz_bytes *bytes, uint8_t mark);

/* A string of the part, to be freed: up to its first zero. */
char *fuzz_string(const struct fuzz_bytes *part);

/* What is wrong with an error's text: it must be one line, and begin with `thing`, if that is not NULL. NULL: nothing.
 */
const char *fuzz_check_refusal(const char *text, const char *thing);

#endif
