// SPDX-License-Identifier: MIT OR GPL-2.0
/*
 * A display at the end of the tapped wires (wire_tap.c) that one of the kernel's own drivers takes: whoever writes its
 * name and properties to /dev/wire_display, as `fb_st7735r reset-low buswidth=8 bgr`, puts it at chip select 0 of bus
 * 0, instead of what is there. Its lines are DC and RESET; reset-low is for drivers that say whether reset is active,
 * others say which level its line has. Built into the kernel of tests/kernel.
 */
#include <linux/dma-mapping.h>
#include <linux/gpio/machine.h>
#include <linux/miscdevice.h>
#include <linux/module.h>
#include <linux/property.h>
#include <linux/spi/spi.h>
#include <linux/string.h>
#include <linux/uaccess.h>

#include "wire_tap.h"

#define PLACE "spi0.0"

enum { PROPERTIES_MAX = 8, DESCRIPTION_MAX_B = 200, SPEED_HZ = 62500000 };

static struct gpiod_lookup_table wiring = {
    .dev_id = PLACE,
    .table = {GPIO_LOOKUP("wire-tap", WIRE_DC, "dc", GPIO_ACTIVE_HIGH),
              GPIO_LOOKUP("wire-tap", WIRE_RESET, "reset", GPIO_ACTIVE_LOW),
              {}},
};

struct description {
    const char *name;
    bool reset_low;
    struct property_entry properties[PROPERTIES_MAX + 1]; /* ends with an empty one */
};

/* "NAME=NUMBER", or "NAME" for what is or is not. */
static int read_property(char *word, struct property_entry *property)
{
    const char *name = strsep(&word, "=");
    u32 value;

    if (!word) {
        *property = (struct property_entry)PROPERTY_ENTRY_BOOL(name);
        return 0;
    }
    if (kstrtou32(word, 0, &value)) return -EINVAL;
    *property = (struct property_entry)PROPERTY_ENTRY_U32(name, 0);
    property->value.u32_data[0] = value;
    return 0;
}

/* Words, divided by spaces. */
static int read_description(char *text, struct description *out)
{
    unsigned int n = 0;
    int err = 0;
    char *word;

    out->name = strsep(&text, " ");
    while (!err && (word = strsep(&text, " "))) {
        if (strcmp(word, "reset-low") == 0)
            out->reset_low = true;
        else
            err = n == PROPERTIES_MAX ? -E2BIG : read_property(word, &out->properties[n++]);
    }
    return err;
}

/* A driver of direct rendering wants memory that its device could reach, if it were one that reached memory. */
static int add_display(struct spi_controller *spi, const struct description *description)
{
    struct spi_device *device = spi_alloc_device(spi);
    int err = 0;

    if (!device) return -ENOMEM;
    device->max_speed_hz = SPEED_HZ;
    strscpy(device->modalias, description->name, sizeof(device->modalias));
    device->dev.coherent_dma_mask = DMA_BIT_MASK(32);
    device->dev.dma_mask = &device->dev.coherent_dma_mask;
    if (description->properties[0].name)
        err = device_create_managed_software_node(&device->dev, description->properties, NULL);
    if (!err) err = spi_add_device(device);
    if (err) spi_dev_put(device);
    return err;
}

/* There is a device always, spidev's at first; the bus outlives it. */
static int exchange(const struct description *description)
{
    struct device *before = bus_find_device_by_name(&spi_bus_type, NULL, PLACE);
    struct spi_controller *spi;
    int err;

    if (!before) return -ENODEV;
    spi = spi_controller_get(to_spi_device(before)->controller);
    spi_unregister_device(to_spi_device(before));
    put_device(before);
    gpiod_remove_lookup_table(&wiring);
    wiring.table[1].flags = description->reset_low ? GPIO_ACTIVE_LOW : GPIO_ACTIVE_HIGH;
    gpiod_add_lookup_table(&wiring);
    err = add_display(spi, description);
    spi_controller_put(spi);
    return err;
}

static ssize_t display_write(struct file *file, const char __user *from, size_t n_b, loff_t *at)
{
    char *text = n_b <= DESCRIPTION_MAX_B ? memdup_user_nul(from, n_b) : ERR_PTR(-E2BIG);
    struct description description = {};
    int err;

    if (IS_ERR(text)) return PTR_ERR(text);
    err = read_description(strim(text), &description);
    if (!err) err = exchange(&description);
    kfree(text);
    return err ? err : n_b;
}

static const struct file_operations display_operations = {
    .owner = THIS_MODULE, .write = display_write, .llseek = noop_llseek};

static struct miscdevice display_file = {
    .minor = MISC_DYNAMIC_MINOR,
    .name = "wire_display",
    .fops = &display_operations,
    .mode = 0600,
};

static int __init display_init(void)
{
    gpiod_add_lookup_table(&wiring);
    return misc_register(&display_file);
}
device_initcall(display_init);

MODULE_DESCRIPTION("Displays for Limner's tests");
MODULE_LICENSE("Dual MIT/GPL");
