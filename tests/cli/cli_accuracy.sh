# SPDX-License-Identifier: MIT
#
# The promises of the precision profiles on the benchmark scenes, as the program itself measures them: 64
# frames of 240x240 pixels against the reference.
. tests/tap.sh

scenes=sim/scenes

# at_most NAME VALUE LIMIT
at_most() {
    echo "$1: $2, at most $3"
    awk -v value="$2" -v limit="$3" 'BEGIN { exit !(value != "" && value + 0 <= limit + 0) }'
}

# The last line of --compare: "... wrong W % (worst ...), beyond a one-pixel shift B ppm, holes H".
measure() { # SCENE PRECISION
    "$BUILD/limner" render "$scenes/$1.obj" --camera "$scenes/$1.cam" --size 240x240 --precision "$2" --stats \
        --compare --sheet "$work/$1.png" >"$work/$1.txt"
}

field() { # SCENE BEFORE: the number after a phrase in the closing line
    sed -n "\$s/.*$2 \([0-9.]*\).*/\1/p" "$work/$1.txt"
}

column() { # SCENE COLUMN: of the statistics of the frames, then their mean and worst
    awk -v column="$2" '$1 == "frame" && !at { for (i = 1; i <= NF; i++) if ($i == column) at = i; next }
        at && !done && $1 ~ /^([0-9]+|mean|worst)$/ { print $at; done = $1 == "worst" }' "$work/$1.txt"
}

mean() { # SCENE COLUMN
    column "$1" "$2" | tail -n 2 | head -n 1
}

reported() { # SCENE LABEL: a number of the compiler's report
    sed -n "s/^ *$2  *\([0-9]*\).*/\1/p" "$work/$1.report" | head -n 1
}

accurate() { # SCENE PRECISION WRONG_PERCENT BEYOND_PPM
    measure "$1" "$2" && at_most "wrong, %" "$(field "$1" wrong)" "$3" &&
        at_most "beyond a pixel, ppm" "$(field "$1" shift)" "$4" && at_most holes "$(field "$1" holes)" 0
}

rooms_are_cheap() { # lines are painted from far to near, over what is hidden
    at_most "polygons reached" "$(mean rooms polygons)" 90 && at_most overdraw "$(mean rooms overdraw)" 1.35 &&
        at_most bands "$(mean rooms bands)" 0
}

rooms_are_painted_once_by_gaps() { # as lines are where only changes are sent
    "$BUILD/limner" render "$scenes/rooms.obj" --camera "$scenes/rooms.cam" --size 240x240 --delta --stats \
        --sheet "$work/once.png" >"$work/once.txt" &&
        [ "$(column once overdraw | sort -u)" = 1.000 ] && [ "$(column once overdraw | wc -l)" -eq 66 ]
}

rooms_compile_small() {
    "$BUILD/limner" compile "$scenes/rooms.obj" --keep-faces -o "$work/rooms" --report >"$work/rooms.report" &&
        at_most splits "$(reported rooms splits)" 20 && at_most "bytes of flash" "$(reported rooms 'in all')" 63488
}

tap_check "fine: rooms: wrong <= 0.03 %, beyond a pixel <= 6 ppm, no holes" accurate rooms fine 0.03 6
tap_check "fine: rooms-tilted: the same" accurate rooms-tilted fine 0.03 6
tap_check "fine: teapot: wrong <= 0.06 %, beyond a pixel <= 60 ppm, no holes" accurate teapot fine 0.06 60
tap_check "fast: teapot: wrong <= 0.08 %, beyond a pixel <= 80 ppm, no holes" accurate teapot fast 0.08 80
tap_check "fast: rooms-tilted: wrong <= 0.05 %, beyond a pixel <= 6 ppm, no holes" accurate rooms-tilted fast 0.05 6
tap_check "fast: rooms: the same" accurate rooms fast 0.05 6
tap_check "rooms: <= 90 polygons reached a frame, every pixel painted 1.35 times at most, no bands" rooms_are_cheap
tap_check "rooms: every pixel is painted once where lines are painted by gaps" rooms_are_painted_once_by_gaps
tap_check "rooms: <= 20 splits, <= 62 KB of flash" rooms_compile_small
tap_done
