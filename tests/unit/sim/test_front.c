/* SPDX-License-Identifier: MIT
 *
 * Which choices nobody need take, and because of which other. */
#include "base/front.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <stdbool.h>

enum { CHOICES = 40, TRIES = 200 };

static void a_single_choice_is_on_the_front(void **state)
{
    const struct front_choice only = {1, 1};
    size_t dominator;

    (void)state;
    front_find(&only, 1, &dominator);
    assert_true(dominator == FRONT_NONE);
}

static void less_error_for_more_cost_is_a_choice(void **state)
{
    const struct front_choice choices[] = {{3, 1}, {2, 2}, {1, 3}};
    size_t dominator[3];

    (void)state;
    front_find(choices, 3, dominator);
    for (int i = 0; i < 3; i++)
        assert_true(dominator[i] == FRONT_NONE);
}

static void worse_in_one_and_equal_in_the_other_is_dominated(void **state)
{
    const struct front_choice choices[] = {{1, 2}, {1, 1}, {2, 1}};
    size_t dominator[3];

    (void)state;
    front_find(choices, 3, dominator);
    assert_int_equal(dominator[0], 1);
    assert_true(dominator[1] == FRONT_NONE);
    assert_int_equal(dominator[2], 1);
}

static void equal_choices_do_not_dominate_each_other(void **state)
{
    const struct front_choice choices[] = {{1, 1}, {1, 1}};
    size_t dominator[2];

    (void)state;
    front_find(choices, 2, dominator);
    assert_true(dominator[0] == FRONT_NONE && dominator[1] == FRONT_NONE);
}

static void of_several_dominators_the_cheapest_is_named(void **state)
{
    const struct front_choice choices[] = {{5, 5}, {1, 4}, {4, 2}, {3, 2}};
    size_t dominator[4];

    (void)state;
    front_find(choices, 4, dominator);
    assert_int_equal(dominator[0], 3); /* not 2, which 3 dominates */
    assert_int_equal(dominator[2], 3);
}

static bool is_dominated(const struct front_choice *choices, size_t i)
{
    for (size_t k = 0; k < CHOICES; k++) {
        const struct front_choice *a = &choices[k], *b = &choices[i];
        if (a->error <= b->error && a->cost <= b->cost && (a->error < b->error || a->cost < b->cost)) return true;
    }
    return false;
}

/* Whole numbers from few: many are equal in one or both. */
static void whoever_is_named_is_on_the_front_and_better(void **state)
{
    struct random random = {7};
    struct front_choice choices[CHOICES];
    size_t dominator[CHOICES];

    (void)state;
    for (int try = 0; try < TRIES; try++) {
        for (int i = 0; i < CHOICES; i++)
            choices[i] = (struct front_choice){(double)random_in(&random, 0, 8), (double)random_in(&random, 0, 8)};
        front_find(choices, CHOICES, dominator);
        for (size_t i = 0; i < CHOICES; i++) {
            assert_int_equal(dominator[i] != FRONT_NONE, is_dominated(choices, i));
            if (dominator[i] == FRONT_NONE) continue;
            const struct front_choice *better = &choices[dominator[i]];
            assert_true(dominator[dominator[i]] == FRONT_NONE);
            assert_true(better->error <= choices[i].error && better->cost <= choices[i].cost);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_single_choice_is_on_the_front),
        cmocka_unit_test(less_error_for_more_cost_is_a_choice),
        cmocka_unit_test(worse_in_one_and_equal_in_the_other_is_dominated),
        cmocka_unit_test(equal_choices_do_not_dominate_each_other),
        cmocka_unit_test(of_several_dominators_the_cheapest_is_named),
        cmocka_unit_test(whoever_is_named_is_on_the_front_and_better),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
