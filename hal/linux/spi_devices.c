/* SPDX-License-Identifier: MIT
 *
 * In: links and files of /sys/bus/spi/devices and /sys/class/spi_master (Documentation/ABI of the kernel). Overlays are
 * Raspberry Pi's, whose configuration names them (raspberrypi/linux, arch/arm/boot/dts/overlays); drivers are the
 * kernel's (drivers/gpu/drm/tiny, drivers/gpu/drm/solomon, drivers/staging/fbtft). Elsewhere than on a Raspberry Pi
 * the device tree is the machine's own affair. */
#include "spi_devices.h"

#include <fcntl.h>
#include <glob.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PATH_B = 128, LINK_B = 256, UEVENT_B = 512 };

/* Drivers of displays, and of what comes with them, and overlays that bring them. */
static const struct {
    const char *driver, *overlays;
} KNOWN[] = {
    {"panel-mipi-dbi-spi", "mipi-dbi-spi"},
    {"ssd130x-spi", "ssd1306-spi or sh1106-spi"},
    {"st7735r", "adafruit-st7735r"},
    {"ili9486", "piscreen"},
    {"ads7846", "ads7846, or a display's with touch"},
};
static const char FBTFT_PREFIX[] = "fb_", FBTFT_OVERLAYS[] = "fbtft, or a display's, such as piscreen";

/* Files ----------------------------------------------------------------------------------------- */

/* The last part of where a link leads; false: it is no link. */
static bool link_name(char out[SPI_NAME_B], const char *path)
{
    char target[LINK_B];
    const ssize_t n_b = readlink(path, target, sizeof target - 1);
    out[0] = '\0';
    if (n_b <= 0) return false;
    target[n_b] = '\0';
    const char *slash = strrchr(target, '/');
    snprintf(out, SPI_NAME_B, "%.*s", SPI_NAME_B - 1, slash ? slash + 1 : target);
    return true;
}

static bool read_text(char *out, size_t out_b, const char *path)
{
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    out[0] = '\0';
    if (fd < 0) return false;
    const ssize_t n_b = read(fd, out, out_b - 1);
    close(fd);
    out[n_b > 0 ? n_b : 0] = '\0';
    return n_b > 0;
}

/* A Raspberry Pi's, which says what its device tree has; NULL: it is none. */
static const char *config_path(void)
{
    static const char *const paths[] = {"/boot/firmware/config.txt", "/boot/config.txt"};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++)
        if (access(paths[i], F_OK) == 0) return paths[i];
    return NULL;
}

/* Places ---------------------------------------------------------------------------------------- */

static bool place_parse(struct spi_place *out, const char *path, const char *format)
{
    const char *slash = strrchr(path, '/');
    int length = 0;
    const char *name = slash ? slash + 1 : path;
    return sscanf(name, format, &out->bus, &out->select, &length) == 2 && length > 0 && name[length] == '\0';
}

bool spi_place_of(struct spi_place *out, const char *path)
{
    char name[SPI_NAME_B];
    return place_parse(out, link_name(name, path) ? name : path, "spidev%u.%u%n");
}

bool spi_controller_name(char out[SPI_NAME_B], const struct spi_place *place)
{
    char path[PATH_B];
    snprintf(path, sizeof path, "/sys/class/spi_master/spi%u/device/driver", place->bus);
    return link_name(out, path);
}

static bool has_node(const struct spi_place *place)
{
    char path[PATH_B];
    snprintf(path, sizeof path, "/dev/spidev%u.%u", place->bus, place->select);
    return access(path, F_OK) == 0;
}

bool spi_place_without_node(struct spi_place *out, size_t index)
{
    glob_t paths;
    bool found = false;
    if (glob("/sys/bus/spi/devices/spi*", 0, NULL, &paths) != 0) return false;
    for (size_t i = 0; i < paths.gl_pathc && !found; i++)
        found = place_parse(out, paths.gl_pathv[i], "spi%u.%u%n") && !has_node(out) && index-- == 0;
    globfree(&paths);
    return found;
}

