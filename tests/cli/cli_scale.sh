# SPDX-License-Identifier: MIT
#
# The generator of scenes of any size: the same files on every run, closed, and the same views of every building. What is
# made of large scenes: as right as of small ones, at the same cost where the same is seen.
. tests/tap.sh

make_scene() { "$BUILD/generate_scale" "$1" "$2" "$work"; }

same_again() {
    mkdir "$work/again" && "$BUILD/generate_scale" "$1" "$2" "$work/again" &&
        for file in "$work/again"/*; do cmp "$file" "$work/${file##*/}" || return 1; done
    rm -r "$work/again"
}

# Each way along an edge belongs to one triangle, and the way back to another one.
closed_mesh() {
    awk '/^f/ { for (i = 2; i <= 4; i++) ways[$i " " $(i < 4 ? i + 1 : 2)]++ }
        END {
            for (way in ways) {
                split(way, ends, " ")
                if (ways[way] != 1 || ways[ends[2] " " ends[1]] != 1) { print "edge " way; exit 1 }
                count++
            }
            exit !count
        }' "$1"
}

no_holes() {
    "$BUILD/limner" render "$work/$1.obj" --camera "$work/$1.cam" --compare >"$work/table" &&
        awk '/^compared/ { print; holes = $NF } END { exit !(holes == "0") }' "$work/table"
}

refuses() { ! make_scene "$@" 2>"$work/err" && grep -q '^usage: generate_scale' "$work/err"; }

tap_check "a building is generated" make_scene rooms 7
tap_check "and a mesh" make_scene mesh 1000
tap_check "the building is the same every time" same_again rooms 7
tap_check "the mesh, too" same_again mesh 1000
tap_check "the mesh is closed" closed_mesh "$work/mesh1000.obj"
tap_check "the building is closed as its walk sees it" no_holes rooms7
tap_check "no rooms are refused" refuses rooms 0
tap_check "a size that is no number is refused" refuses mesh 5k

# What a frame of the walk costs, predicted; pieces of polygons that it reaches.
walk_costs() { # SCENE
    make_scene "${1%%[0-9]*}" "${1#rooms}" && "$BUILD/limner" compile "$work/$1.obj" -o "$work/$1" &&
        "$BUILD/limner" render "$work/$1.lim" --camera "$work/$1.cam" --size 240x240 --stats >"$work/stats" &&
        awk '$1 == "mean" { reached = $5 } /^predicted/ { print $(NF - 3), reached }' "$work/stats" >"$work/$1.costs"
}
grows_little() { # by 30 % at most
    paste -d ' ' "$work/rooms6.costs" "$work/rooms24.costs" |
        awk '{ print; on = NF == 4 && $1 > 100000 && $3 <= 1.3 * $1 && $4 <= 1.3 * $2 } END { exit !on }'
}
tap_check "a walk through 6 x 6 rooms" walk_costs rooms6
tap_check "the same walk in 24 x 24 rooms" walk_costs rooms24
tap_check "costs the same, give or take" grows_little

# The smallest BSP tree of these reaches fifteen polygons for each that is seen.
other_tree() { # SCENE
    walk_costs "$1" && paste -d ' ' "$work/rooms6.costs" "$work/$1.costs" |
        awk '{ print; on = NF == 4 && $1 > 100000 && $3 <= 1.3 * $1 } END { exit !on }'
}
tap_check "9 x 9 rooms have a tree that reaches few" other_tree rooms9

