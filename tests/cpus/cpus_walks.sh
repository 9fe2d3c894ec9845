# SPDX-License-Identifier: MIT
#
# Rays and walkers find the same on every processor, big-endian and 8-bit ones, too.
. tests/tap.sh
. sim/targets/targets.sh
. tests/one_file.sh

# Rooms have upright planes; a teapot in clusters, with feet on its lid, has planes of its own in leaves.
prepare() { # MODEL FOLDER CAMERAS [OPTION...]
    model=$1 folder=$2 cameras=$3
    shift 3
    mkdir -p "$folder" && "$BUILD/limner" compile "$model" "$@" -o "$folder/model" >/dev/null &&
        "$BUILD/limner" render "$folder/model.lim" --camera "$cameras" --write-cameras "$folder/cameras.h"
}

rooms_are_ready() {
    "$BUILD/limner" walk sim/scenes/rooms.obj --frames 160 -o "$work/walk.cam" &&
        awk '!/^#/ && n++ % 20 == 0' "$work/walk.cam" >"$work/few.cam" &&
        prepare sim/scenes/rooms.obj "$work/rooms" "$work/few.cam" --tree bsp
}

teapot_is_ready() {
    awk 'BEGIN { for (i = 0; i < 8; i++) printf "%.4f %.4f %.4f 0 0.6 0\n", 2 * cos(i), 0.5 + i / 8, 2 * sin(i) }' >"$work/round.cam"
    prepare sim/scenes/teapot.obj "$work/teapot" "$work/round.cam" --tree clusters --method nearest
}

flags='-DWALKS_EYE_M=0.4 -DWALKS_RADIUS_M=0.1 -DWALKS_STEP_M=0.1'

found() { # CORE FOLDER
    case $2 in *teapot) set -- "$@" $flags ;; esac
    core=$1 folder=$2
    shift 2
    target_link "$core" "$work/image" '-DLIM_CONFIG="model.h"' "-I$folder" "$@" sim/targets/walks.c boards/common/app_scene.c \
        "$folder"/model*.c "$(one_file)" && target_run "$core" "$work/image" >"$work/$core.found"
}

host_finds() { # FOLDER RAYS
    found host "$1" && sort "$work/host.found" | cut -d ' ' -f 1-2 | uniq -c && cp "$work/host.found" "$1/expected" &&
        [ "$(grep -c '^ray 1' "$1/expected")" -ge "$2" ]
}

finds_the_same() { # CORE FOLDER
    found "$1" "$2" && diff "$2/expected" "$work/$1.found"
}

tap_check "rooms are compiled, with cameras of a walk" rooms_are_ready
tap_check "a teapot is, with clusters" teapot_is_ready
tap_check "the host meets walls in rooms" host_finds "$work/rooms" 16
tap_check "and a teapot" host_finds "$work/teapot" 4
for core in m0plus m4 rv32 powerpc avr; do
    tap_check "$core finds the same in rooms" finds_the_same $core "$work/rooms"
done
for core in m0plus avr; do
    tap_check "$core finds the same of the teapot" finds_the_same $core "$work/teapot"
done
tap_done
