/* SPDX-License-Identifier: MIT */
#include "files/utf16.h"

#include "base/grow.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum { LETTER_MOST_B = 3 }; /* of UTF-8, for each unit of UTF-16 */

static bool is_high(uint32_t unit)
{
    return unit >= 0xD800 && unit < 0xDC00;
}

static bool is_low(uint32_t unit)
{
    return unit >= 0xDC00 && unit < 0xE000;
}

static size_t put(char *out, uint32_t letter)
{
    const size_t more = letter < 0x80 ? 0 : letter < 0x800 ? 1 : letter < 0x10000 ? 2 : 3;
    static const uint8_t first[] = {0, 0xC0, 0xE0, 0xF0};
    for (size_t i = more; i > 0; i--, letter >>= 6)
        out[i] = (char)(0x80 | (letter & 0x3F));
    out[0] = (char)(first[more] | letter);
    return more + 1;
}

static uint32_t unit_at(const struct whole_file *file, size_t i)
{
    const uint8_t *bytes = (const uint8_t *)file->bytes + 2 * i;
    const bool is_big = (uint8_t)file->bytes[0] == 0xFE;
    return is_big ? (uint32_t)(bytes[0] << 8 | bytes[1]) : (uint32_t)(bytes[1] << 8 | bytes[0]);
}

void utf8_from_utf16(struct whole_file *file)
{
    if (whole_file_mark_b(file->bytes, file->size_b) != WHOLE_FILE_UTF16) return;
    const size_t count = file->size_b / 2;
    struct whole_file out = {grow_zeroed(LETTER_MOST_B * count + 1, 1), 0};
    for (size_t i = 1; i < count; i++) {
        uint32_t letter = unit_at(file, i);
        const uint32_t next = is_high(letter) && i + 1 < count ? unit_at(file, i + 1) : 0;
        if (is_low(next)) {
            letter = 0x10000 + ((letter - 0xD800) << 10) + (next - 0xDC00);
            i++;
        } else if (is_high(letter) || is_low(letter)) {
            letter = '?';
        }
        out.size_b += put(out.bytes + out.size_b, letter);
    }
    whole_file_free(file);
    *file = out;
}
