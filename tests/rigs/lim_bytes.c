/* SPDX-License-Identifier: MIT */
#include "lim_bytes.h"

#include "base/inputs.h"
#include "cmocka_ready.h"
#include "scene/lim_image.h"
#include "scene/scene_files.h"

#include <stdio.h>
#include <stdlib.h>

unsigned char *lim_bytes_of(const struct compiled *scene, const char *path)
{
    struct error err;

    inputs_forget(); /* the file may be written anew */
    if (!lim_file_write(scene, path, &err)) fail_msg("%s", err.text);
    unsigned char *bytes = malloc(scene->image_b);
    FILE *file = fopen(path, "rb");
    assert_true(bytes && file);
    assert_int_equal(fread(bytes, 1, scene->image_b, file), scene->image_b);
    assert_int_equal(fgetc(file), EOF);
    fclose(file);
    return bytes;
}

void lim_bytes_sign(unsigned char *bytes, size_t count)
{
    enum { AT_B = 20 }; /* SCENE.md */
    const uint32_t crc32 = lim_image_crc32(bytes, count);

    for (int i = 0; i < 4; i++)
        bytes[AT_B + i] = (unsigned char)(crc32 >> 8 * i);
}

void lim_bytes_write(const unsigned char *bytes, size_t count, const char *path)
{
    FILE *file = fopen(path, "wb");

    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    fclose(file);
}
