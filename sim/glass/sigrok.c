/* SPDX-License-Identifier: MIT
 *
 * libarchive reads zip. Its entries come in the order in which they lie in the file; whoever packed it anew may have
 * changed that, so what is not found behind the last one is looked for from the beginning. */
#include "glass/sigrok.h"

#include <archive.h>
#include <archive_entry.h>
#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { BLOCK_B = 1 << 16, METADATA_MOST_B = 1 << 20, VERSION_MOST_B = 16, NAME_B = 256, CHANNELS_MAX = 64 };
static const uint64_t RATE_MOST_HZ = 1000000000000;

struct sigrok {
    struct capture *capture;
    struct archive *archive;
    struct channels channels;
    char *metadata;
    unsigned sample_b;
    uint64_t rate_hz;       /* 0: nobody knows */
    char capture_file[200]; /* how the samples' names begin */
    uint8_t wire_of_bit[CHANNELS_MAX];
    uint64_t mask, last; /* bits that are wires; these in the last sample */
    uint64_t sample;     /* of the next one, its number */
    uint8_t left[8];     /* of a sample that two blocks share */
    unsigned left_b;
    unsigned parts; /* entries with samples */
    bool is_dense;  /* there is a part 1 */
};

/* The archive -------------------------------------------------------------------------------- */

static bool refuse(const struct sigrok *sigrok, struct error *err)
{
    const char *why = archive_error_string(sigrok->archive);
    return error_set(err, "%s: %s", sigrok->capture->path, why ? why : "not a readable zip archive");
}

static bool reopen(struct sigrok *sigrok, struct error *err)
{
    if (sigrok->archive) archive_read_free(sigrok->archive);
    sigrok->archive = archive_read_new();
    if (!sigrok->archive) return error_set(err, "%s: out of memory", sigrok->capture->path);
    archive_read_support_format_zip(sigrok->archive);
    return archive_read_open_filename(sigrok->archive, sigrok->capture->path, BLOCK_B) == ARCHIVE_OK ||
           refuse(sigrok, err);
}

/* The next entry's name; NULL at the end, and with a text on an error. */
static const char *next_entry(struct sigrok *sigrok, struct error *err)
{
    struct archive_entry *entry;
    if (!capture_has_time_left(sigrok->capture, err)) return NULL;
    const int code = archive_read_next_header(sigrok->archive, &entry);
    if (code == ARCHIVE_EOF) return NULL;
    const char *name = code == ARCHIVE_OK || code == ARCHIVE_WARN ? archive_entry_pathname(entry) : NULL;
    if (!name) refuse(sigrok, err);
    return name;
}

static bool find_behind(struct sigrok *sigrok, const char *wanted, struct error *err)
{
    const char *name;
    while ((name = next_entry(sigrok, err)))
        if (strcmp(name, wanted) == 0) return true;
    return false;
}

/* false: there is none, or an error, with a text. */
static bool find(struct sigrok *sigrok, const char *wanted, struct error *err)
{
    return find_behind(sigrok, wanted, err) ||
           (!err->text[0] && reopen(sigrok, err) && find_behind(sigrok, wanted, err));
}

/* An entry as text, to be freed. */
static char *read_text(struct sigrok *sigrok, const char *name, size_t most_b, struct error *err)
{
    if (!find(sigrok, name, err)) {
        if (!err->text[0])
            error_set(err, "%s: a zip archive without '%s': not a session of sigrok's", sigrok->capture->path, name);
        return NULL;
    }
    char *text = malloc(most_b + 1);
    const la_ssize_t got_b = text ? archive_read_data(sigrok->archive, text, most_b + 1) : -1;
    if (got_b >= 0 && (size_t)got_b <= most_b) {
        text[got_b] = '\0';
        return text;
    }
    if (got_b < 0)
        refuse(sigrok, err);
    else
        error_set(err, "%s: %s has more than %zu bytes", sigrok->capture->path, name, most_b);
    free(text);
    return NULL;
}

static bool check_version(struct sigrok *sigrok, struct error *err)
{
    char *text = read_text(sigrok, "version", VERSION_MOST_B, err);
    if (!text) return false;
    const bool ok = text[0] == '1' || text[0] == '2';
    text[strcspn(text, "\r\n")] = '\0';
    if (!ok) error_set(err, "%s: version '%s' of sigrok's format: 1 and 2 are read", sigrok->capture->path, text);
    free(text);
    return ok;
}

/* Metadata ----------------------------------------------------------------------------------- */

