# SPDX-License-Identifier: MIT
#
# Frames of textured scenes are the same on every processor: the textured demo, a square whose texture is small
# enough for AVR, and bars before a sky.
. tests/tap.sh
. tests/frames_on.sh

frames_in_turn 1 "$BUILD/scenes/textured/textured" 120x96 host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0
cp tests/models/quarters.* "$work"
awk 'BEGIN { for (i = 0; i < 64; i++) print 0.5 + 0.6 * sin(i / 9), 0.5 + 0.3 * cos(i / 7), 0.15 + i / 90, 0.5, 0.4, 0 }' \
    >"$work/quarters.cam"
frames_in_turn 3 "$work/quarters" 80x60 host m0plus avr powerpc avr:-Os
frames_options='--sky heaven'
frames_in_turn 3 tests/models/holes 80x60 host m0plus m4 rv32 powerpc m0plus:-Os
frames_options=
tap_done
