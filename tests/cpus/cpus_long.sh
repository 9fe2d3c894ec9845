# SPDX-License-Identifier: MIT
#
# Scenes of many scales are the same on every processor: coordinates of 32 bits, opaque and with glass; and, in a profile
# each, by other methods, with antialiased edges, as wireframe, and as changes alone; and what moves in them.
. tests/tap.sh
. tests/frames_on.sh
. tests/long_scene.sh

frames_every=1 frames_compile='--coordinates 32'
long_scene "$work/many"
frames_in_turn 0 "$work/many" 80x60 m0plus m3 m4 m33 rv32 powerpc m0plus:-Os rv32:-Os
long_scene "$work/glassy" 0.5
frames_in_turn 2 "$work/glassy" 80x60 m0plus m3 m33 rv32

otherwise() { # OPTIONS PROFILE CORE
    [ -z "${EVERY_PROFILE:-}" ] || set -- "$1" "$PROFILES" "$3"
    frames_options=$1
    for profile in $2; do
        frames_of "$profile" "$3"
    done
}
scene=$work/many size=80x60
otherwise '--method painter' fast m0plus
otherwise '--method scanline' exact rv32
otherwise --antialias fine m33
otherwise --wireframe draft m3
otherwise --delta fast m0plus

frames_every=6 frames_options= frames_path='--fps 3' frames_suffix=gltf frames_flags=-DSCENE_FRAMES_PER_S=3
frames_in_turn 1 sim/scenes/movers 80x60 m0plus powerpc rv32 m3
tap_done
