/* SPDX-License-Identifier: MIT
 *
 * Conditions of the preprocessor that are decided before a compiler runs, and what joining sources makes of them. What
 * is certain is so by C's rules; what is not is left to the compiler. */
#include "export/amalgam.h"
#include "export/conditions.h"
#include "export/template.h"
#include "rigs/cmocka_ready.h"

#include <stdlib.h>
#include <string.h>

static const char *const SETTLED[] = {"LIM_HAS_", "LIM_CONFIG", "__has_include", NULL};

static void expressions_are_those_of_c(void **state)
{
    static const struct {
        const char *text;
        enum known answer;
    } cases[] = {
        {"1", KNOWN_TRUE},
        {"0", KNOWN_FALSE},
        {"!0 && !!2", KNOWN_TRUE},
        {"1 + 2 - 3", KNOWN_FALSE},
        {"2 - 1 - 1", KNOWN_FALSE}, /* from the left */
        {"-1 < 0", KNOWN_TRUE},
        {"0x10 == 16u", KNOWN_TRUE},
        {"250 - 8 >= 64", KNOWN_TRUE},
        {"1 || 0 && 0", KNOWN_TRUE}, /* && binds closer */
        {"(1 || 0) && 0", KNOWN_FALSE},
        {"1 != 1 || 3 <= 2", KNOWN_FALSE},
        {"2 > 1", KNOWN_TRUE},
        {"defined(ONE) && defined TWO", KNOWN_TRUE},
        {"defined(GONE)", KNOWN_FALSE},
        {"ONE && TWO == 2", KNOWN_TRUE},
        {"TWICE == 4", KNOWN_TRUE}, /* a macro of macros */
        {"LIM_EITHER(0, ONE)", KNOWN_TRUE},
        {"LIM_BOTH(0, ONE)", KNOWN_FALSE},
        {"LIM_HAS_NOTHING", KNOWN_FALSE}, /* settled: nobody else defines it */
        {"defined(SOME_HEADER_H)", KNOWN_FALSE},
        {"__AVR__", KNOWN_NOT},
        {"defined(__AVR__)", KNOWN_NOT},
        {"__AVR__ && 0", KNOWN_FALSE}, /* whatever a processor says */
        {"1 || __AVR__", KNOWN_TRUE},
        {"__AVR__ || 0", KNOWN_NOT},
        {"__GNUC__ >= 8", KNOWN_NOT},
        {"LIM_BOTH(__AVR__, 0)", KNOWN_FALSE},
        {"__has_feature(some(thing)) || 1", KNOWN_TRUE},
        {"LOOP", KNOWN_NOT},  /* that names itself */
        {"1 % 2", KNOWN_NOT}, /* not understood, as those that follow */
        {"2 * 1", KNOWN_NOT},
        {"2 / 1", KNOWN_NOT},
        {"~0", KNOWN_NOT},
        {"+ONE", KNOWN_NOT},
        {"1 << 1", KNOWN_NOT},
        {"3 & 1", KNOWN_NOT},
        {"1 ? 1 : 0", KNOWN_NOT},
        {"1 < 2 < 3", KNOWN_NOT},
        {"(1", KNOWN_NOT},
        {"", KNOWN_NOT},
    };
    struct conditions conditions = {.settled = SETTLED};
    (void)state;
    conditions_define(&conditions, "ONE", " 1");
    conditions_define(&conditions, "TWO", "2");
    conditions_define(&conditions, "TWICE", "(TWO + TWO)");
    conditions_define(&conditions, "LOOP", "LOOP");
    conditions_undefine(&conditions, "GONE");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        if (conditions_ask(&conditions, cases[i].text) != cases[i].answer) fail_msg("%s", cases[i].text);
    conditions_define(&conditions, "ONE", "0");
    assert_int_equal(conditions_ask(&conditions, "ONE"), KNOWN_FALSE);
    conditions_forget(&conditions, "ONE");
    assert_int_equal(conditions_ask(&conditions, "ONE"), KNOWN_NOT);
    conditions_free(&conditions);
}

/* What a text becomes behind `#define LIM_HAS_ONE 1`; NULL: it is refused. */
static char *joined(const char *text, struct error *err)
{
    static const char *const folders[] = {"firmware/", NULL};
    struct amalgam amalgam = {.conditions.settled = SETTLED, .folders = folders};
    char *out = NULL;
    size_t out_b;
    FILE *memory = open_memstream(&out, &out_b);
    assert_non_null(memory);
    conditions_define(&amalgam.conditions, "LIM_HAS_ONE", "1");
    const bool ok = amalgam_add_text(&amalgam, "t", text, memory, err);
    fclose(memory);
    amalgam_free(&amalgam);
    if (ok) return out;
    free(out);
    return NULL;
}

static void assert_joined(const char *text, const char *expected)
{
    static const char head[] = "\n/* -- t -- */\n";
    struct error err;
    char *out = joined(text, &err);
    if (!out) fail_msg("%s", err.text);
    if (*expected) {
        assert_memory_equal(out, head, sizeof head - 1);
        assert_string_equal(out + sizeof head - 1, expected);
    } else {
        assert_string_equal(out, "");
    }
    free(out);
}

