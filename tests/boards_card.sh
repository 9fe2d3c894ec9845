# SPDX-License-Identifier: MIT
#
# The boards' self-test in emulators that others wrote: the test card, whose hashes are here, and then a solid that turns.
. tests/tap.sh

# No wait is long, so that the emulators' time is not.
shows() { # CARD-HASH MAKE-ARGUMENT...
    hash=$1
    shift
    make DEPS=skip BUILD="$BUILD" BOARDS="$kept/boards" PICTURES="$work/pictures" SCENE=test-card CARD_MS=5 N=3 "$@" \
        emulate >"$work/said" 2>&1
    status=$?
    cat "$work/said"
    [ "$status" -eq 0 ] && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq 3 ] && grep -q "^frame 0: .* hash $hash\$" "$work/said"
}

# The card is first, and comes again when the path is over.
comes_again() {
    shows 7d9049903aed5415 BOARD=arduboy N=18 || {
        grep '^frame' "$work/said" | sed 's/.* hash //' >"$work/hashes"
        [ "$(grep -nx 7d9049903aed5415 "$work/hashes" | tr '\n' ' ')" = '1:7d9049903aed5415 18:7d9049903aed5415 ' ]
    }
}

needs_npm() {
    sh sim/emulators/npm.sh >/dev/null 2>"$work/npm"
}

tap_check "Arduboy, in runs, without memory for a line" shows 7d9049903aed5415 BOARD=arduboy
tap_check "and again after each flight" comes_again
tap_check "LM3S6965, on QEMU's own display too" shows 8546549dd43d5645 BOARD=lm3s6965evb
tap_check "blue pill" shows 7d9049903aed5415 BOARD=bluepill PANEL=ssd1306
tap_check "STM32F405, lines that are sent together, and what changes alone" shows 4556b16391b40145 BOARD=stm32f405 COMPILE=--delta
tap_check "HiFive1, a memory LCD" shows 40e552521c709175 BOARD=hifive1 PANEL=ls013b7dh03
if needs_npm; then
    tap_check "Pico" shows 4556b16391b40145 BOARD=pico
else
    tap_skip "Pico" "$(grep -m 1 'code\|missing' "$work/npm" || tail -n 1 "$work/npm")"
fi
tap_check "what a display shows can be held against a picture" "$BUILD/limner" card --panel st7789 -o "$work/card.png"
tap_done
