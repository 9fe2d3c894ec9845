/* SPDX-License-Identifier: MIT
 *
 * `limner devices`: what a display can hang on here, a line each, and why something cannot be used. A kind of device is
 * one function of the list below. */
#include "base/printable.h"
#include "cli/commands.h"
#include "hid/hid_bridges.h"
#include "linux/gpio_lines.h"
#include "linux/spi_devices.h"

#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *help_for(int err_no, const char *group_help)
{
    return err_no == EACCES || err_no == EPERM ? group_help : "";
}

/* Device nodes, or that there are `none`; NULL: then nothing. */
static void print_all(const char *pattern, void (*print)(const char *path), const char *none)
{
    glob_t paths;
    if (glob(pattern, 0, NULL, &paths) != 0) {
        if (none) puts(none);
        return;
    }
    for (size_t i = 0; i < paths.gl_pathc; i++)
        print(paths.gl_pathv[i]);
    globfree(&paths);
}

/* spidev ---------------------------------------------------------------------------------------- */

static void print_spidev(const char *path)
{
    const int fd = open(path, O_RDWR | O_CLOEXEC);
    if (fd < 0) {
        printable_print(stdout, "spi   %s: %s%s\n", path, strerror(errno),
                        help_for(errno, "; join group spi, or add the udev rule of hal/linux/README.md"));
        return;
    }
    close(fd);
    char controller[SPI_NAME_B];
    struct spi_place place;
    const bool is_known = spi_place_of(&place, path) && spi_controller_name(controller, &place);
    printable_print(stdout, "spi   %s: usable%s%s\n", path, is_known ? ", on " : "", is_known ? controller : "");
}

/* What an overlay has taken is listed as well, and how it comes back. */
static void print_spidevs(void)
{
    char trouble[SPI_TROUBLE_B], none[SPI_TROUBLE_B + 32];
    struct spi_place place;
    spi_trouble(trouble);
    snprintf(none, sizeof none, "spi   none: no /dev/spidev*; %s", trouble);
    print_all("/dev/spidev*", print_spidev, spi_place_without_node(&place, 0) ? NULL : none);
    for (size_t i = 0; spi_place_without_node(&place, i); i++)
        if (spi_place_trouble(trouble, &place))
            printable_print(stdout, "spi   spi%u.%u: %s\n", place.bus, place.select, trouble);
}

/* GPIO ------------------------------------------------------------------------------------------ */

/* The lines that have names, of one sort: `used` or free. Returns how many. */
static unsigned print_lines(const struct gpio_chip *chip, bool used, const char *heading)
{
    struct gpio_line_info info;
    unsigned count = 0;
    for (unsigned offset = 0; offset < chip->n_lines; offset++) {
        if (gpio_chip_line(chip, offset, &info) != 0 || info.name[0] == '\0' || info.is_used != used) continue;
        printable_print(stdout, "%s%s", count++ ? ", " : heading, info.name);
        if (used) printable_print(stdout, " by %s", info.consumer[0] ? info.consumer : "the kernel");
    }
    return count;
}

static void print_gpiochip(const char *path)
{
    struct gpio_chip chip;
    const int err = gpio_chip_open(&chip, path);
    if (err) {
        printable_print(stdout, "gpio  %s: %s%s\n", path, strerror(-err),
                        help_for(-err, "; join group gpio, or add the udev rule of hal/linux/README.md"));
        return;
    }
    if (strcmp(strrchr(path, '/') + 1, chip.name) == 0) {
        printable_print(stdout, "gpio  %s (%s): usable, %u lines", chip.name, chip.label, chip.n_lines);
        const unsigned named = print_lines(&chip, false, "; free: ") + print_lines(&chip, true, "; in use: ");
        puts(named ? "" : ", none with a name: CHIP:NUMBER names them");
    } else {
        printable_print(stdout, "gpio  %s: the same as /dev/%s\n", path, chip.name);
    }
    gpio_chip_close(&chip);
}

static void print_gpiochips(void)
{
    print_all("/dev/gpiochip*", print_gpiochip,
              "gpio  none: no /dev/gpiochip*; load the driver of the machine's GPIO controller");
}

/* USB-HID bridges ------------------------------------------------------------------------------- */

static void print_bridge(const struct hid_bridge *bridge)
{
    const struct bridge_kind *kind = bridge->kind;
    char why[HID_WHY_B];
    hid_device *device;
    const bool usable = hid_bridges_open(bridge, &device, why) == 0;
    if (usable) hid_close(device);
    printable_print(stdout, "hid   %s %s (%s): %s", kind->name,
                    bridge->serial[0] ? bridge->serial : "without a readable serial number", bridge->path,
                    usable ? "usable" : why);
    if (usable) printf(", pins GP0 to GP%d", kind->pins - 1);
    puts(kind->experimental ? kind->experimental : "");
}

static void print_bridges(void)
{
    struct hid_bridge found[HID_BRIDGES_MAX];
    const size_t n = hid_bridges_find(found);
    if (n == 0) puts("hid   none: no MCP2210 (USB 04d8:00de)");
    for (size_t i = 0; i < n; i++)
        print_bridge(&found[i]);
}

/* All kinds ------------------------------------------------------------------------------------- */

static void (*const PRINT_KIND[])(void) = {print_spidevs, print_gpiochips, print_bridges};

int cmd_devices(int argc, char **argv)
{
    if (argc > 1) {
        fprintf(stderr, "limner: devices: takes nothing, what is '%s'?\n", argv[1]);
        return EXIT_FAILURE;
    }
    for (size_t i = 0; i < sizeof PRINT_KIND / sizeof PRINT_KIND[0]; i++)
        PRINT_KIND[i]();
    return EXIT_SUCCESS;
}
