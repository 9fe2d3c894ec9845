/* SPDX-License-Identifier: MIT
 *
 * Line by line. A file is joined in memory first, so that one of which only comments are left can be dropped. Include
 * guards are conditions like others. */
#include "export/amalgam.h"

#include "base/grow.h"
#include "export/embedded.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { CONDITIONS_MAX = 32, NAME_MAX_B = 128, LINE_MAX_B = 8192 };

/* An #if with its #elif and #else: what became of it so far. */
struct condition {
    enum known taken; /* KNOWN_TRUE: a part was certain, what follows is dropped; KNOWN_NOT: written for the compiler */
    bool is_read;     /* the present part is not dropped */
};

struct join {
    struct amalgam *amalgam;
    const char *path;
    unsigned line;
    struct condition conditions[CONDITIONS_MAX];
    unsigned depth;
    FILE *out;
    struct error *err;
};

static bool fail(const struct join *join, const char *what)
{
    return error_set(join->err, "%s:%u: %s", join->path, join->line, what);
}

static bool is_read(const struct join *join)
{
    return join->depth == 0 || join->conditions[join->depth - 1].is_read;
}

/* Under a condition that the compiler decides. */
static bool is_uncertain(const struct join *join)
{
    for (unsigned i = 0; i < join->depth; i++)
        if (join->conditions[i].taken == KNOWN_NOT) return true;
    return false;
}

static bool join_once(struct amalgam *amalgam, const char *name)
{
    for (size_t i = 0; i < amalgam->count; i++)
        if (strcmp(amalgam->joined[i], name) == 0) return false;
    amalgam->joined = grow(amalgam->joined, amalgam->count, &amalgam->capacity, sizeof *amalgam->joined);
    amalgam->joined[amalgam->count++] = strcpy(grow_zeroed(strlen(name) + 1, 1), name);
    return true;
}

/* The text after a directive's word; NULL: it is another one. */
static const char *directive(const char *line, const char *word)
{
    const size_t length = strlen(word);
    while (isspace((unsigned char)*line))
        line++;
    if (*line++ != '#') return NULL;
    while (isspace((unsigned char)*line))
        line++;
    if (strncmp(line, word, length) != 0 || isalnum((unsigned char)line[length])) return NULL;
    line += length;
    while (isspace((unsigned char)*line))
        line++;
    return line;
}

static void copy_name(char name[NAME_MAX_B], const char *text)
{
    size_t length = 0;
    while ((isalnum((unsigned char)text[length]) || text[length] == '_') && length + 1 < NAME_MAX_B)
        length++;
    memcpy(name, text, length);
    name[length] = '\0';
}

static enum known ask_name(struct join *join, const char *text)
{
    char name[NAME_MAX_B];
    copy_name(name, text);
    return conditions_is_defined(&join->amalgam->conditions, name);
}

static enum known negated(enum known known)
{
    return known == KNOWN_NOT ? KNOWN_NOT : known == KNOWN_TRUE ? KNOWN_FALSE : KNOWN_TRUE;
}

/* The answer of a line that begins a condition, or false. */
static bool asks(struct join *join, const char *line, enum known *answer)
{
    const char *text;
    if ((text = directive(line, "ifdef")))
        *answer = ask_name(join, text);
    else if ((text = directive(line, "ifndef")))
        *answer = negated(ask_name(join, text));
    else if ((text = directive(line, "if")))
        *answer = conditions_ask(&join->amalgam->conditions, text);
    else
        return false;
    return true;
}

static bool begin_condition(struct join *join, const char *line, enum known answer)
{
    if (join->depth == CONDITIONS_MAX) return fail(join, "conditions are nested too deep");
    const bool outside = is_read(join);
    if (outside && answer == KNOWN_NOT) fputs(line, join->out);
    join->conditions[join->depth++] =
        (struct condition){outside ? answer : KNOWN_TRUE, outside && answer != KNOWN_FALSE};
    return true;
}

/* After an #if that was dropped an #elif that only the compiler can answer is its #if. */
static bool next_condition(struct join *join, const char *line, const char *text)
{
    struct condition *condition = &join->conditions[join->depth - 1];
    if (condition->taken == KNOWN_TRUE) {
        condition->is_read = false;
        return true;
    }
    const enum known answer = conditions_ask(&join->amalgam->conditions, text);
    if (condition->taken == KNOWN_NOT) {
        fputs(line, join->out);
        return true;
    }
    if (answer == KNOWN_NOT) fprintf(join->out, "#if %s", text);
    *condition = (struct condition){answer, answer != KNOWN_FALSE};
    return true;
}

