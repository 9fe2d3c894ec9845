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
START     += boards/common/start_cortex_m.c
SOURCES   := $(board_folder)/board.c \
	$(addprefix hal/mcu/,rp2040_clocks.c rp2040_dma.c pl022.c sio_gpio.c systick.c)
BOOT2     := $(board_folder)/boot2.S
IMAGES    := bin uf2
UF2       := --family rp2040

FLASH_TOOL     := findmnt
FLASH_PACKAGES := util-linux
FLASH           = sh $(board_folder)/flash.sh $(IMAGE)

EMULATE_PACKAGES := nodejs npm
EMULATE = sh sim/emulators/rp2040.sh $(IMAGE) $(N) '$(WIRES)' $(DECODE)
WIRES   = --pin dc=16 --pin $(if $(filter ls0%,$(PANEL)),select,cs)=17 --pin backlight=20 --pin reset=22 --pin led=25
SPI_CLOCK_HZ := $(CPU_HZ)
