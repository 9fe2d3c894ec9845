/* SPDX-License-Identifier: MIT
 *
 * Output files come all or none, numbered names are safe, hash files find the frame that changed. */
#include "outputs/outputs.h"
#include "outputs/written.h"
#include "pictures/hashes.h"
#include "rigs/cmocka_ready.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-outputs-XXXXXX";

static int enter_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    (void)state;
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1; /* fails if a test left a file behind */
}

static bool exists(const char *path)
{
    return access(path, F_OK) == 0;
}

static void write_text(struct outputs *outputs, const char *path, const char *text)
{
    struct error err;
    FILE *file = outputs_open(outputs, path, &err);
    assert_non_null(file);
    fputs(text, file);
    assert_true(outputs_close(file, path, &err));
}

static void assert_text(const char *path, const char *expected)
{
    char text[64] = "";
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    assert_string_equal(text, expected);
}

/* All or none -------------------------------------------------------------------------------- */

static void kept_files_are_in_place_in_new_folders(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    struct error err;
    write_text(&outputs, "a/b/one.txt", "one");
    write_text(&outputs, "two.txt", "two");
    assert_false(exists("a/b/one.txt"));
    assert_true(outputs_keep(&outputs, &err));
    assert_text("a/b/one.txt", "one");
    assert_text("two.txt", "two");
    assert_false(exists("two.txt.part"));
    unlink("a/b/one.txt");
    unlink("two.txt");
    rmdir("a/b");
    rmdir("a");
}

static void discarded_files_and_folders_are_gone(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    write_text(&outputs, "a/b/one.txt", "one");
    write_text(&outputs, "a/two.txt", "two");
    outputs_discard(&outputs);
    assert_false(exists("a"));
}

static void what_was_written_is_told_in_a_line(void **state)
{
    (void)state;
    static const struct {
        const char *files[6], *line;
    } cases[] = {
        {{NULL}, ""},
        {{"a.png"}, "wrote a.png"},
        {{"a.c", "a.h"}, "wrote a.c and a.h"},
        {{"a.c", "a.h", "a.lim"}, "wrote a.c, a.h and a.lim"},
        {{"o/0.png", "o/1.png"}, "wrote o/0.png and o/1.png"},
        {{"a.gif", "o/9.png", "o/10.png", "o/11.png"}, "wrote a.gif and o/9.png to o/11.png (3 files)"},
        {{"0.a", "1.a", "2.a", "0.b", "1.b", "x"}, "wrote 0.a to 2.a (3 files), 0.b, 1.b and x"},
        {{"a\nb\033[K"}, "wrote a b [K"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[WRITTEN_B];
        size_t count = 0;
        while (count < 6 && cases[i].files[count])
            count++;
        written_text(cases[i].files, count, text);
        assert_string_equal(text, cases[i].line);
    }
}

static void a_line_that_would_be_too_long_ends_in_dots(void **state)
{
    (void)state;
    static char name[2 * WRITTEN_B];
    const char *files[1] = {name};
    char text[WRITTEN_B];
    memset(name, 'n', sizeof name - 1);
    written_text(files, 1, text);
    assert_int_equal(strlen(text), WRITTEN_B - 1);
    assert_string_equal(text + WRITTEN_B - 6, "nn...");
}

static void discarding_leaves_what_was_there_before(void **state)
{
    (void)state;
    struct outputs first = {0}, second = {0};
    struct error err;
    write_text(&first, "a/old.txt", "old");
    assert_true(outputs_keep(&first, &err));
    write_text(&second, "a/old.txt", "new");
    write_text(&second, "a/b/new.txt", "new");
    outputs_discard(&second);
    assert_text("a/old.txt", "old");
    assert_false(exists("a/b"));
    unlink("a/old.txt");
    rmdir("a");
}

static void what_cannot_be_written_is_named(void **state)
{
    (void)state;
    static const char *const paths[] = {"/dev/null/x.png", "/proc/x/y.png", ".", "", "taken.txt"};
    struct outputs outputs = {0};
    struct error err;
    write_text(&outputs, "taken.txt", "x");
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        err.text[0] = '\0';
        assert_null(outputs_open(&outputs, paths[i], &err));
        assert_true(strlen(err.text) > 10);
        assert_null(strchr(err.text, '\n'));
    }
    assert_string_equal(err.text, "taken.txt: named for two outputs");
    outputs_discard(&outputs);
}

static void devices_are_written_as_they_are(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    struct error err;
    write_text(&outputs, "/dev/null", "x");
    assert_true(outputs_keep(&outputs, &err));
    FILE *full = outputs_open(&outputs, "/dev/full", &err);
    assert_non_null(full);
    fputs("x", full);
    assert_false(outputs_close(full, "/dev/full", &err));
    assert_string_equal(err.text, "/dev/full: cannot be written: No space left on device");
    outputs_discard(&outputs);
    assert_true(exists("/dev/full"));
}

static void a_file_keeps_its_permissions(void **state)
{
    (void)state;
    struct error err;
    struct stat status;
    for (mode_t mode = 0600; mode <= 0644; mode += 044) {
        struct outputs outputs = {0};
        write_text(&outputs, "file", "x");
        assert_true(outputs_keep(&outputs, &err));
        assert_int_equal(chmod("file", mode), 0);
        write_text(&outputs, "file", "y");
        assert_true(outputs_keep(&outputs, &err));
        assert_int_equal(stat("file", &status), 0);
        assert_int_equal(status.st_mode & 0777, mode);
    }
    unlink("file");
}