static bool last_condition(struct join *join, const char *line)
{
    struct condition *condition = &join->conditions[join->depth - 1];
    if (condition->taken == KNOWN_NOT)
        fputs(line, join->out);
    else
        condition->is_read =
            condition->taken == KNOWN_FALSE && (join->depth == 1 || join->conditions[join->depth - 2].is_read);
    if (condition->taken == KNOWN_FALSE) condition->taken = KNOWN_TRUE;
    return true;
}

/* Whether the line belongs to a condition; *ok: it could be followed. */
static bool follows_condition(struct join *join, const char *line, bool *ok)
{
    const char *text;
    enum known answer;
    if (asks(join, line, &answer)) {
        *ok = begin_condition(join, line, answer);
        return true;
    }
    const bool is_next = (text = directive(line, "elif")) != NULL, is_last = directive(line, "else") != NULL;
    if (!is_next && !is_last && !directive(line, "endif")) return false;
    if (join->depth == 0) {
        *ok = fail(join, "a condition ends that did not begin");
        return true;
    }
    if (is_next)
        *ok = next_condition(join, line, text);
    else if (is_last)
        *ok = last_condition(join, line);
    else if (join->conditions[--join->depth].taken == KNOWN_NOT)
        fputs(line, join->out);
    return true;
}

static const struct embedded *find_in(const char *folder, size_t folder_b, const char *name)
{
    char path[NAME_MAX_B * 2];
    if (snprintf(path, sizeof path, "%.*s%s", (int)folder_b, folder, name) >= (int)sizeof path) return NULL;
    return embedded_find(path);
}

static const struct embedded *find_header(const struct join *join, const char *name)
{
    const char *slash = strrchr(join->path, '/');
    const struct embedded *found = slash ? find_in(join->path, (size_t)(slash + 1 - join->path), name) : NULL;
    for (const char *const *folder = join->amalgam->folders; !found && *folder; folder++)
        found = find_in(*folder, strlen(*folder), name);
    return found;
}

static const char *alias(const struct amalgam *amalgam, const char *name)
{
    for (const char *const *pair = amalgam->aliases; pair && *pair; pair += 2)
        if (strcmp(pair[0], name) == 0) return pair[1];
    return name;
}

/* By its name, which no other header has. */
static bool is_joined(const struct amalgam *amalgam, const char *name)
{
    const size_t name_b = strlen(name);
    for (size_t i = 0; i < amalgam->count; i++) {
        const char *path = amalgam->joined[i];
        const size_t path_b = strlen(path);
        if (path_b > name_b && path[path_b - name_b - 1] == '/' && strcmp(path + path_b - name_b, name) == 0)
            return true;
    }
    return false;
}

static bool include_own(struct join *join, const char *text)
{
    char name[NAME_MAX_B];
    const char *end = strchr(text + 1, '"');
    if (!end || end - text - 1 >= NAME_MAX_B) return fail(join, "an include that is not understood");
    memcpy(name, text + 1, (size_t)(end - text - 1));
    name[end - text - 1] = '\0';
    if (is_joined(join->amalgam, alias(join->amalgam, name))) return true;
    const struct embedded *header = find_header(join, alias(join->amalgam, name));
    if (!header) return error_set(join->err, "%s:%u: no header %s", join->path, join->line, name);
    if (is_uncertain(join)) return fail(join, "a header under a condition that only a compiler can decide");
    return amalgam_add_text(join->amalgam, header->path, header->text, join->out, join->err);
}

static bool include(struct join *join, const char *line, const char *text)
{
    if (*text == '"') return include_own(join, text);
    if (*text != '<') return fail(join, "an include that is not understood");
    if (is_uncertain(join) || join_once(join->amalgam, text)) fputs(line, join->out);
    return true;
}

/* The value, without a comment behind it. */
static void define(struct join *join, const char *text)
{
    char name[NAME_MAX_B], value[LINE_MAX_B];
    copy_name(name, text);
    text += strlen(name);
    if (*text == '(' || is_uncertain(join)) {
        conditions_forget(&join->amalgam->conditions, name);
        return;
    }
    snprintf(value, sizeof value, "%s", text);
    char *comment = strstr(value, "/*");
    if (comment) *comment = '\0';
    conditions_define(&join->amalgam->conditions, name, value);
}

