# SPDX-License-Identifier: MIT
#
# Frames of a mesh without a tree are the same on every processor, by distance and with depths, in memory that is short,
# too, and on an AVR, whose edges are quotients and remainders.
. tests/tap.sh
. tests/frames_on.sh

frames_options='--method mesh'
frames_in_turn 1 sim/scenes/teapot 80x60 host m0plus m3 m4 rv32 powerpc avr m0plus:-Os
frames_options='--method mesh-depth'
frames_in_turn 2 sim/scenes/teapot 80x60 host m0plus m3 m4 rv32 powerpc avr:-Os m4:-Os
tap_done
