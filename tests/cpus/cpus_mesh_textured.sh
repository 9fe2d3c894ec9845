# SPDX-License-Identifier: MIT
#
# Frames of meshes with textures are the same on every processor, big-endian ones among them: by distance and with
# depths, texels that advance evenly and in perspective, in memory that is short, too. A square's texture is small enough
# for an AVR.
. tests/tap.sh
. tests/frames_on.sh

cp sim/scenes/mapped/teapottex.obj sim/scenes/mapped/tm.mtl sim/scenes/mapped/t*.png "$work"
cp sim/scenes/teapot.cam "$work/teapottex.cam"
frames_options='--method mesh'
frames_in_turn 1 "$work/teapottex" 80x60 host m0plus m3 m4 rv32 powerpc m0plus:-Os
frames_options='--method mesh-depth'
frames_in_turn 3 "$work/teapottex" 80x60 host m0plus m3 m4 rv32 powerpc m4:-Os
cp tests/models/quarters.* "$work"
awk 'BEGIN { for (i = 0; i < 64; i++) print 0.5 + 0.6 * sin(i / 9), 0.5 + 0.3 * cos(i / 7), 0.15 + i / 90, 0.5, 0.4, 0 }' \
    >"$work/quarters.cam"
frames_in_turn 2 "$work/quarters" 80x60 host m4 avr powerpc avr:-Os
tap_done
