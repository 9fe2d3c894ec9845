/* SPDX-License-Identifier: MIT */
#include "page/page_board.h"

#include "scene/mcu_mem.h"
#include "scene/moving.h"

const struct page_board page_boards[] = {
    {"bluepill", "Blue pill, STM32F103", 20480, 131072}, {"hifive1", "HiFive1, FE310", 16384, 12582912},
    {"lm3s6965evb", "LM3S6965EVB", 65536, 262144},       {"stm32f405", "Feather STM32F405", 131072, 1048576},
    {"pico", "Raspberry Pi Pico", 270336, 2097152},      {"esp32c3", "ESP32-C3, all in RAM", 306688, 0},
    {"pico2", "Raspberry Pi Pico 2", 532480, 4194304}};
const size_t page_board_count = sizeof page_boards / sizeof *page_boards;

size_t page_flash_b(const struct page *page)
{
    const struct moving *moving = page->scene.moving;
    size_t sum_b = page->scene.report.flash_b;
    for (size_t i = 0; moving && i < moving->count; i++)
        sum_b += moving->objects[i].scene.report.flash_b;
    return sum_b;
}

enum page_fit page_board_fit(const struct page *page, const struct page_board *board)
{
    const size_t flash_b = page_flash_b(page) + PAGE_BOARD_CODE_B;
    const size_t loaded_b = board->flash_b ? 0 : flash_b;
    const size_t ram_b = page_ram_b(page, &page->scene) + PAGE_BOARD_RAM_B + loaded_b;
    const size_t least_b = ram_b - mcu_mem_b(&page->scene) + mcu_mem_min_b(&page->scene);
    if (board->flash_b && flash_b > board->flash_b) return PAGE_NO_FLASH;
    if (least_b > board->ram_b) return PAGE_NO_RAM;
    return ram_b > board->ram_b ? PAGE_FITS_SLOWLY : PAGE_FITS;
}
