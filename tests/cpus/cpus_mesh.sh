# SPDX-License-Identifier: MIT
#
# Frames of a mesh without a tree are the same on every processor, by distance and with depths, in memory that is short,
# too, and on an AVR, whose edges are quotients and remainders.
. tests/tap.sh
. tests/frames_on.sh

frames_options='--method mesh'
frames_in_turn 1 sim/scenes/teapot 80x60 host m0plus m3 m4 rv32 powerpc avr m0plus:-Os
frames_options='--method mesh-depth'
frames_mem_b=8448 # a teapot by depth takes no less in exact
frames_in_turn 2 sim/scenes/teapot 80x60 host m0plus m3 m4 rv32 powerpc avr:-Os m4:-Os
# Triangles from beyond the left of the screen to beyond its right: 16 bits do not hold the ways between their corners.
awk -v eyes="$work/wide.cam" 'BEGIN {
    srand(11)
    for (i = 0; i < 30; i++) {
        far = 2 + i / 3; left = -far * (0.8 + 0.3 * rand()); right = far * (0.8 + 0.3 * rand()); y = far * (rand() - 0.5)
        print "v", left, y, -far "\nv", i % 2 ? left : right, y + far * rand() / 30, -far "\nv", right, y - far * rand() / 30, -far
        print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3
        print "f", 3 * i + 3, 3 * i + 2, 3 * i + 1
    }
    for (i = 0; i < 16; i++) print rand() / 9, rand() / 9, 0, rand() / 9, rand() / 9, -2 >eyes
}' >"$work/wide.obj"
frames_every=1 frames_options='--method mesh'
scene=$work/wide size=255x255
frames_of fast host m4
tap_done
