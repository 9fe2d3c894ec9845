# SPDX-License-Identifier: MIT
#
# Blue pill. PART=f103: an STM32F103C8 with the 128 KB of flash that nearly all have, or a CB. PART=f100: what an
# STM32F100 has as well, 24 MHz and 8 KB of RAM; the image runs on both.
PART      := f103
TOOLS     := arm-none-eabi-
ARCH      := -mthumb -mcpu=cortex-m3
SCENE     := rooms
PRECISION := fast
FLASH_B   := 131072
ifeq ($(PART),f100)
TITLE      := bluepill, STM32F100
CPU_HZ     := 24000000
SPI_MAX_HZ := 12000000
RAM_B      := 8192
PANEL      := ssd1351
MODULE     := --size 128x128
else ifeq ($(PART),f103)
CPU_HZ     := 72000000
SPI_MAX_HZ := 18000000
RAM_B      := 20480
PANEL      := st7789
MODULE     := --size 240x240
else
$(error PART=$(PART): must be f103 or f100)
endif
START     += boards/common/start_cortex_m.c
DEFINES    = -DCPU_HZ=UINT32_C\($(CPU_HZ)\) -DSPI_MAX_HZ=UINT32_C\($(SPI_MAX_HZ)\)
LINK      += -Wl,--defsym=board_ram_b=$(RAM_B)
SOURCES   := $(board_folder)/board.c $(addprefix hal/mcu/,stm32_clock.c stm32_spi.c stm32f1_gpio.c stm32f1_rcc.c systick.c)
IMAGES    := bin hex
PACKAGES  := gcc-arm-none-eabi

FLASH_TOOL     := openocd
FLASH_PACKAGES := openocd
FLASH           = openocd -c 'set FLASH_SIZE $(FLASH_B)' -f interface/stlink.cfg -f target/stm32f1x.cfg \
	-c 'program $(IMAGE).elf verify reset exit'

# QEMU knows the F100 alone, so that for an F103 the same scene is drawn there, in less RAM. What takes the F103's RAM is
# counted on a machine that has it, and the same processor, but none of the pins.
EMULATE_PACKAGES := qemu-system-arm
ifeq ($(PART),f100)
QEMU    := arm stm32vldiscovery
EMULATE  = sh sim/emulators/qemu.sh $(QEMU) $(IMAGE).elf $(DECODE) --qemu $(board_folder)/trace.map
else
QEMU    := arm netduino2
EMULATE  = $(MAKE) DEPS=skip BOARD=$(BOARD) PART=f100 BOARDS='$(BOARDS)/f100' SCENE='$(SCENE)' PANEL=$(PANEL) \
	MODULE='$(MODULE)' PRECISION=$(PRECISION) COMPILE='$(COMPILE)' N=$(N) PICTURES='$(PICTURES)' CHECK='$(CHECK)' emulate
endif
SPI_CLOCK_HZ := $(CPU_HZ)
SPI_DIVIDERS := powers

# By the project's own chip, an F103 whichever PART is chosen: see boards/DESIGN.md.
RULES_PACKAGES := libunicorn-dev
RULES_CHECKER  := $(BUILD)/stm32
RULES           = sh sim/emulators/stm32.sh $(BUILD) f103 $(IMAGE).bin $(N) $(board_folder)/trace.map \
	'--panel $(PANEL_HZ) $(FAULTS)' $(DECODE)
