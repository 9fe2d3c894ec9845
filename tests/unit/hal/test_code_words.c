/* SPDX-License-Identifier: MIT
 *
 * Every code of the renderer, of panels and of microcontrollers has words of its own. The codes are those that the
 * headers' text defines. */
#include "linux/code_words.h"

#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CODES_MAX = 64 };

static int codes[CODES_MAX];
static size_t code_count;

/* Lines like "    LIM_ERR_MEMORY = -1001, ...". */
static void collect_codes(const char *path)
{
    char line[256];
    FILE *file = fopen(path, "r");

    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        const char *name = strstr(line, "_ERR_"), *number = name ? strstr(name, "= -") : NULL;
        if (!number) continue;
        assert_true(code_count < CODES_MAX);
        codes[code_count++] = atoi(number + 2);
    }
    assert_int_equal(fclose(file), 0);
}

static void every_code_of_the_headers_has_words_of_its_own(void **state)
{
    const char *unknown = code_words(-30000);

    (void)state;
    collect_codes("firmware/target.h");
    collect_codes("hal/panel.h");
    collect_codes("hal/mcu/mcu.h");
    assert_true(code_count >= 12);
    for (size_t i = 0; i < code_count; i++) {
        assert_string_not_equal(code_words(codes[i]), unknown);
        for (size_t k = 0; k < i; k++)
            assert_string_not_equal(code_words(codes[i]), code_words(codes[k]));
    }
}

static void what_a_system_call_said_is_said(void **state)
{
    (void)state;
    assert_string_equal(code_words(-EIO), "Input/output error");
    assert_string_equal(code_words(-ENODEV), "No such device");
}

static void what_nobody_defines_is_called_so(void **state)
{
    (void)state;
    assert_non_null(strstr(code_words(17), "only the port knows"));
    assert_non_null(strstr(code_words(-9999), "only the port knows"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_code_of_the_headers_has_words_of_its_own),
        cmocka_unit_test(what_a_system_call_said_is_said),
        cmocka_unit_test(what_nobody_defines_is_called_so),
    };

    return cmocka_run_group_tests_name("code_words", tests, NULL, NULL);
}