static void what_is_certain_goes(void **state)
{
    (void)state;
    assert_joined("a\n#if LIM_HAS_ONE\nb\n#else\nc\n#endif\nd\n", "a\nb\nd\n");
    assert_joined("#if LIM_HAS_NONE\na\n#elif LIM_HAS_ONE\nb\n#else\nc\n#endif\n", "b\n");
    assert_joined("#ifndef LIM_HAS_NONE\n#define LIM_HAS_NONE 1\n#endif\n#if LIM_HAS_NONE\na\n#endif\n",
                  "#define LIM_HAS_NONE 1\na\n");
    assert_joined("#if LIM_HAS_NONE\n#if __AVR__\na\n#else\nb\n#endif\n#endif\nc\n", "c\n");
    assert_joined("#if LIM_HAS_ONE && \\\n    LIM_HAS_NONE\na\n#endif\nb\n", "b\n");
    assert_joined("#if LIM_HAS_NONE\na\n#else\nb\n#if LIM_HAS_NONE\nc\n#else\nd\n#endif\n#endif\n", "b\nd\n");
    assert_joined("/* nothing */\n#if LIM_HAS_NONE\na\n#endif\n", "");
}

static void what_a_compiler_decides_stays(void **state)
{
    (void)state;
    assert_joined("#if __AVR__\na\n#else\nb\n#endif\n", "#if __AVR__\na\n#else\nb\n#endif\n");
    assert_joined("#if LIM_HAS_NONE\na\n#elif __AVR__\nb\n#else\nc\n#endif\n", "#if __AVR__\nb\n#else\nc\n#endif\n");
    assert_joined("#if __AVR__\n#if LIM_HAS_ONE\na\n#endif\n#endif\n", "#if __AVR__\na\n#endif\n");
    /* What only one of two ways defines is not known behind them. */
    assert_joined("#if __AVR__\n#define A 1\n#else\n#define A 0\n#endif\n#if A\na\n#endif\n",
                  "#if __AVR__\n#define A 1\n#else\n#define A 0\n#endif\n#if A\na\n#endif\n");
}

static void what_is_undefined_is_so_from_there_on(void **state)
{
    (void)state;
    assert_joined("#define A 1\n#if A\na\n#endif\n#undef A\n#ifdef A\nb\n#endif\nc\n", "#define A 1\na\n#undef A\nc\n");
    assert_joined("#define A 1\n#undef A\n#define A 2\n#if A == 2\na\n#endif\n",
                  "#define A 1\n#undef A\n#define A 2\na\n");
    assert_joined("#define A 1\n#if LIM_HAS_NONE\n#undef A\n#endif\n#if A\na\n#endif\n", "#define A 1\na\n");
    assert_joined("#define A 1\n#if __AVR__\n#undef A\n#endif\n#ifdef A\na\n#endif\n",
                  "#define A 1\n#if __AVR__\n#undef A\n#endif\n#ifdef A\na\n#endif\n");
}

static void headers_come_once(void **state)
{
    (void)state;
    assert_joined("#include <stdint.h>\n#include <stdint.h>\na\n", "#include <stdint.h>\na\n");
    struct error err;
    char *out = joined("#include \"target.h\"\n#include \"camera.h\"\n#include \"target.h\"\na\n", &err);
    assert_non_null(out);
    char *first = strstr(out, "/* -- firmware/target.h -- */");
    assert_non_null(first);
    assert_null(strstr(first + 1, "/* -- firmware/target.h -- */"));
    assert_non_null(strstr(out, "/* -- firmware/camera.h -- */"));
    assert_null(strstr(out, "#include \""));
    free(out);
}

static void assert_refused(const char *text, const char *reason)
{
    struct error err;
    char *out = joined(text, &err);
    if (out) fail_msg("joined: %s", text);
    assert_string_equal(err.text, reason);
}

static void what_cannot_be_joined_is_named(void **state)
{
    (void)state;
    assert_refused("a\n#endif\n", "t:2: a condition ends that did not begin");
    assert_refused("#if 1\na\n", "t:3: a condition does not end");
    assert_refused("a\n\n#include \"nosuch.h\"\n", "t:3: no header nosuch.h");
    assert_refused("a\n#include HEADER\n", "t:2: an include that is not understood");
    assert_refused("#include \"open.h\n", "t:1: an include that is not understood");
    assert_joined("#if LIM_HAS_NONE\n#include HEADER\n#endif\na\n", "a\n");
    assert_refused("#if __AVR__\n#include \"target.h\"\n#endif\n",
                   "t:2: a header under a condition that only a compiler can decide");
}

static void words_are_replaced(void **state)
{
    static const struct template_word words[] = {{"name", "hall"}, {"W", "240"}};
    char *out = NULL;
    size_t out_b;
    FILE *memory = open_memstream(&out, &out_b);
    (void)state;
    template_write(memory, "@name@_@W@: a@b @other@ @", words, 2);
    fclose(memory);
    assert_string_equal(out, "hall_240: a@b @other@ @");
    free(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(expressions_are_those_of_c),
        cmocka_unit_test(what_is_certain_goes),
        cmocka_unit_test(what_a_compiler_decides_stays),
        cmocka_unit_test(headers_come_once),
        cmocka_unit_test(what_cannot_be_joined_is_named),
        cmocka_unit_test(words_are_replaced),
        cmocka_unit_test(what_is_undefined_is_so_from_there_on),
    };
    return cmocka_run_group_tests_name("conditions", tests, NULL, NULL);
}
