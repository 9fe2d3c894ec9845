/* SPDX-License-Identifier: MIT */
#include "files/name_forms.h"

#include "base/hex.h"

#include <string.h>

static bool is_blank_at(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* %20 becomes a blank. */
static void decode_percent(char *name)
{
    char *to = name;
    for (const char *from = name; *from; to++) {
        const int high = *from == '%' ? hex_digit(from[1]) : -1, low = high >= 0 ? hex_digit(from[2]) : -1;
        *to = *from;
        if (low >= 0) *to = (char)(high << 4 | low);
        if (*to == '\\') *to = '/';
        if (*to == '\0') *to = '?';
        from += low >= 0 ? 3 : 1;
    }
    *to = '\0';
}

static void strip(char *name)
{
    size_t first = 0, length = strlen(name);
    while (length > first && is_blank_at(name[length - 1]))
        length--;
    while (first < length && is_blank_at(name[first]))
        first++;
    const bool is_quoted = length - first >= 2 && (name[first] == '"' || name[first] == '\'');
    if (is_quoted && name[length - 1] == name[first]) first++, length--;
    memmove(name, name + first, length - first);
    name[length - first] = '\0';
}

/* Takes the form that stands behind the last one, unless there is such a one. */
static void keep(struct name_forms *forms)
{
    for (size_t i = 0; i < forms->count; i++)
        if (strcmp(forms->forms[i], forms->forms[forms->count]) == 0) return;
    forms->count++;
}

bool name_forms_of(const char *name, struct name_forms *out)
{
    out->count = 0;
    if (strlen(name) >= NAME_FORM_B) return false;
    for (int kind = 0; kind < NAME_FORMS_MOST; kind++) {
        char *form = out->forms[out->count];
        strcpy(form, name);
        for (char *c = form; *c; c++)
            if (*c == '\\') *c = '/';
        if (kind & 2) strip(form);
        if (kind & 1) decode_percent(form);
        keep(out);
    }
    return true;
}

const char *name_bare(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}
