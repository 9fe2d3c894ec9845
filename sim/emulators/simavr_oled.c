/* SPDX-License-Identifier: MIT
 *
 * Runs an Arduboy's image in simavr, with simavr's own SSD1306 on its pins:
 *     simavr_oled IMAGE.elf FRAMES PICTURES LOG [DUMP.vcd]
 * PICTURES names a PNG file for each frame ('out/%03d.png'), of what that display shows; LOG becomes a wire log, DUMP
 * what a logic analyser on the pins would capture, in simavr's own writing. A frame ends when the green light changes.
 * Standard output tells its cycles, and how deep its stack was.
 *
 * simavr lets every byte on the SPI take 100 us. What the processor waits for that is told apart, beside what the byte
 * takes at 8 MHz. */
#include <errno.h>
#include <gd.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_spi.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_vcd_file.h>
#include <ssd1306_virt.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { CPU_HZ = 16000000, W_PX = 128, H_PX = 64, WAIT_CYCLES = CPU_HZ / 10000, BUS_CYCLES = 16 };
enum { SECONDS_MAX = 30 }; /* of the board's time */
enum { LED = 7 };          /* of port B */
enum { DUMP_US = 500 };    /* so much of the dump is in memory */
enum { UNTOUCHED = 0xA5 }; /* in RAM, where nothing was written */
enum { SCK, MOSI, SPI_PINS };

struct run {
    avr_t *avr;
    ssd1306_t display;
    const char *pictures;
    FILE *log;
    const char *dump_path; /* NULL: none is wanted */
    avr_vcd_t dump;
    avr_irq_t *spi; /* pins that simavr's SPI does not move */
    unsigned frames, frames_wanted;
    unsigned bytes; /* of this frame */
    avr_cycle_count_t began;
    uint16_t static_end; /* address behind the program's variables: what is above is the stack's */
    bool failed;
};

static bool fail(const char *what, const char *why)
{
    fprintf(stderr, "simavr_oled: %s: %s\n", what, why);
    return false;
}

/* The usual glass shows memory's last column and line first, unless they are exchanged. */
static bool is_lit(ssd1306_t *display, int x, int y)
{
    const int column = ssd1306_get_flag(display, SSD1306_FLAG_SEGMENT_REMAP_0) ? W_PX - 1 - x : x;
    const int line = ssd1306_get_flag(display, SSD1306_FLAG_COM_SCAN_NORMAL) ? H_PX - 1 - y : y;
    const bool bit = display->vram[line / 8][column] >> line % 8 & 1;

    return ssd1306_get_flag(display, SSD1306_FLAG_DISPLAY_ON) &&
           bit != ssd1306_get_flag(display, SSD1306_FLAG_DISPLAY_INVERTED);
}

static bool put_picture(struct run *run)
{
    char path[4096];
    gdImagePtr image = gdImageCreateTrueColor(W_PX, H_PX);

    /* NOLINTNEXTLINE: the pattern is the caller's */
    const int n_b = snprintf(path, sizeof path, run->pictures, run->frames);
    FILE *file = n_b > 0 && (size_t)n_b < sizeof path ? fopen(path, "wb") : NULL;
    bool ok = file && image;
    for (int y = 0; y < H_PX && ok; y++)
        for (int x = 0; x < W_PX; x++)
            gdImageSetPixel(image, x, y, is_lit(&run->display, x, y) ? 0xFFFFFF : 0);
    if (ok) gdImagePng(image, file);
    if (file && fclose(file)) ok = false;
    if (image) gdImageDestroy(image);
    return ok || fail(path, strerror(errno));
}

static void end_frame(struct run *run)
{
    const avr_cycle_count_t all = run->avr->cycle - run->began, wait = (avr_cycle_count_t)run->bytes * WAIT_CYCLES;

    if (run->frames == run->frames_wanted) return;
    if (!put_picture(run)) run->failed = true;
    printf("# cycles frame %u cpu %llu spi-wait %llu bus %u\n", run->frames, (unsigned long long)(all - wait),
           (unsigned long long)wait, run->bytes * BUS_CYCLES);
    run->began = run->avr->cycle;
    run->bytes = 0;
    run->frames++;
}

/* Mode 0, all bits when the byte has gone: the dump lets the edges follow each other. */
static void clock_out(struct run *run, uint32_t value)
{
    for (int bit = 7; bit >= 0; bit--) {
        avr_raise_irq(&run->spi[MOSI], value >> bit & 1);
        avr_raise_irq(&run->spi[SCK], 1);
        avr_raise_irq(&run->spi[SCK], 0);
    }
}

/* simavr's display knows no start line (40h .. 7Fh), and would take the next command for its argument. */
static void end_start_line(ssd1306_t *display)
{
    if ((display->command_register & 0xC0) == 0x40) display->command_register = 0;
}

static void on_byte(struct avr_irq_t *irq, uint32_t value, void *ctx)
{
    struct run *run = ctx;

    (void)irq;
    end_start_line(&run->display);
    if (run->dump_path) clock_out(run, value);
    fprintf(run->log, "b %02X\n", (unsigned)value & 0xFFu);
    run->bytes++;
}

