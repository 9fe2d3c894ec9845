/* SPDX-License-Identifier: MIT
 *
 * How much two words differ is their edit distance with exchanged neighbours, which count as one (optimal string
 * alignment). */
#include "base/choice.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { LONGEST = 40, LETTERS_A_DIFFERENCE = 3, MOST_DIFFERENCES = 3, LIST_B = 320 };

const char *choice_in_array(const void *list, size_t index)
{
    return ((const char *const *)list)[index];
}

bool choice_is(const char *text, size_t length, const char *word)
{
    return strlen(word) == length && strncasecmp(text, word, length) == 0;
}

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static bool same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* rows[i][k]: between the first i letters of a and the first k of b. */
static unsigned distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    unsigned rows[LONGEST + 1][LONGEST + 1];
    for (unsigned i = 0; i <= a_length; i++)
        rows[i][0] = i;
    for (unsigned k = 0; k <= b_length; k++)
        rows[0][k] = k;
    for (size_t i = 1; i <= a_length; i++)
        for (size_t k = 1; k <= b_length; k++) {
            const bool is_exchanged = i > 1 && k > 1 && same(a[i - 1], b[k - 2]) && same(a[i - 2], b[k - 1]);
            rows[i][k] =
                least(rows[i - 1][k - 1] + !same(a[i - 1], b[k - 1]), least(rows[i - 1][k], rows[i][k - 1]) + 1);
            if (is_exchanged) rows[i][k] = least(rows[i][k], rows[i - 2][k - 2] + 1);
        }
    return rows[a_length][b_length];
}

const char *choice_nearest(choice_word *word, const void *list, const char *text, size_t length)
{
    const char *nearest = NULL;
    unsigned fewest = least((unsigned)length / LETTERS_A_DIFFERENCE, MOST_DIFFERENCES) + 1;
    const char *at;
    if (length > LONGEST) return NULL;
    for (size_t i = 0; (at = word(list, i)); i++) {
        const size_t at_length = strlen(at);
        const unsigned differ = at_length > LONGEST ? fewest : distance(text, length, at, at_length);
        if (differ >= fewest) continue;
        fewest = differ;
        nearest = at;
    }
    return nearest;
}

static bool refuse(const struct choice *choice, const char *text, size_t length, const char *also, struct error *err)
{
    char names[LIST_B] = "";
    const char *nearest = choice_nearest(choice->word, choice->list, text, length), *word;
    for (size_t i = 0; (word = choice->word(choice->list, i)); i++) {
        const size_t used = strlen(names);
        const bool is_last = !also && !choice->word(choice->list, i + 1);
        snprintf(names + used, sizeof names - used, "%s%s", !i ? "" : is_last ? " and " : ", ", word);
    }
    return error_set(err, "%s %.*s: no such %s%s%s%s; there are %s%s%s", choice->option, (int)length, text,
                     choice->kind, nearest ? ", is it " : "", nearest ? nearest : "", nearest ? "?" : "", names,
                     also ? ", and " : "", also ? also : "");
}

bool choice_find_part(const struct choice *choice, const char *text, size_t length, const char *also, size_t *index,
                      struct error *err)
{
    const char *word;
    for (size_t i = 0; (word = choice->word(choice->list, i)); i++) {
        *index = i;
        if (choice_is(text, length, word)) return true;
    }
    return refuse(choice, text, length, also, err);
}

bool choice_find(const struct choice *choice, const char *text, size_t *index, struct error *err)
{
    return choice_find_part(choice, text, strlen(text), NULL, index, err);
}
