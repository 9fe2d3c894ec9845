/* SPDX-License-Identifier: MIT
 *
 * The kernel copies a message into a buffer of its module's parameter `bufsiz`, and refuses a longer one as a whole
 * with EMSGSIZE; so does a controller that takes less. Longer writes are split, and what was refused for its length is
 * sent again in halves.
 * A mode with a flag that the controller does not have is refused as a whole with EINVAL (spi_setup() in the kernel's
 * drivers/spi/spi.c): flags are then tried one by one, for what can be left out, and for who is to blame. */
#include "spidev.h"

#include "fail.h"
#include "spi_devices.h"

#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <linux/spi/spidev.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { USUAL_MOST_B = 4096, LEAST_MOST_B = 16, WORD_BITS = 8 };

static const char BUFSIZ_PATH[] = "/sys/module/spidev/parameters/bufsiz";

static uint32_t bufsiz_b(void)
{
    char text[16] = "";
    const int fd = open(BUFSIZ_PATH, O_RDONLY | O_CLOEXEC);
    if (fd < 0) return USUAL_MOST_B;
    const ssize_t n_b = read(fd, text, sizeof text - 1);
    close(fd);
    const unsigned long value = n_b > 0 ? strtoul(text, NULL, 10) : 0;
    return value > 0 && value <= UINT32_MAX ? (uint32_t)value : USUAL_MOST_B;
}

/* EINTR: a signal came before the kernel had begun. */
static int control(const struct spidev *spidev, unsigned long request, void *argument)
{
    int result;
    do
        result = ioctl(spidev->fd, request, argument);
    while (result < 0 && errno == EINTR);
    return result < 0 ? -errno : result;
}

/* Nodes that there are, as many as there is room for. */
static void list_nodes(char *out, size_t out_b)
{
    glob_t paths;
    out[0] = '\0';
    if (glob("/dev/spidev*", 0, NULL, &paths) != 0) return;
    for (size_t i = 0, used = 0; i < paths.gl_pathc && used < out_b; i++)
        used += (size_t)snprintf(out + used, out_b - used, "%s%s", i ? ", " : "", paths.gl_pathv[i]);
    globfree(&paths);
}

static int no_such_device(const char *path, int err_no, struct port *port)
{
    char there[PORT_ERROR_B / 2], trouble[SPI_TROUBLE_B];
    struct spi_place place;
    if (spi_place_of(&place, path) && spi_place_trouble(trouble, &place))
        return linux_fail(port, err_no, "%s: no such device: %s", path, trouble);
    list_nodes(there, sizeof there);
    if (there[0]) return linux_fail(port, err_no, "%s: no such device; there are %s", path, there);
    if (!spi_place_without_node(&place, 0) || !spi_place_trouble(trouble, &place)) spi_trouble(trouble);
    return linux_fail(port, err_no, "%s: no such device, nor any other; %s", path, trouble);
}

static int cannot_open(const char *path, int err_no, struct port *port)
{
    switch (err_no) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
        return no_such_device(path, err_no, port);
    case EACCES:
    case EPERM:
        return linux_fail_denied(port, err_no, path, "spi");
    case EBUSY:
        return linux_fail(port, err_no, "%s: in use by another program; `fuser %s` names it", path, path);
    default:
        return linux_fail(port, err_no, "%s: %s", path, strerror(err_no));
    }
}

static int cannot_set(const struct spidev *spidev, int err, const char *what, unsigned value)
{
    if (err == -ENOTTY) return linux_fail(spidev->port, ENOTTY, "%s: not an SPI device", spidev->path);
    return linux_fail(spidev->port, -err, "%s: %s %u: %s; the controller cannot do that", spidev->path, what, value,
                      strerror(-err));
}

/* Modes ----------------------------------------------------------------------------------------- */

static const struct {
    uint8_t flag;
    const char *name;
} FLAGS[] = {{SPI_CPHA, "SPI_CPHA"}, {SPI_CPOL, "SPI_CPOL"}, {SPI_CS_HIGH, "SPI_CS_HIGH"}, {SPI_NO_CS, "SPI_NO_CS"}};
enum { FLAG_COUNT = sizeof FLAGS / sizeof FLAGS[0], FLAG_NAMES_B = 48 };

static int set_mode(const struct spidev *spidev, uint8_t mode)
{
    return control(spidev, SPI_IOC_WR_MODE, &mode);
}

/* Those of the flags that the controller refuses by themselves, and their names. */
static uint8_t refused_flags(const struct spidev *spidev, uint8_t mode, char names[FLAG_NAMES_B])
{
    unsigned refused = 0;
    size_t used = 0;
    for (size_t i = 0; i < FLAG_COUNT; i++) {
        if (!(mode & FLAGS[i].flag) || set_mode(spidev, FLAGS[i].flag) != -EINVAL) continue;
        used += (size_t)snprintf(names + used, FLAG_NAMES_B - used, "%s%s", refused ? ", " : "", FLAGS[i].name);
        refused |= FLAGS[i].flag;
    }
    return (uint8_t)refused;
}

/* In brackets. */
static void name_controller(char out[SPI_NAME_B + 3], const char *path)
{
    struct spi_place place;
    char name[SPI_NAME_B];
    out[0] = '\0';
    if (spi_place_of(&place, path) && spi_controller_name(name, &place)) snprintf(out, SPI_NAME_B + 3, " (%s)", name);
}

static void note_left_out(const struct spidev *spidev, uint8_t refused, const char *names)
{
    char controller[SPI_NAME_B + 3];
    name_controller(controller, spidev->path);
    linux_note(spidev->port, "%s: its controller%s refuses %s", spidev->path, controller, names);
    if (refused & SPI_MODE_3)
        linux_note(spidev->port, "mode 0 is taken, in which a display whose chip select is not wired may stay dark");
    if (refused & SPI_NO_CS) linux_note(spidev->port, "chip select is driven, so leave its pin open");
}