/* What is wrong --------------------------------------------------------------------------------- */

static const char *overlays_of(const char *driver)
{
    for (size_t i = 0; i < sizeof KNOWN / sizeof KNOWN[0]; i++)
        if (strcmp(driver, KNOWN[i].driver) == 0) return KNOWN[i].overlays;
    return strncmp(driver, FBTFT_PREFIX, sizeof FBTFT_PREFIX - 1) == 0 ? FBTFT_OVERLAYS : NULL;
}

static void held_by(char out[SPI_TROUBLE_B], const struct spi_place *place, const char *driver)
{
    const char *config = config_path(), *overlays = overlays_of(driver);
    const size_t used =
        (size_t)snprintf(out, SPI_TROUBLE_B, "the kernel's driver %s has spi%u.%u", driver, place->bus, place->select);
    char *end = out + used;
    const size_t left_b = SPI_TROUBLE_B - used;
    if (config && overlays)
        snprintf(end, left_b, ", by an overlay (dtoverlay=%s); put dtparam=spi=on in its place in %s, and start anew",
                 overlays, config);
    else if (config)
        snprintf(end, left_b, "; put dtparam=spi=on in the place of its dtoverlay in %s, and start anew", config);
    else
        snprintf(end, left_b, ", as the device tree says%s%s%s; hal/linux/README.md says how to free it",
                 overlays ? " (on a Raspberry Pi dtoverlay=" : "", overlays ? overlays : "", overlays ? ")" : "");
}

/* Of a device that no driver has: what its device tree calls it, or whoever else made it. */
static void read_kind(char out[SPI_NAME_B], const struct spi_place *place)
{
    static const char *const keys[] = {"OF_COMPATIBLE_0=", "MODALIAS=spi:"};
    char path[PATH_B], text[UEVENT_B];
    snprintf(path, sizeof path, "/sys/bus/spi/devices/spi%u.%u/uevent", place->bus, place->select);
    (void)read_text(text, sizeof text, path);
    snprintf(out, SPI_NAME_B, "device");
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        const char *value = strstr(text, keys[i]);
        if (!value) continue;
        value += strlen(keys[i]);
        snprintf(out, SPI_NAME_B, "%.*s", (int)strcspn(value, "\n"), value);
        return;
    }
}

static void held_by_none(char out[SPI_TROUBLE_B], const struct spi_place *place)
{
    char kind[SPI_NAME_B];
    read_kind(kind, place);
    if (strstr(kind, "spidev"))
        snprintf(out, SPI_TROUBLE_B, "no driver has spi%u.%u; load spidev (sudo modprobe spidev)", place->bus,
                 place->select);
    else
        snprintf(out, SPI_TROUBLE_B,
                 "spi%u.%u is kept for another driver (%s), which is not loaded; hal/linux/README.md says how to "
                 "free it",
                 place->bus, place->select, kind);
}

bool spi_place_trouble(char out[SPI_TROUBLE_B], const struct spi_place *place)
{
    char path[PATH_B], name[SPI_NAME_B];
    snprintf(path, sizeof path, "/sys/bus/spi/devices/spi%u.%u", place->bus, place->select);
    if (access(path, F_OK) != 0) return false;
    strcat(path, "/driver");
    if (!link_name(name, path))
        held_by_none(out, place);
    else if (strcmp(name, "spidev") != 0)
        held_by(out, place, name);
    else
        snprintf(out, SPI_TROUBLE_B,
                 "spidev has spi%u.%u, but its node is missing; udev makes them, and containers want them passed on",
                 place->bus, place->select);
    return true;
}

void spi_trouble(char out[SPI_TROUBLE_B])
{
    const char *config = config_path();
    if (config)
        snprintf(out, SPI_TROUBLE_B, "SPI is off; put dtparam=spi=on into %s, and start anew", config);
    else
        snprintf(out, SPI_TROUBLE_B, "load spidev and the controller's driver (Raspberry Pi: dtparam=spi=on)");
}
