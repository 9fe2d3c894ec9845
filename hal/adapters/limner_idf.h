/* SPDX-License-Identifier: MIT
 *
 * A port: Limner's own panels by ESP-IDF's spi_master (5.0 and later): the last part of a write is sent by DMA after
 * the return. What is not wired is GPIO_NUM_NC. Errors are esp_err_t, made negative.
 *
 *     static struct limner_idf port = {SPI2_HOST, 18, 23, 5, 16, 17, GPIO_NUM_NC, GPIO_NUM_NC};
 *     int err = limner_idf_board(&port, &board, MODULE_SPEED_HZ, MODULE_SPI_MODES); // may be called again
 *     if (!err) err = module_setup(&panel, &board);                                // of `limner module` */
#ifndef LIMNER_IDF_H
#define LIMNER_IDF_H
#include "board.h"
#include "driver/gpio.h"
#include "driver/spi_master.h"
#include "esp_rom_sys.h"
#include "freertos/FreeRTOS.h"
struct limner_idf {
    spi_host_device_t host;
    int sck, mosi, cs, dc, reset, backlight, select; /* select: a memory LCD's, whose driver sets it, instead of cs */
    spi_device_handle_t device;                      /* private, as is what follows */
    spi_transaction_t part;
    bool is_queued;
};

static inline int limner_idf_err(esp_err_t err)
{
    return err > 0 ? -err : err; /* ESP_FAIL is negative already */
}

static inline int limner_idf_set(void *ctx, bool high)
{
    return limner_idf_err(gpio_set_level((gpio_num_t)(intptr_t)ctx, high));
}

static inline struct pin limner_idf_pin(int number, bool high)
{
    const struct pin none = {NULL, NULL}, pin = {(void *)(intptr_t)number, limner_idf_set};
    if (number == GPIO_NUM_NC) return none;
    gpio_reset_pin((gpio_num_t)number);
    gpio_set_level((gpio_num_t)number, high), gpio_set_direction((gpio_num_t)number, GPIO_MODE_OUTPUT);
    return pin;
}

static inline int limner_idf_flush(void *ctx)
{
    struct limner_idf *const port = (struct limner_idf *)ctx;
    spi_transaction_t *sent;
    if (!port->is_queued) return 0;
    port->is_queued = false;
    return limner_idf_err(spi_device_get_trans_result(port->device, &sent, portMAX_DELAY));
}

static inline int limner_idf_write(void *ctx, const uint8_t *data, size_t n_b)
{
    struct limner_idf *const port = (struct limner_idf *)ctx;
    size_t part_b = 0;
    for (int err; n_b; data += part_b, n_b -= part_b) {
        part_b = n_b < 4092 ? n_b : 4092; /* what the bus takes at once, if nobody says more */
        if ((err = limner_idf_flush(port))) return err;
        port->part.length = 8 * part_b, port->part.rxlength = 0, port->part.tx_buffer = data;
        if ((err = limner_idf_err(spi_device_queue_trans(port->device, &port->part, portMAX_DELAY)))) return err;
        port->is_queued = true;
    }
    return 0;
}

static inline int limner_idf_delay(void *ctx, uint32_t delay_us)
{
    return (void)ctx, esp_rom_delay_us(delay_us), 0;
}

static inline int limner_idf_board(struct limner_idf *port, struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const struct bus bus = {port, limner_idf_write, limner_idf_flush, NULL, (uint16_t)(spi_hz / 320000)}; /* 25 us */
    const struct clock clock = {NULL, limner_idf_delay};
    spi_bus_config_t wires = {};
    spi_device_interface_config_t device = {};
    wires.mosi_io_num = port->mosi, wires.sclk_io_num = port->sck;
    wires.miso_io_num = wires.quadwp_io_num = wires.quadhd_io_num = GPIO_NUM_NC;
    device.mode = spi_mode_of(spi_modes, 0), device.clock_speed_hz = (int)spi_hz;
    device.spics_io_num = port->cs, device.queue_size = 1;
    board->dc = limner_idf_pin(port->dc, false), board->reset = limner_idf_pin(port->reset, true);
    board->backlight = limner_idf_pin(port->backlight, false), board->select = limner_idf_pin(port->select, false);
    board->bus = bus, board->clock = clock;
    if (port->device) return limner_idf_flush(port);
    esp_err_t err = spi_bus_initialize(port->host, &wires, SPI_DMA_CH_AUTO);
    if (err) return limner_idf_err(err);
    if ((err = spi_bus_add_device(port->host, &device, &port->device))) spi_bus_free(port->host);
    return limner_idf_err(err);
}
#endif
