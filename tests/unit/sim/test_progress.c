/* SPDX-License-Identifier: MIT
 *
 * What long work says where standard error is a pipe: a line each so many seconds, and nothing before. */
#include "base/progress.h"

#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* What the calls between say() and said() wrote to standard error. */
static FILE *caught;
static int kept;

static void say(void)
{
    caught = tmpfile();
    assert_non_null(caught);
    fflush(stderr);
    kept = dup(STDERR_FILENO);
    assert_true(dup2(fileno(caught), STDERR_FILENO) >= 0);
}

static const char *said(void)
{
    static char text[512];
    fflush(stderr);
    assert_true(dup2(kept, STDERR_FILENO) >= 0);
    close(kept);
    rewind(caught);
    text[fread(text, 1, sizeof text - 1, caught)] = '\0';
    fclose(caught);
    return text;
}

static void wait_s(double seconds)
{
    const struct timespec pause = {(time_t)seconds, (long)(1e9 * (seconds - (double)(time_t)seconds))};
    nanosleep(&pause, NULL);
}

static void long_work_is_told_when_its_time_is_over(void **state)
{
    (void)state;
    setenv("LIMNER_PROGRESS", "1", 1);
    say();
    progress("counting %d", 7);
    progress_beat();
    const char *text = said();
    assert_string_equal(text, "");
    wait_s(2.1);
    say();
    progress_beat();
    progress_beat();
    assert_string_equal(said(), "limner: counting 7\n");
    wait_s(2.1);
    say();
    progress_bar(1, 4, "%s", "welding");
    assert_string_equal(said(), "limner: 25 % welding\n");
}

static void what_has_ended_is_told_no_more(void **state)
{
    (void)state;
    setenv("LIMNER_PROGRESS", "1", 1);
    say();
    progress("counting");
    progress_end();
    wait_s(2.1);
    progress_beat();
    assert_string_equal(said(), "");
}

static void nothing_is_told_where_0_is_asked(void **state)
{
    (void)state;
    setenv("LIMNER_PROGRESS", "0", 1);
    say();
    progress("counting");
    wait_s(2.1);
    progress("counting on");
    progress_bar(1, 2, "half");
    assert_string_equal(said(), "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_work_is_told_when_its_time_is_over),
        cmocka_unit_test(what_has_ended_is_told_no_more),
        cmocka_unit_test(nothing_is_told_where_0_is_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
