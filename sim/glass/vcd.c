/* SPDX-License-Identifier: MIT
 *
 * A dump is words, with blanks between them: a header of commands that $end ends, then times and changes. Changes of
 * one instant are gathered until the next; if a signal changes twice in one, these are two. */
#include "glass/vcd.h"

#include "base/grow.h"
#include "base/input_file.h"

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum {
    WORD_MOST_B = 1 << 20,
    SIGNALS_MAX = 1000000,
    BITS_MAX = 1 << 20,
    PATH_MOST_B = 4096,
    WORDS_MAX = 8,
    PROGRESS_WORDS = 1 << 16,
    BYTES_BETWEEN_CHECKS = 1 << 16
};

struct vcd {
    struct capture *capture;
    FILE *file;
    size_t line; /* of the word, from 1 */
    char *word;
    size_t length, capacity;
    uint64_t read_b;  /* so far, of words and blanks */
    size_t next_line; /* behind the word */

    struct channels channels;
    char scope[PATH_MOST_B]; /* with a dot behind each */
    uint64_t unit_fs;        /* 0: nobody told */

    uint64_t all_b; /* of the file; 0: of a pipe */
    size_t words;   /* changes, or their parts, so far */

    uint64_t now;               /* in units */
    struct wire_levels levels;  /* at the end of this instant */
    uint8_t changed;            /* of it */
    bool has_changed, has_time; /* since the last instant; of the dump */
};

/* Words -------------------------------------------------------------------------------------- */

static bool fail(const struct vcd *vcd, struct error *err)
{
    char where[400];
    snprintf(where, sizeof where, "%.256s:%zu", vcd->capture->path, vcd->line);
    return error_prefix(err, where);
}

static bool put(struct vcd *vcd, int byte, struct error *err)
{
    if (vcd->length == WORD_MOST_B)
        return error_set(err, "a word of more than %d bytes", WORD_MOST_B) || fail(vcd, err);
    if (iscntrl(byte)) return error_set(err, "a byte %02Xh, which is no text", (unsigned)byte) || fail(vcd, err);
    vcd->word = grow(vcd->word, vcd->length, &vcd->capacity, 1);
    vcd->word[vcd->length++] = (char)byte;
    return true;
}

/* EOF at the end of the file, or of the time, with a text. */
static int next_byte(struct vcd *vcd, struct error *err)
{
    if (vcd->read_b++ % BYTES_BETWEEN_CHECKS == 0 && !capture_has_time_left(vcd->capture, err)) return EOF;
    return getc_unlocked(vcd->file);
}

/* false: there is none, and err->text is empty unless that is an error. */
static bool next_word(struct vcd *vcd, struct error *err)
{
    int byte;
    vcd->length = 0;
    while ((byte = next_byte(vcd, err)) != EOF && isspace(byte))
        vcd->next_line += byte == '\n';
    vcd->line = vcd->next_line;
    for (; byte != EOF && !isspace(byte); byte = next_byte(vcd, err))
        if (!put(vcd, byte, err)) return false;
    if (err->text[0]) return false;
    vcd->next_line += byte == '\n';
    if (ferror(vcd->file)) return error_set(err, "%s: %s", vcd->capture->path, strerror(errno));
    if (vcd->length == 0) return false;
    vcd->word = grow(vcd->word, vcd->length, &vcd->capacity, 1);
    vcd->word[vcd->length] = '\0';
    return true;
}

static bool is_word(const struct vcd *vcd, const char *text)
{
    return strcmp(vcd->word, text) == 0;
}

/* Where there must be one. */
static bool need_word(struct vcd *vcd, const char *what, struct error *err)
{
    if (next_word(vcd, err)) return true;
    return !err->text[0] && (error_set(err, "the file ends within %s: was it cut off?", what) || fail(vcd, err));
}

static bool skip_to_end(struct vcd *vcd, const char *what, struct error *err)
{
    do
        if (!need_word(vcd, what, err)) return false;
    while (!is_word(vcd, "$end"));
    return true;
}

/* The header --------------------------------------------------------------------------------- */

