/* SPDX-License-Identifier: MIT
 *
 * Several outputs of one command take their places together: whichever call fails, whenever the process is killed, and
 * whatever else lies there. */
#include "outputs/outputs.h"
#include "rigs/cmocka_ready.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-output-sets-XXXXXX";

/* Faults ------------------------------------------------------------------------------------- */

static struct {
    int calls;         /* of link(), rename() and unlink() so far */
    int fails_from;    /* -1: none */
    int fails_before;  /* the first one that works again */
    bool no_links;     /* a file system that has none */
    bool unlink_fails; /* one of those that failed was unlink() */
    int dies_at;       /* SIGKILL before that call, -1: never */
} faults;

static void no_faults(void)
{
    faults.calls = 0;
    faults.fails_from = faults.dies_at = -1;
    faults.fails_before = 0;
    faults.no_links = faults.unlink_fails = false;
}

int __real_link(const char *from, const char *to);
int __real_rename(const char *from, const char *to);
int __real_unlink(const char *path);
int __wrap_link(const char *from, const char *to);
int __wrap_rename(const char *from, const char *to);
int __wrap_unlink(const char *path);

static bool fails(void)
{
    const int call = faults.calls++;
    if (call == faults.dies_at) raise(SIGKILL);
    return faults.fails_from >= 0 && call >= faults.fails_from && call < faults.fails_before;
}

int __wrap_link(const char *from, const char *to)
{
    if (!fails() && !faults.no_links) return __real_link(from, to);
    errno = faults.no_links ? EPERM : EIO;
    return -1;
}

int __wrap_rename(const char *from, const char *to)
{
    if (!fails()) return __real_rename(from, to);
    errno = EIO;
    return -1;
}

int __wrap_unlink(const char *path)
{
    if (!fails()) return __real_unlink(path);
    faults.unlink_fails = true;
    errno = EIO;
    return -1;
}

/* A set -------------------------------------------------------------------------------------- */

/* In two folders; the last one is not there before. */
static const char *const names[] = {"a.txt", "sub/b.txt", "c.txt", "d.txt"};
enum { NAMES = sizeof names / sizeof names[0], OLD_NAMES = NAMES - 1 };

static void put_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static bool has_text(const char *path, const char *expected)
{
    char text[64] = "";
    FILE *file = fopen(path, "r");
    if (!file) return false;
    const bool ok = fgets(text, sizeof text, file) && strcmp(text, expected) == 0;
    fclose(file);
    return ok;
}

static bool exists(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0;
}

static void clear(const char *path)
{
    char name[512];
    DIR *entries = opendir(path);
    assert_non_null(entries);
    for (struct dirent *entry; (entry = readdir(entries));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
        struct stat status;
        assert_int_equal(lstat(name, &status), 0);
        if (S_ISDIR(status.st_mode)) clear(name);
        assert_int_equal(remove(name), 0);
    }
    closedir(entries);
}

static size_t entries_in(const char *path)
{
    size_t count = 0;
    DIR *entries = opendir(path);
    assert_non_null(entries);
    for (struct dirent *entry; (entry = readdir(entries));)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    closedir(entries);
    return count;
}

static void put_old_set(void)
{
    no_faults();
    clear(".");
    assert_int_equal(mkdir("sub", 0777), 0);
    for (size_t i = 0; i < OLD_NAMES; i++)
        put_text(names[i], "old");
}

static const char *before = ""; /* what names of outputs begin with */

static bool write_set(struct outputs *outputs, struct error *err)
{
    for (size_t i = 0; i < NAMES; i++) {
        char path[sizeof folder + 64];
        snprintf(path, sizeof path, "%s%s", before, names[i]);
        FILE *file = outputs_open(outputs, path, err);
        if (!file) return false;
        fputs("new", file);
        if (!outputs_close(file, path, err)) return false;
    }
    return true;
}

static bool is_old_set(void)
{
    bool all = !exists(names[OLD_NAMES]);
    for (size_t i = 0; i < OLD_NAMES; i++)
        all = all && has_text(names[i], "old");
    return all && entries_in(".") == OLD_NAMES && entries_in("sub") == 1;
}

static bool is_new_set(void)
{
    bool all = true;
    for (size_t i = 0; i < NAMES; i++)
        all = all && has_text(names[i], "new");
    return all && entries_in(".") == NAMES && entries_in("sub") == 1;
}

/* Failures ----------------------------------------------------------------------------------- */