# The building and its walk, turned upright by 30 degrees: no wall lies in an axis plane any more.
turn() { # SCENE TURNED
    awk '{ c = sqrt(3) / 2; s = 0.5 }
        /^v/ { printf "v %.6f %.6f %.6f\n", c * $2 + s * $4, $3, c * $4 - s * $2; next } { print }' "$work/$1.obj" >"$work/$2.obj" &&
        awk '{ c = sqrt(3) / 2; s = 0.5
            print c * $1 + s * $3, $2, c * $3 - s * $1, c * $4 + s * $6, $5, c * $6 - s * $4 }' "$work/$1.cam" >"$work/$2.cam"
}
# No tree that is asked for by name is cheaper on the walk, by more than a twentieth, than what is taken unasked.
costs_with() { # SCENE [OPTION...]
    scene=$1
    shift
    "$BUILD/limner" compile "$work/$scene.obj" -o "$work/asked" --report "$@" >"$work/said" &&
        "$BUILD/limner" render "$work/asked.lim" --camera "$work/$scene.cam" --size 240x240 --stats |
        awk '/^predicted/ { print $(NF - 3) }'
}
chosen_well() { # SCENE
    taken=$(costs_with "$1")
    echo "taken: $taken"
    for asked in '--tree bsp' '--tree bsp --splitter weighted-20' '--tree axis' '--tree clusters' '--mesh-leaves none' '--mesh-leaves all'; do
        cost=$(costs_with "$1" $asked)
        echo "$asked: $cost"
        [ "$taken" -gt 100000 ] && [ "$cost" -gt 100000 ] && [ $((100 * taken)) -le $((105 * cost)) ] || return 1
    done
}
tap_check "40 x 40 rooms" make_scene rooms 40
tap_check "have the tree that is cheapest to draw" chosen_well rooms40
tap_check "they are turned" turn rooms40 turned40
tap_check "and have it then, too" chosen_well turned40

# Wide scenes: indices of 32 bits, where more than 65535 of something are counted.
is_wide() { grep -q "^#define LIM_HAS_WIDE $2\$" "$work/$1.h"; }
tap_check "a small building is narrow" is_wide rooms6 0
tap_check "a large one is wide" is_wide rooms24 1

# SCENE MOST-WRONG-% [OPTION...]: four frames of it against the reference
right() {
    scene=$1 most=$2
    shift 2
    awk 'n++ % 16 == 0' "$work/$scene.cam" >"$work/few.cam"
    "$BUILD/limner" render "$work/$scene.obj" --camera "$work/few.cam" --splitter fewest --compare "$@" >"$work/table" &&
        awk -v most="$most" '/^compared/ { print; wrong = $8; holes = $NF }
            END { exit !(wrong != "" && wrong + 0 <= most && holes == "0") }' "$work/table"
}
tap_check "a mesh of too many words for 16 bits" make_scene mesh 8000
tap_check "is drawn right" right mesh8000 0.08
tap_check "and back to front" right mesh8000 0.08 --method painter
tap_check "a mesh of more polygons than there are colours" make_scene mesh 60000
tap_check "is drawn right, too" right mesh60000 0.02 --precision exact

same_from_file() {
    "$BUILD/limner" compile "$work/mesh8000.obj" --method nearest -o "$work/wide" --report >"$work/said" &&
        "$BUILD/limner" render "$work/mesh8000.obj" --method nearest --camera "$work/few.cam" --size 64x64 --write-hashes "$work/hashes" &&
        "$BUILD/limner" render "$work/wide.lim" --camera "$work/few.cam" --size 64x64 --check "$work/hashes" && is_wide wide 1
}
too_large_to_sort() {
    ! "$BUILD/limner" compile "$work/mesh60000.obj" --method depth --report 2>"$work/err" &&
        grep -q 'too large to be sorted: [5-9][0-9]* pieces of polygons, 32767 are the most' "$work/err"
}
tap_check "its file says the same" same_from_file
tap_check "what cannot be sorted is refused with its number" too_large_to_sort

# What compiling shows on a terminal, and in a pipe; what was decided before is not compiled for again.
terminal_bar() { script -qec "LIMNER_CACHE='$work/empty' '$BUILD/limner' compile '$work/rooms6.obj' --report" /dev/null | grep -q '\[=* *\] *[0-9]* % compiling: 1187 polygons'; }
no_pipe_bar() {
    "$BUILD/limner" compile "$work/rooms6.obj" --report >"$work/said" 2>"$work/err" && [ ! -s "$work/err" ] &&
        ! grep -q '%  *compiling' "$work/said" && grep -q '^memory for compiling, at most  *[1-9][0-9]* MB$' "$work/said" &&
        grep -q '^processor time for compiling  *[0-9.]* s$' "$work/said"
}
tap_on_terminal "a bar shows how far it is on a terminal" terminal_bar
tap_check "and nothing in a pipe; memory and time are reported" no_pipe_bar
tap_done
