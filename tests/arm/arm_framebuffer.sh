# SPDX-License-Identifier: MIT
#
# Firmware that paints into a framebuffer, on processors: the host's pictures (`limner measure` compares them), for fewer
# instructions than line by line.
. tests/tap.sh

counted() { # SCENE FOLDER OPTION...: "CORE INSTRUCTIONS" of each processor into FOLDER/counted
    scene=$1 folder=$2
    shift 2
    awk '!/^ *(#|$)/ && n++ % 8 == 0' "sim/scenes/$scene.cam" >"$work/few.cam"
    "$BUILD/limner" measure "sim/scenes/$scene.obj" --camera "$work/few.cam" --size 128x64 --precision fast \
        --core m0plus,m4 -o "$folder" "$@" >/dev/null &&
        awk -F , 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
            { print $column["core"], $column["instructions"] }' "$folder/measure.csv" >"$folder/counted"
}

takes_less() { # SCENE MOST: of the instructions by lines
    rm -rf "$work/lines" "$work/frame"
    counted "$1" "$work/lines" && counted "$1" "$work/frame" --framebuffer &&
        join "$work/lines/counted" "$work/frame/counted" >"$work/both" && cat "$work/both" &&
        awk -v most="$2" '$3 > most * $2 { more = 1 } END { exit NR != 2 || more }' "$work/both"
}

tap_check "rooms, nearest first: a thirteenth fewer" takes_less rooms 0.923
tap_check "a teapot, back to front: fewer" takes_less teapot 0.985
tap_done