static void keep_with_one_failure(bool no_links)
{
    struct error err;
    bool ok = false, was_met = true;
    int failed = 0;
    for (int call = 0; was_met; call++) {
        struct outputs outputs = {0};
        put_old_set();
        assert_true(write_set(&outputs, &err));
        no_faults();
        faults.no_links = no_links;
        faults.fails_from = call;
        faults.fails_before = call + 1;
        ok = outputs_keep(&outputs, &err);
        was_met = faults.calls > call;
        failed += !ok;
        assert_true(ok || !strstr(err.text, "what was there before"));
        /* Of what is to be removed at the end, or with the list, one file may stay where unlink() itself fails. */
        if (ok ? is_new_set() : is_old_set()) continue;
        assert_true(was_met && faults.unlink_fails);
        for (size_t i = 0; i < OLD_NAMES; i++)
            assert_true(has_text(names[i], ok ? "new" : "old"));
        assert_int_equal(exists(names[OLD_NAMES]), ok);
    }
    assert_true(ok);
    assert_in_range(failed, NAMES, 2 * NAMES);
}

static void a_call_that_fails_leaves_all_old_or_all_new(void **state)
{
    (void)state;
    keep_with_one_failure(false);
}

static void so_it_is_where_files_have_one_name(void **state)
{
    (void)state;
    keep_with_one_failure(true);
}

/* Nothing can be put back then, but nothing is lost. */
static void what_was_there_is_named_if_it_cannot_be_put_back(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    struct error err;
    put_old_set();
    assert_true(write_set(&outputs, &err));
    no_faults();
    faults.no_links = true;
    faults.fails_from = 4; /* link, rename, link, rename */
    faults.fails_before = 1000;
    assert_false(outputs_keep(&outputs, &err));
    const char *named = strstr(err.text, "what was there before is ");
    assert_non_null(named);
    named += strlen("what was there before is ");
    char path[256];
    snprintf(path, sizeof path, "%.*s", (int)(strstr(named, " now") - named), named);
    assert_true(has_text(path, "old"));
    assert_true(has_text("c.txt", "old"));
}

/* Killed ------------------------------------------------------------------------------------- */

static bool dies_at(int call, bool no_links)
{
    int status;
    fflush(NULL);
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        struct outputs outputs = {0};
        struct error err;
        faults.dies_at = call;
        faults.no_links = no_links;
        _exit(write_set(&outputs, &err) && outputs_keep(&outputs, &err) ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    assert_int_equal(waitpid(pid, &status, 0), pid);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

/* Nobody else needs to know what is written. */
static void a_list_is_the_users_own(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    struct error err;
    size_t lists = 0;
    put_old_set();
    assert_true(write_set(&outputs, &err));
    DIR *entries = opendir(".");
    assert_non_null(entries);
    for (struct dirent *entry; (entry = readdir(entries));) {
        struct stat status;
        if (strncmp(entry->d_name, ".limner-", 8) != 0) continue;
        assert_int_equal(lstat(entry->d_name, &status), 0);
        assert_int_equal(status.st_mode & 0777, 0600);
        lists++;
    }
    closedir(entries);
    assert_int_equal(lists, 1);
    outputs_discard(&outputs);
    assert_true(is_old_set());
}

/* Its first output lies where theirs did. */
static void run_again_in_vain(const char *path)
{
    struct outputs outputs = {0};
    struct error err;
    FILE *file = outputs_open(&outputs, path, &err);
    assert_non_null(file);
    fclose(file);
    outputs_discard(&outputs);
}

static void die_at_each_call(bool no_links, const char *next)
{
    bool died = true;
    int news = 0, olds = 0;
    for (int call = 0; died; call++) {
        put_old_set();
        died = dies_at(call, no_links);
        run_again_in_vain(next);
        const bool is_new = is_new_set();
        if (!is_new && !is_old_set()) fail_msg("killed at call %d: neither all new nor all old", call);
        news += is_new;
        olds += !is_new;
    }
    assert_in_range(olds, 2, 100);
    assert_in_range(news, NAMES, 100);
}

static void the_next_run_cleans_up_after_one_killed_at_any_call(void **state)
{
    (void)state;
    die_at_each_call(false, "a.txt");
}

static void and_where_files_have_one_name(void **state)
{
    (void)state;
    die_at_each_call(true, "a.txt");
}

static void it_does_so_from_another_working_folder(void **state)
{
    (void)state;
    char path[sizeof folder + 8];
    snprintf(path, sizeof path, "%s/x", folder);
    put_old_set();
    assert_true(dies_at(0, false));
    assert_int_equal(chdir("/"), 0);
    run_again_in_vain(path);
    assert_int_equal(chdir(folder), 0);
    assert_true(is_old_set());
}

/* What one names by its whole path another finds by its name, and what lies beside the first one's folder as well. */
static void names_may_be_others(void **state)
{
    (void)state;
    char whole[sizeof folder + 1];
    snprintf(whole, sizeof whole, "%s/", folder);
    const char *const begins[] = {whole, "./", "sub/../"}, *const seconds[] = {"x", "x", "./x"};
    for (size_t i = 0; i < sizeof begins / sizeof *begins; i++) {
        before = begins[i];
        die_at_each_call(false, seconds[i]);
    }
    before = "";
}

/* The user has put back a file before the next run. */
static void a_file_that_was_changed_since_stays(void **state)
{
    (void)state;
    put_old_set();
    assert_true(dies_at(OLD_NAMES + 1, false)); /* all have two names, and one is new */
    assert_true(has_text("a.txt", "new"));
    assert_int_equal(remove("c.txt"), 0);
    put_text("c.txt", "mine");
    run_again_in_vain("x");
    assert_true(has_text("c.txt", "mine"));
    assert_true(has_text("sub/b.txt", "new"));
    assert_int_equal(entries_in("."), NAMES);
}

/* Not ours ----------------------------------------------------------------------------------- */

static void what_another_process_writes_stays(void **state)
{
    (void)state;
    struct outputs outputs = {0};
    struct error err;
    int told[2], status;
    char byte = 0;
    put_old_set();
    assert_int_equal(pipe(told), 0);
    assert_true(write_set(&outputs, &err));
    const size_t entries = entries_in(".");
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        run_again_in_vain("a.txt");
        _exit(write(told[1], "x", 1) == 1 ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    assert_int_equal(read(told[0], &byte, 1), 1);
    assert_int_equal(waitpid(pid, &status, 0), pid);
    assert_int_equal(entries_in("."), entries);
    close(told[0]);
    close(told[1]);
    assert_true(outputs_keep(&outputs, &err));
    assert_true(is_new_set());
}

static void a_list(const char *path, const char *text, size_t text_b)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, text_b, file), text_b);
    assert_int_equal(fclose(file), 0);
}

