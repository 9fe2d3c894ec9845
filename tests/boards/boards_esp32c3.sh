# SPDX-License-Identifier: MIT
#
# The ESP32-C3's image: it is as Espressif describes such images, by a reader that shares nothing with the writer; it keeps
# every rule that is written down (sim/emulators/esp32c3_rules.c) while it paints what the simulator does; drivers that
# break a rule are told on, and so are images that the ROM would not load.
. tests/tap.sh

built=$(cd "$BUILD" && pwd) # seen from a copy of the project as well

board() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$built" BOARDS="$kept/boards" PICTURES="$work/pictures" "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

image=$kept/boards/esp32c3/rooms-st7789-fast/image

# Its segments are those of the ELF file, as binutils see it.
reads() {
    board BOARD=esp32c3 && /usr/bin/python3 tests/boards/esp_image.py "$image.esp" >"$work/read" && cat "$work/read" &&
        grep -qx 'code 0x40380000 [0-9]*' "$work/read" && grep -q '^entry 0x40380000,' "$work/read" &&
        [ "$(grep -c '^data' "$work/read")" -eq 1 ]
}

holds_what_was_linked() {
    riscv64-unknown-elf-objcopy -O binary -j .text "$image.elf" "$work/text" &&
        riscv64-unknown-elf-objcopy -O binary -j .rodata -j .data "$image.elf" "$work/rodata" &&
        data_b=$(sed -n 's/^data 0x[0-9a-f]* //p' "$work/read") && code_b=$(sed -n 's/^code 0x[0-9a-f]* //p' "$work/read") &&
        tail -c "+$((24 + 8 + 1))" "$image.esp" | head -c "$data_b" | cmp - "$work/rodata" &&
        tail -c "+$((24 + 8 + data_b + 8 + 1))" "$image.esp" | head -c "$code_b" | cmp - "$work/text"
}

for_this_processor() {
    riscv64-unknown-elf-readelf -A "$image.elf" | tee "$work/attributes" &&
        grep -q '"rv32i[0-9p]*_m[0-9p]*_c[0-9p]*\(_zmmul[0-9p]*\)\{0,1\}"' "$work/attributes"
}

turned_at() { # BYTE NAME: the image with some of that byte's bits turned, negative: from its end
    /usr/bin/python3 -c 'import sys
image = bytearray(open(sys.argv[1], "rb").read())
image[int(sys.argv[2])] ^= 0x41
open(sys.argv[3], "wb").write(image)' "$image.esp" "$1" "$work/$2.esp"
}

# A byte of each part.
wrong_images_are_refused() {
    for at in 0 1 4 12 24 28 40 30000 -40 -33 -1; do
        turned_at "$at" wrong
        ! /usr/bin/python3 tests/boards/esp_image.py "$work/wrong.esp" >"$work/read" 2>&1 || { echo "byte $at" && return 1; }
    done
}

refuses() { # PATTERN IMAGE [FRAMES]: before it runs a frame
    : >"$work/none"
    ! timeout 60 "$BUILD/esp32c3" "$2" "${3-1}" "$work/none" "$work/none" "$work/wires" >"$work/said" 2>&1 &&
        cat "$work/said" && grep -q "^esp32c3: $1\$" "$work/said" && ! grep -q '^#' "$work/said"
}

refuses_turned() { # PATTERN BYTE
    turned_at "$2" turned && refuses "$1" "$work/turned.esp"
}

wants_frames() {
    for frames in x 0 -1 1x '' 4294967296; do
        refuses 'FRAMES: wants a number\( above 0\)*' "$image.esp" "$frames" || { echo "$frames" && return 1; }
    done
}

draws() { # CLOCKS FRAMES MAKE-ARGUMENT...
    clocks=$1 frames=$2
    shift 2
    board emulate N="$frames" BOARD=esp32c3 "$@" && cat "$work/said" && grep -q "^# clocks $clocks\$" "$work/said" &&
        grep -q '^# rules [0-9]*, complaints 0$' "$work/said" && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq "$frames" ]
}

