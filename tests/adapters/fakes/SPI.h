/* SPDX-License-Identifier: MIT
 *
 * A fake of Arduino's SPI library, with the types of ArduinoCore-API's HardwareSPI.h and the constants of AVR's. */
#ifndef FAKE_SPI_H
#define FAKE_SPI_H

#include "Arduino.h"

typedef enum { SPI_MODE0 = 0x00, SPI_MODE1 = 0x04, SPI_MODE2 = 0x08, SPI_MODE3 = 0x0C } SPIMode;

class SPISettings
{
  public:
    SPISettings(uint32_t clock, BitOrder bitOrder, SPIMode dataMode)
        : clock_hz(clock), mode(bitOrder == MSBFIRST ? dataMode / 4 : -1)
    {
    }
    SPISettings() : clock_hz(4000000), mode(0) {}

    uint32_t clock_hz;
    int mode;
};

class SPIClass
{
  public:
    void begin() { begun_ = true; }

    void beginTransaction(SPISettings settings)
    {
        if (!begun_ || taken_) wires_complain("SPI: a transaction in another one, or before begin()");
        taken_ = true;
        wires_bus(settings.clock_hz, settings.mode);
    }

    void endTransaction(void)
    {
        if (!taken_) wires_complain("SPI: no transaction was begun");
        taken_ = false;
    }

    /* What is read, of a line that nobody drives, is written over what was sent. */
    void transfer(void *buf, size_t count)
    {
        if (!taken_) wires_complain("SPI: bytes outside of a transaction");
        wires_send(static_cast<uint8_t *>(buf), count);
        memset(buf, 0xFF, count);
    }

  private:
    bool begun_ = false, taken_ = false;
};

extern SPIClass SPI;

#endif
