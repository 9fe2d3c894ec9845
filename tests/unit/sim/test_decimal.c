/* SPDX-License-Identifier: MIT
 *
 * decimal_parse(): what is a number, and that it becomes the nearest double, by GMP's exact fractions. */
#include "rigs/cmocka_ready.h"

#include "files/decimal.h"
#include "rigs/random.h"

#include <gmp.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static double parsed(const char *text)
{
    double value;
    if (!decimal_parse(text, strlen(text), &value)) fail_msg("'%s' is refused", text);
    return value;
}

static void every_way_to_write_a_decimal_is_read(void **state)
{
    (void)state;
    assert_true(parsed("1") == 1 && parsed("+1") == 1 && parsed("-1") == -1 && parsed("007") == 7);
    assert_true(parsed(".5") == 0.5 && parsed("-.5") == -0.5 && parsed("5.") == 5 && parsed("+5.e1") == 50);
    assert_true(parsed("1e3") == 1000 && parsed("1E+3") == 1000 && parsed("25e-2") == 0.25);
    assert_true(parsed("123456.7890123456789") == 123456.7890123456789);
    assert_true(parsed("1000000.0123456789") == 1000000.0123456789);
    assert_true(parsed("-0") == 0 && parsed("0e99") == 0 && parsed("1e-300") == 0);
    assert_true(parsed("0.1000000000000000055511151231257827021181583404541015625") == 0.1);
}

static void what_is_no_decimal_is_refused(void **state)
{
    static const char *const texts[] = {"",       "+",      ".",    "-.",   "e5",       "1e",      "1e+",   "1,5",
                                        "0x10",   "nan",    "-nan", "inf",  "infinity", "1.2.3",   "1-2",   "--1",
                                        "1e5.0",  "3.1+e2", "1d3",  "five", "1e39",     "-1e39",   "1e999", "1_000",
                                        "1.#IND", "1f",     " 1",   "1 ",   "0b1",      "\xC2\xBD"};
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        double value;
        if (decimal_parse(texts[i], strlen(texts[i]), &value)) fail_msg("'%s' is taken for %g", texts[i], value);
    }
}

/* A number ends where its word does, whatever follows. */
static void only_the_word_counts(void **state)
{
    double value;
    (void)state;
    assert_true(decimal_parse("12 34", 2, &value) && value == 12);
    assert_true(decimal_parse("0.5\n7", 3, &value) && value == 0.5);
    assert_false(decimal_parse("12 34", 5, &value));
}

/* |value - digits / 10^places| against half the step to the doubles on either side. */
static bool is_nearest(const char *digits, unsigned places, double value)
{
    mpq_t exact, error, half;
    mpq_inits(exact, error, half, NULL);
    mpq_set_str(exact, digits, 10);
    mpz_ui_pow_ui(mpq_denref(exact), 10, places);
    mpq_canonicalize(exact);
    mpq_set_d(error, value);
    mpq_sub(error, error, exact);
    mpq_abs(error, error);
    mpq_set_d(half, (nextafter(value, INFINITY) - value) / 2);
    const bool ok = mpq_cmp(error, half) <= 0;
    mpq_clears(exact, error, half, NULL);
    return ok;
}

static void random_decimals_become_the_nearest_double(void **state)
{
    struct random random = {1};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        char digits[32] = "", text[40];
        const unsigned whole = 1 + (unsigned)random_in(&random, 0, 6), places = (unsigned)random_in(&random, 0, 19);
        digits[0] = (char)('1' + random_in(&random, 0, 8));
        for (unsigned k = 1; k < whole + places; k++)
            digits[k] = (char)('0' + random_in(&random, 0, 9));
        snprintf(text, sizeof text, "%.*s.%s", (int)whole, digits, digits + whole);
        if (!is_nearest(digits, places, parsed(text))) fail_msg("%s is read as %.17g", text, parsed(text));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_way_to_write_a_decimal_is_read),
        cmocka_unit_test(what_is_no_decimal_is_refused),
        cmocka_unit_test(only_the_word_counts),
        cmocka_unit_test(random_decimals_become_the_nearest_double),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