# SPI2 stops in the second frame, and is mended by the second reset: the board begins anew, and then all is right.
recovers() {
    head -n 2 "$kept/boards/esp32c3/rooms-st7789-fast/golden" >"$work/golden" &&
        printf 'begin 0\nend 0\n' >"$work/ranges" &&
        "$BUILD/esp32c3" "$image.esp" 4 boards/esp32c3/trace.map "$work/ranges" "$work/wires" --stop-after 200000 --for 1 \
            >"$work/said" && cat "$work/said" && grep -q '^# rules [0-9]*, complaints 0$' "$work/said" &&
        "$BUILD/limner" decode "$work/wires" --panel st7789 --size 240x240 --write-hashes "$work/hashes" >"$work/decoded" &&
        sed -n '3,4p' "$work/hashes" | awk '{ print NR - 1, $2 }' | cmp - "$work/golden"
}

# The project with a copy of the board, in whose folder lies a driver that was changed by sed. The display's clock is slow:
# at the fastest a byte has left before a program that does not wait for it comes to change D/C.
tells() { # RULE FILE SCRIPT
    rule=$1 file=$2 script=$3 project=$work/project name=${2##*/}
    folder=$project/boards/broken
    rm -rf "$project" && mkdir -p "$project/boards" && ln -s "$PWD"/boards/* "$project/boards" &&
        ln -s "$PWD/Makefile" "$PWD/firmware" "$PWD/hal" "$PWD/sim" "$project" &&
        cp -rL boards/esp32c3 "$folder" && sed "$script" "$file" >"$folder/$name" && ! cmp -s "$file" "$folder/$name" || return 1
    sed -i "s,^\(SOURCES.*[ \,]\)$name\(.*\),\1\2 \$(board_folder)/$name," "$folder/board.mk"
    ! (cd "$project" && EMULATE_S=60 board BOARDS="$kept/broken" BOARD=broken SCENE=icosahedron N=1 \
        MODULE='--size 240x240 --hz 10000000' emulate >/dev/null) &&
        cat "$work/said" && grep -q "esp32c3: .*$rule" "$work/said"
}

tap_check "its image is as Espressif describes one" reads
tap_check "and holds what was linked" holds_what_was_linked
tap_check "its instructions are the processor's" for_this_processor
tap_check "images with a wrong bit are not" wrong_images_are_refused
tap_check "40 MHz, SCK 40, mode 3" draws 'processor 40000000 spi 40000000 mode 3' 2
tap_check "a memory LCD: mode 0, SCK 1" draws 'processor 40000000 spi 1000000 mode 0' 2 SCENE=icosahedron PANEL=ls013b7dh03
tap_check "an ST7796 at 480 lines" draws 'processor 40000000 spi 40000000 mode 3' 2 SCENE=icosahedron PANEL=st7796
tap_check "when SPI2 stops the path begins anew, by the rules" recovers
tap_check "registers that are not updated are told" tells 'is updated before bytes' hal/mcu/esp32c3_spi.c \
    '/^static int send/,/^}/ s/int err = update(registers);/int err = 0;/'
tap_check "a queue that is not emptied is" tells 'queue is emptied' hal/mcu/esp32c3_spi.c '/= DMA_CONF_EMPTY;/d'
tap_check "bytes that are not waited for are" tells 'stay as they are while bytes leave' hal/mcu/esp32c3_spi.c \
    '/^static int flush/,/^}/ s/return mcu_wait.*/return !spi;/'
tap_check "D/C that changes with them is" tells 'change when no byte is leaving' hal/mcu/esp32c3_spi.c \
    's/\.flush = flush/.flush = NULL/'
tap_check "a watchdog that runs on is" tells 'are stopped in time' hal/mcu/esp32c3_system.c 's/~(WATCHDOG_ON | RTC_BOOTS)/~WATCHDOG_ON/'
tap_check "a pin of another function is" tells 'at their pins' boards/esp32c3/board.c 's/esp32c3_gpio_lend(&mosi)/(void)mosi/'
tap_check "SPI2 without a clock is" tells 'has its clock' boards/esp32c3/board.c 's/ESP32C3_SPI2 | //'
head -c 100 /dev/zero >"$work/zeros.esp"
tap_check "the ROM takes no image without its magic number" refuses 'the image: does not begin with E9h' "$work/zeros.esp"
tap_check "nor one that is not there" refuses "$work/none.esp: No such file or directory" "$work/none.esp"
tap_check "nor one whose checksum is wrong" refuses_turned 'the image: has a wrong checksum' -33
tap_check "nor one whose digest is" refuses_turned 'the image: has a wrong digest' -1
tap_check "and nobody runs no frames, or no number of them" wants_frames
tap_done
