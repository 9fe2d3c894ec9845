# SPDX-License-Identifier: MIT
#
# Raspberry Pi Pico 2: RP2350, Cortex-M33 at 150 MHz. See boards/image.mk for what these are.
PACKAGES  := gcc-arm-none-eabi
TOOLS     := arm-none-eabi-
ARCH      := -mthumb -mcpu=cortex-m33 -mfpu=fpv5-sp-d16 -mfloat-abi=hard
OPT       := -O2
CPU_HZ    := 150000000
FLASH_B   := 4194304
RAM_B     := 532480
LINES     := 32
STREAM    := auto
PANEL     := st7789
MODULE    := --size 240x240 --hz 62500000
SCENE     := rooms
PRECISION := fast
WALLS     := yes
# Where the LED is, GP0 to GP28 (25: a Pico 2's own), or none.
LED       := 25
led_pin    = $(patsubst GP%,%,$(patsubst GPIO%,%,$(LED)))
$(if $(filter none 0 1 2 3 4 5 6 7 8 9 10 11 21 25 26 27 28,$(led_pin)),,$(error LED=$(LED): none, or a pin that is free: \
	GP0 to GP11, GP21, GP25 to GP28))
DEFINES    = -DPIN_LED=$(if $(filter none,$(LED)),-1,$(led_pin))
START     += boards/common/start_cortex_m.c
SOURCES   := $(board_folder)/board.c $(board_folder)/image_def.c \
	$(addprefix hal/mcu/,rp2040_clocks.c rp2040_dma.c rp2350_clocks.c rp2350_dma.c rp2350_gpio.c pl022.c systick.c)
IMAGES    := bin uf2
UF2       := --family rp2350-arm-s

FLASH_TOOL     := findmnt
FLASH_PACKAGES := util-linux
FLASH           = sh $(board_folder)/flash.sh $(IMAGE)

# No emulator has an RP2350. The image's code runs in QEMU, on a machine with the same core: the same objects, but for this
# folder's and those of hal/mcu, in whose place there is a board that writes down what goes over the wires.
EMULATE_PACKAGES := qemu-system-arm
EMULATE          = sh sim/emulators/an505.sh $(IMAGE) $(N) '$(TOOLS)gcc $(board_flags)' \
	'$(filter-out $(common)/boards/pico2/% $(common)/hal/mcu/%,$(board_objects)) $(image_objects) $(folder)/model*.o' $(DECODE)
QEMU            := arm mps2-an505
COUNTED_ELF      = $(IMAGE).an505.elf
COUNTED_DRIVERS  = $(IMAGE).an505.o
SPI_CLOCK_HZ    := 125000000
