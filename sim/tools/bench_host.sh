# SPDX-License-Identifier: MIT
#
# Instructions of the renderer's own functions on this computer, for sim/tools/bench.sh to source: callgrind watches the
# program that the emulated processors run, between the beginning and the end of lim_frame(). What the target's functions
# take is left out, as there, and what the C library's take, which depends on the processor.
# Needs sim/targets/targets.sh to be sourced as well.
# shellcheck shell=sh

# Of model.h: what draws a mesh, which model.lim does not say.
bench_host_method() { # FOLDER
    awk '/define LIM_HAS_MESH 1$/ { print "--method mesh" } /define LIM_HAS_MESH_DEPTH 1$/ { print "--method mesh-depth" }' "$1/model.h"
}

# bench_host_count FOLDER CAMERAS SIZE [FOV]: of FOLDER/model.c and model.lim; prints "STAGE MEAN WORST", the frame first.
bench_host_count() {
    rm -f "$1"/callgrind.*
    # shellcheck disable=SC2046 # words
    "$BUILD/limner" render "$1/model.lim" --camera "$2" --size "$3" --fov "${4:-60}" --precision fast $(bench_host_method "$1") --write-cameras "$1/cameras.h" \
        --write-hashes "$1/expected" >/dev/null &&
        target_link host "$1/image" -g -ffreestanding -I"$1" '-DLIM_CONFIG="model.h"' -DLIM_HAS_STATS=0 \
            sim/targets/frames.c boards/common/app_scene.c "$1"/model*.c firmware/*.c firmware/*/*.c &&
        valgrind --tool=callgrind --callgrind-out-file="$1/callgrind" --compress-strings=no --compress-pos=no \
            --toggle-collect=lim_frame --dump-after=lim_frame "$1/image" >"$1/hashes" 2>"$1/valgrind.log" &&
        diff "$1/expected" "$1/hashes" >&2 && awk -f sim/tools/bench_host.awk "$1"/callgrind.[0-9]*
}
