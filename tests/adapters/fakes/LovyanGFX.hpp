/* SPDX-License-Identifier: MIT
 *
 * A fake of LovyanGFX's classes with the signatures of its headers (1.2, commit c14105d8), and a display behind it. */
#ifndef FAKE_LOVYANGFX_HPP
#define FAKE_LOVYANGFX_HPP

#include "Arduino.h"
#include "fake_display.h"

#ifndef TFT_BLACK
#define TFT_BLACK 0x0000
#endif

namespace lgfx
{

struct rgb565_t {
    uint16_t raw; /* a number */
};

struct swap565_t {
    uint16_t raw; /* the byte with the red bits first */
};

class LovyanGFX
{
  public:
    LovyanGFX(int32_t w_px, int32_t h_px) : w_px_(w_px), h_px_(h_px) {}
    virtual ~LovyanGFX() {}
    int32_t width(void) const { return w_px_; }
    int32_t height(void) const { return h_px_; }
    bool init(void) { return true; }
    void fillScreen(uint32_t color) { (void)color; }
    size_t drawString(const String &string, int32_t x, int32_t y)
    {
        (void)string, (void)x, (void)y;
        return 0;
    }
    bool getSwapBytes(void) const { return swaps_; }
    void setSwapBytes(bool swap) { swaps_ = swap; }

    /* Calls are counted. */
    void startWrite(bool transaction = true)
    {
        (void)transaction;
        taken_++;
    }

    void endWrite(void)
    {
        if (!taken_) fake_complain("LovyanGFX: the bus was not taken");
        if (taken_) taken_--;
    }

    /* Cut to the display without a word. */
    void setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h)
    {
        if (w > w_px_ - x) w = w_px_ - x;
        if (h > h_px_ - y) h = h_px_ - y;
        fake_window(x, y, x + w - 1, y + h - 1);
    }

    void writePixels(const swap565_t *data, int32_t len)
    {
        if (!taken_) fake_complain("LovyanGFX: pixels while the bus is not taken");
        fake_bytes(reinterpret_cast<const uint8_t *>(data), len);
    }

    void writePixels(const rgb565_t *data, int32_t len)
    {
        if (!taken_) fake_complain("LovyanGFX: pixels while the bus is not taken");
        for (int32_t i = 0; i < len; i++)
            fake_pixel(data[i].raw);
    }

    void writePixels(const uint16_t *data, int32_t len) { writePixels(data, len, swaps_); }

    void writePixels(const uint16_t *data, int32_t len, bool swap)
    {
        if (swap)
            writePixels(reinterpret_cast<const rgb565_t *>(data), len);
        else
            writePixels(reinterpret_cast<const swap565_t *>(data), len);
    }

    bool fake_is_taken(void) const { return taken_ != 0; }

  private:
    int32_t w_px_, h_px_;
    unsigned taken_ = 0;
    bool swaps_ = false;
};

class LGFX_Device : public LovyanGFX
{
  public:
    LGFX_Device() : LovyanGFX(FAKE_W_PX, FAKE_H_PX) {}
    LGFX_Device(int32_t w_px, int32_t h_px) : LovyanGFX(w_px, h_px) {}
};

} // namespace lgfx

#ifdef LGFX_AUTODETECT
typedef lgfx::LGFX_Device LGFX;
#endif

#endif
