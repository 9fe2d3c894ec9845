# SPDX-License-Identifier: MIT
#
# Frames of a mesh without a tree are the same on every processor, by distance and with depths; on an AVR, whose edges
# are quotients and remainders, of a scene that its memory holds.
. tests/tap.sh
. tests/frames_on.sh

frames_options='--method mesh'
frames_in_turn 1 sim/scenes/teapot 80x60 host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0
frames_options='--method mesh-depth'
frames_in_turn 2 sim/scenes/teapot 80x60 host m0plus m3 m4 rv32 powerpc m4:-Os
frames_in_turn 3 sim/scenes/icosahedron 64x48 avr avr:-Os powerpc
frames_options='--method mesh'
frames_in_turn 4 sim/scenes/icosahedron 64x48 avr m4:-Os
tap_done
