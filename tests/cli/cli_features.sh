# SPDX-License-Identifier: MIT
#
# Builds with any two features, with either alone and with neither, paint what the full renderer paints: six
# choices that hold all pairs. (Suite `features` has all choices.)
. tests/tap.sh
. tests/features_on.sh

# Row 1 to 6 of a covering array: up to ten features are on in three rows each, in the first and in two others, no two
# features in the same three.
pairwise() { # ROW
    awk -v row="$1" -v count="$features_count" '
        BEGIN {
            for (a = 2; a < 6; a++)
                for (b = a + 1; b <= 6; b++)
                    if (f++ < count) choice += (row == 1 || row == a || row == b) * 2 ^ (f - 1)
            print choice
        }'
}

pairwise_on() { # COMPILER NAME
    for row in 1 2 3 4 5 6; do
        tap_check "$1: $2 with features $(pairwise $row) is painted as by the full renderer" \
            features_draw "$1" "$2" "$(pairwise $row)"
    done
}

convex_refuses() { # SCENE
    "$BUILD/limner" render "$1" --method convex --size 32x32 -o "$work/none%d.png" >/dev/null 2>"$work/said" && return 1
    cat "$work/said"
    grep -q '^limner: .*rooms.obj: --method convex: the scene is not one convex solid$' "$work/said" && ! ls "$work"/none* 2>/dev/null
}

convex_is_nearest() { # SCENE
    for method in nearest convex; do
        "$BUILD/limner" render "$1" --method $method --size 97x61 --write-hashes "$work/$method" || return 1
    done
    diff "$work/nearest" "$work/convex"
}

tap_check "--method convex refuses the rooms" convex_refuses sim/scenes/rooms.obj
tap_check "--method convex paints an icosahedron as nearest first does" convex_is_nearest sim/scenes/icosahedron.obj
tap_check "the full renderer paints the rooms" features_prepare rooms
tap_check "the full renderer paints the icosahedron" features_prepare icosahedron teapot
pairwise_on "$CC" rooms
pairwise_on "$CC" icosahedron
tap_check "the full renderer paints the glass" features_prepare glass
pairwise_on "$CC" glass
if command -v clang >/dev/null; then
    for name in rooms icosahedron glass; do
        tap_check "clang: $name with what it needs alone" features_draw clang $name 0
        tap_check "clang: $name with every feature" features_draw clang $name $(((1 << features_count) - 1))
    done
else
    tap_skip "clang: builds with few and with all features" "clang is not installed; suite features asks for it"
fi
tap_done
