/* SPDX-License-Identifier: MIT
 *
 * A board for QEMU's mps2-an505, whose display is a wire log on the console of the host: what takes the place of a
 * microcontroller's registers where a board's processor has an emulator and its chip has none (an505.sh). Bytes are
 * read when the bus must have sent them, not before, as DMA may; waits pass at once, and are told. The program ends
 * after FRAMES changes of the LED. */
#include "board.h"
#include "mcu/mcu.h"
#include "targets/semihost.h"

enum { LINE_B = 64 };

static const char DIGITS[] = "0123456789abcdef";

struct wire {
    const char *name;
    uint16_t changes;
};

static struct {
    const uint8_t *data; /* that is under way */
    size_t n_b, left_b;
    uint64_t now_us;
    struct wire dc, select, backlight, reset, led;
} parts;

/* Arm, "Semihosting for AArch32 and AArch64": the trap of the M profile. */
static void trap(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void put(const char *text)
{
    trap(SEMIHOST_WRITE0, text);
}

static void end_program(void)
{
    const uint32_t reason_and_status[2] = {SEMIHOST_APPLICATION_EXIT, 0};
    trap(SEMIHOST_EXIT_EXTENDED, reason_and_status);
}

static void put_bytes(const uint8_t *data, size_t n_b)
{
    char line[3 * LINE_B + 3];
    char *at = line;

    *at++ = 'b';
    for (size_t i = 0; i < n_b; i++) {
        *at++ = ' ';
        *at++ = DIGITS[data[i] >> 4];
        *at++ = DIGITS[data[i] & 15];
    }
    *at++ = '\n';
    *at = 0;
    put(line);
}

static void send_what_is_left(void)
{
    for (; parts.n_b; parts.data += LINE_B) {
        const size_t n_b = parts.n_b < LINE_B ? parts.n_b : LINE_B;
        put_bytes(parts.data, n_b);
        parts.n_b -= n_b;
    }
}

static int wires_write(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)ctx;
    send_what_is_left();
    parts.data = data;
    parts.n_b = parts.left_b = n_b;
    return 0;
}

static int wires_flush(void *ctx)
{
    (void)ctx;
    send_what_is_left();
    parts.left_b = 0;
    return 0;
}

/* Half as many at each look, so that who waits has work done. */
static size_t wires_left_b(void *ctx)
{
    (void)ctx;
    return parts.left_b /= 2;
}

static int wire_set(void *ctx, bool high)
{
    struct wire *wire = ctx;

    send_what_is_left();
    put("p ");
    put(wire->name);
    put(high ? " 1\n" : " 0\n");
    if (++wire->changes == FRAMES && wire == &parts.led) end_program();
    return 0;
}

static struct pin wire_pin(struct wire *wire, const char *name)
{
    *wire = (struct wire){.name = name};
    return (struct pin){.ctx = wire, .set = wire_set};
}

static int wait(void *ctx, uint32_t delay_us)
{
    char digits[24];
    char *at = digits + sizeof digits - 1;

    (void)ctx;
    parts.now_us += delay_us;
    *at = 0;
    for (uint64_t left = 1000 * parts.now_us; left; left /= 10)
        *--at = DIGITS[left % 10];
    put("t ");
    put(at);
    put("\n");
    return 0;
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    (void)spi_hz;
    (void)spi_modes;
    *board = (struct board){
        .bus = {.write = wires_write, .flush = wires_flush, .left_b = wires_left_b},
        .dc = wire_pin(&parts.dc, "dc"),
        .reset = wire_pin(&parts.reset, "reset"),
        .backlight = wire_pin(&parts.backlight, "backlight"),
        .select = wire_pin(&parts.select, "select"),
        .clock = {.delay = wait},
        .led = wire_pin(&parts.led, "led"),
    };
    return pin_set(&board->select, false);
}
