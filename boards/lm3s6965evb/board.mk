# SPDX-License-Identifier: MIT
#
# LM3S6965 Evaluation Board: Cortex-M3, 50 MHz, 256 KB of flash, 64 KB of RAM; SSD0323 of 128x64 with 16 greys.

TOOLS     := arm-none-eabi-
ARCH      := -mthumb -mcpu=cortex-m3
OPT       := -O2
CPU_HZ    := 50000000
FLASH_B   := 262144
RAM_B     := 65536
PANEL     := ssd0323
MODULE    := --converter
SCENE     := rooms
PRECISION := fast
WALLS     := yes
COMPILE   := --fill
START     += boards/common/start_cortex_m.c
SOURCES   := $(board_folder)/board.c $(addprefix hal/mcu/,lm3s_clocks.c lm3s_gpio.c pl022.c systick.c)
IMAGES    := bin hex
PACKAGES  := gcc-arm-none-eabi

FLASH_TOOL     := openocd
FLASH_PACKAGES := openocd
FLASH           = openocd -f board/ek-lm3s6965.cfg -c 'program $(IMAGE).elf verify reset exit'

EMULATE_PACKAGES := qemu-system-arm gdb-multiarch
QEMU             := arm lm3s6965evb
EMULATE           = sh sim/emulators/qemu_oled.sh $(IMAGE).elf $(N) $(folder)/oled $(CHECK) $(DECODE) --qemu $(board_folder)/trace.map
SPI_CLOCK_HZ     := 50000000
SPI_DIVIDERS     := even
