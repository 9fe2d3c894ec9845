/* SPDX-License-Identifier: MIT
 *
 * One bus with one device, whose chip select falls and rises with each transaction. A transaction is the driver's until
 * its result was fetched. Three of the calls can fail by wires_fail(). */
#include "driver/spi_master.h"
#include "fake_wires.h"
#include "freertos/task.h"

enum { DEFAULT_MOST_B = 4092 };

struct spi_device_t {
    spi_device_interface_config_t config;
    spi_transaction_t *queued, as_given;
};

static bool is_initialized, has_device;
static struct spi_device_t device;

static void select_display(bool selected)
{
    if (device.config.spics_io_num >= 0) wires_level((unsigned)device.config.spics_io_num, !selected);
}

esp_err_t spi_bus_initialize(spi_host_device_t host_id, const spi_bus_config_t *bus_config, spi_dma_chan_t dma_chan)
{
    if (host_id != SPI2_HOST || bus_config->mosi_io_num != WIRE_DATA || bus_config->sclk_io_num != WIRE_CLOCK ||
        bus_config->miso_io_num != -1 || bus_config->quadwp_io_num != -1 || bus_config->quadhd_io_num != -1 ||
        bus_config->max_transfer_sz || dma_chan != SPI_DMA_CH_AUTO)
        return ESP_ERR_INVALID_ARG;
    if (is_initialized) return ESP_ERR_INVALID_STATE;
    const esp_err_t failure = wires_failure();
    is_initialized = !failure;
    return failure;
}

esp_err_t spi_bus_free(spi_host_device_t host_id)
{
    if (host_id != SPI2_HOST || !is_initialized || has_device) return ESP_ERR_INVALID_STATE;
    is_initialized = false;
    return ESP_OK;
}

esp_err_t spi_bus_add_device(spi_host_device_t host_id, const spi_device_interface_config_t *dev_config,
                             spi_device_handle_t *handle)
{
    if (!is_initialized || host_id != SPI2_HOST || dev_config->queue_size < 1) return ESP_ERR_INVALID_ARG;
    const esp_err_t failure = wires_failure();
    if (failure) return failure;
    has_device = true;
    device.config = *dev_config;
    if (dev_config->spics_io_num >= 0) wires_output((unsigned)dev_config->spics_io_num, true);
    select_display(false);
    wires_bus((uint32_t)dev_config->clock_speed_hz, dev_config->mode);
    *handle = &device;
    return ESP_OK;
}

esp_err_t spi_device_queue_trans(spi_device_handle_t handle, spi_transaction_t *trans_desc, TickType_t ticks_to_wait)
{
    (void)ticks_to_wait;
    if (trans_desc->length % 8 || trans_desc->length > 8 * DEFAULT_MOST_B || trans_desc->rxlength > trans_desc->length)
        return ESP_ERR_INVALID_ARG;
    if (handle->queued) wires_complain("ESP-IDF: a transaction is queued whose last result was not fetched");
    const esp_err_t failure = wires_failure();
    if (failure) return failure;
    if (!trans_desc->rxlength) trans_desc->rxlength = trans_desc->length;
    handle->queued = trans_desc;
    handle->as_given = *trans_desc;
    select_display(true);
    wires_dma(trans_desc->tx_buffer, trans_desc->length / 8);
    return ESP_OK;
}

esp_err_t spi_device_get_trans_result(spi_device_handle_t handle, spi_transaction_t **trans_desc,
                                      TickType_t ticks_to_wait)
{
    if (!handle->queued) {
        if (ticks_to_wait == portMAX_DELAY) wires_complain("ESP-IDF: waits for ever for no transaction");
        return ESP_ERR_TIMEOUT;
    }
    if (handle->queued->tx_buffer != handle->as_given.tx_buffer || handle->queued->length != handle->as_given.length)
        wires_complain("ESP-IDF: a transaction changed while it was queued");
    wires_dma_wait();
    while (wires_busy())
        continue;
    select_display(false);
    *trans_desc = handle->queued;
    handle->queued = NULL;
    return ESP_OK;
}

void vTaskDelay(TickType_t xTicksToDelay)
{
    wires_pass(UINT64_C(10000) * xTicksToDelay);
}
