# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# For tests/kernel.sh: whether what went over the wires is the picture that the simulator draws.
# Wants tests/kernel/guests.sh.

replay() { "$BUILD/tests/kernel/replay" "$@"; }

# The simulator's picture of the last frame, as $work/NAME.png; the test card needs none.
golden() { # NAME PANEL GLASS PICTURE
    [ "$4" != card ] || return 0
    head -n "$4" "$stage/demo.cam" >"$work/golden.cam"
    "$BUILD/limner" render "$stage/demo.lim" --camera "$work/golden.cam" --panel "$2" --size "${3%%+*}" \
        -o "$work/golden-%d.png" && mv "$work/golden-$(($4 - 1)).png" "$work/$1.png"
}

# shows GUEST NAME PANEL GLASS PICTURE: what the guest recorded as NAME.wires.
shows() {
    wanted=$work/$2.png
    [ "$5" != card ] || wanted=card
    [ -e "$wanted" ] || golden "$2" "$3" "$4" "$5"
    replay "$stage/on-$1/$2.wires" "$3" "$4" "$wanted"
}

# says PATTERN COMMAND...: its output matches, whatever its status.
says() {
    pattern=$1
    shift
    "$@" >"$work/said" 2>&1
    cat "$work/said"
    grep -qE -- "$pattern" "$work/said"
}

judge_display() { # GUEST
    tap_check "$1: the guest ends well" is_good "$1"
    relay "$1"
    while read -r name panel glass picture rest; do
        case $name in '#'*) continue ;; esac
        tap_check "$1: what it drew of $name is the picture" shows "$1" "$name" "$panel" "$glass" "$picture"
    done <"$here/pictures"
    for tearing in still moves; do
        tap_check "$1: the picture is whole with a tearing line that $tearing" shows "$1" $tearing st7789 240x240 2
    done
    for signal in TERM HUP; do
        tap_check "$1: SIG$signal leaves the panel dark and no line held" \
            says 'lit=0 held=0' replay "$stage/on-$1/$signal.wires" st7789 240x240 any
    done
    tap_check "$1: clock and mode are those asked for" \
        says 'speed_hz=12345678 mode=3' replay "$stage/on-$1/card-part.wires" st7789 135x240+52+40 card
}

flies_as_simulated() {
    "$BUILD/limner" render sim/scenes/rooms.obj --camera sim/scenes/rooms.cam --size 240x240 --precision fast \
        --panel st7789 --write-hashes "$work/hashes" && head -n 8 "$work/hashes" >"$work/golden" &&
        "$BUILD/limner" decode "$stage/on-board/flight" --panel st7789 --frames 8 --check "$work/golden"
}

judge_board() {
    tap_check "board: the guest ends well" is_good board
    relay board
    tap_check "board: eight frames are those of the simulator" flies_as_simulated
    tap_check "board: clock and mode are the module's" \
        says 'speed_hz=40000000 mode=3' replay "$stage/on-board/flight.wires" st7789 240x240 any
    tap_check "board: SIGTERM leaves the panel dark and no line held" \
        says 'lit=0 held=0' replay "$stage/on-board/flight.wires" st7789 240x240 any
}

judge_bridge() { # GUEST
    tap_check "$1: the guest ends well" is_good "$1"
    relay "$1"
    tap_check "$1: what it drew of the card is the picture" shows "$1" card st7735 80x160+26+1 card
    tap_check "$1: what it drew of a scene is the picture" shows "$1" scene ssd1306 128x64 2
    tap_check "$1: the frame after plugging in again is whole" shows "$1" replugged st7735 80x160+26+1 1
}

# The card's record with one byte of a pixel changed, and one that stops in the middle. Of two places that are further
# apart than an event's head is long, and nearer than two heads are, one is a pixel's.
falsified() { # GUEST
    for at in 60000 60100; do
        cp "$stage/on-$1/card.wires" "$work/falsified"
        printf '\125' | dd of="$work/falsified" bs=1 seek=$at conv=notrunc 2>"$work/dd"
        ! says 'pixel [0-9]+,[0-9]+ differs' replay "$work/falsified" st7789 240x240 card || return 0
    done
    return 1
}

cut_short() { # GUEST
    head -c 60000 "$stage/on-$1/card.wires" >"$work/falsified"
    says 'ends within an event' replay "$work/falsified" st7789 240x240 card
}
