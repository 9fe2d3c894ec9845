# SPDX-License-Identifier: MIT
#
# Frames of the teapot are the same on every processor: on a screen so small that 16-bit coordinates do, with
# more edges on a line than the smaller memories hold.
. tests/tap.sh
. tests/frames_on.sh

frames_options='--method scanline'
frames_in_turn 3 sim/scenes/teapot 80x60 host m0plus microbit m3 m4 rv32 avr powerpc m0plus:-Os rv32:-O0 avr:-Os
tap_done
