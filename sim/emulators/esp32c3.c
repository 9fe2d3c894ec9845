/* SPDX-License-Identifier: MIT
 *
 * Loads the image of a board with an ESP32-C3 as the chip's ROM does, runs it, and tells every rule that it breaks:
 *     esp32c3 IMAGE.esp FRAMES MAP RANGES LOG [OPTION VALUE]...
 * MAP is the board's trace.map: `pin NAME NUMBER`. RANGES has the addresses of a frame's marks and of drivers, as
 * sim/emulators/ranges.sh tells them. LOG becomes a wire log, with times. Standard output tells what a frame takes,
 * standard error what is wrong, a line each; then, or when the frames do not come, it fails.
 *
 *     --panel HZ          the fastest clock that the display takes
 *     --stop-after BYTES  SPI2 stops    --for RESETS    and is not mended by as many resets of it
 *
 * Unicorn runs the processor, so instructions are executed by others' code; the chip (esp32c3_chip.h) is the project's.
 * An instruction takes a cycle. */
#include "base/sha256.h"
#include "emulators/esp32c3_chip.h"

#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unicorn/unicorn.h>

enum {
    RAM_B = 0x60000, /* without the cache's */
    PAGE_B = 0x1000,
    NAME_B = 16,
    COMPLAINTS_MAX = 40, /* that are told */
    ALL_MAX = 1000,
    RANGES_MAX = 256,
    SECONDS_MAX = 20,
    BATCH_B = 32,
    WAIT_PART = 32,
    SLICE = 1000000
};
#define DATA_AT UINT32_C(0x3FC80000)
#define CODE_AT UINT32_C(0x40380000)
#define ROM_RAM_B UINT32_C(0x5C710) /* from here on the ROM's own stack and data while it loads */
#define PERIPHERALS_AT UINT32_C(0x60000000)
#define PERIPHERALS_B UINT32_C(0x100000)
#define SYSTIMER_OP UINT32_C(0x23004)
#define SYSTIMER_END UINT32_C(0x24000)
#define PS_PER_MS UINT64_C(1000000000)
#define GAP_PS (PS_PER_MS / 100) /* bytes further apart have a time each */

struct run {
    uc_engine *processor;
    struct c3 chip;
    FILE *log;
    char names[C3_PINS][NAME_B];
    uint8_t *ram;
    uint32_t entry;
    struct {
        uint32_t start, end;
    } drivers[RANGES_MAX];
    unsigned n_drivers;
    uint32_t begin, end; /* marks of a frame */
    bool counts;
    uint64_t all, waits_in_drivers; /* instructions since the frame's begin */
    unsigned frames, frames_wanted, counted;
    uint64_t frame_b;
    uint8_t batch[BATCH_B];
    unsigned n_batch;
    uint64_t byte_ps; /* when the last one had left */
    bool waits;       /* nothing but the timer was used lately, */
    uint64_t waits_from_ps;
    uint64_t complaints;
    struct { /* told already */
        enum c3_rule rule;
        uint32_t pc;
    } told[COMPLAINTS_MAX];
    unsigned n_told;
    bool failed;
};

static bool fail(const char *what, const char *why)
{
    fprintf(stderr, "esp32c3: %s: %s\n", what, why);
    return false;
}

static uint32_t program_counter(struct run *run)
{
    uint32_t pc = 0;
    uc_reg_read(run->processor, UC_RISCV_REG_PC, &pc);
    return pc;
}

/* -- What the chip tells -- */

/* The same from the same place is told once. */
static void on_complaint(void *ctx, enum c3_rule rule, const char *what)
{
    struct run *run = ctx;
    const uint32_t pc = program_counter(run);

    if (++run->complaints == ALL_MAX) uc_emu_stop(run->processor);
    for (unsigned i = 0; i < run->n_told; i++)
        if (run->told[i].rule == rule && run->told[i].pc == pc) return;
    if (run->n_told == COMPLAINTS_MAX) return;
    run->told[run->n_told].rule = rule;
    run->told[run->n_told++].pc = pc;
    fprintf(stderr, "esp32c3: %.3f ms, at 0x%08X: %s: %s (%s)\n", (double)run->chip.now_ps / (double)PS_PER_MS,
            (unsigned)pc, what, c3_rules[rule].text, c3_rules[rule].source);
}

static void flush_bytes(struct run *run)
{
    if (!run->n_batch) return;
    putc('b', run->log);
    for (unsigned i = 0; i < run->n_batch; i++)
        fprintf(run->log, " %02X", run->batch[i]);
    putc('\n', run->log);
    run->n_batch = 0;
}