static void undefine(struct join *join, const char *text)
{
    char name[NAME_MAX_B];
    copy_name(name, text);
    if (is_uncertain(join))
        conditions_forget(&join->amalgam->conditions, name);
    else
        conditions_undefine(&join->amalgam->conditions, name);
}

/* A guard's own #define is of no use any more. */
static bool is_guard(const char *text)
{
    char name[NAME_MAX_B];
    copy_name(name, text);
    const size_t length = strlen(name);
    return length > 2 && strcmp(name + length - 2, "_H") == 0 && text[length + strspn(text + length, " \t")] == '\n';
}

static bool join_line(struct join *join, const char *line)
{
    const char *text;
    bool ok = true;
    if (follows_condition(join, line, &ok) || !is_read(join)) return ok;
    if ((text = directive(line, "include"))) return include(join, line, text);
    if ((text = directive(line, "define"))) {
        define(join, text);
        if (is_guard(text)) return true;
    }
    if ((text = directive(line, "undef"))) undefine(join, text);
    fputs(line, join->out);
    return true;
}

/* A line with those that continue it. NULL: it is too long. */
static const char *take_line(const char *at, char line[LINE_MAX_B], unsigned *lines)
{
    size_t length = 0;
    *lines = 0;
    do {
        const char *end = strchr(at, '\n');
        const size_t more = end ? (size_t)(end + 1 - at) : strlen(at);
        if (length + more >= LINE_MAX_B) return NULL;
        memcpy(line + length, at, more);
        length += more;
        at += more;
        ++*lines;
    } while (*at && length >= 2 && line[length - 2] == '\\');
    line[length] = '\0';
    return at;
}

static bool join_text(struct join *join, const char *text)
{
    char line[LINE_MAX_B];
    for (unsigned lines = 0; *text; join->line += lines) {
        text = take_line(text, line, &lines);
        if (!text) return fail(join, "a line is too long");
        if (!join_line(join, line)) return false;
    }
    return join->depth == 0 || fail(join, "a condition does not end");
}

/* Whether there is anything but comments and blanks. */
static bool has_code(const char *text)
{
    while (*text) {
        if (text[0] == '/' && text[1] == '*') {
            text = strstr(text, "*/");
            if (!text) return false;
            text += 2;
        } else if (!isspace((unsigned char)*text++)) {
            return true;
        }
    }
    return false;
}

/* One blank line at most in a row, none at the end, and the file's name where its licence was. */
static void put_joined(const char *path, const char *text, FILE *out)
{
    static const char licence[] = "/* SPDX-License-Identifier: MIT";
    unsigned blanks = 1;
    fprintf(out, "\n/* -- %s -- */\n", path);
    if (strncmp(text, licence, sizeof licence - 1) == 0) {
        text += sizeof licence - 1;
        if (strncmp(text, " */\n", 4) == 0)
            text += 4;
        else {
            text += strspn(text, "\n *");
            fputs("/* ", out);
        }
    }
    for (const char *end; *text; text = end) {
        end = strchr(text, '\n');
        end = end ? end + 1 : text + strlen(text);
        blanks = *text == '\n' ? blanks + 1 : 0;
        if (blanks < 2 && (*text != '\n' || *end)) fwrite(text, 1, (size_t)(end - text), out);
    }
}

bool amalgam_add_text(struct amalgam *amalgam, const char *path, const char *text, FILE *out, struct error *err)
{
    char *joined = NULL;
    size_t joined_b = 0;
    join_once(amalgam, path);
    FILE *memory = open_memstream(&joined, &joined_b);
    if (!memory) return error_set(err, "%s: no memory", path);
    struct join join = {.amalgam = amalgam, .path = path, .line = 1, .out = memory, .err = err};
    const bool ok = join_text(&join, text);
    fclose(memory);
    if (ok && has_code(joined)) put_joined(path, joined, out);
    free(joined);
    return ok;
}

bool amalgam_add(struct amalgam *amalgam, const char *path, FILE *out, struct error *err)
{
    const struct embedded *file = embedded_find(path);
    if (!file) return error_set(err, "%s: no such source", path);
    return amalgam_add_text(amalgam, path, file->text, out, err);
}

void amalgam_free(struct amalgam *amalgam)
{
    for (size_t i = 0; i < amalgam->count; i++)
        free(amalgam->joined[i]);
    free(amalgam->joined);
    conditions_free(&amalgam->conditions);
    *amalgam = (struct amalgam){0};
}
