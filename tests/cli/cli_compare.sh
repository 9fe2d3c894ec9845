# SPDX-License-Identifier: MIT
#
# `limner compare` without counting: all exact methods agree with the reference and so with one another, approximate
# ones are found out, tables and pictures are whole, and what cannot be done is said in a line.
. tests/tap.sh

compare() { # SCENE [OPTION...]: on a few small frames
    name=$1
    shift
    [ ! -e "sim/scenes/$name.cam" ] || set -- --camera "sim/scenes/$name.cam" "$@"
    "$BUILD/limner" compare "sim/scenes/$name.obj" --size 120x120 --frames 6 "$@"
}

# field CSV METHOD COLUMN
field() {
    awk -F , -v method="$2" -v name="$3" '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        NR > 1 && $column["method"] == method { print $column[name] }' "$1"
}

# refuses WORDS OPTION...: fails, in one line that has the words, without a word on standard output.
refuses() {
    words=$1
    shift
    if "$BUILD/limner" compare "$@" >"$work/out" 2>"$work/err"; then
        echo "succeeded"
        return 1
    fi
    cat "$work/err"
    [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qF -- "$words" "$work/err"
}

# The methods that the program has, from its own mouth.
"$BUILD/limner" render none.obj --method none 2>&1 | sed 's/.*there are //; s/,//g; s/ and / /' | tr ' ' '\n' >"$work/methods"

has_a_row_for_each() {
    compare knot --no-cost -o "$work/knot" >"$work/table" && cat "$work/table" "$work/methods" || return 1
    sed -n 's/^| \([a-z-]*\) | \(exact\|approximate\) |.*/\1/p' "$work/table" >"$work/rows"
    [ "$(wc -l <"$work/methods")" -gt 9 ] && diff "$work/methods" "$work/rows"
}

has_its_columns() {
    head=$(grep '^| method' "$work/table")
    for column in kind 'wrong, %' 'order errors' holes splits nodes 'RAM, bytes' 'flash, bytes'; do
        case $head in *"| $column |"*) ;; *) return 1 ;; esac
    done
    # every row has as many fields as the head
    awk -F '|' '/^\|/ { if (!count) count = NF; if (NF != count) exit 1 }' "$work/table"
}

says_why_not() {
    grep '^| convex | exact | - | - |' "$work/table" && grep '^convex: .*not one convex solid$' "$work/table"
}

# Fields are divided by commas, quotes hold text; a line for each method, all with as many fields.
csv_parses() {
    awk '{
            line = $0
            gsub(/"([^"]|"")*"/, "text", line)
            count = split(line, fields, ",")
            if (NR == 1) columns = count
            if (count != columns || line ~ /"/) exit 1
        }' "$work/knot/compare.csv" &&
        [ "$(wc -l <"$work/knot/compare.csv")" -eq $(($(wc -l <"$work/methods") + 1)) ] &&
        while read -r method; do
            [ "$(field "$work/knot/compare.csv" "$method" scene)" = '"knot"' ] || return 1
        done <"$work/methods"
}

writes_what_it_says() {
    diff "$work/table" "$work/knot/compare.md" &&
        [ "$(ls "$work/knot")" = "$(printf '%s\n' compare.csv compare.md depth.png mesh-depth.png mesh.png sheet.png)" ]
}

# No order errors, no holes, no pair left open; wrong pixels within the profile's bound.
exact_agree() { # SCENE MOST-WRONG-% [OPTION...]
    scene=$1 most=$2
    shift 2
    compare "$scene" --no-cost -o "$work/$scene" "$@" >"$work/said" && cat "$work/said" && awk -F , -v most="$most" '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        !$column["exact"] || $column["frames"] == "" { next }
        {
            count++
            if ($column["order_errors"] + $column["holes"] + $column["forced"] > 0) bad = 1
            if ($column["wrong_percent"] == "" || $column["wrong_percent"] + 0 > most) bad = 1
        }
        END { exit bad || count < 7 }' "$work/$scene/compare.csv"
}

# An approximate method's errors are seen where the scene has what it gets wrong.
is_found_out() { # SCENE METHOD
    errors=$(field "$work/$1/compare.csv" "$2" order_errors)
    echo "$2 on $1: $errors pixels"
    [ "$errors" -gt 20 ]
}

draws_a_convex_solid() {
    compare icosahedron --no-cost --frames 2 -o "$work/icosahedron" >/dev/null &&
        [ "$(field "$work/icosahedron/compare.csv" convex wrong_percent)" = \
            "$(field "$work/icosahedron/compare.csv" bsp wrong_percent)" ]
}

