# SPDX-License-Identifier: MIT
#
# What a logic analyser would capture of a board: the Arduboy's image of the self-test, in simavr, which dumps its pins
# with a writer of its own; decoded, these are the card and the frames that the simulator draws, as boards/arduboy/README.md
# has it. The commands of every board's README do what they say, as far as that can be seen without hardware.
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

# -- README's three steps ------------------------------------------------------------------------------------------------

# The line of a board's README that begins so.
line_of() { # BOARD BEGINNING
    sed -n "s/^       \($2 .*\)/\1/p" "boards/$1/README.md" | head -n 1
}

card_of() { # OPTION...: a hash
    "$BUILD/limner" card "$@" | sed 's/.*hash //'
}

# sigrok's demonstration device in the analyser's place: names of channels are taken.
captures() { # BOARD
    line=$(line_of "$1" sigrok-cli | sed "s/-d fx2lafw/-d demo/; s/samplerate=24m/samplerate=1m/; s/--time [0-9]*s/--samples 4000/; s# -o # -o $work/#")
    [ -n "$line" ] && sh -c "$line" && [ -s "$work/$(echo "$line" | sed 's#.*/##')" ]
}

# What the image is made for is what is decoded; what that device captured has all channels, and no picture.
decodes() { # BOARD
    module=$(line_of "$1" make | sed -n "s/.*MODULE='\(.*\)'/\1/p") line=$(line_of "$1" build\\/limner)
    options=$(echo "$line" | sed 's/.*\.sr \(.*\) -o .*/\1/') golden=${line##* }
    panel=$(echo "$options" | sed 's/.*--panel \([a-z0-9]*\).*/\1/')
    echo "$module, $options, $golden"
    # shellcheck disable=SC2086 # options are words
    [ "$(card_of --panel "$panel" $module)" = "$(card_of $options)" ] &&
        [ "$golden" = "build/boards/$1/test-card-$panel-fast/golden" ] || return 1
    sh -c "$(echo "$line" | sed "s#^build#$BUILD#; s#decode #decode $work/#; s#out/#$work/out/#; s#build/boards[^ ]*#$folder/golden#")" 2>"$work/said" &&
        return 1
    cat "$work/said" && ! grep 'no channel' "$work/said" && grep "/[a-z0-9]*.sr: " "$work/said"
}

for name in boards/*/board.mk; do
    name=${name%/board.mk} name=${name#boards/}
    tap_check "$name: README's capture is one" captures "$name"
    tap_check "$name: it is decoded for what the image draws" decodes "$name"
done

tap_check "simavr dumps the pins of an Arduboy" make_dump
tap_check "the dump has the card, and then the solid" decode --frames 6 --check "$folder/golden.6"
tap_check "also if nobody captured the light" decode --wires led=- --frames 6 --check "$folder/golden.6"
tap_check "so it has from the middle on" late_dump 40000000
tap_check "simavr's display shows the same" displays_agree
tap_done
