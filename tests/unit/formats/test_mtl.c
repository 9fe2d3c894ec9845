/* SPDX-License-Identifier: MIT
 *
 * Materials of OBJ models: what their statements mean, and the text that an importer library gets of them. Expected is
 * what the format's manual says, by hand. */
#include "files/companion.h"
#include "readers/obj_library.h"
#include "rigs/cmocka_ready.h"

#include <stdlib.h>
#include <string.h>

static struct obj obj;

static bool reads(const char *text, struct error *err)
{
    companions_begin("/nowhere/model.obj");
    obj_free(&obj);
    obj = (struct obj){.path = "/nowhere/model.obj"};
    if (!mtl_read(&obj.mtl, "a.mtl", text, strlen(text), err)) return false;
    mtl_settle(&obj.mtl);
    return true;
}

static void assert_becomes(const char *text, const char *plain)
{
    struct error err = {""};
    if (!reads(text, &err)) fail_msg("%s", err.text);
    struct whole_file out = obj_materials_text(&obj);
    assert_string_equal(out.bytes, plain);
    whole_file_free(&out);
}

static void assert_refused(const char *text, const char *reason)
{
    struct error err = {""};
    assert_false(reads(text, &err));
    assert_string_equal(err.text, reason);
}

static void assert_told(const struct names *names, const char *list, size_t mentions)
{
    char told[256];
    assert_string_equal(names_list(names, told, sizeof told), list);
    assert_int_equal(names->mentions, mentions);
}

static void materials_go_by_number(void **state)
{
    (void)state;
    assert_becomes("newmtl two words \nKd 1 .5 0\n\nnewmtl #2\r\n\tKE 0.25\r\nillum 0\r\n",
                   "newmtl 1\nKd 1 0.5 0\nnewmtl 2\nKe 0.25 0.25 0.25\nillum 0\n\n");
    assert_string_equal(obj.mtl.materials[0].name, "two words");
    assert_ptr_equal(mtl_find(&obj.mtl, "#2", 2), &obj.mtl.materials[1]);
    assert_null(mtl_find(&obj.mtl, "#", 1));
    assert_becomes("", "\n");
}

static void an_opacity_is_d_or_what_tr_means(void **state)
{
    (void)state;
    assert_becomes("newmtl a\nd .25\n", "newmtl 1\nd 0.25\n\n");
    assert_becomes("newmtl a\nTr .25\n", "newmtl 1\nd 0.75\n\n");
    assert_becomes("newmtl a\nTr .25\nd .75\n", "newmtl 1\nd 0.75\n\n");
    assert_int_equal(obj.mtl.contradicts.mentions, 0);
    assert_becomes("newmtl a\nTr 1\nd 1\n", "newmtl 1\nd 1\n\n");
    assert_told(&obj.mtl.contradicts, "'a'", 1);
    assert_becomes("newmtl a\nTr 1\nnewmtl b\nTr .25\nnewmtl c\nd .5\n",
                   "newmtl 1\nd 1\nnewmtl 2\nd 0.25\nnewmtl 3\nd 0.5\n\n");
    assert_told(&obj.mtl.meshlab, "'a', 'b'", 2);
    assert_becomes("newmtl a\nTr 1\nnewmtl b\nTr 0\n", "newmtl 1\nd 0\nnewmtl 2\nd 1\n\n");
    assert_int_equal(obj.mtl.meshlab.mentions, 0);
}

