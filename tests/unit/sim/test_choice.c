/* SPDX-License-Identifier: MIT
 *
 * Words that users choose: in any case, and the nearest one to what they mistype. */
#include "base/choice.h"

#include "rigs/cmocka_ready.h"

#include <string.h>

static const char *const WORDS[] = {"auto", "bsp", "clusters", "axis", "octree", NULL};
static const struct choice TREES = {"--tree", "tree", choice_in_array, WORDS};

static void words_are_found_in_any_case(void **state)
{
    static const char *const given[] = {"clusters", "CLUSTERS", "Clusters"};
    (void)state;
    for (size_t i = 0; i < sizeof given / sizeof *given; i++) {
        struct error err;
        size_t index = 99;
        assert_true(choice_find(&TREES, given[i], &index, &err));
        assert_int_equal(index, 2);
    }
}

static void a_part_of_a_text_is_a_word(void **state)
{
    struct error err;
    size_t index = 99;
    (void)state;
    assert_true(choice_find_part(&TREES, "axis:more", 4, NULL, &index, &err));
    assert_int_equal(index, 3);
    assert_false(choice_find_part(&TREES, "axis:more", 3, "others", &index, &err));
    assert_string_equal(err.text, "--tree axi: no such tree, is it axis?; there are auto, bsp, clusters, axis, octree, "
                                  "and others");
}

/* What was meant, and what came out: letters left out, put in, exchanged with a neighbour, others. */
static void the_nearest_word_is_told(void **state)
{
    static const struct {
        const char *given, *meant;
    } cases[] = {{"bps", "bsp"},
                 {"ots", NULL},
                 {"cluster", "clusters"},
                 {"clutsers", "clusters"},
                 {"clsutres", "clusters"},
                 {"octre", "octree"},
                 {"Octtree", "octree"},
                 {"axes", "axis"},
                 {"17", NULL},
                 {"", NULL},
                 {"x", NULL},
                 {"quadtree-of-boxes", NULL}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *nearest = choice_nearest(choice_in_array, WORDS, cases[i].given, strlen(cases[i].given));
        if (!cases[i].meant != !nearest || (nearest && strcmp(nearest, cases[i].meant) != 0))
            fail_msg("'%s' is taken for '%s'", cases[i].given, nearest ? nearest : "nothing");
    }
}

static void texts_of_any_length_do(void **state)
{
    char text[200];
    struct error err;
    size_t index;
    (void)state;
    for (size_t length = 0; length < sizeof text - 1; length++) {
        memset(text, 'b', length);
        text[length] = '\0';
        assert_false(choice_find(&TREES, text, &index, &err));
        assert_non_null(strstr(err.text, "no such tree"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_are_found_in_any_case),
        cmocka_unit_test(a_part_of_a_text_is_a_word),
        cmocka_unit_test(the_nearest_word_is_told),
        cmocka_unit_test(texts_of_any_length_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
