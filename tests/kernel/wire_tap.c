// SPDX-License-Identifier: MIT OR GPL-2.0
/*
 * A display's wires, recorded: SPI controllers and a chip of GPIO lines, of which everything that a program does to
 * them becomes one ordered record, read from /dev/wire_tap. Built into the kernel of tests/kernel. On bus 0 chip select
 * 0 takes messages of any length, 1 refuses those of more than 1000 bytes, 2 all; what is refused is not recorded; 3 is
 * another driver's than spidev's. Bus 1 has no other flags than clock polarity and phase, as spi-dw; the chip select of
 * bus 2 is a GPIO line. MISO is not connected.
 *
 * A record is a struct wire_tap_event in the machine's byte order, followed by n_b bytes of data. A transfer takes as
 * long as on a wire. With a kernel whose time moves only while everything sleeps, the times are the sums of transfers
 * and of the delays that the program asked for; and whoever waits for the record has a chance to run.
 */
#include <linux/delay.h>
#include <linux/gpio/driver.h>
#include <linux/gpio/machine.h>
#include <linux/kfifo.h>
#include <linux/ktime.h>
#include <linux/miscdevice.h>
#include <linux/module.h>
#include <linux/platform_device.h>
#include <linux/poll.h>
#include <linux/spi/spi.h>
#include <linux/vmalloc.h>

#include "wire_tap.h"

#define FIFO_B (16u << 20) /* a power of two; a dozen frames of 240x320 */

enum { SELECT_FREE, SELECT_SHORT, SELECT_BROKEN, SELECT_HELD, N_SELECTS };
enum { BUS_USUAL, BUS_PLAIN, BUS_SELECTED_BY_LINE };
enum { LINE_CS = WIRE_LINES, N_LINES };
enum { SHORT_MOST_B = 1000 };

static const char *const line_names[N_LINES] = {[WIRE_DC] = "DC",
                                                [WIRE_RESET] = "RESET",
                                                [WIRE_BACKLIGHT] = "BACKLIGHT",
                                                [WIRE_SELECT] = "SELECT",
                                                [LINE_CS] = "CS"};

static struct gpiod_lookup_table chip_selects = {
    .dev_id = "spi2", .table = {GPIO_LOOKUP_IDX("wire-tap", LINE_CS, "cs", 0, GPIO_ACTIVE_LOW), {}}};

static struct {
    struct platform_device *device;
    struct gpio_chip lines;
    unsigned long levels, inputs; /* a bit for each line */
    struct kfifo record;
    void *memory;
    bool full; /* something was lost: the record says so by ending with an error */
    spinlock_t lock;
    wait_queue_head_t grown;
} tap;

static void record(struct wire_tap_event event, const void *data)
{
    unsigned long flags;

    spin_lock_irqsave(&tap.lock, flags);
    event.time_ns = ktime_get_ns();
    if (kfifo_avail(&tap.record) < sizeof(event) + event.n_b) tap.full = true;
    if (!tap.full) {
        kfifo_in(&tap.record, (const u8 *)&event, sizeof(event));
        kfifo_in(&tap.record, (const u8 *)data, event.n_b);
    }
    spin_unlock_irqrestore(&tap.lock, flags);
    wake_up_interruptible(&tap.grown);
}

/* Lines ---------------------------------------------------------------------------------------- */

static int line_direction(struct gpio_chip *chip, unsigned int line)
{
    return test_bit(line, &tap.inputs) ? GPIO_LINE_DIRECTION_IN : GPIO_LINE_DIRECTION_OUT;
}

static int line_level(struct gpio_chip *chip, unsigned int line)
{
    return test_bit(line, &tap.levels);
}

static void line_set(struct gpio_chip *chip, unsigned int line, int level)
{
    assign_bit(line, &tap.levels, level);
    record((struct wire_tap_event){.kind = WIRE_TAP_LEVEL, .which = line, .value = !!level}, NULL);
}

static int line_to_input(struct gpio_chip *chip, unsigned int line)
{
    set_bit(line, &tap.inputs);
    record((struct wire_tap_event){.kind = WIRE_TAP_INPUT, .which = line}, NULL);
    return 0;
}

static int line_to_output(struct gpio_chip *chip, unsigned int line, int level)
{
    clear_bit(line, &tap.inputs);
    line_set(chip, line, level);
    return 0;
}

/* What gpiolib calls when a program gives a line back. */
static void line_free(struct gpio_chip *chip, unsigned int line)
{
    record((struct wire_tap_event){.kind = WIRE_TAP_RELEASED, .which = line}, NULL);
}

static int add_lines(void)
{
    tap.inputs = GENMASK(N_LINES - 1, 0);
    tap.lines = (struct gpio_chip){
        .label = "wire-tap",
        .parent = &tap.device->dev,
        .owner = THIS_MODULE,
        .base = -1,
        .ngpio = N_LINES,
        .names = line_names,
        .free = line_free,
        .get_direction = line_direction,
        .direction_input = line_to_input,
        .direction_output = line_to_output,
        .get = line_level,
        .set = line_set,
    };
    return gpiochip_add_data(&tap.lines, NULL);
}

/* SPI ------------------------------------------------------------------------------------------ */

