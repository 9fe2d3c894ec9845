/* SPDX-License-Identifier: MIT
 *
 * Runs the image of a board with an STM32F405 or STM32F103 as it is flashed, and tells every rule of the maker's
 * manuals that it breaks:
 *     stm32 f405|f103 IMAGE.bin FRAMES MAP LOG [OPTION VALUE]...
 * MAP is the board's trace.map, which says where the display hangs; LOG becomes a wire log, with times. Standard output
 * tells the clocks, standard error what is wrong, a line each; then, or when the frames do not come, it fails.
 *
 *     --hse HZ            the crystal; 0: it does not start    --pll no       the PLL does not lock
 *     --panel HZ          the fastest clock that the display takes
 *     --stop-after BYTES  the SPI stops    --for STARTS        and is not mended by as many starts of it
 *     --cycles N          that an instruction takes: 1
 *
 * Unicorn runs the processor, so instructions are executed by others' code; the chip (stm32_chip.h) is the project's.
 * An instruction takes the same time whatever it is, so the times are not the processor's. */
#include "stm32_chip.h"

#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unicorn/unicorn.h>

enum {
    FLASH_B = 1 << 20,
    CCM_B = 1 << 16,
    NAME_B = 16,
    COMPLAINTS_MAX = 40,
    SECONDS_MAX = 20,
    BATCH_B = 32,
    CYCLES_MAX = 1000
};
enum { TICK_CVR = 0x18, WAIT_PART = 32 };
#define FLASH_AT UINT32_C(0x08000000)
#define RAM_AT UINT32_C(0x20000000)
#define CCM_AT UINT32_C(0x10000000)
#define PERIPHERALS_AT UINT32_C(0x40000000)
#define PERIPHERALS_B UINT32_C(0x80000)
#define CORE_AT UINT32_C(0xE000E000)
#define CORE_B UINT32_C(0x1000)
#define PS_PER_MS UINT64_C(1000000000)
#define GAP_PS (PS_PER_MS / 100) /* bytes further apart have a time each */

struct run {
    uc_engine *processor;
    struct chip chip;
    FILE *log;
    char names[CHIP_WIRES][NAME_B];
    uint8_t *flash, *ram;
    uint32_t ram_b;
    unsigned cycles, frames, frames_wanted;
    uint64_t bytes, frame_b; /* sent in all, and in this frame */
    uint8_t batch[BATCH_B];
    unsigned n_batch;
    uint64_t byte_ps;       /* when the last one had left */
    bool waits;             /* the last register looked at was SysTick's, */
    uint64_t waits_from_ps; /* as all since then */
    uint64_t complaints;
    struct { /* told already */
        enum chip_rule rule;
        uint32_t pc;
    } told[COMPLAINTS_MAX];
    unsigned n_told;
    bool failed;
};

static bool fail(const char *what, const char *why)
{
    fprintf(stderr, "stm32: %s: %s\n", what, why);
    return false;
}

static uint32_t program_counter(struct run *run)
{
    uint32_t pc = 0;
    uc_reg_read(run->processor, UC_ARM_REG_PC, &pc);
    return pc;
}

static void stop(struct run *run)
{
    uc_emu_stop(run->processor);
}

/* -- What the chip tells -- */

/* The same from the same place is told once. */
static void on_complaint(void *ctx, enum chip_rule rule, const char *what)
{
    struct run *run = ctx;
    const uint32_t pc = program_counter(run);

    run->complaints++;
    for (unsigned i = 0; i < run->n_told; i++)
        if (run->told[i].rule == rule && run->told[i].pc == pc) return;
    if (run->n_told == COMPLAINTS_MAX) {
        stop(run);
        return;
    }
    run->told[run->n_told].rule = rule;
    run->told[run->n_told++].pc = pc;
    fprintf(stderr, "stm32: %.3f ms, at 0x%08X: %s: %s (%s)\n", (double)run->chip.now_ps / (double)PS_PER_MS,
            (unsigned)pc, what, chip_rules[rule].text, chip_rules[rule].source[run->chip.kind]);
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
    run->bytes++;
    run->frame_b++;
}

