/* SPDX-License-Identifier: MIT
 *
 * By recursive descent. A value is a number, or is not known; && and || are known as soon as one side decides. */
#include "export/conditions.h"

#include "base/grow.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_MAX_B = 64, DEPTH_MAX = 32 };

struct condition_macro {
    char *name, *text; /* text NULL: certainly not defined */
    bool is_known;
};

struct value {
    long long number;
    bool is_known;
};

struct reader {
    const struct conditions *conditions;
    const char *at;
    unsigned depth; /* of macros in macros */
};

static const struct value NOT_KNOWN = {0, false};

static struct value number_value(long long number)
{
    return (struct value){number, true};
}

static struct condition_macro *find(const struct conditions *conditions, const char *name)
{
    for (size_t i = 0; i < conditions->count; i++)
        if (strcmp(conditions->macros[i].name, name) == 0) return &conditions->macros[i];
    return NULL;
}

static bool is_settled(const struct conditions *conditions, const char *name)
{
    const size_t length = strlen(name);
    if (length > 2 && strcmp(name + length - 2, "_H") == 0) return true;
    for (const char *const *start = conditions->settled; start && *start; start++)
        if (strncmp(name, *start, strlen(*start)) == 0) return true;
    return false;
}

static char *copied(const char *text)
{
    const size_t size_b = strlen(text) + 1;
    return memcpy(grow_zeroed(size_b, 1), text, size_b);
}

static void set(struct conditions *conditions, const char *name, const char *text, bool is_known)
{
    struct condition_macro *macro = find(conditions, name);
    if (!macro) {
        conditions->macros = grow(conditions->macros, conditions->count, &conditions->capacity, sizeof *macro);
        macro = &conditions->macros[conditions->count++];
        *macro = (struct condition_macro){.name = copied(name)};
    }
    free(macro->text);
    macro->text = text ? copied(text) : NULL;
    macro->is_known = is_known;
}

void conditions_define(struct conditions *conditions, const char *name, const char *text)
{
    set(conditions, name, text, true);
}

void conditions_undefine(struct conditions *conditions, const char *name)
{
    set(conditions, name, NULL, true);
}

void conditions_forget(struct conditions *conditions, const char *name)
{
    set(conditions, name, NULL, false);
}

void conditions_free(struct conditions *conditions)
{
    for (size_t i = 0; i < conditions->count; i++) {
        free(conditions->macros[i].name);
        free(conditions->macros[i].text);
    }
    free(conditions->macros);
    *conditions = (struct conditions){0};
}

enum known conditions_is_defined(const struct conditions *conditions, const char *name)
{
    const struct condition_macro *macro = find(conditions, name);
    if (!macro) return is_settled(conditions, name) ? KNOWN_FALSE : KNOWN_NOT;
    if (!macro->is_known) return KNOWN_NOT;
    return macro->text ? KNOWN_TRUE : KNOWN_FALSE;
}

static struct value read_or(struct reader *reader);

static void skip_blanks(struct reader *reader)
{
    while (isspace((unsigned char)*reader->at) || *reader->at == '\\')
        reader->at++;
}

static bool take(struct reader *reader, const char *sign)
{
    const size_t length = strlen(sign);
    skip_blanks(reader);
    if (strncmp(reader->at, sign, length) != 0) return false;
    reader->at += length;
    return true;
}

static bool take_name(struct reader *reader, char name[NAME_MAX_B])
{
    size_t length = 0;
    skip_blanks(reader);
    while (isalnum((unsigned char)reader->at[length]) || reader->at[length] == '_')
        length++;
    if (length == 0 || length >= NAME_MAX_B || isdigit((unsigned char)*reader->at)) return false;
    memcpy(name, reader->at, length);
    name[length] = '\0';
    reader->at += length;
    return true;
}

static struct value read_defined(struct reader *reader)
{
    char name[NAME_MAX_B];
    const bool has_bracket = take(reader, "(");
    if (!take_name(reader, name) || (has_bracket && !take(reader, ")"))) return NOT_KNOWN;
    const enum known known = conditions_is_defined(reader->conditions, name);
    return known == KNOWN_NOT ? NOT_KNOWN : number_value(known == KNOWN_TRUE);
}

static struct value both(struct value a, struct value b)
{
    if ((a.is_known && !a.number) || (b.is_known && !b.number)) return number_value(0);
    return a.is_known && b.is_known ? number_value(1) : NOT_KNOWN;
}

static struct value either(struct value a, struct value b)
{
    if ((a.is_known && a.number) || (b.is_known && b.number)) return number_value(1);
    return a.is_known && b.is_known ? number_value(0) : NOT_KNOWN;
}

