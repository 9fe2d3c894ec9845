# SPDX-License-Identifier: MIT
#
# Delta output sends the same changes on every processor: what they leave of a frame is the frame.
. tests/tap.sh
. tests/frames_on.sh

frames_options=--delta
frames_in_turn 1 sim/scenes/rooms 80x60 host m0plus rv32 powerpc m0plus:-Os
tap_done
