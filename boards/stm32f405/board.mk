# SPDX-License-Identifier: MIT
#
# Adafruit Feather STM32F405 Express. Another board with this processor: HSE_HZ is its crystal's rate.
TOOLS     := arm-none-eabi-
ARCH      := -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard
HSE_HZ    := 12000000
CPU_HZ    := 168000000
FLASH_B   := 1048576
RAM_B     := 131072
PANEL     := st7789
MODULE    := --size 240x240 --hz 42000000
SCENE     := rooms
PRECISION := fast
LINES     := 32
STREAM    := auto
START     += boards/common/start_cortex_m.c
DEFINES    = -DHSE_HZ=UINT32_C\($(HSE_HZ)\)
SOURCES   := $(board_folder)/board.c $(addprefix hal/mcu/,stm32_clock.c stm32_dma.c stm32_spi.c stm32f4_gpio.c stm32f4_rcc.c systick.c)
IMAGES    := bin hex
PACKAGES  := gcc-arm-none-eabi

FLASH_TOOL     := dfu-util
FLASH_PACKAGES := dfu-util
FLASH           = dfu-util --device 0483:df11 --alt 0 --dfuse-address 0x08000000:leave --download $(IMAGE).bin

EMULATE_PACKAGES := qemu-system-arm
QEMU             := arm netduinoplus2
EMULATE           = sh sim/emulators/qemu.sh $(QEMU) $(IMAGE).elf $(DECODE) --qemu $(board_folder)/trace.map
SPI_CLOCK_HZ     := 84000000
SPI_DIVIDERS     := powers

# By the project's own chip, with what QEMU lacks: see boards/DESIGN.md.
RULES_PACKAGES := libunicorn-dev
RULES_CHECKER  := $(BUILD)/stm32
RULES           = sh sim/emulators/stm32.sh $(BUILD) f405 $(IMAGE).bin $(N) $(board_folder)/trace.map \
	'--hse $(HSE_HZ) --panel $(PANEL_HZ) $(FAULTS)' $(DECODE)
