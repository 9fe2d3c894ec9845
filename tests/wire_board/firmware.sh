# SPDX-License-Identifier: MIT
#
# For test scripts to source, behind tap.sh: the firmware of boards/common for a display, on a board that is this computer
# (board.c), $work/firmware; the frames that it draws are those of $work/golden, four of them and then again. DEFINES: more flags of the compiler's.
# shellcheck shell=sh disable=SC2154 # $work is tap.sh's

limner=$BUILD/limner
model=sim/scenes/icosahedron.obj
printf '%s\n' '0 1 4 0 0 0' '2 1 3 0 0 0' '3 0 1 0 0 0' '1 -1 3 0.3 0 0' >"$work/path.cam"

compile() { # SOURCE...: for the scene
    # shellcheck disable=SC2086 # warnings are words
    printf '%s\n' "$@" | (cd "$work/objects" && xargs -P 2 -n 8 "${CC:-gcc}" -std=c11 -O1 $WARNINGS ${DEFINES:-} -I"$work" \
        -DLIM_CONFIG='"model.h"' -I"$OLDPWD/firmware" -I"$OLDPWD/hal" -I"$OLDPWD/hal/mcu" -I"$OLDPWD/boards/common" -c)
}

compile_scene() {
    mkdir -p "$work/objects"
    "$limner" compile "$model" --size 240x240 -o "$work/model" &&
        compile "$work/model.c" "$PWD"/firmware/*.c "$PWD"/firmware/*/*.c "$PWD"/boards/common/card.c "$PWD/boards/common/screen.c" "$PWD/tests/wire_board/board.c"
}

make_firmware() { # SIZE RENDERED-PANEL PANEL OPTION...
    size=$1 rendered=$2
    shift 2
    "$limner" render "$work/model.lim" --camera "$work/path.cam" --size "$size" --panel "$rendered" \
        --write-hashes "$work/golden" --write-cameras "$work/cameras.h" &&
        "$limner" module --panel "$@" -o "$work/module" &&
        compile "$work/module.c" "$PWD/boards/common/main.c" "$PWD/boards/common/app_scene.c" &&
        "${CC:-gcc}" -o "$work/firmware" "$work"/objects/*.o "$BUILD/host/liblimner.a"
}

# The wires of its first four frames: the LED's level, and four changes.
wires_of_four() {
    "$work/firmware" | awk '{ print } $1 == "p" && $2 == "led" && frames++ == 4 { exit }'
}

fails() { # PATTERN COMMAND...: one line of error, nothing else left
    pattern=$1
    shift
    rm -rf "$work/bad"
    "$@" >"$work/out" 2>"$work/said" && return 1
    cat "$work/said"
    [ "$(wc -l <"$work/said")" -eq 1 ] && grep -qE -- "$pattern" "$work/said" && [ ! -e "$work/bad" ]
}