static void put_clocks(struct run *run)
{
    const struct chip_clocks *clocks = &run->chip.clocks;
    uint32_t spi_hz = run->chip.spi.hz, cr1 = chip_read(&run->chip, 0x40013000, 4);

    printf("# clocks processor %u apb1 %u apb2 %u spi %u mode %u\n", (unsigned)clocks->hclk_hz,
           (unsigned)clocks->apb1_hz, (unsigned)clocks->apb2_hz, (unsigned)spi_hz,
           (unsigned)((cr1 >> 1 & 1) << 1 | (cr1 & 1)));
}

/* As `limner decode` counts: a frame ends when the LED changes after bytes. */
static void end_frame(struct run *run)
{
    if (!run->frame_b) return;
    if (!run->frames) put_clocks(run);
    printf("# frame %u: %" PRIu64 " bytes, until %.3f ms\n", run->frames, run->frame_b,
           (double)run->chip.now_ps / (double)PS_PER_MS);
    run->frame_b = 0;
    if (++run->frames == run->frames_wanted) stop(run);
}

static void on_level(void *ctx, unsigned wire, bool high)
{
    struct run *run = ctx;

    put_time(run);
    fprintf(run->log, "p %s %d\n", run->names[wire], high);
    if (!strcmp(run->names[wire], "led")) end_frame(run);
}

static bool on_memory(void *ctx, uint32_t address, uint8_t *value)
{
    const struct run *run = ctx;

    if (address >= FLASH_AT && address - FLASH_AT < FLASH_B)
        *value = run->flash[address - FLASH_AT];
    else if (address >= RAM_AT && address - RAM_AT < run->ram_b)
        *value = run->ram[address - RAM_AT];
    else
        return false;
    return true;
}

/* -- What the processor does -- */

static void on_instruction(uc_engine *processor, uint64_t address, uint32_t size, void *ctx)
{
    struct run *run = ctx;

    (void)processor, (void)address, (void)size;
    chip_run(&run->chip, run->cycles);
}

static uint64_t on_read(uc_engine *processor, uint64_t offset, unsigned size, void *ctx)
{
    struct run *run = ctx;

    (void)processor;
    run->waits = false;
    return chip_read(&run->chip, PERIPHERALS_AT + (uint32_t)offset, size);
}

static void on_write(uc_engine *processor, uint64_t offset, unsigned size, uint64_t value, void *ctx)
{
    struct run *run = ctx;

    (void)processor;
    run->waits = false;
    chip_write(&run->chip, PERIPHERALS_AT + (uint32_t)offset, (uint32_t)value, size);
}

/* Who looks at SysTick again and again, and at nothing else, waits. So that it takes us less time than the board, each
 * look takes longer than the one before: a wait becomes longer by a 32nd at most. */
static void hurry(struct run *run)
{
    if (!run->waits) run->waits_from_ps = run->chip.now_ps;
    run->waits = true;
    const uint64_t waited_ps = run->chip.now_ps - run->waits_from_ps;
    chip_run(&run->chip, (uint32_t)(waited_ps / WAIT_PART / run->chip.clocks.cycle_ps));
}

static uint64_t on_core_read(uc_engine *processor, uint64_t offset, unsigned size, void *ctx)
{
    struct run *run = ctx;

    (void)processor;
    if (offset == TICK_CVR) hurry(run);
    return chip_read(&run->chip, CORE_AT + (uint32_t)offset, size);
}

static void on_core_write(uc_engine *processor, uint64_t offset, unsigned size, uint64_t value, void *ctx)
{
    struct run *run = ctx;

    (void)processor;
    chip_write(&run->chip, CORE_AT + (uint32_t)offset, (uint32_t)value, size);
}

static void on_exception(uc_engine *processor, uint32_t number, void *ctx)
{
    struct run *run = ctx;
    char what[32];

    (void)processor;
    (void)snprintf(what, sizeof what, "exception %u at 0x%08X", (unsigned)number, (unsigned)program_counter(run));
    run->failed = true;
    fail(what, "no program wants one");
    stop(run);
}