static void on_pin(struct run *run, const char *name, uint32_t value)
{
    fprintf(run->log, "p %s %u\n", name, (unsigned)value);
}

static void on_dc(struct avr_irq_t *irq, uint32_t value, void *ctx)
{
    (void)irq;
    on_pin(ctx, "dc", value);
}

static void on_reset(struct avr_irq_t *irq, uint32_t value, void *ctx)
{
    (void)irq;
    on_pin(ctx, "reset", value);
}

static void on_select(struct avr_irq_t *irq, uint32_t value, void *ctx)
{
    (void)irq;
    on_pin(ctx, "cs", value);
}

/* Its first level is no frame's end: nothing was sent before. */
static void on_led(struct avr_irq_t *irq, uint32_t value, void *ctx)
{
    struct run *run = ctx;

    if (value == irq->value) return;
    on_pin(run, "led", value);
    if (run->bytes) end_frame(run);
}

static void wire(struct run *run)
{
    static const ssd1306_pin_t select = {'D', 6}, dc = {'D', 4}, reset = {'D', 7};
    ssd1306_wiring_t wiring = {select, dc, reset};
    avr_t *avr = run->avr;

    ssd1306_init(avr, &run->display, W_PX, H_PX);
    ssd1306_connect(&run->display, &wiring);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_SPI_GETIRQ(0), SPI_IRQ_OUTPUT), on_byte, run);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), dc.pin), on_dc, run);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), reset.pin), on_reset, run);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), select.pin), on_select, run);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), LED), on_led, run);
}

/* The names are those on an Arduboy's plan. */
static bool begin_dump(struct run *run)
{
    static const char *names[SPI_PINS] = {">sck", ">mosi"};
    avr_t *avr = run->avr;

    run->spi = avr_alloc_irq(&avr->irq_pool, 0, SPI_PINS, names);
    if (avr_vcd_init(avr, run->dump_path, &run->dump, DUMP_US)) return fail(run->dump_path, strerror(errno));
    avr_vcd_add_signal(&run->dump, &run->spi[SCK], 1, "SCK");
    avr_vcd_add_signal(&run->dump, &run->spi[MOSI], 1, "MOSI");
    avr_vcd_add_signal(&run->dump, avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 4), 1, "DC");
    avr_vcd_add_signal(&run->dump, avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 6), 1, "CS");
    avr_vcd_add_signal(&run->dump, avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 7), 1, "RST");
    avr_vcd_add_signal(&run->dump, avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), LED), 1, "LED");
    return avr_vcd_start(&run->dump) == 0 || fail(run->dump_path, strerror(errno));
}

static bool load(struct run *run, const char *path)
{
    elf_firmware_t firmware;

    memset(&firmware, 0, sizeof firmware);
    if (elf_read_firmware(path, &firmware)) return fail(path, "is no AVR program");
    run->avr = avr_make_mcu_by_name("atmega32u4");
    if (!run->avr) return fail("atmega32u4", "this simavr does not know it");
    avr_init(run->avr);
    firmware.frequency = CPU_HZ;
    avr_load_firmware(run->avr, &firmware);
    run->static_end = (uint16_t)(run->avr->ioend + 1u + firmware.datasize + firmware.bsssize);
    memset(run->avr->data + run->static_end, UNTOUCHED, run->avr->ramend + 1u - run->static_end);
    return true;
}

/* How deep the stack was, by the lowest byte of it that the program has written. */
static void tell_stack(const struct run *run)
{
    unsigned lowest = run->static_end;

    while (lowest <= run->avr->ramend && run->avr->data[lowest] == UNTOUCHED)
        lowest++;
    printf("# stack %u of %u bytes\n", run->avr->ramend + 1u - lowest, run->avr->ramend + 1u - run->static_end);
}

static bool run_frames(struct run *run)
{
    int state = cpu_Running;

    while (run->frames < run->frames_wanted && !run->failed) {
        if (state == cpu_Done || state == cpu_Crashed) return fail("the image", "it has ended, or crashed");
        if (run->avr->cycle > (avr_cycle_count_t)SECONDS_MAX * CPU_HZ) return fail("the image", "draws no more frames");
        state = avr_run(run->avr);
    }
    return !run->failed;
}

int main(int argc, char **argv)
{
    if (argc != 5 && argc != 6) return !fail("usage", "simavr_oled IMAGE.elf FRAMES PICTURES LOG [DUMP.vcd]");
    struct run run = {.pictures = argv[3], .frames_wanted = (unsigned)strtoul(argv[2], NULL, 10)};

    run.log = fopen(argv[4], "w");
    if (!run.log) return !fail(argv[4], strerror(errno));
    bool ok = load(&run, argv[1]);
    if (ok) {
        wire(&run);
        run.dump_path = argv[5];
        ok = (!run.dump_path || begin_dump(&run)) && run_frames(&run);
        tell_stack(&run);
        if (run.dump_path) avr_vcd_close(&run.dump);
    }
    if (fclose(run.log)) ok = fail(argv[4], strerror(errno));
    return !ok;
}