static void put_time(struct run *run)
{
    flush_bytes(run);
    fprintf(run->log, "t %" PRIu64 "\n", run->chip.now_ps / 1000);
}

static void on_byte(void *ctx, uint8_t byte)
{
    struct run *run = ctx;

    if (!run->n_batch || run->chip.now_ps - run->byte_ps > GAP_PS) put_time(run);
    run->byte_ps = run->chip.now_ps;
    run->batch[run->n_batch++] = byte;
    if (run->n_batch == BATCH_B) flush_bytes(run);
    run->frame_b++;
}

/* As `limner decode` counts: a frame ends when the LED changes after bytes. */
static void end_frame(struct run *run)
{
    if (!run->frame_b) return;
    if (!run->frames)
        printf("# clocks processor %u spi %u mode %u\n", (unsigned)c3_cpu_hz(&run->chip),
               (unsigned)c3_spi_hz(&run->chip), c3_spi_mode(&run->chip));
    printf("# frame %u: %" PRIu64 " bytes, until %.3f ms\n", run->frames, run->frame_b,
           (double)run->chip.now_ps / (double)PS_PER_MS);
    run->frame_b = 0;
    if (++run->frames == run->frames_wanted) uc_emu_stop(run->processor);
}

static void on_level(void *ctx, unsigned pin, bool high)
{
    struct run *run = ctx;

    if (!run->names[pin][0]) return;
    put_time(run);
    fprintf(run->log, "p %s %d\n", run->names[pin], high);
    if (!strcmp(run->names[pin], "led")) end_frame(run);
}

/* -- What the processor does -- */

static bool in_driver(const struct run *run, uint32_t pc)
{
    for (unsigned i = 0; i < run->n_drivers; i++)
        if (pc - run->drivers[i].start < run->drivers[i].end - run->drivers[i].start) return true;
    return false;
}

static void count(struct run *run, uint32_t pc)
{
    if (pc == run->begin) {
        run->counts = true;
        run->all = run->waits_in_drivers = 0;
    }
    if (run->counts && pc == run->end) {
        run->counts = false;
        printf("# instructions frame %u total %" PRIu64 " drivers %" PRIu64 "\n", run->counted++, run->all,
               run->waits_in_drivers);
    }
    if (!run->counts) return;
    run->all++;
    run->waits_in_drivers += in_driver(run, pc);
}

static void on_instruction(uc_engine *processor, uint64_t address, uint32_t size, void *ctx)
{
    struct run *run = ctx;

    (void)processor, (void)size;
    count(run, (uint32_t)address);
    c3_run(&run->chip, 1);
}

/* Who looks at the timer again and again, and at nothing else, waits. So that it takes us less time than the board,
 * each look takes longer than the one before: a wait becomes longer by a 32nd at most. */
static void hurry(struct run *run, uint32_t offset)
{
    const bool is_timer = offset >= SYSTIMER_OP && offset < SYSTIMER_END;

    if (is_timer && !run->waits) run->waits_from_ps = run->chip.now_ps;
    run->waits = is_timer;
    if (!is_timer || offset != SYSTIMER_OP) return;
    const uint64_t cycle_ps = PS_PER_MS * 1000 / c3_cpu_hz(&run->chip);
    c3_run(&run->chip, (uint32_t)((run->chip.now_ps - run->waits_from_ps) / WAIT_PART / cycle_ps));
}

static uint64_t on_read(uc_engine *processor, uint64_t offset, unsigned size, void *ctx)
{
    struct run *run = ctx;

    (void)processor;
    hurry(run, (uint32_t)offset);
    return c3_read(&run->chip, PERIPHERALS_AT + (uint32_t)offset, size);
}

static void on_write(uc_engine *processor, uint64_t offset, unsigned size, uint64_t value, void *ctx)
{
    struct run *run = ctx;

    (void)processor;
    run->waits = run->waits && offset >= SYSTIMER_OP && offset < SYSTIMER_END;
    c3_write(&run->chip, PERIPHERALS_AT + (uint32_t)offset, (uint32_t)value, size);
}

/* Data by the address for code are whole words. */
static void on_code_access(uc_engine *processor, uc_mem_type type, uint64_t address, int size, int64_t value, void *ctx)
{
    (void)processor, (void)type, (void)value;
    if (size != 4 || address % 4) on_complaint(ctx, C3_WORDS, "RAM");
}

static void on_exception(uc_engine *processor, uint32_t number, void *ctx)
{
    struct run *run = ctx;
    char what[40];

    (void)snprintf(what, sizeof what, "exception %u at 0x%08X", (unsigned)number, (unsigned)program_counter(run));
    run->failed = true;
    fail(what, "no program wants one");
    uc_emu_stop(processor);
}

