/* SPDX-License-Identifier: MIT
 *
 * The display behind a fake library: a chip with a window, which is filled row by row, and a bus that is taken and
 * given back. What a real one would show wrong, it says on standard error, and counts. */
#ifndef FAKE_DISPLAY_H
#define FAKE_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { FAKE_W_PX = 320, FAKE_H_PX = 320 };

void fake_complain(const char *what);
unsigned fake_complaints(void);

/* The picture's place, columns x0 to x1 and rows y0 to y1, both in it. */
void fake_window(int x0, int y0, int x1, int y1);

/* The next pixel of the window, RGB565 as a number; or as the bytes that go over the bus, that with the red bits first.
 */
void fake_pixel(uint16_t rgb565);
void fake_bytes(const uint8_t *bytes, int n_px);

/* Pixels that the open window still takes. */
int fake_left_px(void);

/* FNV-1a of a part of what is shown, 64 bits, as `limner render --write-hashes` has it; and nothing is shown any more.
 */
uint64_t fake_hash(int x0, int y0, int w_px, int h_px);
void fake_wipe(void);

#ifdef __cplusplus
}
#endif

#endif