/* Links of links, in a folder and out of it again. */
static void what_a_link_names_is_written(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    struct error err;
    struct stat status;
    assert_int_equal(mkdir("a", 0777), 0);
    assert_true(symlink("a/second", "first") == 0 && symlink("../target", "a/second") == 0);
    write_text(&outputs, "first", "x");
    assert_true(outputs_keep(&outputs, &err));
    assert_text("target", "x");
    assert_true(lstat("first", &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(lstat("a/second", &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(unlink("first") == 0 && unlink("a/second") == 0 && unlink("target") == 0 && rmdir("a") == 0);
}

/* Numbered names ----------------------------------------------------------------------------- */

static void numbered_names_follow_their_pattern(void **state)
{
    (void)state;
    static const struct {
        const char *pattern;
        size_t number;
        const char *path;
    } cases[] = {{"out/%03d.png", 7, "out/007.png"},
                 {"%d", 12, "12"},
                 {"a%4d.b", 5, "a   5.b"},
                 {"%02d", 123, "123"},
                 {"%0d.png", 0, "0.png"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char path[64];
        struct error err;
        assert_true(output_pattern_check(cases[i].pattern, &err));
        assert_true(output_pattern_path(cases[i].pattern, cases[i].number, path, sizeof path, &err));
        assert_string_equal(path, cases[i].path);
    }
}

static void patterns_with_anything_but_one_number_are_refused(void **state)
{
    (void)state;
    static const char *const patterns[] = {"out.png", "%s.png",    "%n",   "%d%d",         "%%d", "%",
                                           "%*d",     "%3",        "%d%s", "%-3d",         "%+d", "%ld",
                                           "%3.2d",   "%d 100%.x", "%%%d", "%1000000000d", "%0x"};
    for (size_t i = 0; i < sizeof patterns / sizeof patterns[0]; i++) {
        char path[64];
        struct error err;
        assert_false(output_pattern_check(patterns[i], &err));
        assert_non_null(strstr(err.text, patterns[i]));
        err.text[0] = '\0';
        assert_false(output_pattern_path(patterns[i], 1, path, sizeof path, &err));
        assert_non_null(strstr(err.text, patterns[i]));
    }
}

static void path_that_does_not_fit_is_refused(void **state)
{
    (void)state;
    char path[8];
    struct error err;
    assert_true(output_pattern_path("%03d.pn", 1, path, sizeof path, &err));
    assert_false(output_pattern_path("%03d.png", 10000, path, sizeof path, &err));
}

/* Hashes ------------------------------------------------------------------------------------- */

static void hash_is_fnv_1a_of_the_bytes_on_the_bus(void **state)
{
    (void)state;
    /* "foobar" in the author's list of test vectors. */
    static const uint16_t foobar[] = {'f' << 8 | 'o', 'o' << 8 | 'b', 'a' << 8 | 'r'};
    assert_int_equal(hash_pixels(foobar, 0), 0xcbf29ce484222325);
    assert_int_equal(hash_pixels(foobar, 3), 0x85944171f73967e8);
}

static bool check_text(const char *text, const uint64_t *hashes, size_t count, struct error *err)
{
    FILE *file = fopen("hashes.txt", "w");
    fputs(text, file);
    fclose(file);
    bool ok = hashes_check(hashes, count, "hashes.txt", err);
    unlink("hashes.txt");
    return ok;
}

static void hash_file_names_the_first_frame_that_differs(void **state)
{
    (void)state;
    static const uint64_t hashes[] = {1, 2, UINT64_MAX};
    struct error err;
    FILE *file = fopen("hashes.txt", "w");
    assert_true(hashes_write(hashes, 3, file));
    fclose(file);
    assert_true(hashes_check(hashes, 3, "hashes.txt", &err));
    unlink("hashes.txt");

    assert_false(check_text("0 0000000000000001\n1 0000000000000003\n2 0000000000000000\n", hashes, 3, &err));
    assert_string_equal(err.text, "hashes.txt: frame 1 differs: hash 0000000000000002, expected 0000000000000003");
}

static void hash_file_of_another_length_or_form_is_refused(void **state)
{
    (void)state;
    static const uint64_t hashes[] = {1, 2};
    static const char *const texts[] = {"",           "0 1\n",        "0 1\n1 2\n2 3\n", "0 1\n2 2\n",
                                        "0 1\nx 2\n", "0 1\n1 2 3\n", "0 1\n1 2\n\n",    "0 1\n1 20000000000000002\n"};
    struct error err;
    assert_true(check_text("0 1\n1 2\n", hashes, 2, &err));
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        assert_false(check_text(texts[i], hashes, 2, &err));
    assert_false(hashes_check(hashes, 2, "missing.txt", &err));
    assert_string_equal(err.text, "missing.txt: No such file or directory");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kept_files_are_in_place_in_new_folders),
        cmocka_unit_test(discarded_files_and_folders_are_gone),
        cmocka_unit_test(what_was_written_is_told_in_a_line),
        cmocka_unit_test(a_line_that_would_be_too_long_ends_in_dots),
        cmocka_unit_test(discarding_leaves_what_was_there_before),
        cmocka_unit_test(what_cannot_be_written_is_named),
        cmocka_unit_test(devices_are_written_as_they_are),
        cmocka_unit_test(a_file_keeps_its_permissions),
        cmocka_unit_test(what_a_link_names_is_written),
        cmocka_unit_test(numbered_names_follow_their_pattern),
        cmocka_unit_test(patterns_with_anything_but_one_number_are_refused),
        cmocka_unit_test(path_that_does_not_fit_is_refused),
        cmocka_unit_test(hash_is_fnv_1a_of_the_bytes_on_the_bus),
        cmocka_unit_test(hash_file_names_the_first_frame_that_differs),
        cmocka_unit_test(hash_file_of_another_length_or_form_is_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
