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

tap_check "newell agrees with the reference, and could settle every pair" newell_is_right
tap_check "so it does with planes first and one of two split" newell_is_right --newell planes,one
tap_check "it split polygons" says '3:P_behind'
tap_check "depth does not agree" depth_is_wrong
tap_check "newell sorts the polygons of any compiled scene" on_any_tree
tap_check "pieces take the memory of their own lines" pieces_are_small
tap_check "an unknown choice is refused" refused '^limner: --newell rectangles: no such choice; there are planes, one and most=COMPARISONS$' --newell rectangles
tap_check "an unknown method is refused, and these are listed" refused 'there are .*depth, newell' --method zbuffer
tap_done
