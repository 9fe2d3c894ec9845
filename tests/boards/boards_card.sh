# SPDX-License-Identifier: MIT
#
# The boards' self-test in emulators that others wrote: the test card, whose hashes are here, and then a solid that turns.
. tests/tap.sh

# No wait is long, so that the emulators' time is not. The frames' hashes go to $work/hashes.
emulate() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$BUILD" BOARDS="$kept/boards" PICTURES="$work/pictures" SCENE=test-card CARD_MS=5 "$@" \
        emulate >"$work/said" 2>&1 || { cat "$work/said" && return 1; }
    sed -n 's/^frame [0-9]*: .* hash //p' "$work/said" | tee "$work/hashes"
}

shows() { # CARD-HASH MAKE-ARGUMENT...
    hash=$1
    shift
    emulate N=3 "$@" && [ "$(head -n 1 "$work/hashes")" = "$hash" ] && [ "$(sort -u "$work/hashes" | wc -l)" -eq 3 ]
}

# When the path of 16 frames is over.
comes_again() {
    emulate BOARD=arduboy N=18 && [ "$(grep -nx 7d9049903aed5415 "$work/hashes" | tr '\n' ' ')" = \
        '1:7d9049903aed5415 18:7d9049903aed5415 ' ]
}

needs_npm() {
    sh sim/emulators/npm.sh >/dev/null 2>"$work/npm"
}

tap_check "Arduboy, in runs, without memory for a line" shows 7d9049903aed5415 BOARD=arduboy
tap_check "and again after each flight" comes_again
tap_check "LM3S6965, on QEMU's own display too" shows 8546549dd43d5645 BOARD=lm3s6965evb
tap_check "blue pill" shows 7d9049903aed5415 BOARD=bluepill PANEL=ssd1306
tap_check "and on its side, wider than the chip's memory" shows 3f8e0d12c16a9cfd BOARD=bluepill PANEL=st7735 \
    MODULE='--size 80x160 --rotate 270'
tap_check "STM32F405, lines that are sent together, and what changes alone" shows 4556b16391b40145 BOARD=stm32f405 COMPILE=--delta
tap_check "HiFive1, a memory LCD" shows 40e552521c709175 BOARD=hifive1 PANEL=ls013b7dh03
tap_check "ESP32-C3, an ST7796" shows 11b22d94e62fb545 BOARD=esp32c3 PANEL=st7796
if needs_npm; then
    tap_check "Pico" shows 4556b16391b40145 BOARD=pico
else
    tap_skip "Pico" "$(grep -m 1 'code\|missing' "$work/npm" || tail -n 1 "$work/npm")"
fi
if sh tests/kernel/build.sh --path >"$work/kernel" 2>&1; then
    tap_check "Linux, a program in the tests' kernel" shows 7d9049903aed5415 BOARD=linux PANEL=ssd1306
else
    tap_skip "Linux, a program in the tests' kernel" "$(tail -n 1 "$work/kernel")"
fi
held_against_a_picture() {
    "$BUILD/limner" card --panel st7789 -o "$work/card.png" && "$BUILD/limner" hashes "$work/card.png" | grep -q 4556b16391b40145
}
tap_check "limner card has the picture that a display must show" held_against_a_picture
tap_done