/* Flags that can do without: phase and polarity only together. */
static int leave_out(const struct spidev *spidev, uint8_t *mode, uint8_t spare)
{
    char names[FLAG_NAMES_B] = "", controller[SPI_NAME_B + 3];
    const uint8_t refused = refused_flags(spidev, *mode, names);
    if (!refused) return cannot_set(spidev, -EINVAL, "mode", *mode);
    if (refused & ~spare) {
        name_controller(controller, spidev->path);
        return linux_fail(spidev->port, EINVAL, "%s: its controller%s refuses %s", spidev->path, controller, names);
    }
    *mode = (uint8_t)(*mode & ~(refused & SPI_MODE_3 ? refused | SPI_MODE_3 : refused));
    const int err = set_mode(spidev, *mode);
    if (err < 0) return cannot_set(spidev, err, "mode", *mode);
    note_left_out(spidev, refused, names);
    return 0;
}

/* Where chip select is a GPIO line spidev keeps SPI_CS_HIGH set whatever it is told, as the line's own description has
 * the polarity (spidev_ioctl() in drivers/spi/spidev.c, since Linux 5.4). Kernels of some years say then that it is
 * set when it was not asked for, later ones that it is not set when it was. */
static bool keeps_polarity(const struct spidev *spidev, uint8_t mode)
{
    uint8_t with = mode, without = 0;
    const int err = control(spidev, SPI_IOC_RD_MODE, &with);
    if (err < 0) return false;
    if (!(with & SPI_CS_HIGH)) return true;
    if (set_mode(spidev, (uint8_t)(mode & ~SPI_CS_HIGH)) < 0 || control(spidev, SPI_IOC_RD_MODE, &without) < 0)
        return false;
    return without & SPI_CS_HIGH;
}

static int configure_mode(struct spidev *spidev, uint8_t mode, uint8_t spare)
{
    int err = set_mode(spidev, mode);
    if (err == -EINVAL)
        err = leave_out(spidev, &mode, spare);
    else if (err < 0)
        err = cannot_set(spidev, err, "mode", mode);
    spidev->mode = mode & SPI_MODE_3;
    if (err < 0 || !(mode & SPI_CS_HIGH)) return err;
    if (keeps_polarity(spidev, mode))
        linux_note(spidev->port,
                   "%s: its chip select is a GPIO line, whose level the device tree says (cs-gpios); SPI_CS_HIGH "
                   "changes nothing",
                   spidev->path);
    err = set_mode(spidev, mode);
    return err < 0 ? cannot_set(spidev, err, "mode", mode) : 0;
}

/* Whatever the last program has left there: a word of more bits would change the order of bytes. */
static int configure(struct spidev *spidev, uint8_t mode, uint8_t spare)
{
    uint8_t word_bits = WORD_BITS;
    int err = configure_mode(spidev, mode, spare);
    if (err < 0) return err;
    err = control(spidev, SPI_IOC_WR_BITS_PER_WORD, &word_bits);
    if (err < 0) return cannot_set(spidev, err, "bits a word", word_bits);
    err = control(spidev, SPI_IOC_WR_MAX_SPEED_HZ, &spidev->speed_hz);
    if (err < 0) return cannot_set(spidev, err, "Hz", spidev->speed_hz);
    return 0;
}

/* The device ------------------------------------------------------------------------------------ */

int spidev_open(struct spidev *spidev, const char *path, uint8_t mode, uint8_t spare, uint32_t speed_hz,
                struct port *port)
{
    *spidev = (struct spidev){.path = path, .speed_hz = speed_hz, .most_b = bufsiz_b(), .port = port};
    do
        spidev->fd = open(path, O_RDWR | O_CLOEXEC);
    while (spidev->fd < 0 && errno == EINTR);
    if (spidev->fd < 0) return cannot_open(path, errno, port);
    const int err = configure(spidev, mode, spare);
    if (err) spidev_close(spidev);
    return err;
}

void spidev_close(struct spidev *spidev)
{
    if (spidev->fd >= 0) close(spidev->fd);
    spidev->fd = -1;
}

static int send(const struct spidev *spidev, const uint8_t *data, uint32_t n_b)
{
    struct spi_ioc_transfer transfer = {
        .tx_buf = (uintptr_t)data, .len = n_b, .speed_hz = spidev->speed_hz, .bits_per_word = WORD_BITS};
    const int result = control(spidev, SPI_IOC_MESSAGE(1), &transfer);
    if (result < 0) return result;
    return (uint32_t)result == n_b ? 0 : -EIO;
}

static int cannot_send(const struct spidev *spidev, int err, uint32_t n_b)
{
    const char *help = err == -EMSGSIZE                      ? "; raise spidev.bufsiz"
                       : err == -ENODEV || err == -ESHUTDOWN ? "; its driver was unloaded"
                                                             : "";
    return linux_fail(spidev->port, -err, "%s: a message of %u bytes: %s%s", spidev->path, (unsigned)n_b,
                      strerror(-err), help);
}

int spidev_write(void *ctx, const uint8_t *data, size_t n_b)
{
    struct spidev *spidev = ctx;
    while (n_b > 0) {
        const uint32_t part_b = n_b < spidev->most_b ? (uint32_t)n_b : spidev->most_b;
        const int err = send(spidev, data, part_b);
        if (err == -EMSGSIZE && part_b > LEAST_MOST_B) {
            spidev->most_b = part_b / 2;
            continue;
        }
        if (err) return cannot_send(spidev, err, part_b);
        data += part_b;
        n_b -= part_b;
    }
    return 0;
}
