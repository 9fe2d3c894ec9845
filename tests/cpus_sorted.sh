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

# Triangles through one point: so many of their pieces meet that comparing gives way to dividing.
awk 'BEGIN {
    srand(7)
    for (i = 0; i < 10; i++) {
        for (k = 0; k < 6; k++) c[k] = 2 * rand() - 1
        printf "v %.4f %.4f %.4f\nv %.4f %.4f %.4f\nv %.4f %.4f %.4f\n", c[0], c[1], c[2], c[3], c[4], c[5], -c[0] - c[3], -c[1] - c[4], -c[2] - c[5]
        printf "f %d %d %d\nf %d %d %d\n", 3 * i + 1, 3 * i + 2, 3 * i + 3, 3 * i + 3, 3 * i + 2, 3 * i + 1
    }
}' >"$work/star.obj"
awk 'BEGIN { for (i = 0; i < 8; i++) printf "%.4f 1.1 %.4f 0 0 0\n", 3 * cos(0.7 * i), 3 * sin(0.7 * i) }' >"$work/star.cam"
divides() {
    "$BUILD/limner" render "$work/star.obj" --method newell --camera "$work/star.cam" --size 120x90 --stats >"$work/said" &&
        cat "$work/said" && awk '/ sorted / { found = 1 } found && /^ mean/ { exit !($(NF - 1) > 1) }' "$work/said"
}
tap_check "a star of triangles is divided" divides
frames_options='--method newell' frames_every=1
frames_in_turn 6 "$work/star" 120x90 host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0
tap_done