/* All words up to $end, those behind the first few left out; to be freed. */
static bool take_words(struct vcd *vcd, const char *what, char *words[WORDS_MAX], size_t *count, struct error *err)
{
    for (*count = 0; need_word(vcd, what, err);) {
        if (is_word(vcd, "$end")) return true;
        if (*count < WORDS_MAX) words[(*count)++] = strdup(vcd->word);
    }
    return false;
}

static void free_words(char *words[WORDS_MAX], size_t count)
{
    for (size_t i = 0; i < count; i++)
        free(words[i]);
}

/* `10 ns` or `10ns` */
static bool set_unit(struct vcd *vcd, char *const words[WORDS_MAX], size_t count, struct error *err)
{
    static const char *const names[] = {"fs", "ps", "ns", "us", "ms", "s"};
    char text[32] = "", *unit;
    for (size_t i = 0; i < count; i++)
        strncat(text, words[i], sizeof text - strlen(text) - 1);
    const unsigned long number = strtoul(text, &unit, 10);
    vcd->unit_fs = number;
    for (int i = 0; i < 6; i++, vcd->unit_fs *= 1000)
        if (strcmp(unit, names[i]) == 0 && (number == 1 || number == 10 || number == 100)) return true;
    return error_set(err, "$timescale '%s' is not 1, 10 or 100 of s, ms, us, ns, ps or fs", text) || fail(vcd, err);
}

static bool enter_scope(struct vcd *vcd, char *const words[WORDS_MAX], size_t count, struct error *err)
{
    const size_t length = strlen(vcd->scope);
    const char *name = count > 1 ? words[1] : count ? words[0] : "";
    if (length + strlen(name) + 2 > sizeof vcd->scope)
        return error_set(err, "scopes with names of more than %d bytes", PATH_MOST_B) || fail(vcd, err);
    snprintf(vcd->scope + length, sizeof vcd->scope - length, "%s.", name);
    return true;
}

static void leave_scope(struct vcd *vcd)
{
    const size_t length = strlen(vcd->scope);
    if (length == 0) return;
    vcd->scope[length - 1] = '\0';
    char *const dot = strrchr(vcd->scope, '.');
    if (dot)
        dot[1] = '\0';
    else
        vcd->scope[0] = '\0';
}

/* [7:0] of several bits; [3] of one is a part of its name. */
static void set_range(struct channel *channel, const char *range)
{
    int first, last;
    channel->first_bit_index = (int)channel->bits - 1;
    channel->counts_down = true;
    if (!range || sscanf(range, "[%d:%d]", &first, &last) != 2) return;
    channel->first_bit_index = first;
    channel->counts_down = first >= last;
}

/* The words of a name, which may have blanks: sigrok and Logic write channels as people call them. Of a range that is
 * joined to the last word, or a word of its own, only [3] of one bit is a part of the name. NULL: there is none. */
static const char *join_name(char *name, size_t size_b, char *const *words, size_t count)
{
    const char *range = NULL;
    name[0] = '\0';
    for (size_t i = 0; i < count && !range; i++) {
        const char *bracket = strrchr(words[i], '['), *colon = bracket ? strchr(bracket, ':') : NULL;
        const size_t length = strlen(name), word_b = colon ? (size_t)(bracket - words[i]) : strlen(words[i]);
        range = colon ? bracket : NULL;
        const bool is_apart = i > 0 && word_b > 0 && words[i][0] != '[';
        snprintf(name + length, size_b - length, "%s%.*s", is_apart ? " " : "", (int)word_b, words[i]);
    }
    return range;
}

