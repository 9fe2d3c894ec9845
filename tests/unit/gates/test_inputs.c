/* SPDX-License-Identifier: MIT
 *
 * Files that were read are known by themselves and not by their names, in a child process as well, and no output takes
 * the place of one. */
#include "base/inputs.h"
#include "outputs/outputs.h"
#include "rigs/cmocka_ready.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-inputs-XXXXXX";
static const char *const names[] = {"read", "soft", "hard", "./read", "other", "there is none"};
enum { OF_READ = 4, OTHER = 4, NONE = 5 };

static bool is_known(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && inputs_have(&status);
}

static void assert_known(bool read, bool other)
{
    for (int i = 0; i < OF_READ; i++)
        assert_int_equal(is_known(names[i]), read);
    assert_int_equal(is_known(names[OTHER]), other);
}

static void a_file_is_known_by_any_of_its_names(void **state)
{
    (void)state;
    for (int i = 0; i < OF_READ; i++) {
        assert_known(false, false);
        inputs_note_name(names[i]);
        assert_known(true, false);
        inputs_forget();
    }
    inputs_note_name(names[NONE]);
    inputs_note_name("/dev/null");
    inputs_note_name(".");
    assert_false(is_known("/dev/null") || is_known("."));
    assert_int_equal(inputs_count(), 0);
}

/* More than a list holds at first. */
static void paths_are_kept_in_their_order(void **state)
{
    (void)state;
    enum { MANY = 100 };
    char path[16];
    for (int i = 0; i < MANY; i++) {
        snprintf(path, sizeof path, "%d", i);
        inputs_note(path);
    }
    inputs_note("read");
    assert_int_equal(inputs_count(), MANY + 1);
    for (int i = 0; i < MANY; i++) {
        snprintf(path, sizeof path, "%d", i);
        assert_string_equal(inputs_path((size_t)i), path);
    }
    assert_string_equal(inputs_path(MANY), "read");
    assert_known(true, false);
    inputs_forget();
    assert_int_equal(inputs_count(), 0);
    assert_known(false, false);
}

static int status_of_child(FILE *channel)
{
    int status;
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        inputs_send_to(fileno(channel));
        inputs_note("read");
        inputs_note_name("other");
        _exit(7);
    }
    assert_int_equal(waitpid(pid, &status, 0), pid);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void a_child_tells_what_it_reads_and_what_it_names(void **state)
{
    (void)state;
    FILE *channel = tmpfile();
    assert_non_null(channel);
    assert_int_equal(status_of_child(channel), 7);
    assert_known(false, false);
    inputs_receive(channel);
    assert_known(true, true);
    assert_int_equal(inputs_count(), 1);
    assert_string_equal(inputs_path(0), "read");
    fclose(channel);
    inputs_forget();
}

/* What the parent does not hear of could be overwritten. */
static void a_child_that_cannot_tell_fails(void **state)
{
    (void)state;
    FILE *full = fopen("/dev/full", "w");
    assert_non_null(full);
    assert_int_equal(status_of_child(full), EXIT_FAILURE);
    fclose(full);
}

static void assert_refused(const struct error *err, const char *path)
{
    char text[ERROR_B];
    snprintf(text, sizeof text, "%s: cannot be written: the same command reads it", path);
    assert_string_equal(err->text, text);
}

/* Read before the output is begun, or after. */
static void no_output_takes_its_place(void **state)
{
    (void)state;
    struct error err;
    inputs_note_name("read");
    for (int i = 0; i < OF_READ; i++) {
        struct outputs outputs = {0};
        assert_null(outputs_open(&outputs, names[i], &err));
        assert_refused(&err, names[i]);
        outputs_discard(&outputs);
    }
    inputs_forget();
    for (int keeps = 0; keeps < 2; keeps++) {
        struct outputs outputs = {0};
        FILE *other = outputs_open(&outputs, "other", &err), *file = outputs_open(&outputs, "hard", &err);
        assert_true(other && file);
        assert_true(outputs_close(other, "other", &err) && outputs_close(file, "hard", &err));
        assert_true(outputs_check(&outputs, &err));
        inputs_note_name("read");
        assert_false(keeps ? outputs_keep(&outputs, &err) : outputs_check(&outputs, &err));
        assert_refused(&err, "hard");
        if (!keeps) outputs_discard(&outputs);
        inputs_forget();
        struct stat status;
        assert_true(stat("hard", &status) == 0 && status.st_size == 1 && status.st_nlink == 2);
        assert_true(stat("other", &status) == 0 && status.st_size == 1);
    }
}

static void put_byte(const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputc('x', file);
    assert_int_equal(fclose(file), 0);
}

static int enter_folder(void **state)
{
    (void)state;
    if (!mkdtemp(folder) || chdir(folder) != 0) return -1;
    put_byte("read");
    put_byte("other");
    return symlink("read", "soft") == 0 && link("read", "hard") == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    (void)state;
    for (int i = 0; i < NONE; i++)
        (void)unlink(names[i]);
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_file_is_known_by_any_of_its_names),
        cmocka_unit_test(paths_are_kept_in_their_order),
        cmocka_unit_test(a_child_tells_what_it_reads_and_what_it_names),
        cmocka_unit_test(a_child_that_cannot_tell_fails),
        cmocka_unit_test(no_output_takes_its_place),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
