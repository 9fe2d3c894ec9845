# SPDX-License-Identifier: MIT
#
# What moves is placed, lit, cut by the scene's planes and by one another, and painted alike on every processor.
. tests/tap.sh
. tests/frames_on.sh

frames_suffix=gltf frames_every=6 frames_options='--mover-light turning' frames_path='--fps 3'
frames_flags=-DSCENE_FRAMES_PER_S=3
frames_in_turn 1 sim/scenes/movers 120x90 host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0
tap_done
