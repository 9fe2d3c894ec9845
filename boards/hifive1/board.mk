# SPDX-License-Identifier: MIT
#
# SiFive HiFive1 with an FE310-G000.
TOOLS      := riscv64-unknown-elf-
ARCH       := -march=rv32imac -mabi=ilp32
CPU_HZ     := 256000000
SPI_MAX_HZ := 32000000
MTIME_HZ   := 32768
FLASH_B    := 12582912
RAM_B      := 16384
PANEL      := st7789
MODULE     := --size 240x240
SCENE      := rooms
PRECISION  := fast
START      += boards/common/start_riscv.c
DEFINES     = -DSPI_MAX_HZ=UINT32_C\($(SPI_MAX_HZ)\) -DMTIME_HZ=UINT32_C\($(MTIME_HZ)\)
SOURCES    := $(board_folder)/board.c $(addprefix hal/mcu/,fe310_gpio.c fe310_prci.c fe310_spi.c mtime.c)
IMAGES     := bin hex
PACKAGES   := gcc-riscv64-unknown-elf

FLASH_TOOL     := openocd
FLASH_PACKAGES := openocd
FLASH           = openocd -f board/sifive-hifive1.cfg -c 'program $(IMAGE).elf verify' -c 'resume 0x20400000' -c exit

EMULATE_PACKAGES := qemu-system-misc
QEMU             := riscv32 sifive_e
EMULATE           = sh sim/emulators/qemu.sh $(QEMU) $(IMAGE).elf $(DECODE) --qemu $(board_folder)/trace.map
SPI_CLOCK_HZ     := $(CPU_HZ)
SPI_DIVIDERS     := even
