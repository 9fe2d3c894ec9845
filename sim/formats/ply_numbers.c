/* SPDX-License-Identifier: MIT */
#include "formats/ply_numbers.h"

#include "files/decimal.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

bool ply_numbers_begin(struct ply_numbers *numbers)
{
    return numbers->coding == PLY_TEXT ? text_next_line(&numbers->text) : numbers->text.at < numbers->text.end;
}

static double whole_of(uint64_t bits, enum ply_type type)
{
    switch (type) {
    case PLY_CHAR:
        return (int8_t)bits;
    case PLY_SHORT:
        return (int16_t)bits;
    case PLY_INT:
        return (int32_t)bits;
    default:
        return (double)bits;
    }
}

static double number_of(uint64_t bits, enum ply_type type)
{
    const uint32_t half = (uint32_t)bits;
    float f32;
    double f64;
    memcpy(&f32, &half, sizeof f32);
    memcpy(&f64, &bits, sizeof f64);
    if (type != PLY_FLOAT && type != PLY_DOUBLE) return whole_of(bits, type);
    const double number = type == PLY_FLOAT ? (double)f32 : f64;
    return fabs(number) <= (double)FLT_MAX ? number : NAN;
}

static bool byte_number(struct ply_numbers *numbers, enum ply_type type, double *value)
{
    const size_t size_b = ply_type_b(type);
    uint64_t bits = 0;
    if ((size_t)(numbers->text.end - numbers->text.at) < size_b) return false;
    for (size_t i = 0; i < size_b; i++) {
        const size_t at = numbers->coding == PLY_BIG ? i : size_b - 1 - i;
        bits = bits << 8 | (unsigned char)numbers->text.at[at];
    }
    numbers->text.at += size_b;
    *value = number_of(bits, type);
    return true;
}

bool ply_number(struct ply_numbers *numbers, enum ply_type type, double *value)
{
    struct word word;
    if (numbers->coding != PLY_TEXT) return byte_number(numbers, type, value);
    if (!text_word(&numbers->text, &word)) return false;
    if (!decimal_parse(word.text, word.length, value)) *value = NAN;
    return true;
}

bool ply_numbers_skip(struct ply_numbers *numbers, enum ply_type type, double count)
{
    const size_t left_b = (size_t)(numbers->text.end - numbers->text.at), size_b = ply_type_b(type);
    struct word word;
    if (numbers->coding == PLY_TEXT) {
        while (count > 0 && text_word(&numbers->text, &word))
            count--;
        return !(count > 0);
    }
    if (count * (double)size_b > (double)left_b) return false;
    numbers->text.at += (size_t)count * size_b;
    return true;
}

struct word ply_number_word(const struct ply_numbers *numbers)
{
    const char *end = numbers->text.at, *first = end;
    if (numbers->coding != PLY_TEXT) return (struct word){end, 0};
    while (!is_blank(first[-1]) && !is_line_end(first[-1]))
        first--;
    return (struct word){first, (size_t)(end - first)};
}