/* `24 MHz`, `12.5 kHz`, `1000000` */
static bool take_rate(struct sigrok *sigrok, const char *value, struct error *err)
{
    static const char units[] = " kMG";
    char *end;
    double rate_hz = strtod(value, &end);
    while (*end == ' ')
        end++;
    for (int i = 1; units[i]; i++)
        if (*end && toupper((unsigned char)*end) == toupper((unsigned char)units[i]))
            for (int by = 0; by < i; by++)
                rate_hz *= 1000;
    if (*end && strchr("kKmMgG", *end)) end++;
    const bool ok = (*end == '\0' || strcasecmp(end, "Hz") == 0) && rate_hz >= 0 && rate_hz <= (double)RATE_MOST_HZ;
    sigrok->rate_hz = ok ? (uint64_t)(rate_hz + 0.5) : 0;
    return ok || error_set(err, "%s: samplerate '%.40s' is no number of Hz", sigrok->capture->path, value);
}

static bool take_channel(struct sigrok *sigrok, const char *number, const char *value, struct error *err)
{
    char *end;
    const unsigned long bit = strtoul(number, &end, 10);
    if (*end || bit < 1 || bit > CHANNELS_MAX)
        return error_set(err, "%s: probe%.20s: there are 1 to %d", sigrok->capture->path, number, CHANNELS_MAX);
    channels_add(&sigrok->channels, (struct channel){.path = strdup(value), .id = strdup(number), .bits = 1});
    return true;
}

static bool take_line(struct sigrok *sigrok, const char *key, const char *value, struct error *err)
{
    if (strcmp(key, "samplerate") == 0) return take_rate(sigrok, value, err);
    if (strncmp(key, "probe", 5) == 0) return take_channel(sigrok, key + 5, value, err);
    if (strcmp(key, "unitsize") == 0) sigrok->sample_b = (unsigned)strtoul(value, NULL, 10);
    if (strcmp(key, "capturefile") == 0) snprintf(sigrok->capture_file, sizeof sigrok->capture_file, "%s", value);
    return true;
}

/* Of the first device: an INI file, `key=value`. */
static bool read_metadata(struct sigrok *sigrok, struct error *err)
{
    char *rest = NULL;
    unsigned devices = 0;
    for (char *line = strtok_r(sigrok->metadata, "\r\n", &rest); line; line = strtok_r(NULL, "\r\n", &rest)) {
        char *const value = strchr(line, '=');
        if (line[0] == '[') devices += strncmp(line, "[device", 7) == 0;
        if (!value || devices != 1) continue;
        *value = '\0';
        if (!take_line(sigrok, line, value + 1, err)) return false;
    }
    if (!sigrok->capture_file[0]) return error_set(err, "%s: no logic channels: no capturefile", sigrok->capture->path);
    return (sigrok->sample_b >= 1 && sigrok->sample_b <= 8) ||
           error_set(err, "%s: unitsize is not 1 to 8 bytes", sigrok->capture->path);
}

/* How many entries have samples. */
static bool count_parts(struct sigrok *sigrok, struct error *err)
{
    const size_t length = strlen(sigrok->capture_file);
    const char *name;
    if (!reopen(sigrok, err)) return false;
    while ((name = next_entry(sigrok, err)))
        if (strncmp(name, sigrok->capture_file, length) == 0 && (!name[length] || name[length] == '-')) {
            sigrok->parts++;
            sigrok->is_dense |= name[length] == '-';
        }
    if (err->text[0]) return false;
    return sigrok->parts || error_set(err, "%s: no samples: no entry %s", sigrok->capture->path, sigrok->capture_file);
}

/* Samples ------------------------------------------------------------------------------------ */

/* Every wire has a bit of its own, or several share one. */
static bool find_bits(struct sigrok *sigrok, struct error *err)
{
    for (int wire = 0; wire < CAPTURE_WIRES; wire++) {
        const struct channel *channel = sigrok->capture->wire[wire].channel;
        if (!channel) continue;
        const unsigned long bit = strtoul(channel->id, NULL, 10) - 1;
        if (bit >= 8ul * sigrok->sample_b)
            return error_set(err, "%s: probe%s is beyond a sample's %u bytes", sigrok->capture->path, channel->id,
                             sigrok->sample_b);
        sigrok->wire_of_bit[bit] |= (uint8_t)(1u << wire);
        sigrok->mask |= UINT64_C(1) << bit;
    }
    return true;
}

