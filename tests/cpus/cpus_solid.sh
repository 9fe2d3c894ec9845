# SPDX-License-Identifier: MIT
#
# Frames of a convex solid, drawn by its own method, are the same on every processor.
. tests/tap.sh
. tests/frames_on.sh

cp sim/scenes/icosahedron.obj "$work/solid.obj"
cp sim/scenes/teapot.cam "$work/solid.cam"
frames_options='--method convex'
frames_in_turn 2 "$work/solid" 80x60 host m0plus m3 rv32 avr powerpc avr:-Os rv32:-Os
tap_done
