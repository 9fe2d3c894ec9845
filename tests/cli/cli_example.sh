# SPDX-License-Identifier: MIT
#
# The example of a firmware (tests/example) builds as README says, and its frames do not depend on how
# wide the build's screen arithmetic is, nor on how much memory it is given.
. tests/tap.sh

compile_scene() {
    "$BUILD/limner" compile sim/scenes/teapot.obj -o "$work/teapot"
}

build() { # NAME FLAG...
    name=$1
    shift
    # shellcheck disable=SC2086 # flags are words
    $CC -std=c11 -O2 $WARNINGS "$@" -DLIM_CONFIG='"teapot.h"' -Ifirmware -Isim/targets -I"$work" -o "$work/$name" \
        tests/example/*.c sim/targets/start_host.c "$work/teapot.c" firmware/*.c
}

# Three frames; neither nothing nor everything is painted.
shows_a_teapot() { # NAME FLAG...
    build "$@" && "$work/$1" >"$work/$1.txt" || return 1
    cat "$work/$1.txt"
    awk '{ painted = $4 } END { exit !(NR == 3 && painted > 5000 && painted < 240 * 240 * 3 / 2) }' "$work/$1.txt"
}

same_frames() { # NAME FLAG...
    shows_a_teapot "$@" && diff "$work/narrow.txt" "$work/$1.txt"
}

refuses() { # NAME FLAG...
    build "$@" || return 1
    "$work/$1" >"$work/$1.txt"
    [ $? -eq 1 ] && [ ! -s "$work/$1.txt" ]
}

tap_check "the teapot compiles to C" compile_scene
tap_check "the example shows it on a display of 240 pixels" shows_a_teapot narrow -DLIM_MAX_SIDE_PX=240
tap_check "a build for 1024 pixels draws the same frames" same_frames wide -DLIM_MAX_SIDE_PX=1024
tap_check "so does one without counters and painter" same_frames bare -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_STATS=0 \
    -DLIM_HAS_PAINTER=0
tap_check "so does one with 8 KB of memory" same_frames small -DLIM_MAX_SIDE_PX=240 -DMEM_B=8192
tap_check "2 KB of memory are refused" refuses smaller -DLIM_MAX_SIDE_PX=240 -DMEM_B=2048
tap_done
