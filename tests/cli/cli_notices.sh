# SPDX-License-Identifier: MIT
#
# Options that are taken and change nothing, for this panel or this scene: each is told in one line, the command
# succeeds, and what it writes is what it writes without them. Where they do change something nothing is said.
. tests/tap.sh

limner=$BUILD/limner
still=sim/scenes/icosahedron.obj moving=sim/scenes/movers.gltf
"$limner" compile "$still" -o "$work/compiled" >/dev/null

# run FOLDER ARGUMENT...: OUT in an argument stands for the folder.
run() {
    mkdir -p "$1" && folder=$1
    shift
    for argument; do
        shift
        case $argument in OUT*) argument=$folder${argument#OUT} ;; esac
        set -- "$@" "$argument"
    done
    "$limner" "$@" >"$folder.said" 2>"$folder.notes" </dev/null || { cat "$folder.notes" && return 1; }
    # of the model, not of an option
    sed -i '/: what is animated stands still where the file has it$/d' "$folder.notes"
}

# changes_nothing NOTES OPTIONS COMMAND...: as many lines of notes as there are, in that order.
changes_nothing() {
    wanted=$1 options=$2
    shift 2
    rm -rf "$work/with" "$work/without"
    # shellcheck disable=SC2086 # options are words
    run "$work/without" "$@" && [ ! -s "$work/without.notes" ] && run "$work/with" "$@" $options || return 1
    printf '%s\n' "$wanted" | sed 's/^/limner: note: /; s/$/; nothing changes/' | diff - "$work/with.notes" &&
        diff -r -I '^ *[.]bgr = true,$' "$work/without" "$work/with" # which a driver of greys is told, and passes over
}

# says_nothing COMMAND...
says_nothing() {
    run "$work/quiet" "$@" && cat "$work/quiet.notes" && [ ! -s "$work/quiet.notes" ]
}

# -- Panels --------------------------------------------------------------------------------------------------------------

for panel in pcd8544 sh1106 ssd1306 st7567 uc1701 ssd0323 ssd1327; do
    for option in bgr rgb; do
        tap_check "$panel has no colours to exchange: --$option" changes_nothing "--$option: $panel has no colours" \
            --$option module --panel $panel -o OUT/module
    done
done
for panel in ls013b7dh03 ls027b7dh01; do
    tap_check "$panel has neither colours nor inversion" changes_nothing "--bgr: $panel has no colours
--no-invert: $panel shows its memory as it is" "--no-invert --bgr" module --panel $panel -o OUT/module
done
for panel in gc9a01 ili9341 ili9488 ssd1351 st7735 st7796 st7789:rgb444; do
    tap_check "$panel takes both" says_nothing module --panel $panel --bgr --invert -o OUT/module
done
tap_check "greys and pages are inverted" says_nothing module --panel ssd1327 --invert -o OUT/module
tap_check "a mode and a clock are written" says_nothing module --panel ls027b7dh01 --mode 0 --hz 1000000 -o OUT/module
tap_check "the card has no colours either" changes_nothing "--bgr: ssd1306 has no colours" --bgr \
    card --panel ssd1306 -o OUT/card.png

# Two columns of a page, and two pixels: reset, commands, data, and the lamp that ends a frame.
record=$work/record
reset='p reset 0\nt 20000000\np reset 1\nt 200000000\np led 0\np dc 0\n'
# shellcheck disable=SC2059 # the format is the record
{
    printf "${reset}b B0 00 10\np dc 1\nb FF FF\np led 1\n" >"$record"
    printf "${reset}b 11\nt 400000000\nb 3A\np dc 1\nb 05\np dc 0\nb 2A\np dc 1\nb 00 02 00 03\np dc 0\nb 2B\np dc 1\n" \
        >"$record.colour"
    printf 'b 00 01 00 01\np dc 0\nb 2C\np dc 1\nb F8 00\np led 1\n' >>"$record.colour"
}
tap_check "a record is of a panel, too" changes_nothing "--rgb: ssd1306 has no colours" --rgb decode "$record" \
    --panel ssd1306 --write-hashes OUT/hashes
tap_check "and takes the words that set its display up" says_nothing decode "$record" --panel ssd1306 --mode 3 \
    --contrast 5 --hz 8000000
tap_check "its colours are exchanged where there are some" says_nothing decode "$record.colour" --panel st7735 --rgb

# -- Scenes --------------------------------------------------------------------------------------------------------------

frame='--camera random:1:1'
# shellcheck disable=SC2086 # words
{
    tap_check "a still model is drawn moving" changes_nothing "--movers: nothing moves in $still
--mover-light: nothing moves in $still
--fps: nothing moves in $still" "--movers on --mover-light turning --fps 5" render $still $frame -o OUT/%d.png
    tap_check "an abbreviated option is told whole" changes_nothing "--fps: nothing moves in $still" "--fp 5" \
        render $still $frame -o OUT/%d.png
    tap_check "a model that could move is told not to" says_nothing render $moving $frame --movers off -o OUT/%d.png
    tap_check "then time does not matter" changes_nothing "--mover-light: nothing moves in $moving
--fps: nothing moves in $moving" "--fps 30 --mover-light turning" render $moving $frame --movers off -o OUT/%d.png
    tap_check "a model that moves" says_nothing render $moving $frame --movers on --fps 30 -o OUT/%d.png
    tap_check "a compiled scene is as it was compiled" changes_nothing "--splitter: $work/compiled.lim is compiled already
--tolerance: $work/compiled.lim is compiled already
--unlit: $work/compiled.lim is compiled already
--drop-small: $work/compiled.lim is compiled already
--movers: nothing moves in $work/compiled.lim" \
        "--unlit --drop-small --movers off --tolerance 2 --splitter first" render "$work/compiled.lim" $frame -o OUT/%d.png
    tap_check "one may be drawn as a set" says_nothing render "$work/compiled.lim" $frame --tree none -o OUT/%d.png
    tap_check "a set has no planes" changes_nothing "--splitter: no plane divides the set of $still" "--splitter fewest" \
        render $still $frame --tree none -o OUT/%d.png
    tap_check "outlines in two colours have their own background" changes_nothing \
        "--background: outlines have their own, of $still" "--background 102030" \
        render $still $frame --wireframe=FFFFFF,000000 -o OUT/%d.png
    tap_check "so have those of black and white panels" changes_nothing \
        "--background: outlines have their own, of $still" "--background 102030" \
        render $still $frame --wireframe --panel ssd1306 -o OUT/%d.png
    tap_check "those in their own colours do not" says_nothing render $still $frame --wireframe --background 102030 -o OUT/%d.png
    tap_check "what is not lit is not lit as it moves" changes_nothing "--mover-light: --unlit leaves nothing lit in $moving" \
        "--mover-light turning" render $moving $frame --unlit -o OUT/%d.png
    tap_check "a tree has" says_nothing render $still $frame --splitter fewest -o OUT/%d.png
}
tap_check "a still model is compiled" changes_nothing "--movers: nothing moves in $still" "--movers on" \
    compile "$still" -o OUT/scene
tap_check "a set is sorted, and not filled" changes_nothing "--fill: $still is sorted, and not filled as it is found" "--fill" \
    compile "$still" --tree none -o OUT/scene
tap_check "two of which one moves" says_nothing compile "$still" "$moving" --movers on -o OUT/scene
tap_check "two that stand still" changes_nothing "--movers: nothing moves in these models
--mover-light: nothing moves in these models" "--movers on --mover-light turning" \
    compile "$still" sim/scenes/rooms.obj -o OUT/scene
tap_done
