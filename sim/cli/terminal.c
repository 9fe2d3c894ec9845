/* SPDX-License-Identifier: MIT
 *
 * Pictures by upper half blocks, whose foreground is the pixel above and whose background the one
 * below; and flying from a terminal, a frame a key press. */
#include "cli/terminal.h"

#include "cli/fly.h"
#include "pictures/dump.h"

#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

static const char UPPER_HALF_BLOCK[] = "\xE2\x96\x80";

static void print_cell(int above, int below, FILE *out)
{
    fprintf(out, "\x1B[38;2;%d;%d;%d;48;2;%d;%d;%dm%s", gdTrueColorGetRed(above), gdTrueColorGetGreen(above),
            gdTrueColorGetBlue(above), gdTrueColorGetRed(below), gdTrueColorGetGreen(below), gdTrueColorGetBlue(below),
            UPPER_HALF_BLOCK);
}

static int at_least_1(double size)
{
    return size < 1.0 ? 1 : (int)size;
}

/* A frame shrunk to fit w_max_px x h_max_px; its height is even. */
static gdImagePtr fitted(const struct film *frame, unsigned w_max_px, unsigned h_max_px)
{
    double scale_x = (double)w_max_px / frame->w_px, scale_y = (double)h_max_px / frame->h_px;
    double scale = scale_x < scale_y ? scale_x : scale_y;
    if (scale > 1.0) scale = 1.0;
    int w_px = at_least_1(frame->w_px * scale), h_px = 2 * at_least_1(frame->h_px * scale / 2.0);
    gdImagePtr whole = image_from_frame(frame, 0);
    gdImagePtr small = whole ? gdImageCreateTrueColor(w_px, h_px) : NULL;
    if (small) gdImageCopyResampled(small, whole, 0, 0, 0, 0, w_px, h_px, gdImageSX(whole), gdImageSY(whole));
    if (whole) gdImageDestroy(whole);
    return small;
}

bool terminal_print(const struct film *frame, unsigned columns, unsigned rows, FILE *out, struct error *err)
{
    gdImagePtr image = fitted(frame, columns, 2 * rows);
    if (!image) return error_set(err, "terminal: out of memory");
    for (int y = 0; y + 1 < gdImageSY(image); y += 2) {
        for (int x = 0; x < gdImageSX(image); x++)
            print_cell(gdImageTrueColorPixel(image, x, y), gdImageTrueColorPixel(image, x, y + 1), out);
        fputs("\x1B[0m\n", out);
    }
    gdImageDestroy(image);
    return fflush(out) == 0 || error_set(err, "terminal: cannot be written");
}

/* Flying ------------------------------------------------------------------------------------- */

static const struct {
    const char *bytes; /* what the terminal sends */
    enum fly_key key;
} KEYS[] = {
    {"w", FLY_FORWARD},      {"s", FLY_BACK},           {"a", FLY_LEFT},           {"d", FLY_RIGHT},
    {"r", FLY_UP},           {"f", FLY_DOWN},           {"\x1B[D", FLY_TURN_LEFT}, {"\x1B[C", FLY_TURN_RIGHT},
    {"\x1B[A", FLY_LOOK_UP}, {"\x1B[B", FLY_LOOK_DOWN}, {"x", FLY_WALLS},
};

static bool show(struct flight *flight, struct error *err)
{
    struct winsize size;
    bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 2;
    unsigned columns = known ? size.ws_col : 80, rows = known ? size.ws_row - 2u : 40;
    if (!flight_frame(flight, err)) return false;
    struct film frame = simulator_film(flight->simulator);
    return terminal_print(&frame, columns, rows, stdout, err);
}

/* One read is one key press, unless keys come faster than frames: then only the first counts. */
static bool next_key(enum fly_key *key)
{
    for (char bytes[16];;) {
        ssize_t n_b = read(STDIN_FILENO, bytes, sizeof bytes - 1);
        if (n_b <= 0) return false;
        bytes[n_b] = '\0';
        bool is_escape_key = bytes[0] == '\x1B' && n_b == 1, is_interrupt = bytes[0] == '\x03';
        if (bytes[0] == 'q' || is_escape_key || is_interrupt) return false;
        for (size_t i = 0; i < sizeof KEYS / sizeof KEYS[0]; i++) {
            if (strncmp(bytes, KEYS[i].bytes, strlen(KEYS[i].bytes)) != 0) continue;
            *key = KEYS[i].key;
            return true;
        }
    }
}

static bool fly_by_keys(struct flight *flight, struct error *err)
{
    enum fly_key key;
    bool ok;
    fputs("\x1B[2J", stdout);
    do {
        fputs("\x1B[H", stdout);
        ok = show(flight, err);
        printf("%s", FLY_HELP);
        fflush(stdout);
    } while (ok && next_key(&key) && (flight_key(flight, key), true));
    putchar('\n');
    return ok;
}

static bool nowhere(struct error *err)
{
    const char *why = window_is_built ? "" : " (built without SDL2: Debian's package libsdl2-dev, then make)";
    return error_set(
        err, "view: neither a window%s nor a terminal to fly in; limner render MODEL --gif x.gif draws a file", why);
}

enum flight_end terminal_fly(struct flight *flight, struct error *err)
{
    struct termios before;
    if (!isatty(STDOUT_FILENO) || tcgetattr(STDIN_FILENO, &before) != 0) {
        const bool ok = dump_is_asked() ? show(flight, err) : nowhere(err);
        return ok ? FLIGHT_ENDED : FLIGHT_FAILED;
    }
    struct termios raw = before;
    raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO | ISIG);
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    bool ok = fly_by_keys(flight, err);
    tcsetattr(STDIN_FILENO, TCSANOW, &before);
    return ok ? FLIGHT_ENDED : FLIGHT_FAILED;
}
