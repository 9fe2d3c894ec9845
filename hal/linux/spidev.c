/* SPDX-License-Identifier: MIT
 *
 * The kernel copies a message into a buffer of its module's parameter `bufsiz`, and refuses a longer one as a whole
 * with EMSGSIZE; so does a controller that takes less. Longer writes are split, and what was refused for its length is
 * sent again in halves. */
#include "spidev.h"

#include "fail.h"

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

static int no_such_device(const char *path, int err_no, struct port *port)
{
    char there[PORT_ERROR_B / 2] = "";
    glob_t paths;
    if (glob("/dev/spidev*", 0, NULL, &paths) == 0) {
        for (size_t i = 0, used = 0; i < paths.gl_pathc && used < sizeof there; i++)
            used += (size_t)snprintf(there + used, sizeof there - used, "%s%s", i ? ", " : "", paths.gl_pathv[i]);
        globfree(&paths);
    }
    if (there[0]) return linux_fail(port, err_no, "%s: no such device; there are %s", path, there);
    return linux_fail(port, err_no,
                      "%s: no such device, nor any other; load spidev and the controller's driver (Raspberry Pi: "
                      "dtparam=spi=on)",
                      path);
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

/* Whatever the last program has left there: a word of more bits would change the order of bytes. */
static int configure(struct spidev *spidev, uint8_t mode)
{
    uint8_t word_bits = WORD_BITS;
    int err = control(spidev, SPI_IOC_WR_MODE, &mode);
    if (err < 0) return cannot_set(spidev, err, "mode", mode);
    err = control(spidev, SPI_IOC_WR_BITS_PER_WORD, &word_bits);
    if (err < 0) return cannot_set(spidev, err, "bits a word", word_bits);
    err = control(spidev, SPI_IOC_WR_MAX_SPEED_HZ, &spidev->speed_hz);
    if (err < 0) return cannot_set(spidev, err, "Hz", spidev->speed_hz);
    return 0;
}

int spidev_open(struct spidev *spidev, const char *path, uint8_t mode, uint32_t speed_hz, struct port *port)
{
    *spidev = (struct spidev){.path = path, .speed_hz = speed_hz, .most_b = bufsiz_b(), .port = port};
    do
        spidev->fd = open(path, O_RDWR | O_CLOEXEC);
    while (spidev->fd < 0 && errno == EINTR);
    if (spidev->fd < 0) return cannot_open(path, errno, port);
    const int err = configure(spidev, mode);
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