/* -- Setting up -- */

static bool is(uc_err err, const char *what)
{
    return err == UC_ERR_OK || fail(what, uc_strerror(err));
}

static bool map_memory(struct run *run)
{
    uc_engine *processor = run->processor;

    run->flash = malloc(FLASH_B);
    run->ram = calloc(1, run->ram_b);
    if (!run->flash || !run->ram) return fail("memory", strerror(errno));
    memset(run->flash, 0xFF, FLASH_B);
    return is(uc_mem_map_ptr(processor, FLASH_AT, FLASH_B, UC_PROT_READ | UC_PROT_EXEC, run->flash), "flash") &&
           is(uc_mem_map_ptr(processor, RAM_AT, run->ram_b, UC_PROT_ALL, run->ram), "RAM") &&
           (run->chip.kind != CHIP_F405 || is(uc_mem_map(processor, CCM_AT, CCM_B, UC_PROT_ALL), "CCM")) &&
           is(uc_mmio_map(processor, PERIPHERALS_AT, PERIPHERALS_B, on_read, run, on_write, run), "peripherals") &&
           is(uc_mmio_map(processor, CORE_AT, CORE_B, on_core_read, run, on_core_write, run), "the core's registers");
}

static bool add_hooks(struct run *run)
{
    uc_hook instruction, exception;

    return is(uc_hook_add(run->processor, &instruction, UC_HOOK_CODE, (void *)on_instruction, run, 1, 0), "hook") &&
           is(uc_hook_add(run->processor, &exception, UC_HOOK_INTR, (void *)on_exception, run, 1, 0), "hook");
}

static bool load(struct run *run, const char *path)
{
    FILE *file = fopen(path, "rb");

    if (!file) return fail(path, strerror(errno));
    const size_t n_b = fread(run->flash, 1, FLASH_B, file);
    const bool whole = n_b >= 8 && fgetc(file) == EOF && !ferror(file);
    fclose(file);
    return whole || fail(path, "is no image that fits into flash");
}

/* `pin NAME bsrr ADDRESS BIT`; sim/glass/qemu_trace.h. The register lies in its port's first KB. */
static bool take_line(struct run *run, const char *line)
{
    char *const name = run->names[run->chip.n_wires];
    unsigned address, bit;

    if (line[0] == '#' || line[0] == '\n' || !strncmp(line, "spi ", 4)) return true;
    if (run->chip.n_wires == CHIP_WIRES || sscanf(line, "pin %15s bsrr %x %u", name, &address, &bit) != 3 || bit > 15)
        return false;
    const bool needed = !strcmp(name, "dc") || !strcmp(name, "select");
    const struct chip_wire wire = {.port = address & ~0x3FFu,
                                   .bit = (uint8_t)bit,
                                   .is_display = needed || !strcmp(name, "reset"),
                                   .is_needed = needed};
    return chip_add_wire(&run->chip, &wire);
}

static bool read_map(struct run *run, const char *path)
{
    char line[128];
    FILE *file = fopen(path, "r");
    bool ok = true;

    if (!file) return fail(path, strerror(errno));
    while (ok && fgets(line, sizeof line, file))
        ok = take_line(run, line) || fail(path, "a line is neither 'spi' nor 'pin NAME bsrr ADDRESS BIT'");
    fclose(file);
    return ok;
}

static bool read_number(const char *option, const char *word, uint64_t *value)
{
    char *end;

    errno = 0;
    *value = strtoull(word, &end, 10);
    return (word[0] >= '0' && word[0] <= '9' && !*end && !errno) || fail(option, "wants a number");
}

