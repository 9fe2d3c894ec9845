/* SPDX-License-Identifier: MIT
 *
 * What may be shown, by Unicode's and ECMA-48's tables: written here byte by byte. */
#include "base/c_name.h"
#include "base/error.h"
#include "base/printable.h"
#include "outputs/written.h"
#include "page/html.h"
#include "rigs/cmocka_ready.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *from, *to;
} CASES[] = {
    {"", ""},
    {"plain", "plain"},
    {"na\xC3\xAFve \xE2\x82\xAC \xF0\x9F\x98\x80", "na\xC3\xAFve \xE2\x82\xAC \xF0\x9F\x98\x80"},
    {"\x01\x07\x08\t\n\r\x1B[31m\x7F", "       [31m "},
    {"a\xC2\x80\xC2\x9B\x33mb\xC2\x9F\xC2\xA0", "a  3mb \xC2\xA0"},                       /* C1, among them CSI */
    {"\xE2\x80\xAA\xE2\x80\xAB\xE2\x80\xAC\xE2\x80\xAD\xE2\x80\xAE", "     "},            /* U+202A to 202E */
    {"\xE2\x81\xA5\xE2\x81\xA6\xE2\x81\xA7\xE2\x81\xA8\xE2\x81\xA9", "\xE2\x81\xA5    "}, /* U+2065 to 2069 */
    {"\xE2\x80\xA7\xE2\x80\xA8\xE2\x80\xA9", "\xE2\x80\xA7  "},                           /* U+2027 to 2029 */
    {"\xE2\x80\x8E\xE2\x80\x8F\xD8\x9C", "   "},                                          /* marks of direction */
    {"\x80\xBF\xFE\xFF\xC0\xAF", "??????"},                                               /* no UTF-8; an overlong / */
    {"\xE0\x80\xAF\xF0\x80\x80\xAF", "???????"},                                          /* so are these */
    {"\xED\xA0\x80\xF4\x90\x80\x80", "???????"}, /* a surrogate; beyond the last */
    {"\xC3", "?"},                               /* cut off */
    {"\xE2\x82", "??"},
    {"\xF0\x9F\x98", "???"},
    {"\xC3\x41", "?A"},
    {"\xF0\x9F\x98\x41", "???A"},
};
enum { CASE_COUNT = sizeof CASES / sizeof *CASES };

static char *copy_of(const char *text)
{
    char *copy = strdup(text);
    assert_non_null(copy);
    return copy;
}

static void text_becomes_a_line_that_can_be_shown(void **state)
{
    (void)state;
    for (size_t i = 0; i < CASE_COUNT; i++) {
        char *text = copy_of(CASES[i].from);
        assert_string_equal(printable(text), CASES[i].to);
        free(text);
    }
}

static void errors_and_lists_of_files_are_such(void **state)
{
    (void)state;
    for (size_t i = 0; i < CASE_COUNT; i++) {
        struct error err;
        char text[WRITTEN_B], expected[WRITTEN_B];
        error_set(&err, "%s", CASES[i].from);
        assert_string_equal(err.text, CASES[i].to);
        written_text(&CASES[i].from, 1, text);
        snprintf(expected, sizeof expected, "wrote %s", CASES[i].to);
        assert_string_equal(text, expected);
    }
}

static char *written_by(void (*write)(FILE *, const char *), const char *text)
{
    char *bytes = NULL;
    size_t size_b;
    FILE *file = open_memstream(&bytes, &size_b);
    assert_non_null(file);
    write(file, text);
    assert_int_equal(fclose(file), 0);
    return bytes;
}

static void print_as_line(FILE *file, const char *text)
{
    printable_print(file, "%s\n", text);
}

static void print_within(FILE *file, const char *text)
{
    printable_print(file, "%s", text);
}

static void what_is_printed_keeps_the_formats_newline(void **state)
{
    (void)state;
    char *line = written_by(print_as_line, "a\nb\x1B]0;c\a"), *within = written_by(print_within, "a\n");
    assert_string_equal(line, "a b ]0;c \n");
    assert_string_equal(within, "a ");
    free(line);
    free(within);
}

static void pages_hold_the_same_text(void **state)
{
    (void)state;
    char *text = written_by(html_text, "<a\x1B\xC2\x9B\xE2\x80\xAE\xFF&\xC3\xAF>");
    assert_string_equal(text, "&lt;a   &#65533;&amp;\xC3\xAF&gt;");
    free(text);
}

static void files_get_names_that_c_can_include(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to;
    } names[] = {{"plain", "plain"},
                 {"a b-c.d", "a b-c.d"},
                 {"\"od\"d\"/a\"b", "\"od\"d\"/a_b"},
                 {"it's", "it_s"},
                 {"a\\b", "a_b"},
                 {"a?\?!b", "a__!b"},
                 {"a\nb", "a_b"},
                 {"na\xC3\xAFve", "na\xC3\xAFve"},
                 {"\xFF\xE2\x80\xAEx", "____x"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char *name = copy_of(names[i].from);
        assert_int_equal(c_name_map(name), strcmp(names[i].from, names[i].to) != 0);
        assert_string_equal(name, names[i].to);
        free(name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_becomes_a_line_that_can_be_shown),
        cmocka_unit_test(errors_and_lists_of_files_are_such),
        cmocka_unit_test(what_is_printed_keeps_the_formats_newline),
        cmocka_unit_test(pages_hold_the_same_text),
        cmocka_unit_test(files_get_names_that_c_can_include),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
