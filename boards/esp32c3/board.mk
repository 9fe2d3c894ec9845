# SPDX-License-Identifier: MIT
#
# Any board with an ESP32-C3, as the DevKitM-1 and the Super Mini. Code, scene and data are all in RAM.
TOOLS       := riscv64-unknown-elf-
ARCH        := -march=rv32imc -mabi=ilp32
CPU_HZ      := 40000000
RAM_B       := 306688
CODE_IN_RAM := yes
PANEL       := st7789
MODULE      := --size 240x240
SCENE       := rooms
PRECISION   := fast
START       += $(board_folder)/start.c
SOURCES     := $(board_folder)/board.c $(addprefix hal/mcu/,esp32c3_gpio.c esp32c3_spi.c esp32c3_system.c esp32c3_systimer.c)
IMAGES      := esp
ESPIMAGE    := --chip esp32c3
PACKAGES    := gcc-riscv64-unknown-elf
# Segments hold what is loaded, and no headers before it.
LINK        += -Wl,--nmagic

FLASH_TOOL  := esptool
FLASH_FROM  := Espressif's: pip install esptool
FLASH        = esptool --chip esp32c3 write-flash 0x0 $(IMAGE).esp

# By the project's own chip: see boards/DESIGN.md.
EMULATE_PACKAGES := libunicorn-dev
EMULATOR         := $(BUILD)/esp32c3
EMULATE           = sh sim/emulators/esp32c3.sh $(BUILD) $(IMAGE) $(N) $(board_folder)/trace.map \
	'--panel $(PANEL_HZ) $(FAULTS)' \
	'$(filter $(common)/hal/mcu/%,$(board_objects))' $(DECODE)
# Rates are the crystal's by 1, 2, 3: as of twice that by even numbers.
SPI_CLOCK_HZ     := 80000000
SPI_DIVIDERS     := even