/* TYPE BITS ID NAME [RANGE] */
static bool add_signal(struct vcd *vcd, char *const words[WORDS_MAX], size_t count, struct error *err)
{
    char *end, name[PATH_MOST_B], path[2 * PATH_MOST_B];
    const unsigned long bits = count >= 4 ? strtoul(words[1], &end, 10) : 0;
    if (count < 4 || *end || bits > BITS_MAX)
        return error_set(err, "$var is not followed by type, bits, id and name") || fail(vcd, err);
    if (vcd->channels.count == SIGNALS_MAX)
        return error_set(err, "more than %d signals", SIGNALS_MAX) || fail(vcd, err);
    struct channel channel = {.bits = (unsigned)bits};
    const char *range = join_name(name, sizeof name, words + 3, count - 3);
    snprintf(path, sizeof path, "%s%s", vcd->scope, name);
    set_range(&channel, range);
    channel.path = strdup(path);
    channel.id = strdup(words[2]);
    channels_add(&vcd->channels, channel);
    return true;
}

static bool take_section(struct vcd *vcd, const char *name, struct error *err)
{
    char *words[WORDS_MAX];
    size_t count;
    bool ok = take_words(vcd, name, words, &count, err);
    if (ok && strcmp(name, "$timescale") == 0) ok = set_unit(vcd, words, count, err);
    if (ok && strcmp(name, "$scope") == 0) ok = enter_scope(vcd, words, count, err);
    if (ok && strcmp(name, "$upscope") == 0) leave_scope(vcd);
    if (ok && strcmp(name, "$var") == 0) ok = add_signal(vcd, words, count, err);
    free_words(words, count);
    return ok;
}

/* Up to $enddefinitions. Sections that say nothing of signals may be long: nothing of them is kept. */
static bool read_header(struct vcd *vcd, struct error *err)
{
    static const char *const kept[] = {"$timescale", "$scope", "$upscope", "$var"};
    while (need_word(vcd, "its header", err)) {
        const char *name = NULL;
        if (vcd->word[0] != '$') return error_set(err, "'%.40s' in the header of a VCD", vcd->word) || fail(vcd, err);
        if (is_word(vcd, "$enddefinitions")) return skip_to_end(vcd, "its header", err);
        for (int i = 0; i < 4; i++)
            if (is_word(vcd, kept[i])) name = kept[i];
        if (!(name ? take_section(vcd, name, err) : skip_to_end(vcd, "its header", err))) return false;
    }
    return false;
}

/* Changes ------------------------------------------------------------------------------------ */

/* In ns; what is beyond 584 years is none. */
static uint64_t now_ns(const struct vcd *vcd)
{
    return vcd->unit_fs >= 1000000 ? vcd->now * (vcd->unit_fs / 1000000) : vcd->now / (1000000 / vcd->unit_fs);
}

/* What has changed so far, changes now. */
static bool commit(struct vcd *vcd, struct error *err)
{
    const bool has_changed = vcd->has_changed;
    vcd->has_changed = false;
    vcd->changed = 0;
    return !has_changed || capture_levels(vcd->capture, now_ns(vcd), vcd->levels, err);
}

static bool take_time(struct vcd *vcd, struct error *err)
{
    char *end;
    if (!commit(vcd, err)) return false;
    errno = 0;
    const unsigned long long now = strtoull(vcd->word + 1, &end, 10);
    const uint64_t most = UINT64_MAX / (vcd->unit_fs >= 1000000 ? vcd->unit_fs / 1000000 : 1);
    if (vcd->word[1] < '0' || vcd->word[1] > '9' || *end || errno || now > most)
        return error_set(err, "'%.40s' is no time", vcd->word) || fail(vcd, err);
    if (vcd->has_time && now < vcd->now)
        return error_set(err, "time goes back from #%" PRIu64 " to #%llu", vcd->now, now) || fail(vcd, err);
    vcd->now = now;
    vcd->has_time = true;
    return true;
}

static bool set_level(struct vcd *vcd, enum capture_wire wire, char value, struct error *err)
{
    const uint8_t bit = (uint8_t)(1u << wire);
    const bool high = strchr("1hH", value), known = high || strchr("0lL", value);
    struct wire_levels *levels = &vcd->levels;
    if (vcd->changed & bit && (high != ((levels->high & bit) != 0) || known == ((levels->unknown & bit) != 0)) &&
        !commit(vcd, err))
        return false;
    levels->high = (uint8_t)(high ? levels->high | bit : levels->high & ~bit);
    levels->unknown = (uint8_t)(known ? levels->unknown & ~bit : levels->unknown | bit);
    vcd->changed |= bit;
    vcd->has_changed = true;
    return true;
}

