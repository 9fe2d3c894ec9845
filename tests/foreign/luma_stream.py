# SPDX-License-Identifier: MIT
#
# Draws a picture with a driver of luma.lcd or luma.oled, through luma's own SPI interface, and prints what goes over the
# wires as a wire log, which `limner decode` reads:
#   python3 luma_stream.py CLASS PICTURE.ppm [NAME=VALUE ...] >LOG
# CLASS is the driver's, as st7735; NAME=VALUE are its arguments, as h_offset=1. Stands in for spidev and RPi.GPIO, both
# of which luma lets its caller bring. No times are told: luma waits on the clock of this machine.
import sys

import luma.lcd.device
import luma.oled.device
from luma.core.interface.serial import spi
from PIL import Image

DC, RESET, BACKLIGHT = 24, 25, 18  # luma's defaults


class Wires:
    """What luma calls of spidev and of RPi.GPIO, each call printed."""

    LOW, HIGH, OUT = 0, 1, 0
    names = {DC: "dc", RESET: "reset", BACKLIGHT: "backlight"}

    def setup(self, pin, direction):
        pass

    def output(self, pin, level):
        self.level(self.names[pin], level)

    def level(self, name, level):
        print("p", name, int(level))

    def open(self, bus, device):
        pass

    def writebytes(self, data):
        print("b", bytes(data).hex(" ").upper())

    def cleanup(self, *pins):
        pass

    close = cleanup


def find_driver(name):
    for drivers in luma.lcd.device, luma.oled.device:
        if name in drivers.__all__:
            return getattr(drivers, name)
    sys.exit(f"luma_stream: luma has no driver {name}")


def argument(text):
    name, value = text.split("=")
    return name, int(value)


def main(name, picture, *arguments):
    wires = Wires()
    serial = spi(spi=wires, gpio=wires, gpio_DC=DC, gpio_RST=RESET)
    card = Image.open(picture).convert("RGB")
    options = dict(gpio=wires, active_low=False) if name in luma.lcd.device.__all__ else {}
    device = find_driver(name)(serial, **options, **dict(map(argument, arguments)))
    device.persist = True  # the display stays on when this ends
    if device.mode == "1":
        card = card.convert("1", dither=Image.Dither.NONE)
    wires.level("led", 0)
    device.display(card)
    wires.level("led", 1)


if len(sys.argv) < 3:
    sys.exit("usage: luma_stream.py CLASS PICTURE.ppm [NAME=VALUE ...]")
main(*sys.argv[1:])
