# SPDX-License-Identifier: MIT
#
# Displays behind a USB-HID bridge: what the port sends, and frames a second.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
. sim/scenes/cube.sh

cube_make "$work"
"$BUILD/limner" bridge "$work/cube.dae" "$work/cube.cam" sim/scenes/rooms.obj sim/scenes/rooms-walk.cam
