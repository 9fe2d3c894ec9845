/* SPDX-License-Identifier: MIT
 *
 * The program that links this is linked with --wrap for each __wrap_ function here. */
#include "fake_linux.h"

#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <linux/spi/spidev.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

enum { FIRST_FD = 1000, AS_SPI = 1, AS_BUFSIZ, AS_NODE, FAKE_PATHS_MAX = 64 };

struct fake_linux fake;

void fake_linux_init(void)
{
    static const char *const names[] = {"GPIO0", "GPIO1", "GPIO2", "GPIO3", "GPIO4", "GPIO5", "GPIO6", "GPIO7"};
    fake = (struct fake_linux){.spi_path = "/dev/spidev0.0",
                               .bufsiz = "4096\n",
                               .mode_bits = 0xFF,
                               .first_fd = FIRST_FD,
                               .most_b = 4096,
                               .chip_count = 2,
                               .fail_at = -1};
    fake.chips[0] = (struct fake_chip){"/dev/gpiochip0", "gpiochip0", "pinctrl-fake", FAKE_NAMED_LINES, 0, {{0}}};
    fake.chips[1] = (struct fake_chip){"/dev/gpiochip1", "gpiochip1", "expander", 4, 0, {{0}}};
    for (unsigned i = 0; i < FAKE_NAMED_LINES; i++)
        fake.chips[0].lines[i].name = names[i];
}

void fake_fail_at(long n, int err_no)
{
    fake.calls = 0;
    fake.fail_at = n;
    fake.err_no = err_no;
    fake.failed = NULL;
}

/* A call that succeeds may leave anything there. */
bool fake_fails(const char *name)
{
    errno = ENOTRECOVERABLE;
    if (fake.calls++ != fake.fail_at) return false;
    fake.failed = name;
    errno = fake.err_no;
    return true;
}

bool fake_is_interrupted(void)
{
    if (fake.interrupts == 0) return false;
    fake.interrupts--;
    fake.now_ns += fake.interrupt_ns;
    errno = EINTR;
    return true;
}

bool fake_is_clean(void)
{
    return fake.fds == 0 && fake.chips_open == 0 && fake.lines_held == 0 && fake.objects == 0;
}

/* libgpiod -------------------------------------------------------------------------------------- */

struct fake_chip *fake_chip_open(const char *path)
{
    if (fake_fails("chip_open")) return NULL;
    for (unsigned i = 0; i < fake.chip_count; i++) {
        struct fake_chip *chip = &fake.chips[i];
        if (strcmp(chip->path, path) != 0) continue;
        errno = chip->open_err_no;
        if (errno) return NULL;
        fake.chips_open++;
        return chip;
    }
    errno = ENOENT;
    return NULL;
}

void fake_chip_close(void)
{
    fake.chips_open--;
}

int fake_line_request(struct fake_line *line, bool is_output, bool level)
{
    if (fake_fails("line_request")) return -1;
    errno = EBUSY;
    if (line->is_used || line->held) return -1;
    line->held = true;
    line->is_output = is_output;
    line->level = level;
    fake.lines_held++;
    return 0;
}

void fake_line_release(struct fake_line *line)
{
    if (line->released) (void)!write(line->released, line->level ? "1" : "0", 1);
    line->held = false;
    fake.lines_held--;
}

int fake_line_set(struct fake_line *line, bool level)
{
    if (fake_fails("line_set")) return -1;
    errno = EPERM;
    if (!line->held || !line->is_output) return -1;
    line->level = level;
    return line->wire.set ? line->wire.set(line->wire.ctx, level) : 0;
}

int fake_line_wait(struct fake_line *line, uint64_t timeout_ns)
{
    fake.waited_at = fake.calls;
    if (fake_fails("line_wait") || fake_is_interrupted()) return -1;
    if (line->rises) return 1;
    if (fake.rise_after_waits && --fake.rise_after_waits == 0) {
        line->rises++;
        return 1;
    }
    fake.now_ns += timeout_ns;
    return 0;
}

/* The system's calls ---------------------------------------------------------------------------- */

