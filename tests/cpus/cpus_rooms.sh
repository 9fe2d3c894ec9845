# SPDX-License-Identifier: MIT
#
# Frames of the rooms are the same on every processor: on a screen so wide that the finer profiles need
# wide coordinates, with polygons that reach behind the eye.
. tests/tap.sh
. tests/frames_on.sh

frames_on sim/scenes/rooms 400x96 host m0plus microbit m3 m4 rv32 avr powerpc m0plus:-Os rv32:-O0 avr:-Os
tap_done
