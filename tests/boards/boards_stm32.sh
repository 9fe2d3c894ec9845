# SPDX-License-Identifier: MIT
#
# The STM32 boards' images on a chip that has what QEMU lacks: crystal, PLL, wait states, DMA. They keep every rule of the
# maker's manuals that is written down (sim/emulators/stm32_rules.c), and paint what the simulator does, at the rates that
# the boards' pages say, with what fails made to fail; and drivers that break a rule are told on.
. tests/tap.sh

built=$(cd "$BUILD" && pwd) # seen from a copy of the project as well

rules() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$built" BOARDS="$kept/boards" PICTURES="$work/pictures" "$@" rules >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

runs_at() { # CLOCKS FRAMES MAKE-ARGUMENT...
    clocks=$1 frames=$2
    shift 2
    rules N="$frames" "$@" && cat "$work/said" && grep -q "^# clocks $clocks" "$work/said" &&
        grep -q '^# rules [0-9]*, complaints 0$' "$work/said" && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq "$frames" ]
}

# The times are those of the bytes at SCK's rate, or more, where something fails to overlap.
bus_bound() {
    awk '/^# frame/ { sub(/,/, ""); ms = $7; if ($3 + 0 > 1) { n++; took += ms - before; bytes += $4 } before = ms }
        END { ideal = bytes * 8 / 42000; printf "%.2f of the bus\n", took / ideal; exit !(n && took >= ideal && took < 1.05 * ideal) }' "$work/said"
}

# The SPI stops in the second frame, and for one start more: what was sent of that frame is not checked, and those that
# follow are the path's from its beginning.
recovers() { # BOARD PART MAKE-ARGUMENT...
    rules N=2 BOARD="$1" && head -n 2 "$kept/boards/$1/rooms-st7789-fast/golden" >"$work/golden" &&
        sh sim/emulators/stm32.sh "$BUILD" "$2" "$kept/boards/$1/rooms-st7789-fast/image.bin" 4 "boards/$1/trace.map" \
            '--stop-after 200000 --for 1' cat >"$work/wires" || return 1
    "$BUILD/limner" decode "$work/wires" --panel st7789 --size 240x240 --write-hashes "$work/hashes" &&
        sed -n '3,4p' "$work/hashes" | awk '{ print NR - 1, $2 }' | cmp - "$work/golden" &&
        grep '^# rules [0-9]*, complaints 0$' "$work/wires" && [ "$(grep -c '^p reset 0' "$work/wires")" -eq 3 ]
}

