/* SPDX-License-Identifier: MIT
 *
 * Counts the instructions that an emulated processor executes: a plugin of QEMU's TCG (plugin API,
 * version 1), loaded with -plugin count_plugin.so,ranges=FILE,out=FILE[,frames=N]. In: lines `range START END` and
 * `helper START END` of addresses, ascending, and two marks, `begin ADDRESS` and `end ADDRESS`, all
 * hexadecimal. Out: each time when execution has come from one mark to the other, a line `frame` with two
 * numbers for every range, and last for all other addresses: its own instructions, and those of helpers
 * (a compiler's support library) on its behalf; helpers have none of their own. `done` closes the file,
 * and where a program goes on for ever the last of N frames ends the emulator.
 *
 * Debian's qemu-system packages load plugins but do not ship the header that declares the interface,
 * so what is used of it is declared here. */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- The plugin interface of QEMU ------------------------------------------------------------- */

#define EXPORTED __attribute__((visibility("default")))

typedef uint64_t qemu_plugin_id_t;
struct qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;

enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS };
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };

typedef void qemu_plugin_block_fn(qemu_plugin_id_t id, struct qemu_plugin_tb *block);
typedef void qemu_plugin_step_fn(unsigned processor, void *ctx);
typedef void qemu_plugin_exit_fn(qemu_plugin_id_t id, void *ctx);

/* Blocks of instructions as they are translated, before they run. */
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, qemu_plugin_block_fn *call);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);

/* What happens each time an instruction is executed: calls come before additions. */
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *instruction, qemu_plugin_step_fn *call,
                                            enum qemu_plugin_cb_flags flags, void *ctx);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *instruction, enum qemu_plugin_op operation,
                                                void *counter, uint64_t by);

void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, qemu_plugin_exit_fn *call, void *ctx);

/* Found by QEMU by name. */
EXPORTED extern const int qemu_plugin_version;
EXPORTED int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info, int argc, char **argv);

const int qemu_plugin_version = 1;

/* -- Counting --------------------------------------------------------------------------------- */

enum { RANGES_MAX = 4096 };

struct counter;

struct range {
    uint64_t start, end; /* addresses, the end exclusive */
    bool is_helper;
    uint64_t own, helpers; /* instructions since the begin mark */
    struct counter *counter;
};

struct counter {
    struct range ranges[RANGES_MAX + 1]; /* ranges[range_count]: all other addresses */
    size_t range_count;
    struct range *running; /* the range, no helper, that execution was in last */
    uint64_t begin, end;   /* the marks */
    bool counting;
    unsigned long frames_left; /* 0: until the emulator ends */
    FILE *out;
};

/* QEMU calls on_block() without a context, so there can only be one counter. */
static struct counter the_counter;

static struct range *find(struct counter *counter, uint64_t address)
{
    size_t low = 0, high = counter->range_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (address >= counter->ranges[middle].end)
            low = middle + 1;
        else
            high = middle;
    }
    const bool found = low < counter->range_count && address >= counter->ranges[low].start;
    return &counter->ranges[found ? low : counter->range_count];
}

static void on_begin(unsigned processor, void *ctx)
{
    struct counter *counter = ctx;
    (void)processor;
    for (size_t i = 0; i <= counter->range_count; i++)
        counter->ranges[i].own = counter->ranges[i].helpers = 0;
    counter->counting = true;
}

static void finish(struct counter *counter)
{
    fputs("done\n", counter->out);
    fclose(counter->out);
}

static void on_end(unsigned processor, void *ctx)
{
    struct counter *counter = ctx;
    (void)processor;
    if (!counter->counting) return;
    counter->counting = false;
    fputs("frame", counter->out);
    for (size_t i = 0; i <= counter->range_count; i++)
        fprintf(counter->out, " %" PRIu64 " %" PRIu64, counter->ranges[i].own, counter->ranges[i].helpers);
    fputc('\n', counter->out);
    if (counter->frames_left == 0 || --counter->frames_left > 0) return;
    finish(counter);
    _Exit(0);
}

static void on_enter(unsigned processor, void *ctx)
{
    struct range *range = ctx;
    (void)processor;
    range->counter->running = range;
}

