# SPDX-License-Identifier: MIT
#
# Frames of the glass scene are the same on every processor; where memory is scarce the stack of layers has half of
# what the scene asks for, and lines are painted back to front.
. tests/tap.sh
. tests/frames_on.sh

frames_in_turn 0 sim/scenes/glass 80x60 host m0plus m3 rv32 avr powerpc m0plus:-Os avr:-Os
tap_done