/* Of several bits the first ones may be left out: they are 0, or as the first that is there if that is x or z. */
static char value_of(const char *values, size_t count, unsigned bits, unsigned bit)
{
    const size_t left_out = bits > count ? bits - count : 0;
    if (bit >= left_out) return values[bit - left_out];
    return values[0] == 'x' || values[0] == 'X' || values[0] == 'z' || values[0] == 'Z' ? values[0] : '0';
}

static bool set_signal(struct vcd *vcd, const char *values, size_t count, const char *id, struct error *err)
{
    for (int i = 0; i < CAPTURE_WIRES; i++) {
        const struct channel_bit *at = &vcd->capture->wire[i];
        if (!at->channel || strcmp(at->channel->id, id) != 0) continue;
        if (!set_level(vcd, (enum capture_wire)i, value_of(values, count, at->channel->bits, at->bit), err))
            return false;
    }
    return true;
}

/* bVALUES ID: rREAL ID and sTEXT ID are no wires. */
static bool take_values(struct vcd *vcd, struct error *err)
{
    char *const values = strdup(vcd->word + 1);
    bool ok = need_word(vcd, "a change", err);
    const size_t count = strlen(values);
    if (ok && (count == 0 || strspn(values, "01xXzZuUwWlLhH-") != count))
        ok = error_set(err, "'%.40s' are no values of bits", values) || fail(vcd, err);
    if (ok) ok = set_signal(vcd, values, count, vcd->word, err);
    free(values);
    return ok;
}

static bool take_change(struct vcd *vcd, struct error *err)
{
    switch (vcd->word[0]) {
    case '#':
        return take_time(vcd, err);
    case 'b':
    case 'B':
        return take_values(vcd, err);
    case 'r':
    case 'R':
    case 's':
    case 'S':
        return need_word(vcd, "a change", err);
    case '$':
        return !is_word(vcd, "$comment") || skip_to_end(vcd, "a comment", err);
    default:
        break;
    }
    if (!strchr("01xXzZuUwWlLhH-", vcd->word[0]))
        return error_set(err, "'%.40s' is no change of a signal", vcd->word) || fail(vcd, err);
    if (!vcd->word[1]) return error_set(err, "a change of a signal without a name") || fail(vcd, err);
    return set_signal(vcd, vcd->word, 1, vcd->word + 1, err);
}

static bool read_changes(struct vcd *vcd, struct error *err)
{
    for (; next_word(vcd, err); vcd->words++) {
        if (vcd->words % PROGRESS_WORDS == 0)
            capture_tell_progress(vcd->capture, (uint64_t)ftello(vcd->file), vcd->all_b);
        if (!take_change(vcd, err)) return false;
    }
    if (err->text[0] || !commit(vcd, err)) return false;
    vcd->capture->now_ns = now_ns(vcd);
    return true;
}

/* All of it ---------------------------------------------------------------------------------- */

static bool read_all(struct vcd *vcd, struct error *err)
{
    if (!read_header(vcd, err)) return false;
    if (!vcd->unit_fs) return error_set(err, "%s: no $timescale", vcd->capture->path);
    if (!capture_begin(vcd->capture, &vcd->channels, 0, true, err)) return false;
    for (int i = 0; i < CAPTURE_WIRES; i++)
        if (vcd->capture->wire[i].channel) vcd->levels.unknown |= (uint8_t)(1u << i);
    return read_changes(vcd, err);
}

bool vcd_read(struct capture *capture, FILE *file, struct error *err)
{
    struct vcd vcd = {.capture = capture, .file = file, .line = 1, .next_line = 1 + capture->lines_before};
    struct stat about;
    if (input_is_regular(file) && fstat(fileno(file), &about) == 0) vcd.all_b = (uint64_t)about.st_size;
    const bool ok = read_all(&vcd, err);
    channels_free(&vcd.channels);
    free(vcd.word);
    return ok;
}