static uint64_t time_of(const struct sigrok *sigrok)
{
    const uint64_t rate_hz = sigrok->rate_hz, n = sigrok->sample;
    return rate_hz ? n / rate_hz * 1000000000 + n % rate_hz * 1000000 / rate_hz * 1000 +
                         n % rate_hz * 1000000 % rate_hz * 1000 / rate_hz
                   : n;
}

static bool take_sample(struct sigrok *sigrok, const uint8_t *bytes, struct error *err)
{
    uint64_t bits = 0;
    for (unsigned i = 0; i < sigrok->sample_b; i++)
        bits |= (uint64_t)bytes[i] << 8 * i;
    bits &= sigrok->mask;
    if (bits == sigrok->last && sigrok->sample) {
        sigrok->sample++;
        return true;
    }
    struct wire_levels levels = {0, 0};
    for (uint64_t left = bits; left; left &= left - 1)
        levels.high |= sigrok->wire_of_bit[__builtin_ctzll(left)];
    const uint64_t now_ns = time_of(sigrok);
    sigrok->last = bits;
    sigrok->sample++;
    return capture_levels(sigrok->capture, now_ns, levels, err);
}

static bool take_block(struct sigrok *sigrok, const uint8_t *bytes, size_t n_b, struct error *err)
{
    const unsigned sample_b = sigrok->sample_b;
    while (sigrok->left_b && n_b) { /* a sample that began in the block before */
        sigrok->left[sigrok->left_b++] = *bytes++;
        n_b--;
        if (sigrok->left_b < sample_b) continue;
        sigrok->left_b = 0;
        if (!take_sample(sigrok, sigrok->left, err)) return false;
    }
    for (; n_b >= sample_b; bytes += sample_b, n_b -= sample_b)
        if (!take_sample(sigrok, bytes, err)) return false;
    if (n_b) memcpy(sigrok->left, bytes, n_b);
    if (n_b) sigrok->left_b = (unsigned)n_b;
    return true;
}

static bool read_part(struct sigrok *sigrok, struct error *err)
{
    uint8_t block[BLOCK_B];
    la_ssize_t got_b;
    while ((got_b = archive_read_data(sigrok->archive, block, sizeof block)) > 0)
        if (!capture_has_time_left(sigrok->capture, err) || !take_block(sigrok, block, (size_t)got_b, err))
            return false;
    return got_b == 0 || refuse(sigrok, err);
}

/* logic-1-1 and on, or logic-1. */
static bool read_parts(struct sigrok *sigrok, struct error *err)
{
    char name[NAME_B];
    if (!reopen(sigrok, err)) return false;
    for (unsigned part = 1; part <= sigrok->parts; part++) {
        snprintf(name, sizeof name, sigrok->is_dense ? "%s-%u" : "%s", sigrok->capture_file, part);
        if (!find(sigrok, name, err))
            return !err->text[0] && error_set(err, "%s: %s is missing", sigrok->capture->path, name);
        if (!read_part(sigrok, err)) return false;
        capture_tell_progress(sigrok->capture, part, sigrok->parts);
    }
    sigrok->capture->now_ns = time_of(sigrok);
    return !sigrok->left_b || error_set(err, "%s: ends within a sample: was it cut off?", sigrok->capture->path);
}

/* All of it ---------------------------------------------------------------------------------- */

static bool read_all(struct sigrok *sigrok, struct error *err)
{
    if (sigrok->capture->is_stream)
        return error_set(err, "%s: sigrok's sessions are read more than once: say which by its name",
                         sigrok->capture->path);
    if (!reopen(sigrok, err) || !check_version(sigrok, err)) return false;
    sigrok->metadata = read_text(sigrok, "metadata", METADATA_MOST_B, err);
    if (!sigrok->metadata || !read_metadata(sigrok, err) || !count_parts(sigrok, err)) return false;
    const uint64_t rate_hz = sigrok->rate_hz, sample_ns = rate_hz ? (1000000000 + rate_hz - 1) / rate_hz : 1;
    if (!capture_begin(sigrok->capture, &sigrok->channels, sample_ns, rate_hz > 0, err)) return false;
    return find_bits(sigrok, err) && read_parts(sigrok, err);
}

bool sigrok_read(struct capture *capture, struct error *err)
{
    struct sigrok sigrok = {.capture = capture, .sample_b = 1};
    const bool ok = read_all(&sigrok, err);
    if (sigrok.archive) archive_read_free(sigrok.archive);
    channels_free(&sigrok.channels);
    free(sigrok.metadata);
    return ok;
}