static void select_chip(struct spi_device *device, bool level)
{
    record((struct wire_tap_event){.kind = WIRE_TAP_SELECT, .which = device->chip_select, .value = level}, NULL);
}

static int transfer(struct spi_controller *spi, struct spi_device *device, struct spi_transfer *x)
{
    const struct wire_tap_event event = {.kind = WIRE_TAP_BYTES,
                                         .which = device->chip_select,
                                         .mode = device->mode & 0xFF,
                                         .word_bits = x->bits_per_word,
                                         .value = x->speed_hz,
                                         .n_b = x->len};
    if (spi->bus_num == BUS_USUAL && device->chip_select == SELECT_BROKEN) return -EIO;
    if (spi->bus_num == BUS_USUAL && device->chip_select == SELECT_SHORT && x->len > SHORT_MOST_B) return -EMSGSIZE;
    if (x->tx_buf) record(event, x->tx_buf);
    if (x->rx_buf) memset(x->rx_buf, 0, x->len);
    fsleep(DIV_ROUND_UP_ULL(8ull * USEC_PER_SEC * x->len, x->speed_hz));
    return 0;
}

/* Has a device, as a display's driver would, and does nothing with it. */
static int hold(struct spi_device *device)
{
    return 0;
}

static const struct spi_device_id held_ids[] = {{"fb_held", 0}, {}};
static struct spi_driver holder = {.driver = {.name = "fb_held"}, .id_table = held_ids, .probe = hold};

/* spidev's driver takes none of its own name, but this one. */
static int add_device(struct spi_controller *spi, u16 chip_select, const char *name)
{
    struct spi_board_info info = {.max_speed_hz = 62500000, .chip_select = chip_select};

    strscpy(info.modalias, name, sizeof(info.modalias));
    return spi_new_device(spi, &info) ? 0 : -ENODEV;
}

static int add_bus(s16 bus, u32 mode_bits, u16 n_selects)
{
    struct spi_controller *spi = spi_alloc_master(&tap.device->dev, 0);
    u16 chip_select;
    int err;

    if (!spi) return -ENOMEM;
    spi->bus_num = bus;
    spi->num_chipselect = n_selects;
    spi->mode_bits = mode_bits;
    spi->use_gpio_descriptors = bus == BUS_SELECTED_BY_LINE;
    spi->bits_per_word_mask = SPI_BPW_MASK(8);
    spi->min_speed_hz = 1000;
    spi->max_speed_hz = 62500000;
    spi->set_cs = select_chip;
    spi->transfer_one = transfer;
    err = spi_register_controller(spi);
    if (err) {
        spi_controller_put(spi);
        return err;
    }
    for (chip_select = 0; chip_select < n_selects && !err; chip_select++)
        err = add_device(spi, chip_select, chip_select == SELECT_HELD ? "fb_held" : "bk4");
    return err;
}

static int add_spi(void)
{
    int err = spi_register_driver(&holder);

    gpiod_add_lookup_table(&chip_selects);
    if (!err) err = add_bus(BUS_USUAL, SPI_CPOL | SPI_CPHA | SPI_CS_HIGH | SPI_NO_CS, N_SELECTS);
    if (!err) err = add_bus(BUS_PLAIN, SPI_CPOL | SPI_CPHA, 1);
    if (!err) err = add_bus(BUS_SELECTED_BY_LINE, SPI_CPOL | SPI_CPHA, 1);
    return err;
}

/* /dev/wire_tap -------------------------------------------------------------------------------- */

static ssize_t tap_read(struct file *file, char __user *to, size_t n_b, loff_t *at)
{
    unsigned int copied_b;
    int err;

    if (kfifo_is_empty(&tap.record) && tap.full) return -EOVERFLOW;
    if (kfifo_is_empty(&tap.record) && file->f_flags & O_NONBLOCK) return 0;
    err = wait_event_interruptible(tap.grown, !kfifo_is_empty(&tap.record));
    if (!err) err = kfifo_to_user(&tap.record, to, n_b, &copied_b);
    return err ? err : copied_b;
}

static const struct file_operations tap_operations = {.owner = THIS_MODULE, .read = tap_read, .llseek = noop_llseek};

static struct miscdevice tap_file = {
    .minor = MISC_DYNAMIC_MINOR,
    .name = "wire_tap",
    .fops = &tap_operations,
    .mode = 0600,
};

/* What was added before an error stays: a kernel whose tap fails is of no use, and halts at once. */
static int __init tap_init(void)
{
    int err;

    spin_lock_init(&tap.lock);
    init_waitqueue_head(&tap.grown);
    tap.memory = vmalloc(FIFO_B);
    if (!tap.memory) return -ENOMEM;
    kfifo_init(&tap.record, tap.memory, FIFO_B);
    tap.device = platform_device_register_simple("wire-tap", PLATFORM_DEVID_NONE, NULL, 0);
    if (IS_ERR(tap.device)) return PTR_ERR(tap.device);
    err = add_lines();
    if (!err) err = add_spi();
    return err ? err : misc_register(&tap_file);
}
device_initcall(tap_init);

MODULE_DESCRIPTION("Recorder of SPI and GPIO for Limner's tests");
MODULE_LICENSE("Dual MIT/GPL");
