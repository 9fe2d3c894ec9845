/* SPDX-License-Identifier: MIT
 *
 * The boards that images are made for, and whether a scene fits. */
#ifndef SIM_PAGE_BOARD_H
#define SIM_PAGE_BOARD_H

#include "page/page.h"

struct page_board {
    const char *name;      /* of its folder in boards/ */
    const char *title;     /* for people */
    size_t ram_b, flash_b; /* as its board.mk has them; flash_b 0: all is in RAM */
};

/* What an image takes beside the scene: renderer, driver, screen, stack. */
enum { PAGE_BOARD_CODE_B = 24 << 10, PAGE_BOARD_RAM_B = 2 << 10 };

enum page_fit { PAGE_FITS, PAGE_FITS_SLOWLY, PAGE_NO_RAM, PAGE_NO_FLASH };

extern const struct page_board page_boards[];
extern const size_t page_board_count;

/* Slowly: with pools that are too short for some frames, which take more walks for the same pixels. */
enum page_fit page_board_fit(const struct page *page, const struct page_board *board);

/* Arrays of the scene and of what moves in it. */
size_t page_flash_b(const struct page *page);

#endif