static bool take_option(struct chip_setting *setting, unsigned *cycles, const char *option, const char *word)
{
    uint64_t value = 0;

    if (!strcmp(option, "--pll")) {
        setting->pll_fails = !strcmp(word, "no");
        return setting->pll_fails || fail(option, "wants 'no'");
    }
    if (!read_number(option, word, &value)) return false;
    if (!strcmp(option, "--hse"))
        setting->hse_hz = (uint32_t)value;
    else if (!strcmp(option, "--panel"))
        setting->panel_hz = (uint32_t)value;
    else if (!strcmp(option, "--stop-after"))
        setting->stop_after = value;
    else if (!strcmp(option, "--for"))
        setting->stop_for = (uint32_t)value;
    else if (!strcmp(option, "--cycles") && value && value <= CYCLES_MAX)
        *cycles = (unsigned)value;
    else
        return fail(option, "no such option, or no such number of it");
    return true;
}

static bool read_options(struct chip_setting *setting, unsigned *cycles, char **words)
{
    for (; words[0]; words += 2) {
        if (!words[1]) return fail(words[0], "its value is missing");
        if (!take_option(setting, cycles, words[0], words[1])) return false;
    }
    return true;
}

static bool read_frames(unsigned *frames, const char *word)
{
    uint64_t value = 0;

    if (!read_number("FRAMES", word, &value)) return false;
    *frames = (unsigned)value;
    return (value && value <= UINT_MAX) || fail("FRAMES", "wants a number above 0");
}

static bool set_up(struct run *run, enum chip_kind kind, char **words)
{
    static const uint32_t ram_b[CHIP_KINDS] = {[CHIP_F405] = 128 * 1024, [CHIP_F103] = 20 * 1024};
    static const int models[CHIP_KINDS] = {[CHIP_F405] = UC_CPU_ARM_CORTEX_M4, [CHIP_F103] = UC_CPU_ARM_CORTEX_M3};
    const struct chip_world world = {run, on_complaint, on_byte, on_level, on_memory};
    struct chip_setting setting = {.hse_hz = kind == CHIP_F405 ? 12000000 : 8000000};

    run->cycles = 1;
    run->ram_b = ram_b[kind];
    if (!read_frames(&run->frames_wanted, words[1]) || !read_options(&setting, &run->cycles, words + 4)) return false;
    chip_init(&run->chip, kind, &setting, &world);
    run->log = fopen(words[3], "w");
    if (!run->log) return fail(words[3], strerror(errno));
    return is(uc_open(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS, &run->processor), "Unicorn") &&
           is(uc_ctl_set_cpu_model(run->processor, models[kind]), "the processor") && map_memory(run) &&
           add_hooks(run) && load(run, words[0]) && read_map(run, words[2]);
}

/* In slices, so that a program which draws nothing ends too. */
static bool fly(struct run *run)
{
    uint32_t start[2];

    memcpy(start, run->flash, sizeof start);
    if (!is(uc_reg_write(run->processor, UC_ARM_REG_SP, &start[0]), "the stack")) return false;
    for (uint32_t pc = start[1]; run->frames < run->frames_wanted && !run->failed;) {
        if (run->n_told == COMPLAINTS_MAX) return fail("the image", "breaks too many rules");
        if (run->chip.now_ps > SECONDS_MAX * 1000 * PS_PER_MS) return fail("the image", "draws no more frames");
        if (!is(uc_emu_start(run->processor, pc | 1, 0xFFFFFFFE, 0, 1000000), "the image")) return false;
        pc = program_counter(run);
    }
    return !run->failed;
}

int main(int argc, char **argv)
{
    static struct run run;
    const char *const part = argc > 5 ? argv[1] : "";
    const bool f405 = !strcmp(part, "f405");

    if (!f405 && strcmp(part, "f103") != 0)
        return !fail("usage", "stm32 f405|f103 IMAGE.bin FRAMES MAP LOG [OPTION VALUE]...");
    const bool is_set = set_up(&run, f405 ? CHIP_F405 : CHIP_F103, argv + 2);
    bool ok = is_set && fly(&run);
    if (run.log) flush_bytes(&run);
    if (run.log && fclose(run.log)) ok = fail(argv[5], strerror(errno));
    if (is_set) printf("# rules %u, complaints %" PRIu64 "\n", (unsigned)RULES, run.complaints);
    return !ok || run.complaints;
}
