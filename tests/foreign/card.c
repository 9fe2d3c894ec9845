/* SPDX-License-Identifier: MIT
 *
 * The test card as a PPM file on standard output, for drivers that this project did not write: card WIDTH HEIGHT */
#include "pictures/image.h"
#include "test_card.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    const unsigned w_px = argc == 3 ? (unsigned)strtoul(argv[1], NULL, 10) : 0;
    const unsigned h_px = argc == 3 ? (unsigned)strtoul(argv[2], NULL, 10) : 0;

    if (w_px == 0 || h_px == 0) {
        fputs("usage: card WIDTH HEIGHT >CARD.ppm\n", stderr);
        return EXIT_FAILURE;
    }
    printf("P6 %u %u 255\n", w_px, h_px);
    for (unsigned y_px = 0; y_px < h_px; y_px++)
        for (unsigned x_px = 0; x_px < w_px; x_px++) {
            const uint32_t rgb = image_rgb888_from_565(test_card_px(x_px, y_px, w_px, h_px));
            printf("%c%c%c", rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
        }
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