# The project with a copy of a board, in whose folder lies a file that was changed by sed: one of its own, or a driver
# that it then has in the place of the usual one. The rule that this breaks must be told. A byte takes 128 cycles or so:
# at the most rate it has left before a program that does not wait for it comes to change D/C.
tells() { # RULE FILE SCRIPT BOARD
    rule=$1 file=$2 script=$3 board=$4
    project=$work/project folder=$work/project/boards/broken-$board name=${file##*/}
    rm -rf "$project" && mkdir -p "$project/boards" && ln -s "$PWD"/boards/* "$project/boards" &&
        ln -s "$PWD/Makefile" "$PWD/firmware" "$PWD/hal" "$PWD/sim" "$project" &&
        cp -rL "boards/$board" "$folder" && sed "$script" "$file" >"$folder/$name" && ! cmp -s "$file" "$folder/$name" ||
        return 1
    sed -i "s,^\(SOURCES.*[ \,]\)$name\(.*\),\1\2 \$(board_folder)/$name," "$folder/board.mk"
    ! (cd "$project" && EMULATE_S=60 rules N=1 BOARDS="$kept/broken" BOARD="broken-$board" \
        MODULE='--size 240x240 --hz 10500000' >/dev/null) &&
        cat "$work/said" && grep -q "stm32: .*$rule" "$work/said"
}

refuses() { # PATTERN ARGUMENT...
    pattern=$1
    shift
    ! "$BUILD/stm32" "$@" >"$work/said" 2>&1 && cat "$work/said" && grep -q "^stm32: $pattern" "$work/said"
}

tap_check "stm32f405: five frames by DMA at 168 MHz, SCK 42" \
    runs_at 'processor 168000000 apb1 42000000 apb2 84000000 spi 42000000' 5 BOARD=stm32f405
tap_check "the bus is what limits it" bus_bound
tap_check "bluepill: frames at 72 MHz, SCK 18" \
    runs_at 'processor 72000000 apb1 36000000 apb2 72000000 spi 18000000' 3 BOARD=bluepill
tap_check "stm32f405 without a crystal: 16 MHz" runs_at 'processor 16000000 .* spi 8000000' 1 BOARD=stm32f405 FAULTS='--hse 0'
tap_check "bluepill without a crystal: 8 MHz" runs_at 'processor 8000000 .* spi 4000000' 1 BOARD=bluepill FAULTS='--hse 0'
tap_check "stm32f405 whose PLL does not lock" runs_at 'processor 16000000' 1 BOARD=stm32f405 FAULTS='--pll no'
tap_check "bluepill whose PLL does not lock" runs_at 'processor 8000000' 1 BOARD=bluepill FAULTS='--pll no'
tap_check "a processor that is slower than its bus" runs_at 'processor 168' 2 BOARD=stm32f405 FAULTS='--cycles 9'
tap_check "a framebuffer" runs_at 'processor 168' 4 BOARD=stm32f405 PANEL=ssd1351 MODULE='--size 128x128' COMPILE=--framebuffer
tap_check "pages of a bit a pixel" runs_at 'processor 168' 4 BOARD=stm32f405 SCENE=icosahedron PANEL=ssd1306
tap_check "stm32f405: when the SPI stops the path begins anew, by the rules" recovers stm32f405 f405
tap_check "bluepill does as well" recovers bluepill f103
tap_check "what changes alone" runs_at 'processor 168' 3 BOARD=stm32f405 COMPILE=--delta BOARDS="$kept/delta"
tap_check "what is built for an STM32F100 runs on an F103 at 24 MHz, SCK 12" \
    runs_at 'processor 24000000 apb1 24000000 apb2 24000000 spi 12000000' 2 BOARD=bluepill PART=f100 BOARDS="$kept/f100"
tap_check "flags that are not cleared are told" tells 'flags are cleared' hal/mcu/stm32_dma.c '/ifcr = IFCR_ALL/d' stm32f405
tap_check "a line that follows too soon is told" tells 'configured while it is disabled' hal/mcu/stm32_dma.c \
    's/int err = finish(dma);/int err = 0;/' stm32f405
tap_check "D/C that changes with the last byte is told" tells 'D/C, select and reset change' hal/mcu/stm32_spi.c \
    's/return err ? err : mcu_wait.*/return err;/' stm32f405
tap_check "a driver that waits by counting is told" tells 'TXE is read as 1 and then BSY' hal/mcu/stm32_spi.c \
    '/^int stm32_spi_flush/,/^}/ { s/int err = .*/volatile int i = !spi;/; s/return err.*/{ while (i < 999) i++; } return 0;/ }' stm32f405
tap_check "memory that DMA does not reach is told" tells 'DMA reads flash, SRAM1 and SRAM2, not CCM' \
    boards/stm32f405/memory.ld 's/0x20000000, LENGTH = 128K/0x10000000, LENGTH = 64K/' stm32f405
tap_check "too few wait states are told" tells '4 wait states at 168000000 Hz, which wants 5' hal/mcu/stm32f4_rcc.c \
    's/ACR_LATENCY_5 = 5/ACR_LATENCY_5 = 4/' stm32f405
tap_check "and on the bluepill" tells '1 wait states at 72000000 Hz, which wants 2' hal/mcu/stm32f1_rcc.c \
    's,(cpu_hz - 1) / WAIT,(cpu_hz / 2) / WAIT,' bluepill
head -c 64 /dev/zero >"$work/zeros.bin"
map=boards/stm32f405/trace.map
tap_check "an image that is none is told" refuses 'the image: ' f405 "$work/zeros.bin" 1 $map "$work/wires"
tap_check "one that is not there is" refuses "$work/none: No such file" f405 "$work/none" 1 $map "$work/wires"
tap_check "a map that is none is" refuses 'README.md: a line is neither' f405 "$work/zeros.bin" 1 README.md "$work/wires"
tap_check "an option that is none is" refuses '--nix: ' f405 "$work/zeros.bin" 1 $map "$work/wires" --nix 1
tap_check "an instruction that takes no time is" refuses '--cycles: ' f405 "$work/zeros.bin" 1 $map "$work/wires" --cycles 0
tap_check "no frames are" refuses 'FRAMES: ' f405 "$work/zeros.bin" 0 $map "$work/wires"
tap_check "a number of frames that is none is" refuses 'FRAMES: ' f405 "$work/zeros.bin" x $map "$work/wires"
tap_done
