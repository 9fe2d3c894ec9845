# SPDX-License-Identifier: MIT
#
# Arduboy: ATmega32U4, 16 MHz, 28 KB of flash before the bootloader, 2.5 KB of RAM; SSD1306 of 128x64.
# Scenes are convex solids, whose runs go into the display's pages without a line of memory (LINES := 0).

TOOLS     := avr-
ARCH      := -mmcu=atmega32u4 -mrelax
STANDARD  := -std=gnu11 -ffreestanding # gnu: __flash is no part of C
OPT       := -Os
CPU_HZ    := 16000000
SPI_CLOCK_HZ := 16000000
SPI_DIVIDERS := powers
FLASH_B   := 28672
RAM_B     := 2560
PANEL     := ssd1306
LINES     := 0
SCENE     := hexecontahedron
PRECISION := fast
TITLE      = arduboy$(if $(OUTLINES),$(comma) hidden lines)
COMPILE    = --method convex $(if $(OUTLINES),--wireframe --unlit)
START     :=
LINK      :=
FRAMES    := -g
DEFINES    = -DBOARD_CPU_HZ=UINT32_C\($(CPU_HZ)\) -DLIM_HAS_FILL=1 -DLIM_HAS_LINES=0 -DPIXELS_ONLY_PAGES=1
SOURCES   := $(board_folder)/board.c $(addprefix hal/mcu/,avr_gpio.c avr_spi.c avr_timer.c)
IMAGES    := hex
PACKAGES  := gcc-avr avr-libc

FLASH          = avrdude -p atmega32u4 -c avr109 -P $(PORT) -U flash:w:$(IMAGE).hex:i
FLASH_TOOL     := avrdude
FLASH_PACKAGES := avrdude
PORT           := /dev/ttyACM0

EMULATE_PACKAGES := libsimavr-dev libelf-dev
EMULATOR         := $(BUILD)/simavr_oled
EMULATE           = sh sim/emulators/simavr.sh $(BUILD) $(IMAGE).elf $(N) $(PICTURES) $(CHECK) \
	$(BUILD)/limner decode - --panel $(PANEL) $(MODULE) --frames $(N) --check $(CHECK)

# Where most of the time goes.
%/firmware/orders/convex.o %/firmware/screen/edge.o %/hal/pixels.o: OPT := -O2
