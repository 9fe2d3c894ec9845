/* SPDX-License-Identifier: MIT
 *
 * A Linux machine for hal/linux, without a kernel: one SPI device, and GPIO chips behind stand-ins for libgpiod's
 * functions, of the generation that the tests are built for. What is sent and set reaches an emulated display. Calls
 * can be made to fail, and what is open is counted. */
#ifndef TESTS_FAKE_LINUX_H
#define TESTS_FAKE_LINUX_H

#include "glass/emulated_display.h"

enum {
    FAKE_CHIPS_MAX = 3,
    FAKE_LINES_MAX = 16,
    FAKE_NODES_MAX = 8,
    FAKE_NAMED_LINES = 8,
    FAKE_MESSAGES_MAX = 1024,
    FAKE_FDS_MAX = 8
};

struct fake_line {
    const char *name;     /* NULL: none */
    const char *consumer; /* of another program's, that has it; NULL: nobody */
    bool is_used;
    struct pin wire; /* what an output reaches */
    bool held, is_output, level;
    unsigned rises; /* remembered */
    int released;   /* a file that gets the line's level, 0 or 1, when it is let go; 0: none */
};

struct fake_chip {
    const char *path, *name, *label;
    unsigned n_lines;
    int open_err_no; /* 0: it opens */
    struct fake_line lines[FAKE_LINES_MAX];
};

/* A path of /sys, /dev or /boot beside the SPI device and the chips. */
struct fake_node {
    const char *path;
    const char *text; /* what it holds; NULL: it cannot be read */
    const char *link; /* where it leads; NULL: it is no link */
};

struct fake_linux {
    /* The machine; to be set by a test. */
    const char *spi_path; /* NULL: there is none */
    unsigned spi_count;   /* so often it is listed; 0: once */
    bool no_memory;       /* nothing can be allocated, and nobody wants more than one of anything */
    int spi_err_no;       /* of opening it; 0: it opens */
    const char *bufsiz;   /* text of the module's parameter; NULL: unreadable */
    struct fake_node nodes[FAKE_NODES_MAX];
    uint8_t mode_bits;    /* of SPI's flags, those that the controller has */
    bool cs_is_gpio;      /* its level is the device tree's: SPI_CS_HIGH stays set */
    bool cs_is_told_high; /* and so it is read, as by some kernels; else as never set */
    int first_fd;         /* the least descriptor that is free; as it is, nobody else's */
    size_t most_b;        /* of a message, for the kernel */
    size_t unsent_b;      /* of each message, that the kernel says it has not sent */
    unsigned chip_count;
    struct fake_chip chips[FAKE_CHIPS_MAX];
    struct emulated_port *display; /* NULL: bytes go nowhere */
    unsigned rise_after_waits;     /* a tearing line rises during the n-th wait from now; 0: never */

    /* What happened. */
    uint8_t mode, word_bits;
    uint32_t speed_hz;
    size_t messages_b[FAKE_MESSAGES_MAX]; /* length of each message */
    unsigned message_count;
    uint64_t now_ns;
    int fds, chips_open, lines_held, objects; /* not closed, released or freed yet */
    uint8_t open_as[FAKE_FDS_MAX];            /* what the descriptors from the first on are open as; 0: they are not */

    /* Faults: the call of that index among all that can fail, counted from 0. */
    long calls, fail_at;   /* -1: none */
    int err_no;            /* that it sets */
    const char *failed;    /* its name; NULL: none has failed yet */
    long waited_at;        /* the last call that waited for a line */
    unsigned interrupts;   /* of so many calls that can be interrupted, before they succeed */
    uint64_t interrupt_ns; /* that each of them takes */
};

extern struct fake_linux fake;

/* A machine with an SPI device, bufsiz 4096 and the chips gpiochip0 (pinctrl-fake), with GPIO0 .. GPIO7, and gpiochip1
 * (expander), whose lines have no names. */
void fake_linux_init(void);

/* The n-th call from now fails; -1: none. */
void fake_fail_at(long n, int err_no);

/* Whether this call is to fail; errno is set then. */
bool fake_fails(const char *name);
bool fake_is_interrupted(void);

/* All that has been opened is closed. */
bool fake_is_clean(void);

/* For the stand-ins: NULL or negative with errno set, as libgpiod has it. */
struct fake_chip *fake_chip_open(const char *path);
void fake_chip_close(void);
int fake_line_request(struct fake_line *line, bool is_output, bool level);
void fake_line_release(struct fake_line *line);
int fake_line_set(struct fake_line *line, bool level);
int fake_line_wait(struct fake_line *line, uint64_t timeout_ns);

#endif