/* -- The ROM: espressif/esptool docs/en/advanced-topics/firmware-image-format.rst -- */

static uint32_t word_at(const uint8_t *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* Neither the ROM's RAM nor anything but RAM. */
static uint8_t *place(struct run *run, uint32_t address, uint32_t size_b)
{
    const uint32_t in_code_b = address - CODE_AT, in_data_b = address - DATA_AT;
    const uint32_t at_b = in_code_b < ROM_RAM_B ? in_code_b : in_data_b;

    return at_b < ROM_RAM_B && size_b <= ROM_RAM_B - at_b ? run->ram + at_b : NULL;
}

static bool load_segments(struct run *run, const uint8_t *image, size_t size_b, size_t *end_b, uint8_t *checksum)
{
    size_t at = 24;

    for (unsigned i = 0; i < image[1]; i++) {
        if (size_b - at < 8) return fail("the image", "is cut off");
        const uint32_t address = word_at(image + at), n_b = word_at(image + at + 4);
        at += 8;
        uint8_t *const ram = place(run, address, n_b);
        if (n_b % 4 || n_b > size_b - at) return fail("the image", "a segment is cut off, or no whole words");
        if (!ram) return fail("the image", "a segment is not in RAM that the ROM leaves free");
        memcpy(ram, image + at, n_b);
        for (uint32_t k = 0; k < n_b; k++)
            *checksum ^= image[at + k];
        at += n_b;
    }
    *end_b = at;
    return true;
}

/* What follows the checksum: nothing, or the digest of all that is before it. */
static bool is_sealed(const uint8_t *image, size_t size_b, size_t before_b)
{
    uint8_t digest[SHA256_B];

    if (size_b != before_b + (image[23] ? SHA256_B : 0)) return fail("the image", "does not end where it should");
    if (!image[23]) return true;
    sha256(digest, image, before_b);
    return !memcmp(image + before_b, digest, SHA256_B) || fail("the image", "has a wrong digest");
}

static bool boot(struct run *run, const uint8_t *image, size_t size_b)
{
    uint8_t checksum = 0xEF;
    size_t end_b;

    if (size_b < 48 || image[0] != 0xE9) return fail("the image", "does not begin with E9h");
    if (image[1] == 0 || image[1] > 16) return fail("the image", "has no segments, or more than 16");
    if (image[12] != 5 || image[13] != 0) return fail("the image", "is for another chip than number 5");
    if (!load_segments(run, image, size_b, &end_b, &checksum)) return false;
    const size_t checksum_at = end_b / 16 * 16 + 15;
    if (checksum_at >= size_b || image[checksum_at] != checksum) return fail("the image", "has a wrong checksum");
    if (!is_sealed(image, size_b, checksum_at + 1)) return false;
    run->entry = word_at(image + 4);
    return true;
}

static bool load(struct run *run, const char *path)
{
    static uint8_t image[2 * RAM_B];
    FILE *file = fopen(path, "rb");

    if (!file) return fail(path, strerror(errno));
    const size_t n_b = fread(image, 1, sizeof image, file);
    fclose(file);
    return boot(run, image, n_b);
}

/* -- Setting up -- */

static bool is(uc_err err, const char *what)
{
    return err == UC_ERR_OK || fail(what, uc_strerror(err));
}

/* The same RAM twice; instructions are fetched from one of the two alone. */
static bool map_memory(struct run *run)
{
    uc_engine *processor = run->processor;

    run->ram = aligned_alloc(PAGE_B, RAM_B);
    if (!run->ram) return fail("memory", strerror(errno));
    memset(run->ram, 0xA5, RAM_B);
    return is(uc_mem_map_ptr(processor, DATA_AT, RAM_B, UC_PROT_READ | UC_PROT_WRITE, run->ram), "RAM") &&
           is(uc_mem_map_ptr(processor, CODE_AT, RAM_B, UC_PROT_ALL, run->ram), "RAM") &&
           is(uc_mmio_map(processor, PERIPHERALS_AT, PERIPHERALS_B, on_read, run, on_write, run), "peripherals");
}

static bool add_hooks(struct run *run)
{
    uc_hook instruction, exception, access;

    return is(uc_hook_add(run->processor, &instruction, UC_HOOK_CODE, (void *)on_instruction, run, 1, 0), "hook") &&
           is(uc_hook_add(run->processor, &exception, UC_HOOK_INTR, (void *)on_exception, run, 1, 0), "hook") &&
           is(uc_hook_add(run->processor, &access, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, (void *)on_code_access, run,
                          CODE_AT, CODE_AT + RAM_B - 1),
              "hook");
}

static bool take_pin(struct run *run, const char *line)
{
    char name[NAME_B];
    unsigned pin;

    if (line[0] == '#' || line[0] == '\n') return true;
    if (sscanf(line, "pin %15s %u", name, &pin) != 2 || pin >= C3_PINS) return false;
    memcpy(run->names[pin], name, sizeof name);
    if (!strcmp(name, "dc") || !strcmp(name, "select") || !strcmp(name, "reset"))
        run->chip.setting.wired |= UINT32_C(1) << pin;
    return true;
}

static bool take_range(struct run *run, const char *line)
{
    unsigned start, end;

    if (sscanf(line, "begin %x", &run->begin) == 1 || sscanf(line, "end %x", &run->end) == 1) return true;
    if (run->n_drivers == RANGES_MAX || sscanf(line, "range %x %x", &start, &end) != 2) return false;
    run->drivers[run->n_drivers].start = start;
    run->drivers[run->n_drivers++].end = end;
    return true;
}

static bool read_lines(struct run *run, const char *path, bool (*take)(struct run *run, const char *line))
{
    char line[128];
    FILE *file = fopen(path, "r");
    bool ok = true;

    if (!file) return fail(path, strerror(errno));
    while (ok && fgets(line, sizeof line, file))
        ok = take(run, line) || fail(path, "a line is not as it should be");
    fclose(file);
    return ok;
}

static bool read_number(const char *what, const char *word, uint64_t *value)
{
    char *end;

    *value = strtoull(word, &end, 10);
    return (word[0] >= '0' && word[0] <= '9' && !*end) || fail(what, "wants a number");
}

static bool take_option(struct c3_setting *setting, const char *option, const char *word)
{
    uint64_t value;

    if (!read_number(option, word, &value)) return false;
    if (!strcmp(option, "--panel"))
        setting->panel_hz = (uint32_t)value;
    else if (!strcmp(option, "--stop-after"))
        setting->stop_after = value;
    else if (!strcmp(option, "--for"))
        setting->stop_for = (uint32_t)value;
    else
        return fail(option, "no such option");
    return true;
}

static bool read_options(struct c3_setting *setting, char **words)
{
    for (; words[0]; words += 2) {
        if (!words[1]) return fail(words[0], "its value is missing");
        if (!take_option(setting, words[0], words[1])) return false;
    }
    return true;
}

static bool read_frames(unsigned *frames, const char *word)
{
    uint64_t value;

    if (!read_number("FRAMES", word, &value)) return false;
    *frames = (unsigned)value;
    return (value && value <= UINT_MAX) || fail("FRAMES", "wants a number above 0");
}

static bool set_up(struct run *run, char **words)
{
    const struct c3_world world = {run, on_complaint, on_byte, on_level};
    struct c3_setting setting = {0};

    if (!read_frames(&run->frames_wanted, words[1]) || !read_options(&setting, words + 5)) return false;
    c3_init(&run->chip, &setting, &world);
    run->log = fopen(words[4], "w");
    if (!run->log) return fail(words[4], strerror(errno));
    return is(uc_open(UC_ARCH_RISCV, UC_MODE_RISCV32, &run->processor), "Unicorn") && map_memory(run) &&
           add_hooks(run) && load(run, words[0]) && read_lines(run, words[2], take_pin) &&
           read_lines(run, words[3], take_range);
}

/* In slices, so that a program which draws nothing ends too. */
static bool fly(struct run *run)
{
    for (uint32_t pc = run->entry; run->frames < run->frames_wanted && !run->failed;) {
        if (run->complaints >= ALL_MAX) return fail("the image", "breaks too many rules");
        if (run->chip.now_ps > SECONDS_MAX * 1000 * PS_PER_MS) return fail("the image", "draws no more frames");
        if (!is(uc_emu_start(run->processor, pc, UINT32_MAX, 0, SLICE), "the image")) return false;
        pc = program_counter(run);
    }
    return !run->failed;
}

int main(int argc, char **argv)
{
    static struct run run;

    if (argc < 6) return !fail("usage", "esp32c3 IMAGE.esp FRAMES MAP RANGES LOG [OPTION VALUE]...");
    const bool is_set = set_up(&run, argv + 1);
    bool ok = is_set && fly(&run);
    if (run.log) flush_bytes(&run);
    if (run.log && fclose(run.log)) ok = fail(argv[5], strerror(errno));
    if (is_set) printf("# rules %u, complaints %" PRIu64 "\n", (unsigned)C3_RULES, run.complaints);
    return !ok || run.complaints;
}
