/* SPDX-License-Identifier: MIT
 *
 * The port of hal/linux as a board. Which device and which lines the display hangs on, the environment says:
 *
 *     LIMNER_SPI=/dev/spidev0.0 LIMNER_DC=GPIO25 LIMNER_RESET=GPIO24 build/boards/linux/rooms-st7789-fast/image.elf
 *
 * are what they are if it does not; what it says to be empty is not wired. A signal ends the program; what fails ends
 * it too, and is said in one line: there are no blinks to count. */
#include "board.h"

#include "linux/code_words.h"
#include "linux/fail.h"
#include "linux/interrupt.h"
#include "linux/linux_port.h"
#include "panel.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SPI, MODE, DC, RESET, BACKLIGHT, SELECT, TEARING, LED, WIRES };

static const struct {
    const char *variable, *usual; /* NULL: not wired */
} wires[WIRES] = {
    [SPI] = {"LIMNER_SPI", "/dev/spidev0.0"}, [MODE] = {"LIMNER_MODE", NULL},
    [DC] = {"LIMNER_DC", "GPIO25"},           [RESET] = {"LIMNER_RESET", "GPIO24"},
    [BACKLIGHT] = {"LIMNER_BACKLIGHT", NULL}, [SELECT] = {"LIMNER_SELECT", NULL},
    [TEARING] = {"LIMNER_TE", NULL},          [LED] = {"LIMNER_LED", NULL},
};

/* Where the module takes several. */
enum { USUAL_MODE = 0 };

static struct port port;

static const char *value_of(int wire)
{
    const char *value = getenv(wires[wire].variable);
    if (!value) return wires[wire].usual;
    return *value ? value : NULL;
}

static int read_mode(uint8_t *mode)
{
    const char *text = value_of(MODE);
    if (!text) return 0;
    if (text[0] < '0' || text[0] > '3' || text[1] != '\0')
        return linux_fail(&port, EINVAL, "%s: an SPI mode is 0 to 3", text);
    *mode = (uint8_t)(text[0] - '0');
    return 0;
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    struct linux_port_config config = {.spi = value_of(SPI),
                                       .dc = value_of(DC),
                                       .reset = value_of(RESET),
                                       .backlight = value_of(BACKLIGHT),
                                       .select = value_of(SELECT),
                                       .tearing = value_of(TEARING),
                                       .led = value_of(LED),
                                       .speed_hz = spi_hz};

    interrupt_watch();
    config.mode = spi_mode_of(spi_modes, USUAL_MODE);
    config.any_mode = !value_of(MODE);
    int err = read_mode(&config.mode);
    if (!err) err = linux_port_open(&port, &config);
    if (err) return err;
    if (port.notice[0]) fprintf(stderr, "limner: note: %s\n", port.notice);
    *board = (struct board){.bus = port.bus,
                            .dc = port.dc,
                            .reset = port.reset,
                            .backlight = port.backlight,
                            .select = port.select,
                            .tearing = port.tearing,
                            .clock = port.clock,
                            .led = port.led};
    return 0;
}

bool board_is_over(void)
{
    return interrupt_signal() != 0;
}

/* The port's texts begin with the name of what they are about: of which variable that is the value. */
static void print_wire(const char *text)
{
    for (int i = 0; i < WIRES; i++) {
        const char *value = value_of(i);
        const size_t length = value ? strlen(value) : 0;
        if (length == 0 || strncmp(text, value, length) != 0 || text[length] != ':') continue;
        fprintf(stderr, "%s=", wires[i].variable);
        return;
    }
}

static void explain(int err)
{
    fputs("limner: ", stderr);
    print_wire(port.error);
    if (port.error[0])
        fprintf(stderr, "%s\n", port.error);
    else if (err == PANEL_ERR_CONFIG)
        fputs("the panel wants a wire that is not named: LIMNER_DC, LIMNER_RESET, LIMNER_SELECT\n", stderr);
    else
        fprintf(stderr, "the scene cannot be drawn as it was built: %s (%d)\n", code_words(err), err);
}

int board_end(int err)
{
    if (err) explain(err);
    port_close(&port);
    if (!err) interrupt_die();
    return err ? EXIT_FAILURE : EXIT_SUCCESS;
}
