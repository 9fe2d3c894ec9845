# SPDX-License-Identifier: MIT
#
# Code that is both small and fast (LIM_OPTIMISE=LIM_BALANCE): the rooms' renderer on Cortex-M4 takes 9 KB at most, and 1.1
# times the instructions of -O2; the smallest stays smaller, and the fastest faster. The same frames: `limner measure` counts none that are not the host's.
. tests/tap.sh
. sim/targets/targets.sh
. sim/tools/footprint.sh

balance=-DLIM_OPTIMISE=LIM_BALANCE

# The renderer, from separate files and from the one that is exported.
prepare() {
    mkdir "$work/rooms" && "$BUILD/limner" compile sim/scenes/rooms.obj -o "$work/rooms/model" --report >"$work/report" &&
        "$BUILD/limner" export sim/scenes/rooms.obj --for plain -o "$work/export/model" >"$work/exported"
}

code_b() { # FLAG...
    footprint_objects m4 "$work/rooms" model.h "$@" && footprint_link m4 "$work/rooms" &&
        footprint_size m4 "$work/rooms/m4/renderer.elf" 1
}

exported_b() { # FLAG...
    mkdir -p "$work/one/m4"
    rm -f "$work/one/m4"/*
    # shellcheck disable=SC2046,SC2086 # flags are words
    $(target_compiler m4) $(target_flags m4) $footprint_flags $WARNINGS -I"$work/export/model" "$@" -c -o "$work/one/m4/limner.o" \
        "$work/export/model/limner.c" && footprint_link m4 "$work/one" && footprint_size m4 "$work/one/m4/renderer.elf" 1
}

sizes() {
    size_b=$(code_b) && balance_b=$(code_b "$balance") && one_b=$(exported_b "$balance") || return 1
    echo "smallest $size_b, balanced $balance_b, exported $one_b bytes"
    [ "$size_b" -lt "$balance_b" ] && [ "$balance_b" -le 9216 ] && [ "$one_b" -gt 5000 ] && [ "$one_b" -le 9216 ]
}

# Mean instructions of a frame: rows of a table for each processor in turn.
counts() { # OPTIMISE CORES MODEL CAMERAS [OPTION...]
    counts_of=$1 counts_cores=$2 counts_model=$3 counts_cameras=$4
    shift 4
    "$BUILD/limner" measure "$counts_model" --camera "$counts_cameras" --precision fast --core "$counts_cores" \
        --optimise "$counts_of" "$@" >"$work/measured" || return 1
    awk -F '|' '/^## / { cost = 1 } cost && $2 ~ /^ fast / { print $4 + 0 }' "$work/measured"
}

ratios() {
    for purpose in speed balance size; do
        counts $purpose m4 sim/scenes/rooms.obj sim/scenes/rooms.cam || return 1
    done >"$work/ratios"
    tr '\n' ' ' <"$work/ratios"
    awk '{ n[NR] = $1 } END { exit !(NR == 3 && n[1] > 0 && n[1] < n[2] && n[2] <= 1.1 * n[1] && n[3] >= 1.15 * n[2]) }' "$work/ratios"
}

draws() { # CORES MODEL [OPTION...]
    draws_cores=$1 draws_model=$2
    shift 2
    sed '/^#/d' "${draws_model%.*}.cam" | awk 'NR % 16 == 1' >"$work/few.cam"
    counts balance "$draws_cores" "$draws_model" "$work/few.cam" --size 96x64 "$@" >"$work/drawn" && tr '\n' ' ' <"$work/drawn" &&
        [ "$(wc -l <"$work/drawn")" -eq "$(echo "$draws_cores" | tr ',' '\n' | wc -l)" ]
}

tap_check "the rooms compile, and export" prepare
tap_check "m4: balanced code takes 9 KB at most, from separate files and from one" sizes
tap_check "m4: and 1.1 times the instructions of -O2 at most; the smallest takes 1.15 times as many" ratios
tap_check "balanced code draws the rooms" draws m0plus,rv32 sim/scenes/rooms.obj
tap_check "rooms into a framebuffer" draws m4 sim/scenes/rooms.obj --framebuffer
tap_check "the teapot" draws m0plus sim/scenes/teapot.obj
tap_check "glass with smooth edges" draws m4 sim/scenes/glass.obj --antialias
tap_check "textures" draws m4 "$BUILD/scenes/textured/textured.obj"
tap_done
