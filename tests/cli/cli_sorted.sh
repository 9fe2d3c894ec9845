# SPDX-License-Identifier: MIT
#
# The methods that need no tree, from the command line: newell is as right as the tree's order on what no order of whole
# polygons gets right, depth is not; what was compared is printed; wrong choices are refused.
. tests/tap.sh

knot() { # METHOD [OPTION...]: eight frames, compared with the reference
    knot_method=$1
    shift
    awk 'n++ % 8 == 0' sim/scenes/knot.cam >"$work/few.cam"
    "$BUILD/limner" render sim/scenes/knot.obj --method "$knot_method" "$@" --camera "$work/few.cam" --size 160x120 --stats \
        --compare >"$work/said" || return 1
    cat "$work/said"
}

says() { # PATTERN
    cat "$work/said"
    grep -qE "$1" "$work/said"
}

newell_is_right() { # [OPTION...]
    knot newell "$@" && says 'compared with the reference: 8 frames, wrong 0\.0[0-4].* holes 0$' && says '^ mean .* 0\.0$'
}

depth_is_wrong() {
    knot depth && ! says 'holes 0$'
}

on_any_tree() { # a compiled scene keeps its tree, whose polygons newell sorts, with no room to split them again
    "$BUILD/limner" compile sim/scenes/knot.obj -o "$work/knot" >/dev/null &&
        "$BUILD/limner" render "$work/knot.lim" --method newell --camera "$work/few.cam" --size 160x120 --stats >"$work/said" &&
        awk '/^ mean/ { last = $0 } END { $0 = last; print; exit !($2 > 40 && $(NF - 1) == 0) }' "$work/said"
}

# What is retained of a piece are its own lines, not those of the polygon that it was cut from.
pieces_are_small() {
    "$BUILD/limner" compile sim/scenes/knot.obj --method newell --report >"$work/said" &&
        awk '/working memory/ { print; exit !($NF > 10000 && $NF < 22500) }' "$work/said"
}

refused() { # REASON OPTION...
    reason=$1
    shift
    "$BUILD/limner" render sim/scenes/knot.obj "$@" >/dev/null 2>"$work/said" && return 1
    says "$reason"
}

# Triangles at random, all through one another, seen from both sides.
awk 'BEGIN {
    srand(5)
    for (i = 0; i < 100; i++) {
        for (k = 0; k < 3; k++) printf "v %.4f %.4f %.4f\n", 2 * rand() - 1, 2 * rand() - 1, 2 * rand() - 1
        printf "f %d %d %d\nf %d %d %d\n", 3 * i + 1, 3 * i + 2, 3 * i + 3, 3 * i + 3, 3 * i + 2, 3 * i + 1
    }
}' >"$work/many.obj"

# Triangles through one point, seen from both sides: near it corners that rounding makes one or moves past each other.
awk -v seed=2 -v count=50 -f tests/star.awk >"$work/star.obj"

# worst COLUMN: of the worst frame of those that --stats printed
worst() {
    awk -v column="$1" '/ sorted / { for (i = 1; i <= NF; i++) at[$i] = i } column in at && /^worst/ { print $at[column]; exit }' "$work/said"
}

many() { # OPTION...: an orbit
    timeout 120 "$BUILD/limner" render "$work/many.obj" --method newell --size 160x120 --stats "$@" >"$work/said" 2>"$work/err" || return 1
    cat "$work/err" "$work/said"
}

a_hundred_are_right() {
    many --compare && says 'wrong 0\.0.* holes 0$' && ! grep 'no comparisons' "$work/err" &&
        [ "$(worst compared)" -lt 400000 ] && [ "$(worst divided)" -gt 100 ]
}

a_star_is_right() { # PROFILE
    "$BUILD/limner" render "$work/star.obj" --method newell --precision "$1" --stats --compare >"$work/said" 2>"$work/err" || return 1
    cat "$work/err" "$work/said"
    says 'wrong 0\.0.* holes 0$' && [ ! -s "$work/err" ] && [ "$(worst forced)" -eq 0 ]
}

the_limit_is_told() {
    many --newell most=1000 && grep -q '^limner: note: the order of .* in 16 frames could not be settled: .*when no comparisons were left' "$work/err" &&
        [ "$(worst compared)" -lt $((1000 + $(worst sorted))) ]
}

the_limit_is_far() { # the scenes that are shipped do not come near it
    for scene in knot teapot glass; do
        "$BUILD/limner" render sim/scenes/$scene.obj --method newell --camera sim/scenes/$scene.cam --size 80x60 --stats >"$work/said" 2>"$work/err" || return 1
        cat "$work/said"
        [ "$(worst divided)" -eq 0 ] && [ "$(worst forced)" -eq 0 ] && [ ! -s "$work/err" ] || return 1
    done
}

compiles() {
    timeout 120 "$BUILD/limner" compile "$work/many.obj" --method newell --size 160x120 -o "$work/many" >/dev/null && [ -s "$work/many.h" ]
}

few_cameras_are_told() {
    "$BUILD/limner" compile "$work/many.obj" --method newell --size 160x120 --report >"$work/said" && says 'measured on +[1-9][0-9]? sampled cameras alone' &&
        "$BUILD/limner" compile sim/scenes/knot.obj --method newell --report >"$work/said" && ! says 'sampled cameras alone'
}

tap_check "a hundred triangles through one another are right, and do not take long" a_hundred_are_right
tap_check "fifty through one point are right, and all are settled" a_star_is_right fast
tap_check "so they are with finer corners" a_star_is_right exact
tap_check "few comparisons: the frames end, and what was left is told" the_limit_is_told
tap_check "the scenes that are shipped are not divided, and settled" the_limit_is_far
tap_check "a hundred are compiled, too" compiles
tap_check "the report tells on how few cameras memory was measured" few_cameras_are_told
tap_check "newell agrees with the reference, and could settle every pair" newell_is_right
tap_check "so it does with planes first and one of two split" newell_is_right --newell planes,one
tap_check "it split polygons" says '3:P_behind'
tap_check "depth does not agree" depth_is_wrong
tap_check "newell sorts the polygons of any compiled scene" on_any_tree
tap_check "pieces take the memory of their own lines" pieces_are_small
tap_check "an unknown choice is refused" refused '^limner: --newell rectangles: no such choice; there are planes, one and most=COMPARISONS$' --newell rectangles
tap_check "an unknown method is refused, and these are listed" refused 'there are .*depth, newell' --method zbuffer
tap_done
