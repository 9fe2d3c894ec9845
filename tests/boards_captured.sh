# SPDX-License-Identifier: MIT
#
# What a logic analyser would capture of a board: the Arduboy's image of the self-test, in simavr, which dumps its pins
# with a writer of its own; decoded, these are the card and the frames that the simulator draws, as boards/arduboy/README.md
# has it.
. tests/tap.sh

folder=$kept/boards/arduboy/test-card-ssd1306-fast

make_dump() {
    make DEPS=skip BUILD="$BUILD" BOARDS="$kept/boards" BOARD=arduboy SCENE=test-card CARD_MS=20 N=6 image \
        "$folder/golden.6" "$BUILD/simavr_oled" &&
        timeout -k 5 60 "$BUILD/simavr_oled" "$folder/image.elf" 6 "$work/%d.png" "$work/wires" "$work/dump.vcd"
}

decode() { # OPTION...
    "$BUILD/limner" decode "$work/dump.vcd" --panel ssd1306 "$@"
}

displays_agree() { # simavr's own shows what the dump says
    "$BUILD/limner" hashes "$work"/?.png --check "$folder/golden.6"
}

# The dump without its beginning, as if the analyser was switched on later: signals have the levels of then.
late_dump() {
    awk '/^#/ && !is_late { now = substr($0, 2) + 0; is_late = now > from }
        /^[01x]./ && !is_late { level[substr($0, 2)] = substr($0, 1, 1); next }
        is_late && !told++ { print "#" now; for (id in level) print level[id] id; next }
        is_late || /^\$(time|scope|var|upscope|enddef)/ { print }' from="$1" "$work/dump.vcd" >"$work/late.vcd"
    "$BUILD/limner" decode "$work/late.vcd" --panel ssd1306 --running --check-loop "$folder/golden" >"$work/out" &&
        cat "$work/out" && [ "$(grep -c '^frame' "$work/out")" -ge 3 ]
}

tap_check "simavr dumps the pins of an Arduboy" make_dump
tap_check "the dump has the card, and then the solid" decode --frames 6 --check "$folder/golden.6"
tap_check "also if nobody captured the light" decode --wires led=- --frames 6 --check "$folder/golden.6"
tap_check "so it has from the middle on" late_dump 40000000
tap_check "simavr's display shows the same" displays_agree
tap_done
