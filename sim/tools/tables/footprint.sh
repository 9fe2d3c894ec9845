# SPDX-License-Identifier: MIT
#
# What scenes cost in a firmware.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
. sim/targets/targets.sh
. sim/tools/footprint.sh

: "${WARNINGS:=-Wall}"
h_px=240

method_of() { # FOLDER
    sed -n 's/^#define MODEL_SCENE_METHOD LIM_//p' "$1/model.h" | tr '[:upper:]' '[:lower:]' | sed 's/_first$//'
}

row() { # NAME MODEL [OPTION...]
    scene=$1 model=$2
    shift 2
    mkdir -p "$work/$scene"
    "$BUILD/limner" compile "$model" --size ${h_px}x$h_px -o "$work/$scene/model" "$@" >/dev/null
    footprint_costs m0plus "$work/$scene" $h_px >"$work/m0plus"
    footprint_costs m4 "$work/$scene" $h_px >"$work/m4"
    read -r code_m0 ram_m0 stack_m0 <"$work/m0plus"
    read -r code_m4 ram_m4 stack_m4 <"$work/m4"
    [ "$ram_m4" -le "$ram_m0" ] # the same structs, but for pairs of 16 bits
    echo "| $scene | $(method_of "$work/$scene") | $code_m0 | $code_m4 | $(footprint_data "$work/$scene") | $ram_m0 | $stack_m0 | $stack_m4 |"
}

table() {
    echo "| scene | method | code, M0+ | code, M4 | scene data | RAM | stack, M0+ | stack, M4 |"
    echo "|---|---|---|---|---|---|---|---|"
    row demo "$BUILD/scenes/demo.obj"
    row rooms sim/scenes/rooms.obj
    row teapot sim/scenes/teapot.obj
    row icosahedron sim/scenes/icosahedron.obj
    row icosahedron sim/scenes/icosahedron.obj --method convex
}

table
