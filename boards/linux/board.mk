# SPDX-License-Identifier: MIT
#
# Any Linux machine with SPI and GPIO, a Raspberry Pi first: the image is a program, which `make flash` runs. For
# another one: TOOLS=aarch64-linux-gnu-, and LAST if its libgpiod is not where that compiler looks.

TOOLS     :=
ARCH      :=
OPT       := -O2
DEFINES   := -DBOARD_ENDS=1
STANDARD   = -std=c11 -D_POSIX_C_SOURCE=200809L -DLIM_GPIOD=$(GPIOD)
PANEL     := st7789
SCENE     := rooms
PRECISION := fast

START     :=
SOURCES   := $(board_folder)/board.c $(wildcard hal/linux/*.c)
LINK      :=
LAST      := -lgpiod
IMAGES    :=

PACKAGES   := gcc libgpiod-dev
FLASH_TOOL := true
FLASH       = $(IMAGE).elf
EMULATE_PACKAGES = $(packages-kernel)
EMULATE          = sh sim/emulators/uml.sh $(BUILD)/tests/kernel $(IMAGE).elf $(N) $(DECODE)
emulate: $(BUILD)/tests/kernel/wires $(BUILD)/tests/kernel/power_off
