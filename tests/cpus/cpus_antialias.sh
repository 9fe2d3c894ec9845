# SPDX-License-Identifier: MIT
#
# Antialiased edges are the same on every processor: nearest first from a tree, where memory is scarce in bands and single
# lines, and sorted, with pieces of polygons that are split.
. tests/tap.sh
. tests/frames_on.sh

frames_options=--antialias
frames_in_turn 2 sim/scenes/rooms 80x60 host m0plus rv32 avr powerpc m0plus:-Os
frames_options='--antialias --method newell'
frames_in_turn 0 sim/scenes/knot 80x60 m0plus powerpc
tap_done