# With a PATH in which there is no compiler for Arm.
does_without_tools() {
    env PATH=/nowhere "$BUILD/limner" compare sim/scenes/icosahedron.obj --size 32x32 --frames 1 >"$work/said" || return 1
    cat "$work/said"
    grep -q '^Cortex-M0+: not counted: .*gcc-arm-none-eabi' "$work/said" && grep '^| bsp |.* | - | - | - | - | ' "$work/said"
}

is_the_same_again() {
    compare knot --no-cost >"$work/again" && diff "$work/table" "$work/again"
}

leaves_nothing_behind() {
    mkdir -p "$work/blocked/sheet.png" "$work/tmp"
    TMPDIR="$work/tmp" refuses "it is a folder" sim/scenes/icosahedron.obj --no-cost --size 32x32 --frames 1 \
        -o "$work/blocked" && [ "$(ls "$work/blocked")" = sheet.png ] && [ -z "$(ls "$work/tmp")" ]
}

# The folder is refused before the model is looked at.
refuses_a_folder_that_is_a_file() {
    touch "$work/file"
    refuses "$work/file" none.obj --no-cost --out "$work/file/deeper"
}

ends_on_an_interrupt() {
    mkdir -p "$work/tmp"
    TMPDIR="$work/tmp" timeout -s INT 1 "$BUILD/limner" compare sim/scenes/rooms.obj --camera sim/scenes/rooms.cam \
        --size 480x480 --no-cost -o "$work/interrupted" >"$work/out" 2>"$work/err"
    [ $? -eq 124 ] && [ ! -s "$work/err" ] && [ ! -s "$work/out" ] && [ ! -e "$work/interrupted" ] &&
        [ -z "$(ls "$work/tmp")" ]
}

tap_check "every method has its row" has_a_row_for_each
tap_check "every column is there" has_its_columns
tap_check "what cannot draw the scene says why" says_why_not
tap_check "CSV has a line for each method, and parses" csv_parses
tap_check "-o writes what is printed, CSV, and a picture for each approximate method" writes_what_it_says
tap_check "the same again is the same" is_the_same_again
tap_check "knot: all exact methods agree with the reference" exact_agree knot 0.05
tap_check "rooms: so they do" exact_agree rooms 0.05
tap_check "rooms-tilted: so they do" exact_agree rooms-tilted 0.05
tap_check "teapot: so they do" exact_agree teapot 0.08
tap_check "glass: so they do, of what is opaque before all else" exact_agree glass 0.05
tap_check "knot, in profile exact: so they do" exact_agree knot 0.003 --precision exact --frames 16
for scene in knot rooms teapot; do
    tap_check "$scene: depth is found out" is_found_out $scene depth
done
tap_check "knot: a mesh by distance is found out" is_found_out knot mesh
tap_check "a convex solid's own method is as right as the tree" draws_a_convex_solid
tap_check "without compilers and emulators there are dashes, and the reason" does_without_tools
tap_check "what cannot be written leaves nothing behind" leaves_nothing_behind
tap_check "a folder that cannot be made is refused at once" refuses_a_folder_that_is_a_file
tap_check "an interrupt leaves nothing behind" ends_on_an_interrupt
tap_check "no model" refuses "compare: needs a model"
tap_check "two models" refuses "one model at a time" a.obj b.obj
tap_check "a missing model is refused" refuses "none.obj" none.obj --no-cost
tap_check "a missing camera file is refused" refuses "none.cam" sim/scenes/knot.obj --camera none.cam
tap_check "a compiled scene is refused" refuses "not against a compiled scene" a.lim
tap_check "an unknown option is refused" refuses "--brisk: no such option here" a.obj --brisk
tap_check "an option of measure alone is refused" refuses "--method: no such option here" a.obj --method bsp
tap_check "no frames are refused" refuses "--frames 0: how many frames" a.obj --frames 0
tap_check "half a frame is refused" refuses "--cost-frames 1.5: how many frames" a.obj --cost-frames 1.5
tap_check "two profiles are refused" refuses "one --precision at a time" a.obj --precision fast,fine
tap_check "an unknown processor is refused" refuses "there are m0plus, m3, m4, m33 and rv32" a.obj --core z80
tap_check "sim/MEASURED.md says of knot what is measured now" sh sim/tools/tables.sh --check compare:knot
tap_done
