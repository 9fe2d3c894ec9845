# SPDX-License-Identifier: MIT
#
# The heuristics of the tree builder, side by side: each is what it says, and says the same every time.
. tests/tap.sh

table() { # MODEL OPTION...: one table into $work/table
    "$BUILD/limner" splitters "$@" >"$work/table" && cat "$work/table"
}

# NAME COLUMN: depth 4, splits 5, polygons 6, nodes 7, bytes 8, instructions 9
cell() {
    awk -F '|' -v name="$1" -v column="$2" '{ gsub(/ /, "") } $2 == name { print $column }' "$work/table"
}

for name in rooms teapot; do
    tap_check "$name: a table of them all" table "sim/scenes/$name.obj"
    cp "$work/table" "$work/$name"
done

has_rows() {
    for name in auto first fewest balanced weighted sampled; do
        for column in 4 6 7 8 9; do
            [ "$(cell $name $column)" -gt 0 ] || return 1
        done
    done
}
tap_check "every row has depth, polygons, nodes, bytes and instructions" has_rows

# Of the teapot, whose polygons cannot but be split.
least() { # COLUMN NAME OTHER...
    column=$1 name=$2
    shift 2
    for other; do
        [ "$(cell "$name" "$column")" -lt "$(cell "$other" "$column")" ] || return 1
    done
}
tap_check "balanced is the shallowest" least 4 balanced first fewest weighted sampled
tap_check "weighted splits least of all, as fewest looks one step ahead only" least 5 weighted first balanced sampled
tap_check "fewest splits less than first and balanced" least 5 fewest first balanced
tap_check "five samples are better than the first polygon" least 9 sampled first

auto_is_the_least() {
    for name in fewest weighted; do
        [ "$(cell auto 8)" -le "$(cell $name 8)" ] || return 1
    done
}
tap_check "auto takes the smallest tree" auto_is_the_least

is_the_same_again() {
    table sim/scenes/teapot.obj >/dev/null && cmp "$work/table" "$work/teapot"
}
tap_check "the same again is the same, samples too" is_the_same_again

other_trees() {
    table sim/scenes/teapot.obj --tree axis && [ "$(cell auto 5)" -lt 200 ]
}
tap_check "heuristics weigh the cuts of other trees as well" other_trees

# The same numbers as in the compiler's own report.
agrees_with_the_report() {
    table sim/scenes/rooms.obj >/dev/null &&
        "$BUILD/limner" compile sim/scenes/rooms.obj --tree bsp --splitter balanced --report >"$work/report" &&
        awk -v splits="$(cell balanced 5)" -v instructions="$(cell balanced 9)" '
            $1 == "splits" && $2 == splits { same++ }
            $1 " " $2 " " $3 == "instructions a frame" && $4 == instructions { same++ }
            END { exit same != 2 }' "$work/report"
}
tap_check "compile --report says the same" agrees_with_the_report

# What moves has trees of its own.
movers_are_left_out() {
    table sim/scenes/movers.gltf && grep -q '^What stands still alone; objects that move: 5$' "$work/table" &&
        "$BUILD/limner" compile sim/scenes/movers.gltf --report >"$work/report" &&
        [ "$(cell auto 6)" -eq "$(awk '/^  polygons in the scene/ { print $5 }' "$work/report")" ] && ! grep '^What' "$work/rooms"
}
tap_check "of a model with movers it is what stands still, as compile has it" movers_are_left_out

draws_right() {
    "$BUILD/limner" render sim/scenes/teapot.obj --camera sim/scenes/teapot.cam --tree bsp --splitter "$1" --compare >"$work/out" &&
        awk '/^compared/ { wrong = $8; holes = $NF } END { exit !(wrong != "" && wrong + 0 <= 0.08 && holes == 0) }' "$work/out"
}
for name in first fewest balanced weighted sampled; do
    tap_check "teapot, $name: the picture is right" draws_right $name
done

refused() { # PATTERN ARGUMENT...
    pattern=$1
    shift
    "$BUILD/limner" "$@" >"$work/out" 2>&1 && return 1
    cat "$work/out"
    [ "$(wc -l <"$work/out")" -eq 1 ] && grep -q "^limner: $pattern" "$work/out"
}
tap_check "no model is refused" refused 'splitters: needs a model' splitters
tap_check "two models are refused" refused 'splitters: one model at a time' splitters a.obj b.obj
tap_check "a missing model is refused" refused 'none.obj: ' splitters none.obj
tap_check "a set has no planes to choose" refused 'splitters: a set' splitters sim/scenes/icosahedron.obj --tree none
tap_check "an unknown option is refused" refused '--colour: no such option' splitters sim/scenes/icosahedron.obj --colour
tap_check "an unknown heuristic is refused by name" refused \
    '.*--splitter best: no such heuristic; there are auto, first, fewest, balanced, weighted and sampled$' \
    compile sim/scenes/icosahedron.obj --report --splitter best
tap_done
