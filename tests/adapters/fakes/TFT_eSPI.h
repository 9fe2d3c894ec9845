/* SPDX-License-Identifier: MIT
 *
 * A fake of TFT_eSPI's class with the signatures of its header (2.5.43, commit 83d4d16), and a display behind it. */
#ifndef FAKE_TFT_ESPI_H
#define FAKE_TFT_ESPI_H

#include "Arduino.h"
#include "fake_display.h"

#define TFT_BLACK 0x0000

class TFT_eSPI
{
  public:
    TFT_eSPI(int16_t w_px = FAKE_W_PX, int16_t h_px = FAKE_H_PX) : w_px_(w_px), h_px_(h_px) {}
    virtual ~TFT_eSPI() {}
    virtual int16_t height(void) { return h_px_; }
    virtual int16_t width(void) { return w_px_; }
    void init(uint8_t tc = 0) { (void)tc; }
    void fillScreen(uint32_t color) { (void)color; }
    int16_t drawString(const String &string, int32_t x, int32_t y, uint8_t font)
    {
        (void)string, (void)x, (void)y, (void)font;
        return 0;
    }
    void setSwapBytes(bool swap) { swaps_ = swap; }
    bool getSwapBytes(void) { return swaps_; }

    void startWrite(void)
    {
        if (taken_) fake_complain("TFT_eSPI: the bus is taken already");
        taken_ = true;
    }

    void endWrite(void)
    {
        if (!taken_) fake_complain("TFT_eSPI: the bus was not taken");
        taken_ = false;
    }

    void setAddrWindow(int32_t xs, int32_t ys, int32_t w, int32_t h)
    {
        if (xs + w > w_px_ || ys + h > h_px_) fake_complain("TFT_eSPI: a window larger than the display");
        fake_window(xs, ys, xs + w - 1, ys + h - 1);
    }

    /* Swapped, words of memory go out as numbers, else as their bytes lie. */
    void pushPixels(const void *data_in, uint32_t len)
    {
        if (!taken_) fake_complain("TFT_eSPI: pixels while chip select is high");
        for (uint32_t i = 0; i < len; i++)
            if (swaps_)
                fake_pixel(static_cast<const uint16_t *>(data_in)[i]);
            else
                fake_bytes(static_cast<const uint8_t *>(data_in) + 2 * i, 1);
    }

    bool fake_is_taken(void) const { return taken_; }

  private:
    int16_t w_px_, h_px_;
    bool swaps_ = false, taken_ = false;
};

#endif
