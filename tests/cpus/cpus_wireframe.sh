# SPDX-License-Identifier: MIT
#
# Wireframes are the same on every processor: of a concave scene nearest first, where memory is scarce by lines painted
# back to front, and of a convex solid by its own method.
. tests/tap.sh
. tests/frames_on.sh

frames_options=--wireframe
frames_in_turn 3 sim/scenes/glass 80x60 host m0plus m3 rv32 avr powerpc avr:-Os
cp sim/scenes/icosahedron.obj "$work/solid.obj"
cp sim/scenes/teapot.cam "$work/solid.cam"
frames_options='--wireframe --method convex'
frames_in_turn 1 "$work/solid" 80x60 host m0plus rv32 avr powerpc
tap_done
