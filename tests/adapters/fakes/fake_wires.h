/* SPDX-License-Identifier: MIT
 *
 * A microcontroller's pins and SPI behind a fake library, as a wire log for `limner decode` on standard output. What a
 * display would not understand is told on standard error, and counted: bytes while it is not selected, pins that change
 * while bytes are on their way, bytes that change before they are sent. */
#ifndef FAKE_WIRES_H
#define FAKE_WIRES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of the pins. CLOCK and DATA are the bus's. */
enum { WIRE_NONE, WIRE_CS, WIRE_DC, WIRE_RESET, WIRE_BACKLIGHT, WIRE_SELECT, WIRE_CLOCK, WIRE_DATA, WIRE_COUNT };

void wires_complain(const char *what);
unsigned wires_complaints(void);

/* Of the calls that can fail, the next one number `call`, from 0 on, is to return `failure`; 0 for all others. */
void wires_fail(int call, int failure);
int wires_failure(void);

void wires_output(unsigned pin, bool is_output);
void wires_level(unsigned pin, bool high);
void wires_pass(uint64_t time_us);
uint64_t wires_now_us(void);

/* The bus: rate and mode; or it is not ready. */
void wires_bus(uint32_t hz, int mode);
int wires_mode(void);
void wires_send(const uint8_t *data, size_t n_b);

/* DMA, which reads as late as it may: some bytes when it is asked how many are left, all when it is waited for. The
 * last ones are in the SPI then, until that is asked for being busy. */
void wires_dma(const uint8_t *data, size_t n_b);
size_t wires_dma_left_b(void);
void wires_dma_wait(void);
bool wires_busy(void);

#ifdef __cplusplus
}
#endif

#endif
