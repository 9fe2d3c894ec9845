/* SPDX-License-Identifier: MIT
 *
 * sigrok's sessions as others may have packed them: samples in parts, whose order in the archive is anybody's, of one
 * to eight bytes; what is missing, or is no session, is one line of error that names the file. */
#include "glass/sigrok.h"
#include "rigs/cmocka_ready.h"

#include <archive.h>
#include <archive_entry.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SAMPLES = 4000, DC_BIT = 0, SCK_BIT = 3, MOSI_BIT = 9, SAMPLE_B = 2 };

struct entry {
    const char *name;
    const void *bytes;
    size_t size_b;
};

static char path[] = "/tmp/limner_sigrok_XXXXXX";
static uint8_t samples[SAMPLES * SAMPLE_B];
static char metadata[1000];
static struct module_choice module;
static struct listener listener;
static struct capture_choice choice;
static struct capture capture;

static void pack(const struct entry *entries, size_t count)
{
    struct archive *archive = archive_write_new();
    archive_write_set_format_zip(archive);
    assert_int_equal(archive_write_open_filename(archive, path), ARCHIVE_OK);
    for (size_t i = 0; i < count; i++) {
        struct archive_entry *entry = archive_entry_new();
        archive_entry_set_pathname(entry, entries[i].name);
        archive_entry_set_filetype(entry, AE_IFREG);
        archive_entry_set_perm(entry, 0644);
        archive_entry_set_size(entry, (la_int64_t)entries[i].size_b);
        assert_int_equal(archive_write_header(archive, entry), ARCHIVE_OK);
        assert_int_equal(archive_write_data(archive, entries[i].bytes, entries[i].size_b), entries[i].size_b);
        archive_entry_free(entry);
    }
    archive_write_free(archive);
}

/* Of an ST7789's command 0x00, which does nothing, a bit is two samples. */
static unsigned make_samples(void)
{
    memset(samples, 0, sizeof samples);
    for (size_t i = 0; i < SAMPLES; i++)
        samples[SAMPLE_B * i] = (uint8_t)(1 << (DC_BIT + 1) | (i % 2) << SCK_BIT);
    return SAMPLES / 2 / 8;
}

static void describe(const char *rate, const char *unitsize)
{
    snprintf(metadata, sizeof metadata,
             "[global]\nsigrok version=0.5.2\n\n[device 1]\ncapturefile=logic-1\ntotal probes=10\n%s%s"
             "probe1=DC\nprobe4=SCK\nprobe10=MOSI\n%s[device 2]\ncapturefile=other\nprobe1=SCK\n",
             rate ? "samplerate=" : "", rate ? rate : "", unitsize);
}

static bool on_frame(void *ctx, struct error *err)
{
    (void)ctx, (void)err;
    return true;
}

static bool read_file(struct error *err)
{
    listener_init(&listener, &module);
    capture = (struct capture){
        .choice = &choice, .module = &module, .listener = &listener, .path = path, .on_frame = on_frame};
    err->text[0] = '\0';
    return sigrok_read(&capture, err);
}

static bool read_entries(const struct entry *entries, size_t count, struct error *err)
{
    pack(entries, count);
    return read_file(err);
}

#define ENTRIES(...)                                                                                                   \
    (const struct entry[]){__VA_ARGS__}, sizeof((const struct entry[]){__VA_ARGS__}) / sizeof(struct entry)
#define VERSION                                                                                                        \
    {                                                                                                                  \
        "version", "2", 1                                                                                              \
    }
#define METADATA                                                                                                       \
    {                                                                                                                  \
        "metadata", metadata, strlen(metadata)                                                                         \
    }

static void parts_are_joined_in_their_order_whatever_it_is_in_the_archive(void **state)
{
    (void)state;
    const unsigned bytes = make_samples();
    const struct entry parts[] = {
        {"logic-1-1", samples, 1001},        {"logic-1-2", samples + 1001, 999}, {"logic-1-3", samples + 2000, 3000},
        {"logic-1-4", samples + 5000, 1000}, {"logic-1-5", samples + 6000, 500}, {"logic-1-6", samples + 6500, 500},
        {"logic-1-7", samples + 7000, 500},  {"logic-1-8", samples + 7500, 250}, {"logic-1-9", samples + 7750, 200},
        {"logic-1-10", samples + 7950, 25},  {"logic-1-11", samples + 7975, 25}};
    struct error err;
    describe("24 MHz\n", "unitsize=2\n");
    for (size_t shift = 0; shift < 11; shift += 5) {
        struct entry entries[14] = {{"analog-1-2-1", "abcd", 4}};
        for (size_t i = 0; i < 11; i++)
            entries[i + 1] = parts[(i + shift) % 11];
        entries[12] = (struct entry)METADATA;
        entries[13] = (struct entry)VERSION;
        if (!read_entries(entries, 14, &err)) fail_msg("%s", err.text);
        assert_int_equal(capture.wires.bytes, bytes);
        assert_int_equal(capture.now_ns, SAMPLES * UINT64_C(125) / 3);
    }
}

