/* @name@ in an endless orbit, on an ST7789 by ESP-IDF's esp_lcd. Another controller: another esp_lcd_new_panel_...(). */
#include "@name@.h"
#include "driver/gpio.h"
#include "driver/spi_master.h"
#include "esp_lcd_panel_vendor.h"
#include "esp_log.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"
#include "limner_esp_lcd.h"

enum { PIN_CLOCK = 18, PIN_DATA = 23, PIN_CS = 5, PIN_DC = 16, PIN_RESET = 17, PIN_BACKLIGHT = 4, LINES = 8 };

@SCENE@_MEMORY(@W@, @H@);
static uint16_t blocks[2 * LINES * @W@]; /* one is sent while the other is filled */
static struct limner_esp_lcd display = {.memory = &@scene@_memory, .blocks = blocks, .blocks_b = sizeof blocks};

static esp_lcd_panel_handle_t start_panel(esp_lcd_panel_io_handle_t *io)
{
    const spi_bus_config_t bus = {.sclk_io_num = PIN_CLOCK,
                                  .mosi_io_num = PIN_DATA,
                                  .miso_io_num = GPIO_NUM_NC,
                                  .quadwp_io_num = GPIO_NUM_NC,
                                  .quadhd_io_num = GPIO_NUM_NC,
                                  .max_transfer_sz = sizeof blocks / 2};
    const esp_lcd_panel_io_spi_config_t wires = {.cs_gpio_num = PIN_CS,
                                                 .dc_gpio_num = PIN_DC,
                                                 .pclk_hz = 40000000,
                                                 .trans_queue_depth = 4,
                                                 .lcd_cmd_bits = 8,
                                                 .lcd_param_bits = 8};
    const esp_lcd_panel_dev_config_t chip = {
        .reset_gpio_num = PIN_RESET, .rgb_ele_order = LCD_RGB_ELEMENT_ORDER_RGB, .bits_per_pixel = 16};
    esp_lcd_panel_handle_t panel;

    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &wires, io));
    ESP_ERROR_CHECK(esp_lcd_new_panel_st7789(*io, &chip, &panel));
    ESP_ERROR_CHECK(esp_lcd_panel_reset(panel));
    ESP_ERROR_CHECK(esp_lcd_panel_init(panel));
    ESP_ERROR_CHECK(esp_lcd_panel_invert_color(panel, true)); /* as nearly all IPS glass wants */
    ESP_ERROR_CHECK(esp_lcd_panel_disp_on_off(panel, true));
    ESP_ERROR_CHECK(gpio_set_direction((gpio_num_t)PIN_BACKLIGHT, GPIO_MODE_OUTPUT));
    ESP_ERROR_CHECK(gpio_set_level((gpio_num_t)PIN_BACKLIGHT, 1));
    return panel;
}

void app_main(void)
{
    static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);
    struct lim_camera camera = {.near_q8 = @SCENE@_M_Q8(@ORBIT_M@ / 20.0)};
    esp_lcd_panel_io_handle_t io;
    esp_lcd_panel_handle_t panel = start_panel(&io);
    int err = limner_esp_lcd_begin(&display, panel, io);

    if (!err) err = @scene@_begin(&@scene@_memory, limner_esp_lcd_send, &display);
    if (!err) err = lim_camera_set_fov(&camera, LIM_DEGREES(@LENS@), @W@, @H@);
    for (uint32_t yaw = 0; !err; yaw += LIM_DEGREES(2)) {
        lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), yaw, LIM_DEGREES(-20));
        err = lim_frame(@scene@_memory.lim, &camera);
        vTaskDelay(1); /* others have their turn */
    }
    ESP_LOGE("limner", "error %d", err);
}
