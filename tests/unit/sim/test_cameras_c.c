/* SPDX-License-Identifier: MIT
 *
 * A camera path as a C header. That firmware renders the host's frames from it is for the scripts that run
 * emulated processors. */
#include "cameras/cameras_c.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct grid GRID = {.origin_m = {0.0, 0.0, 0.0}, .units_per_m = 1000.0};
static const struct lens LENS = {.tan_x = 1.0, .tan_y = 0.5, .near_m = 0.1};

/* The text of the header, or NULL with the reason; the caller frees it. */
static char *header_of(const struct viewpoint *viewpoints, const double *times_s, size_t count, struct error *err)
{
    struct viewpoint frames[2];
    char *text;
    size_t length;
    memcpy(frames, viewpoints, count * sizeof *frames);
    const struct camera_path path = {.name = "test.cam", .frames = frames, .count = count};
    FILE *file = open_memstream(&text, &length);
    assert_non_null(file);
    const bool ok = cameras_c_write(&path, times_s, &LENS, &GRID, 240, 120, file, err);
    fclose(file);
    if (ok) return text;
    free(text);
    return NULL;
}

static void header_holds_size_count_and_fixed_point_cameras(void **state)
{
    (void)state;
    const struct viewpoint viewpoints[2] = {{{1, 2, 3}, {1, 2, 2}, 1, false, 0}, {{-1, 0, 0}, {-2, 0, 0}, 2, false, 0}};
    struct error err;
    char *text = header_of(viewpoints, NULL, 2, &err);
    assert_non_null(text);
    assert_non_null(strstr(text, "#define CAMERAS_W_PX 240\n#define CAMERAS_H_PX 120\n#define CAMERAS_COUNT 2\n"));
    assert_non_null(strstr(
        text, "= {\n"
              "    {{256000, 512000, 768000}, 0u, 0u, 0u, 268435456u, 134217728u, LIM_CAMERA_END(25600, 0, 0, 0)},\n"
              "    {{-256000, 0, 0}, 1073741824u, 0u, 0u, 268435456u, 134217728u, LIM_CAMERA_END(25600, 0, 0, 0)},\n"
              "};\n"));
    assert_null(strstr(text, "TIME"));
    free(text);
}

static void cameras_of_an_animation_have_milliseconds(void **state)
{
    (void)state;
    const struct viewpoint viewpoints[2] = {{{1, 2, 3}, {1, 2, 2}, 1, true, 0.25}, {{0, 0, 1}, {0, 0, 0}, 2, false, 0}};
    const double times_s[] = {0.25, 12.007};
    struct error err;
    char *text = header_of(viewpoints, times_s, 2, &err);
    assert_non_null(text);
    assert_non_null(strstr(text, "cameras_time_ms[CAMERAS_COUNT] = {\n    250, 12007,\n};\n"));
    assert_non_null(strstr(text, "#define CAMERAS_TIME_MS(frame) cameras_time_ms[frame]\n"));
    free(text);
}

static void an_eye_out_of_range_is_refused_by_its_line(void **state)
{
    (void)state;
    const struct viewpoint viewpoints[2] = {{{1, 2, 3}, {1, 2, 2}, 1, false, 0}, {{1e9, 0, 0}, {0, 0, 0}, 7, false, 0}};
    struct error err;
    assert_null(header_of(viewpoints, NULL, 2, &err));
    assert_non_null(strstr(err.text, "test.cam:7: the eye is too far"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(header_holds_size_count_and_fixed_point_cameras),
        cmocka_unit_test(cameras_of_an_animation_have_milliseconds),
        cmocka_unit_test(an_eye_out_of_range_is_refused_by_its_line),
    };
    return cmocka_run_group_tests_name("cameras_c", tests, NULL, NULL);
}