static void the_first_version_has_one_part(void **state)
{
    (void)state;
    const unsigned bytes = make_samples();
    struct error err;
    describe("1000000\n", "unitsize=2\n");
    if (!read_entries(ENTRIES({"version", "1", 1}, METADATA, {"logic-1", samples, sizeof samples}), &err))
        fail_msg("%s", err.text);
    assert_int_equal(capture.wires.bytes, bytes);
    assert_int_equal(capture.now_ns, SAMPLES * 1000);
}

static void without_a_rate_there_is_no_time(void **state)
{
    (void)state;
    struct error err;
    make_samples();
    describe(NULL, "unitsize=2\n");
    samples[SAMPLE_B * 21] ^= 1; /* D/C, within a byte */
    assert_false(read_entries(ENTRIES(VERSION, METADATA, {"logic-1-1", samples, sizeof samples}), &err));
    assert_non_null(strstr(err.text, ": at sample 21: dc changes after "));
}

static void rates_have_units(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        uint64_t end_ns;
    } rates[] = {{"1 kHz\n", 4000000000}, {"12.5 MHz\n", 320000}, {"1 GHz\n", 4000}, {"200000 Hz\n", 20000000}};
    struct error err;
    make_samples();
    for (int i = 0; i < 4; i++) {
        describe(rates[i].text, "unitsize=2\n");
        if (!read_entries(ENTRIES(VERSION, METADATA, {"logic-1-1", samples, sizeof samples}), &err))
            fail_msg("%s", err.text);
        assert_int_equal(capture.now_ns, rates[i].end_ns);
    }
    describe("fast\n", "unitsize=2\n");
    assert_false(read_entries(ENTRIES(VERSION, METADATA, {"logic-1-1", samples, sizeof samples}), &err));
    assert_non_null(strstr(err.text, "samplerate 'fast' is no number of Hz"));
}

static void refuse(const struct entry *entries, size_t count, const char *why)
{
    struct error err;
    assert_false(read_entries(entries, count, &err));
    assert_int_equal(strncmp(err.text, path, strlen(path)), 0);
    if (!strstr(err.text, why)) fail_msg("'%s', not '%s'", err.text, why);
}

static void what_is_no_whole_session_is_refused(void **state)
{
    (void)state;
    const struct entry all = {"logic-1-1", samples, sizeof samples}, third = {"logic-1-3", samples, 100};
    make_samples();
    describe("1 MHz\n", "unitsize=2\n");
    refuse(ENTRIES({"mimetype", "x", 1}), "a zip archive without 'version'");
    refuse(ENTRIES({"version", "3", 1}, METADATA, all), "version '3' of sigrok's format");
    refuse(ENTRIES(VERSION, all), "a zip archive without 'metadata'");
    refuse(ENTRIES(VERSION, METADATA), "no samples");
    refuse(ENTRIES(VERSION, METADATA, all, third), "logic-1-2 is missing");
    refuse(ENTRIES(VERSION, METADATA, {"logic-1-1", samples, 101}), "ends within a sample");
    describe("1 MHz\n", "unitsize=1\n");
    refuse(ENTRIES(VERSION, METADATA, all), "probe10 is beyond a sample's 1 bytes");
    describe("1 MHz\n", "unitsize=9\n");
    refuse(ENTRIES(VERSION, METADATA, all), "unitsize is not 1 to 8 bytes");
    describe("1 MHz\n", "unitsize=2\nprobe65=X\n");
    refuse(ENTRIES(VERSION, METADATA, all), "probe65: there are 1 to 64");
    snprintf(metadata, sizeof metadata, "[device 1]\ntotal analog=1\n");
    refuse(ENTRIES(VERSION, METADATA, all), "no logic channels");
}

static void a_file_that_is_cut_anywhere_is_refused_or_has_less(void **state)
{
    (void)state;
    struct error err;
    make_samples();
    describe("1 MHz\n", "unitsize=2\n");
    for (long size_b = 4; size_b < 700; size_b += 7) {
        pack(ENTRIES(VERSION, METADATA, {"logic-1-1", samples, sizeof samples}));
        assert_int_equal(truncate(path, size_b), 0);
        if (read_file(&err)) continue;
        assert_int_equal(strncmp(err.text, path, strlen(path)), 0);
        assert_null(strchr(err.text, '\n'));
    }
}

static int begin(void **state)
{
    (void)state;
    char *words[] = {"decode", "--panel", "st7789", NULL};
    struct arguments arguments = {words, 3};
    struct error err;
    const int descriptor = mkstemp(path);
    return descriptor < 0 || close(descriptor) || !module_choice_parse(&module, &arguments, &err);
}

static int end(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_joined_in_their_order_whatever_it_is_in_the_archive),
        cmocka_unit_test(the_first_version_has_one_part),
        cmocka_unit_test(without_a_rate_there_is_no_time),
        cmocka_unit_test(rates_have_units),
        cmocka_unit_test(what_is_no_whole_session_is_refused),
        cmocka_unit_test(a_file_that_is_cut_anywhere_is_refused_or_has_less),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
