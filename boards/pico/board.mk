# SPDX-License-Identifier: MIT
#
# Raspberry Pi Pico: RP2040, Cortex-M0+ at 125 MHz. See boards/image.mk for what these are.
PACKAGES  := gcc-arm-none-eabi
TOOLS     := arm-none-eabi-
ARCH      := -mthumb -mcpu=cortex-m0plus
OPT       := -O2
CPU_HZ    := 125000000
FLASH_B   := 2097152
RAM_B     := 270336
LINES     := 32
STREAM    := auto
PANEL     := st7789
MODULE    := --size 240x240 --hz 62500000
SCENE     := rooms
PRECISION := fast
WALLS     := yes
# Where the LED is, GP0 to GP28 (25: a Pico's own), or none.
LED       := 25
led_pin    = $(patsubst GP%,%,$(patsubst GPIO%,%,$(LED)))
$(if $(filter none 0 1 2 3 4 5 6 7 8 9 10 11 21 25 26 27 28,$(led_pin)),,$(error LED=$(LED): none, or a pin that is free: \
	GP0 to GP11, GP21, GP25 to GP28))
DEFINES    = -DPIN_LED=$(if $(filter none,$(LED)),-1,$(led_pin))
START     += boards/common/start_cortex_m.c
SOURCES   := $(board_folder)/board.c \
	$(addprefix hal/mcu/,rp2040_clocks.c rp2040_dma.c pl022.c sio_gpio.c systick.c)
BOOT2     := $(board_folder)/boot2.S
IMAGES    := bin uf2
UF2       := --family rp2040

FLASH_TOOL     := findmnt
FLASH_PACKAGES := util-linux
FLASH           = sh $(board_folder)/flash.sh $(IMAGE)

# EMULATED: other options of sim/emulators/rp2040.mjs: --flash unknown, --cache lru
EMULATE_PACKAGES := nodejs npm
EMULATE = $(if $(filter none,$(LED)),echo 'emulate: LED=none: frames are told by the LED' >&2; exit 1,\
	sh sim/emulators/rp2040.sh $(IMAGE) $(N) '$(WIRES) $(EMULATED)' $(DECODE))
WIRES   = --pin dc=16 --pin $(if $(filter ls0%,$(PANEL)),select,cs)=17 --pin backlight=20 --pin reset=22 --pin led=$(led_pin)
SPI_CLOCK_HZ := $(CPU_HZ)
