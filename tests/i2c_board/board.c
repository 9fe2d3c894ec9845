/* SPDX-License-Identifier: MIT
 *
 * The LM3S811 Evaluation Board, as far as QEMU has it, for a display on I2C: its OLED's controller, SSD0303, is told by
 * a control byte whether a command follows (80h, one byte) or pixels do (40h, up to the message's end). So D/C is
 * remembered for the next write. Registers: LM3S811 datasheet, "Inter-Integrated Circuit". */
#include "board.h"

#include <stdint.h>

enum { I2C_ADDRESS = 0x3D, COMMAND_FOLLOWS = 0x80, PIXELS_FOLLOW = 0x40 };

struct i2c_master {
    volatile uint32_t address, control, data, timer, mask, raw, masked, clear, configuration;
};

enum { CONTROL_RUN = 1, CONTROL_START = 2, CONTROL_STOP = 4, CONFIGURATION_MASTER = 0x10 };

static struct i2c_master *const master = (struct i2c_master *)0x40020000;
static bool pixels_follow;

static void put(uint8_t byte, unsigned how)
{
    master->data = byte;
    master->control = CONTROL_RUN | how;
}

static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)ctx;
    if (pixels_follow) put(PIXELS_FOLLOW, CONTROL_START);
    for (size_t i = 0; i < n_b; i++) {
        if (!pixels_follow) put(COMMAND_FOLLOWS, CONTROL_START);
        put(data[i], !pixels_follow || i + 1 == n_b ? CONTROL_STOP : 0);
    }
    return 0;
}

static int set_dc(void *ctx, bool high)
{
    (void)ctx;
    pixels_follow = high;
    return 0;
}

/* QEMU's display waits for nothing. */
static int delay(void *ctx, uint32_t delay_us)
{
    (void)ctx;
    (void)delay_us;
    return 0;
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    (void)spi_hz;
    (void)spi_modes;
    master->configuration = CONFIGURATION_MASTER;
    master->address = I2C_ADDRESS << 1;
    board->bus = (struct bus){.ctx = master, .write = write_bytes};
    board->dc = (struct pin){.ctx = master, .set = set_dc};
    board->clock = (struct clock){.ctx = master, .delay = delay};
    return 0;
}
