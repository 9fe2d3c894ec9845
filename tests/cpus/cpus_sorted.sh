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
awk -v seed=7 -v count=10 -f tests/star.awk >"$work/star.obj"
awk 'BEGIN { for (i = 0; i < 8; i++) printf "%.4f 1.1 %.4f 0 0 0\n", 3 * cos(0.7 * i), 3 * sin(0.7 * i) }' >"$work/star.cam"
divides() {
    "$BUILD/limner" render "$work/star.obj" --method newell --camera "$work/star.cam" --size 120x90 --stats >"$work/said" &&
        cat "$work/said" && awk '/ sorted / { found = 1 } found && /^ mean/ { exit !($(NF - 1) > 1) }' "$work/said"
}
tap_check "a star of triangles is divided" divides
frames_options='--method newell' frames_every=1
frames_in_turn 6 "$work/star" 120x90 host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0

# The limit: what is left is painted as it lies, alike everywhere, and a frame is over when its comparisons are. Of the ten
# triangles ten face the eye, so 1 n^2 is 100.
frames_options='--method newell' frames_path='--newell most=100' frames_flags=-DLIM_NEWELL_EFFORT=1u
frames_in_turn 7 "$work/star" 120x90 m0plus m4 rv32 powerpc

# limit_counts CORE: the frames of tests/targets/newell_limit.c with their instructions, one a line, in $work/limited.
limit_counts() {
    target_link "$1" "$work/limit" -DLIM_HAS_STATS=1 '-DLIM_CONFIG="model.h"' "-I$work/limited.d" tests/targets/newell_limit.c \
        boards/common/app_scene.c "$work"/limited.d/model*.c "$(one_file)" &&
        "$(target_tools "$1")nm" "$work/limit" | awk '$3 == "frame_begin" { print "begin " $1 } $3 == "frame_end" { print "end " $1 }' >"$work/marks" &&
        target_run "$1" "$work/limit" -icount shift=0 -plugin "$BUILD/count_plugin.so,ranges=$work/marks,out=$work/counts" >"$work/frames" &&
        awk '/^frame/ { print $2 + $3 }' "$work/counts" | paste -d ' ' "$work/frames" - >"$work/limited" &&
        cat "$work/limited"
}

# Beside what a frame without any comparison takes, so many instructions a comparison that it may make.
within_the_limit() { # CORE INSTRUCTIONS
    limit_counts "$1" && awk -v each="$2" '
        { limit = $1; compared = $2; entries = $3; forced = $4; reason = $5; spent = $6 }
        NR == 1 { all = compared; most = spent; if (forced) exit }
        NR == 2 { least = spent }
        NR > 1 {
            n++
            printf "most %d: %d comparisons, %d instructions, %.0f a comparison more than of none, %.2f of all\n", limit, compared, spent, (spent - least) / (limit + entries), spent / most
            if (compared > limit + entries || reason != forced || (limit < all) != (forced > 0)) exit
            if (spent > least + each * (limit + entries) || spent > 1.1 * most) exit
            good++
        }
        END { exit !(n == 7 && good == n) }' "$work/limited"
}
mkdir "$work/limited.d"
tap_check "the star compiles, and its cameras" eval '"$BUILD/limner" compile "$work/star.obj" --method newell --size 120x90 -o "$work/limited.d/model" &&
    "$BUILD/limner" render "$work/limited.d/model.lim" --method newell --camera "$work/star.cam" --size 120x90 --write-cameras "$work/limited.d/cameras.h"'
tap_check "m0plus: a frame at its limit ends, within so many instructions, and says why" within_the_limit m0plus 20000
tap_check "m4: so does it there" within_the_limit m4 8000
tap_done