int __wrap_open(const char *path, int flags, ...);
ssize_t __wrap_readlink(const char *path, char *to, size_t most_b);
int __wrap_access(const char *path, int mode);
int __real_open(const char *path, int flags, ...);
int __real_close(int fd);
int __wrap_close(int fd);
ssize_t __wrap_read(int fd, void *to, size_t most_b);
int __wrap_ioctl(int fd, unsigned long request, ...);
int __wrap_glob(const char *pattern, int flags, int (*on_error)(const char *path, int err_no), glob_t *out);
void __wrap_globfree(glob_t *paths);
void *__wrap_calloc(size_t n, size_t size_b);
void *__real_calloc(size_t n, size_t size_b);
int __wrap_clock_gettime(clockid_t id, struct timespec *out);
int __wrap_clock_nanosleep(clockid_t id, int flags, const struct timespec *until, struct timespec *left);

static bool is_fake(int fd)
{
    return fd >= fake.first_fd && fd < fake.first_fd + FAKE_FDS_MAX;
}

static int opened(uint8_t as)
{
    int i = 0;

    while (i < FAKE_FDS_MAX && fake.open_as[i])
        i++;
    errno = EMFILE;
    if (i == FAKE_FDS_MAX) return -1;
    fake.fds++;
    fake.open_as[i] = as;
    return fake.first_fd + i;
}

/* NULL: there is none. */
static const struct fake_node *find_node(const char *path)
{
    for (int i = 0; i < FAKE_NODES_MAX; i++)
        if (fake.nodes[i].path && strcmp(fake.nodes[i].path, path) == 0) return &fake.nodes[i];
    return NULL;
}

int __wrap_access(const char *path, int mode)
{
    assert_int_equal(mode, F_OK);
    const bool is_spi = fake.spi_path && strcmp(path, fake.spi_path) == 0;
    errno = ENOENT;
    return is_spi || find_node(path) ? 0 : -1;
}

ssize_t __wrap_readlink(const char *path, char *to, size_t most_b)
{
    const struct fake_node *node = find_node(path);
    errno = EINVAL;
    if (!node || !node->link) return -1;
    const size_t n_b = strlen(node->link) < most_b ? strlen(node->link) : most_b;
    memcpy(to, node->link, n_b); /* without an end */
    return (ssize_t)n_b;
}

int __wrap_open(const char *path, int flags, ...)
{
    const struct fake_node *node = find_node(path);
    const bool is_spi = strncmp(path, "/dev/", 5) == 0;
    if (!is_spi && strncmp(path, "/sys/", 5) != 0) return __real_open(path, flags); /* no device: a scene, a camera */
    assert_int_equal(flags, (is_spi ? O_RDWR : O_RDONLY) | O_CLOEXEC); /* it is nobody's business whom we start */
    errno = ENOENT;
    if (node && !is_spi) return node->text ? opened((uint8_t)(AS_NODE + (node - fake.nodes))) : -1;
    if (fake_fails(is_spi ? "open" : "open bufsiz")) return -1;
    if (is_spi && fake_is_interrupted()) return -1;
    errno = is_spi ? fake.spi_err_no : 0;
    if (errno) return -1;
    errno = ENOENT;
    if (!is_spi) return fake.bufsiz ? opened(AS_BUFSIZ) : -1;
    return fake.spi_path && strcmp(path, fake.spi_path) == 0 ? opened(AS_SPI) : -1;
}

int __wrap_close(int fd)
{
    if (!is_fake(fd)) return __real_close(fd);
    fake.fds--;
    fake.open_as[fd - fake.first_fd] = 0;
    return 0;
}

ssize_t __wrap_read(int fd, void *to, size_t most_b)
{
    const int as = fake.open_as[fd - fake.first_fd];
    if (as < AS_NODE && fake_fails("read bufsiz")) return -1;
    const char *text = as < AS_NODE ? fake.bufsiz : fake.nodes[as - AS_NODE].text;
    const size_t n_b = strlen(text) < most_b ? strlen(text) : most_b;
    memcpy(to, text, n_b);
    return (ssize_t)n_b;
}

static int send_message(const struct spi_ioc_transfer *transfer)
{
    errno = EMSGSIZE;
    if (transfer->len > fake.most_b) return -1;
    if (fake.message_count < FAKE_MESSAGES_MAX) fake.messages_b[fake.message_count++] = transfer->len;
    fake.speed_hz = transfer->speed_hz;
    fake.word_bits = transfer->bits_per_word;
    if (fake.unsent_b) return (int)(transfer->len - fake.unsent_b);
    if (!fake.display) return (int)transfer->len;
    const struct bus bus = emulated_port_bus(fake.display);
    const int code = bus_write(&bus, (const uint8_t *)(uintptr_t)transfer->tx_buf, transfer->len);
    return code || bus_flush(&bus) ? -1 : (int)transfer->len;
}