/* LIM_EITHER(a, b) or LIM_BOTH(a, b), after the name. */
static struct value read_pair(struct reader *reader, struct value (*join)(struct value, struct value))
{
    if (!take(reader, "(")) return NOT_KNOWN;
    const struct value a = read_or(reader);
    if (!take(reader, ",")) return NOT_KNOWN;
    const struct value b = read_or(reader);
    return take(reader, ")") ? join(a, b) : NOT_KNOWN;
}

/* What follows a macro that is not known may be its arguments. */
static void skip_arguments(struct reader *reader)
{
    unsigned depth = 0;
    skip_blanks(reader);
    if (*reader->at != '(') return;
    do {
        depth += *reader->at == '(';
        depth -= *reader->at == ')';
        reader->at++;
    } while (depth && *reader->at);
}

static struct value read_macro(struct reader *reader, const char *name)
{
    const struct condition_macro *macro = find(reader->conditions, name);
    if (!macro && is_settled(reader->conditions, name)) return number_value(0);
    if (!macro || !macro->is_known || reader->depth >= DEPTH_MAX) {
        skip_arguments(reader);
        return NOT_KNOWN;
    }
    if (!macro->text) return number_value(0);
    struct reader inner = {reader->conditions, macro->text, reader->depth + 1};
    const struct value value = read_or(&inner);
    skip_blanks(&inner);
    return *inner.at ? NOT_KNOWN : value;
}

static struct value read_number(struct reader *reader)
{
    char *end;
    const long long number = strtoll(reader->at, &end, 0);
    if (end == reader->at) return NOT_KNOWN;
    while (*end == 'u' || *end == 'U' || *end == 'l' || *end == 'L')
        end++;
    reader->at = end;
    return number_value(number);
}

static struct value read_primary(struct reader *reader)
{
    char name[NAME_MAX_B];
    if (take(reader, "(")) {
        const struct value value = read_or(reader);
        return take(reader, ")") ? value : NOT_KNOWN;
    }
    if (!take_name(reader, name)) return read_number(reader);
    if (strcmp(name, "defined") == 0) return read_defined(reader);
    if (strcmp(name, "LIM_EITHER") == 0) return read_pair(reader, either);
    if (strcmp(name, "LIM_BOTH") == 0) return read_pair(reader, both);
    return read_macro(reader, name);
}

static struct value read_unary(struct reader *reader)
{
    skip_blanks(reader);
    if (reader->at[0] == '!' && reader->at[1] != '=') {
        reader->at++;
        const struct value value = read_unary(reader);
        return value.is_known ? number_value(!value.number) : NOT_KNOWN;
    }
    if (take(reader, "-")) {
        const struct value value = read_unary(reader);
        return value.is_known ? number_value(-value.number) : NOT_KNOWN;
    }
    return read_primary(reader);
}

static struct value read_sum(struct reader *reader)
{
    struct value sum = read_unary(reader);
    for (;;) {
        const int sign = take(reader, "+") ? 1 : take(reader, "-") ? -1 : 0;
        if (!sign) return sum;
        const struct value next = read_unary(reader);
        sum = (struct value){sum.number + sign * next.number, sum.is_known && next.is_known};
    }
}

static bool compare(const char *sign, long long a, long long b)
{
    switch (sign[0]) {
    case '<':
        return sign[1] ? a <= b : a < b;
    case '>':
        return sign[1] ? a >= b : a > b;
    default:
        return sign[0] == '=' ? a == b : a != b;
    }
}

static struct value read_comparison(struct reader *reader)
{
    static const char *const signs[] = {"<=", ">=", "==", "!=", "<", ">"};
    const struct value left = read_sum(reader);
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (!take(reader, signs[i])) continue;
        const struct value right = read_sum(reader);
        if (!left.is_known || !right.is_known) return NOT_KNOWN;
        return number_value(compare(signs[i], left.number, right.number));
    }
    return left;
}

static struct value read_and(struct reader *reader)
{
    struct value value = read_comparison(reader);
    while (take(reader, "&&"))
        value = both(value, read_comparison(reader));
    return value;
}

static struct value read_or(struct reader *reader)
{
    struct value value = read_and(reader);
    while (take(reader, "||"))
        value = either(value, read_and(reader));
    return value;
}

enum known conditions_ask(const struct conditions *conditions, const char *expression)
{
    struct reader reader = {conditions, expression, 0};
    const struct value value = read_or(&reader);
    skip_blanks(&reader);
    if (*reader.at || !value.is_known) return KNOWN_NOT;
    return value.number ? KNOWN_TRUE : KNOWN_FALSE;
}
