/* SPDX-License-Identifier: MIT
 *
 * What a confined process can still do, asked of the kernel itself: by the version that it tells of Landlock, or all of
 * it where it has none. */
#define _GNU_SOURCE /* syscall() */
#include "readers/confine.h"
#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-confine-XXXXXX";

enum deed { MAKES, WRITES, REMOVES, MOVES, RUNS, SIGNALS, DEEDS };
static const long versions[DEEDS] = {[MAKES] = 1, [WRITES] = 1, [REMOVES] = 1, [MOVES] = 1, [RUNS] = 1, [SIGNALS] = 6};

static bool does(enum deed deed)
{
    char *const argv[] = {(char[]){"true"}, NULL};
    switch (deed) {
    case MAKES:
        return open("made", O_WRONLY | O_CREAT | O_CLOEXEC, 0666) >= 0;
    case WRITES:
        return open("there", O_WRONLY | O_CLOEXEC) >= 0;
    case REMOVES:
        return unlink("there") == 0;
    case MOVES:
        return rename("there", "elsewhere") == 0;
    case RUNS:
        return execv("/bin/true", argv) == 0;
    case SIGNALS:
        return kill(getppid(), 0) == 0;
    default:
        return false;
    }
}

static void put_file(void)
{
    FILE *file = fopen("there", "w");
    assert_non_null(file);
    assert_int_equal(fclose(file), 0);
}

/* Exit status 0 as /bin/true has it, too. */
static int status_of(enum deed deed)
{
    int status;
    put_file();
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        confine_to_reading();
        _exit(does(deed) ? 0 : 1);
    }
    assert_int_equal(waitpid(pid, &status, 0), pid);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void nothing_but_reading_is_left(void **state)
{
    (void)state;
    const long version = syscall(444, NULL, (size_t)0, 1); /* landlock_create_ruleset(), which tells it */
    for (enum deed deed = 0; deed < DEEDS; deed++)
        assert_int_equal(status_of(deed), version >= versions[deed]);
    (void)unlink("made");
    (void)unlink("elsewhere");
}

static void reading_and_files_that_are_open_are_left(void **state)
{
    (void)state;
    int status;
    put_file();
    const int out = open("there", O_WRONLY | O_CLOEXEC);
    assert_true(out >= 0);
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        char byte;
        confine_to_reading();
        const bool wrote = write(out, "x", 1) == 1;
        const int in = open("there", O_RDONLY | O_CLOEXEC);
        _exit(wrote && in >= 0 && read(in, &byte, 1) == 1 && byte == 'x' && prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1
                  ? 0
                  : 1);
    }
    assert_int_equal(waitpid(pid, &status, 0), pid);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    assert_int_equal(close(out), 0);
}

static int enter_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    (void)state;
    (void)unlink("there");
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_but_reading_is_left),
        cmocka_unit_test(reading_and_files_that_are_open_are_left),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