static int write_mode(uint8_t mode)
{
    errno = EINVAL;
    if (mode & ~fake.mode_bits) return -1;
    fake.mode = (uint8_t)(mode | (fake.cs_is_gpio ? SPI_CS_HIGH : 0));
    return 0;
}

static uint8_t read_mode(void)
{
    if (!fake.cs_is_gpio) return fake.mode;
    return (uint8_t)(fake.cs_is_told_high ? fake.mode | SPI_CS_HIGH : fake.mode & ~SPI_CS_HIGH);
}

int __wrap_ioctl(int fd, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    void *argument = va_arg(arguments, void *);
    va_end(arguments);
    if (fake_fails("ioctl") || fake_is_interrupted()) return -1;
    errno = EBADF;
    if (!is_fake(fd) || fake.open_as[fd - fake.first_fd] != AS_SPI) return -1;
    errno = ENOTTY;
    if (request == SPI_IOC_MESSAGE(1)) return send_message(argument);
    if (request == SPI_IOC_WR_MODE) return write_mode(*(const uint8_t *)argument);
    if (request == SPI_IOC_RD_MODE)
        *(uint8_t *)argument = read_mode();
    else if (request == SPI_IOC_WR_BITS_PER_WORD)
        fake.word_bits = *(const uint8_t *)argument;
    else if (request == SPI_IOC_WR_MAX_SPEED_HZ)
        fake.speed_hz = *(const uint32_t *)argument;
    else
        return -1;
    return 0;
}

/* As sorted as they are listed. */
static unsigned list_nodes(const char *pattern, char **paths)
{
    const size_t length = strlen(pattern) - 1; /* without its star */
    unsigned count = 0;
    for (int i = 0; i < FAKE_NODES_MAX; i++) {
        const char *path = fake.nodes[i].path;
        if (path && strncmp(path, pattern, length) == 0 && !strchr(path + length, '/')) paths[count++] = strdup(path);
    }
    return count;
}

static unsigned list_devices(bool is_spi, char **paths)
{
    const unsigned spis = !fake.spi_path ? 0 : fake.spi_count ? fake.spi_count : 1;
    const unsigned count = is_spi ? spis : fake.chip_count;
    for (unsigned i = 0; i < count; i++)
        paths[i] = strdup(is_spi ? fake.spi_path : fake.chips[i].path);
    return count;
}

int __wrap_glob(const char *pattern, int flags, int (*on_error)(const char *path, int err_no), glob_t *out)
{
    static char *paths[FAKE_PATHS_MAX];
    (void)flags, (void)on_error;
    const bool is_device = strncmp(pattern, "/dev/", 5) == 0;
    const unsigned count =
        is_device ? list_devices(strcmp(pattern, "/dev/spidev*") == 0, paths) : list_nodes(pattern, paths);
    *out = (glob_t){.gl_pathc = count, .gl_pathv = paths};
    if (count == 0) return GLOB_NOMATCH;
    fake.objects++;
    return 0;
}

void __wrap_globfree(glob_t *paths)
{
    for (size_t i = 0; i < paths->gl_pathc; i++)
        free(paths->gl_pathv[i]);
    fake.objects--;
}

void *__wrap_calloc(size_t n, size_t size_b)
{
    if (!fake.no_memory) return __real_calloc(n, size_b);
    assert_int_equal(n, 1);
    return NULL;
}

int __wrap_clock_gettime(clockid_t id, struct timespec *out)
{
    (void)id;
    *out = (struct timespec){(time_t)(fake.now_ns / 1000000000u), (long)(fake.now_ns % 1000000000u)};
    return 0;
}

int __wrap_clock_nanosleep(clockid_t id, int flags, const struct timespec *until, struct timespec *left)
{
    (void)left;
    if (fake_fails("clock_nanosleep") || fake_is_interrupted()) return errno;
    if (id != CLOCK_MONOTONIC || flags != TIMER_ABSTIME) return EINVAL;
    const uint64_t until_ns = (uint64_t)until->tv_sec * 1000000000u + (uint64_t)until->tv_nsec;
    if (until_ns <= fake.now_ns) return 0;
    if (fake.display) fake.display->now_us += (until_ns - fake.now_ns) / 1000;
    fake.now_ns = until_ns;
    return 0;
}