static void on_helper(unsigned processor, void *ctx)
{
    struct counter *counter = ctx;
    (void)processor;
    counter->running->helpers++;
}

static void watch_instruction(struct counter *counter, struct qemu_plugin_insn *instruction, bool enters)
{
    const uint64_t address = qemu_plugin_insn_vaddr(instruction);
    struct range *range = find(counter, address);
    if (address == counter->begin)
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_begin, QEMU_PLUGIN_CB_NO_REGS, counter);
    if (address == counter->end)
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_end, QEMU_PLUGIN_CB_NO_REGS, counter);
    if (range->is_helper) {
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_helper, QEMU_PLUGIN_CB_NO_REGS, counter);
        return;
    }
    if (enters) qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_enter, QEMU_PLUGIN_CB_NO_REGS, range);
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, QEMU_PLUGIN_INLINE_ADD_U64, &range->own, 1);
}

/* A block is left before its end by exceptions only, and entered at its start alone. */
static void on_block(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
    const size_t count = qemu_plugin_tb_n_insns(block);
    const struct range *before = NULL;
    (void)id;
    for (size_t i = 0; i < count; i++) {
        struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
        const struct range *range = find(&the_counter, qemu_plugin_insn_vaddr(instruction));
        watch_instruction(&the_counter, instruction, range != before);
        before = range;
    }
}

static void on_exit_of_qemu(qemu_plugin_id_t id, void *ctx)
{
    (void)id;
    finish(ctx);
}

/* -- Start ------------------------------------------------------------------------------------ */

static bool read_range(struct counter *counter, const char *line)
{
    struct range range = {.counter = counter};
    char kind[8];
    if (sscanf(line, "%7s %" SCNx64 " %" SCNx64, kind, &range.start, &range.end) != 3) return false;
    range.is_helper = strcmp(kind, "helper") == 0;
    if (!range.is_helper && strcmp(kind, "range") != 0) return false;
    const uint64_t last = counter->range_count ? counter->ranges[counter->range_count - 1].end : 0;
    if (counter->range_count == RANGES_MAX || range.start < last || range.end <= range.start) return false;
    counter->ranges[counter->range_count++] = range;
    return true;
}

static bool read_line(struct counter *counter, const char *line)
{
    if (sscanf(line, "begin %" SCNx64, &counter->begin) == 1) return true;
    if (sscanf(line, "end %" SCNx64, &counter->end) == 1) return true;
    return read_range(counter, line);
}

static bool read_ranges(struct counter *counter, const char *path)
{
    char line[128];
    FILE *file = fopen(path, "r");
    bool ok = file != NULL;
    while (ok && fgets(line, sizeof line, file))
        ok = read_line(counter, line);
    if (file) fclose(file);
    counter->ranges[counter->range_count] = (struct range){.counter = counter};
    counter->running = &counter->ranges[counter->range_count];
    if (!ok) fprintf(stderr, "count_plugin: %s: cannot be read, or a line is not as it should be\n", path);
    return ok;
}

static const char *argument(int argc, char **argv, const char *name)
{
    const size_t length = strlen(name);
    for (int i = 0; i < argc; i++)
        if (strncmp(argv[i], name, length) == 0 && argv[i][length] == '=') return argv[i] + length + 1;
    return NULL;
}

int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info, int argc, char **argv)
{
    struct counter *counter = &the_counter;
    const char *ranges = argument(argc, argv, "ranges"), *out = argument(argc, argv, "out");
    const char *frames = argument(argc, argv, "frames");
    (void)info;
    if (!ranges || !out) {
        fputs("count_plugin: needs ranges=FILE and out=FILE\n", stderr);
        return -1;
    }
    if (!read_ranges(counter, ranges)) return -1;
    if (frames) counter->frames_left = strtoul(frames, NULL, 10);
    counter->out = fopen(out, "w");
    if (!counter->out) {
        fprintf(stderr, "count_plugin: %s: cannot be written\n", out);
        return -1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_block);
    qemu_plugin_register_atexit_cb(id, on_exit_of_qemu, counter);
    return 0;
}
