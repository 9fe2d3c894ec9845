# SPDX-License-Identifier: MIT
#
# Frames of mesh leaves are the same on every processor: leaves that stand still, nearest first and by scan lines, near
# the eye and far away, in memory that is short, and with what moves. Profile exact has none.
. tests/tap.sh
. tests/frames_on.sh

mkdir -p "$work/leaves"
awk -v seed=5 -v things=6 -v how=apart -v mtl="$work/leaves/rooms.mtl" -f tests/furnished.awk >"$work/leaves/rooms.obj"
awk 'BEGIN {
    srand(3)
    for (i = 0; i < 8; i++) print 1 + 6 * rand(), 1 + rand(), 1 + 6 * rand(), 8 * rand(), rand(), 8 * rand()
}' >"$work/leaves/rooms.cam"
frames_compile='--mesh-leaves all' frames_options='--method nearest'
frames_in_turn 1 sim/scenes/teapot 80x60 m0plus m3 powerpc avr
frames_every=1
frames_in_turn 2 "$work/leaves/rooms" 80x60 m0plus rv32 powerpc m4:-Os
frames_options='--method scanline'
frames_in_turn 0 "$work/leaves/rooms" 80x60 host m4 rv32 powerpc
frames_flags=-DSCENE_FRAMES_PER_S=3
frames_every=6 frames_options='' frames_path='--fps 3' frames_suffix=gltf
frames_in_turn 1 sim/scenes/movers 80x60 m0plus m4 powerpc m4:-Os
tap_done
