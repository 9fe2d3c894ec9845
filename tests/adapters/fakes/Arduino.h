/* SPDX-License-Identifier: MIT
 *
 * A fake of Arduino's functions, with the types of ArduinoCore-API (commit cd91833), which are stricter than AVR's. */
#ifndef FAKE_ARDUINO_H
#define FAKE_ARDUINO_H

#include "fake_wires.h"

#include <string.h>
#include <string>

#define LED_BUILTIN WIRE_BACKLIGHT

/* What sketches concatenate. */
class String : public std::string
{
  public:
    String(const std::string &text) : std::string(text) {}
    explicit String(int value) : std::string(std::to_string(value)) {}
};

unsigned long millis();

typedef enum { LOW = 0, HIGH = 1, CHANGE = 2, FALLING = 3, RISING = 4 } PinStatus;
typedef enum { INPUT = 0x0, OUTPUT = 0x1, INPUT_PULLUP = 0x2, INPUT_PULLDOWN = 0x3 } PinMode;
typedef enum { LSBFIRST = 0, MSBFIRST = 1 } BitOrder;
typedef uint8_t pin_size_t;

inline void pinMode(pin_size_t pinNumber, PinMode pinMode)
{
    wires_output(pinNumber, pinMode == OUTPUT);
}

inline void digitalWrite(pin_size_t pinNumber, PinStatus status)
{
    wires_level(pinNumber, status == HIGH);
}

/* As short as AVR's may be. */
inline void delay(unsigned long ms)
{
    wires_pass(ms ? 1000 * ms - 999 : 0);
}

inline void delayMicroseconds(unsigned int us)
{
    if (us > 16383) wires_complain("Arduino: delayMicroseconds() counts to 16383");
    wires_pass(us & 0x3FFF);
}

#endif