static void options_are_no_part_of_a_name(void **state)
{
    (void)state;
    assert_becomes("newmtl a\nmap_Kd -blendu on -s 2 3 1 -o -.5 -bm 2 -imfchan l -texres 64x64 a b.png\n",
                   "newmtl 1\nKd 1 1 1\nmap_Kd a b.png\n\n");
    const struct mtl_map *map = &obj.mtl.materials[0].maps[MTL_COLOUR];
    assert_true(map->scale[0] == 2 && map->scale[1] == 3 && map->offset[0] == -0.5 && map->offset[1] == 0);
    assert_false(map->clamps);
    assert_int_equal(obj.mtl.options.mentions, 0);
    assert_becomes("newmtl a\nmap_Ke -clamp on x.png\nmap_d -what -ever 1 2 3 -so on -x y z.png\n",
                   "newmtl 1\nmap_Ke -clamp on x.png\nmap_d z.png\n\n");
    assert_told(&obj.mtl.options, "'-what', '-ever', '-so', '-x'", 4);
    assert_becomes("newmtl a\nmap_Kd -1.png\nmap_d -s 3 2\n", "newmtl 1\nKd 1 1 1\nmap_Kd ./-1.png\nmap_d 2\n\n");
    assert_becomes("newmtl a\nmap_Kd -s 2 a.png\nmap_d -o .5 b.png\n",
                   "newmtl 1\nKd 1 1 1\nmap_Kd a.png\nmap_d b.png\n\n");
    assert_told(&obj.mtl.options, "'-s', '-o'", 2);
    assert_becomes("newmtl a\nmap_Ke -s 2 a.png\n", "newmtl 1\nmap_Ke a.png\n\n");
    assert_true(mtl_map_of(&obj.mtl.materials[0])->scale[0] == 2);
    assert_int_equal(obj.mtl.options.mentions, 0);
    assert_becomes("newmtl a\nmap_Kd\nmap_Kd  \n", "newmtl 1\n\n");
    assert_becomes("newmtl a\nmap_Kd a.png # red\nmap_d a #1.png\n",
                   "newmtl 1\nKd 1 1 1\nmap_Kd a.png\nmap_d a #1.png\n\n");
}

static void what_is_not_drawn_is_counted_by_kind(void **state)
{
    (void)state;
    assert_becomes("Kd 1 1 1\nnewmtl a\nfoo\nPr 1\nbar 2\nfoo\nKd spectral x.rfl\nnewmtl a\nKd 2 0 0\n",
                   "newmtl 1\nnewmtl 2\nKd 2 0 0\n\n");
    assert_told(&obj.mtl.early, "'Kd'", 1);
    assert_told(&obj.mtl.left_out, "'foo', 'bar'", 3);
    assert_told(&obj.mtl.no_rgb, "'a'", 1);
    assert_told(&obj.mtl.doubled, "'a'", 1);
    assert_told(&obj.mtl.beyond, "'a'", 1);
    assert_becomes("newmtl a\nKd 0 0 0\nmap_Kd x.png\n", "newmtl 1\nKd 0 0 0\nmap_Kd x.png\n\n");
    assert_told(&obj.mtl.black, "'a'", 1);
}

static void what_is_no_number_is_refused_by_its_line(void **state)
{
    (void)state;
    assert_refused("newmtl a\nKd 1 1\n", "a.mtl:2: a colour of 2 numbers; it has one or three");
    assert_refused("newmtl a\n\nKe nan\n", "a.mtl:3: 'nan' is not a decimal number up to 3.4e38");
    assert_refused("newmtl a\r\nTr\r\n", "a.mtl:2: Tr without a number");
}

static void names_are_told_by_their_ends_and_the_first_of_many(void **state)
{
    struct names names = {0};
    char name[301], told[1024];
    (void)state;
    memset(name, 'x', 300);
    strcpy(name + 290, "_left.png");
    assert_string_equal(name_end("short").text, "short");
    assert_int_equal(strlen(name_end(name).text), NAME_END_B - 1);
    assert_memory_equal(name_end(name).text, "...x", 4);
    assert_string_equal(name_end(name).text + NAME_END_B - 1 - strlen("x_left.png"), "x_left.png");
    for (int i = 0; i < 200; i++)
        for (int times = 0; times < 2; times++)
            names_add(&names, name, (size_t)snprintf(name, sizeof name, "n%d", i));
    assert_string_equal(names_list(&names, told, sizeof told), "'n0', 'n1', 'n2', 'n3' and many more");
    assert_int_equal(names.mentions, 400);
    names_free(&names);
    for (int i = 0; i < 6; i++)
        names_add(&names, name, (size_t)snprintf(name, sizeof name, "n%d", i));
    assert_string_equal(names_list(&names, told, sizeof told), "'n0', 'n1', 'n2', 'n3' and 2 more");
    names_free(&names);
}

static int free_all(void **state)
{
    (void)state;
    obj_free(&obj);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_go_by_number),
        cmocka_unit_test(an_opacity_is_d_or_what_tr_means),
        cmocka_unit_test(options_are_no_part_of_a_name),
        cmocka_unit_test(what_is_not_drawn_is_counted_by_kind),
        cmocka_unit_test(what_is_no_number_is_refused_by_its_line),
        cmocka_unit_test(names_are_told_by_their_ends_and_the_first_of_many),
    };
    return cmocka_run_group_tests(tests, NULL, free_all);
}