/* Names alike, without a list; a list that is a link, that somebody else made, or that names what is elsewhere. */
static void files_of_others_stay(void **state)
{
    (void)state;
    static const char *const theirs[] = {"a.txt.01234567-0.part", "x.part", "a.txt.part", "a.txt.old",
                                         "sub/b.txt.89abcdef-0.part"};
    static const char forged[] = "csub/b.txt\0../../../../etc/hostname\0a.txt", whole[] = "wsub/b.txt";
    put_old_set();
    for (size_t i = 0; i < sizeof theirs / sizeof theirs[0]; i++)
        put_text(theirs[i], "theirs");
    a_list("list", whole, sizeof whole);
    assert_int_equal(symlink("list", ".limner-89abcdef.run"), 0);
    a_list(".limner-forged00.run", forged, sizeof forged);
    run_again_in_vain("x.txt");
    assert_true(exists(".limner-89abcdef.run"));
    assert_false(exists(".limner-forged00.run"));
    for (size_t i = 0; i < sizeof theirs / sizeof theirs[0]; i++)
        assert_true(has_text(theirs[i], "theirs"));
    for (size_t i = 0; i < OLD_NAMES; i++)
        assert_true(has_text(names[i], "old"));
    assert_int_equal(remove(".limner-89abcdef.run"), 0);
    a_list(".limner-89abcdef.run", whole, sizeof whole);
    if (chown(".limner-89abcdef.run", geteuid() + 1, (gid_t)-1) == 0) {
        run_again_in_vain("x.txt");
        assert_true(has_text("sub/b.txt.89abcdef-0.part", "theirs"));
        assert_int_equal(chown(".limner-89abcdef.run", geteuid(), (gid_t)-1), 0);
    }
    run_again_in_vain("x.txt"); /* it is the user's own now */
    assert_false(exists("sub/b.txt.89abcdef-0.part"));
}

static int enter_folder(void **state)
{
    (void)state;
    no_faults();
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    (void)state;
    no_faults();
    clear(".");
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_call_that_fails_leaves_all_old_or_all_new),
        cmocka_unit_test(so_it_is_where_files_have_one_name),
        cmocka_unit_test(what_was_there_is_named_if_it_cannot_be_put_back),
        cmocka_unit_test(a_list_is_the_users_own),
        cmocka_unit_test(the_next_run_cleans_up_after_one_killed_at_any_call),
        cmocka_unit_test(and_where_files_have_one_name),
        cmocka_unit_test(it_does_so_from_another_working_folder),
        cmocka_unit_test(names_may_be_others),
        cmocka_unit_test(a_file_that_was_changed_since_stays),
        cmocka_unit_test(what_another_process_writes_stays),
        cmocka_unit_test(files_of_others_stay),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
