/* SPDX-License-Identifier: MIT
 *
 * Files that a model names where the system has no /proc, where links lead out of the folder, and where a library
 * crashes at one of them. The calls that say so are this program's own: readlink() and a decoder of pictures. */
#define _XOPEN_SOURCE 700
#include "files/companion.h"
#include "readers/model_import.h"
#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <gd.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_B = 1 << 20 };

static char folder[] = "/tmp/limner-companion-XXXXXX";
static char path[128];

/* There is no /proc. */
ssize_t readlink(const char *restrict link, char *restrict out, size_t out_b)
{
    (void)link, (void)out, (void)out_b;
    errno = ENOENT;
    return -1;
}

gdImagePtr gdImageCreateFromPngPtr(int size_b, void *bytes)
{
    (void)size_b, (void)bytes;
    signal(SIGSEGV, SIG_DFL); /* a sanitizer would tell of it */
    raise(SIGSEGV);
    return NULL;
}

static const char *in_folder(const char *name)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void put_bytes(const char *name, const void *bytes, size_t size_b)
{
    FILE *file = fopen(in_folder(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size_b, file), size_b);
    assert_int_equal(fclose(file), 0);
}

static void put(const char *name, const char *text)
{
    put_bytes(name, text, strlen(text));
}

/* As model model.obj of the folder. */
static void assert_opens(const char *name, const char *text)
{
    struct error err = {""};
    char bytes[64] = "";
    companions_begin(in_folder("model.obj"));
    FILE *file = companion_open(name, MOST_B, NULL, &err);
    if (!file) fail_msg("%s: %s", name, err.text);
    assert_int_equal(fread(bytes, 1, sizeof bytes - 1, file), strlen(text));
    assert_string_equal(bytes, text);
    fclose(file);
    assert_false(companions_refused(&err));
}

static void assert_refused(const char *name, const char *reason)
{
    struct error err = {""};
    companions_begin(in_folder("model.obj"));
    assert_null(companion_open(name, MOST_B, NULL, &err));
    if (!strstr(err.text, reason)) fail_msg("%s: %s", name, err.text);
}

static void a_file_beside_its_model_needs_no_proc(void **state)
{
    (void)state;
    put("own.mtl", "own");
    assert_int_equal(mkdir(in_folder("sub"), 0777), 0);
    put("sub/below.mtl", "below");
    assert_opens("own.mtl", "own");
    assert_opens("sub/../own.mtl", "own");
    assert_opens("sub\\below.mtl", "below");
    assert_opens("SUB/Below.MTL", "below");
}

static void links_are_followed_within_the_folder_alone(void **state)
{
    (void)state;
    char to[128];
    snprintf(to, sizeof to, "%s", in_folder("own.mtl"));
    assert_int_equal(symlink(to, in_folder("inside.mtl")), 0);
    assert_int_equal(symlink("/etc/passwd", in_folder("outside.mtl")), 0);
    assert_int_equal(symlink("/etc", in_folder("etc")), 0);
    assert_opens("inside.mtl", "own");
    assert_refused("outside.mtl", "it names 'outside.mtl', which lies outside of its folder");
    assert_refused("OUTSIDE.mtl", "which lies outside of its folder");
    assert_refused("etc/passwd", "which lies outside of its folder");
    assert_refused("nowhere/outside.mtl", "No such file");
}

static void what_cannot_be_found_out_is_not_called_outside(void **state)
{
    (void)state;
    struct error err = {""};
    char there[128], gone[128];
    snprintf(there, sizeof there, "%s", in_folder("moves"));
    snprintf(gone, sizeof gone, "%s", in_folder("gone"));
    assert_int_equal(mkdir(there, 0777), 0);
    companions_begin(in_folder("gone/model.obj")); /* not there yet */
    put("moves/own.mtl", "own");
    assert_int_equal(rename(there, gone), 0);
    assert_null(companion_open("own.mtl", MOST_B, NULL, &err));
    if (!strstr(err.text, "this system does not tell whether that lies in its folder")) fail_msg("%s", err.text);
    assert_null(strstr(err.text, "trust-paths"));
    assert_true(companions_refused(&err));
}

static void a_crash_names_the_file_that_was_opened_last(void **state)
{
    (void)state;
    static const char png[] = "\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR\0\0\0\1\0\0\0\1\x8\2\0\0\0\x90\x77\x53\xDE"; /* 1 x 1 */
    struct model model;
    struct error err = {""};
    put("model.mtl", "newmtl a\nmap_Kd picture.png\n");
    put_bytes("picture.png", png, sizeof png);
    put("model.obj", "mtllib model.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    assert_false(model_import(in_folder("model.obj"), &model, &err));
    assert_non_null(strstr(err.text, "model.obj: the importer cannot read it (Segmentation fault); the last that it "
                                     "opened is "));
    assert_non_null(strstr(err.text, "/picture.png"));
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    static const char *const names[] = {"own.mtl",     "sub/below.mtl", "sub",          "inside.mtl",
                                        "outside.mtl", "etc",           "gone/own.mtl", "gone",
                                        "model.mtl",   "picture.png",   "model.obj",    ""};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (remove(in_folder(names[i])) != 0) return -1;
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_file_beside_its_model_needs_no_proc),
        cmocka_unit_test(links_are_followed_within_the_folder_alone),
        cmocka_unit_test(what_cannot_be_found_out_is_not_called_outside),
        cmocka_unit_test(a_crash_names_the_file_that_was_opened_last),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
