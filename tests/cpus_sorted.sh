# SPDX-License-Identifier: MIT
#
# What is sorted without a tree is sorted, split and painted alike on every processor. (Not on AVR: half of its memory leaves
# less room for pieces, and then some polygons go by their farthest points.)
. tests/tap.sh
. tests/frames_on.sh

turn=0
for method in depth newell; do
    turn=$((turn + 2))
    frames_options="--method $method"
    frames_in_turn $turn sim/scenes/knot 120x90 host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0
done
tap_done
