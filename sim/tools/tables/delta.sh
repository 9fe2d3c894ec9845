# SPDX-License-Identifier: MIT
#
# What delta output sends on each kind of panel (delta), and what it costs on emulated processors (delta-cost). A part is a
# panel's row.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
. sim/scenes/cube.sh

panels='st7789:240x240 st7789:240x240:rgb444 ili9341:240x320 ili9488:320x480 gc9a01:240x240 st7735:128x160 ssd1351:128x128
    ssd1327:128x128 ssd0323:128x64 ls027b7dh01:400x240 ssd1306:128x64 st7567:128x64 pcd8544:84x48'

share() { # MODEL CAMERAS: in percent of a whole frame's bytes
    "$BUILD/limner" render "$1" --camera "$2" --panel "$panel" --size "$size" --delta --stats >"$work/stats"
    awk '/^delta: / { printf " %.2f |", $2 }' "$work/stats"
}

shares() {
    echo '| panel | pixels | whole, bytes | cube turns, % | walk, % | turn, % |'
    echo '|---|---|---|---|---|---|'
    share_rows
}

share_rows() {
    for row in $panels; do
        name=${row%%:*} rest=${row#*:}
        size=${rest%%:*} format=${rest#"$size"}
        panel=$name$format
        printf '| %s | %s |' "$panel" "$size"
        head -n 1 sim/scenes/rooms-walk.cam >"$work/one.cam"
        "$BUILD/limner" render sim/scenes/rooms.obj --camera "$work/one.cam" --panel "$panel" --size "$size" --stats >"$work/stats"
        awk '$1 == 0 { printf " %d |", $NF }' "$work/stats"
        share "$work/cube.dae" "$work/cube.cam"
        share sim/scenes/rooms.obj sim/scenes/rooms-walk.cam
        share sim/scenes/rooms.obj sim/scenes/rooms-turn.cam
        echo
    done
}

instructions() { # CAMERAS OPTION...: on both processors
    cameras=$1
    shift
    "$BUILD/limner" measure sim/scenes/rooms.obj --camera "$cameras" --precision fast --core m0plus,m4 -o "$work/measured" \
        "$@" >/dev/null &&
        awk -F '|' '/instructions a frame/ { on = 1 } on && $2 ~ /fast/ { printf " %d", $4; on = 0 }' \
            "$work/measured/measure.md"
}

costs() {
    echo '| path | Cortex-M0+, instructions a frame | with delta | Cortex-M4F | with delta |'
    echo '|---|---|---|---|---|'
    for path in walk turn; do
        grep -v '^#' "sim/scenes/rooms-$path.cam" | head -n 60 >"$work/$path.cam"
        # shellcheck disable=SC2046 # numbers are words
        set -- $(instructions "$work/$path.cam") $(instructions "$work/$path.cam" --delta)
        echo "| $path | ${1:-} | ${3:-} | ${2:-} | ${4:-} |"
    done
}

# What begins with the panel and a colon is its own.
only() { # PANEL
    for row in $panels; do
        case $row in "$1":*) echo "$row" ;; esac
    done | head -n 1
}

[ "${2:-}" = of ] || cube_make "$work"
case $1-${2:-} in
delta-part)
    panels=$(only "$3")
    share_rows
    ;;
delta-of) grep "^| $3 |" ;;
delta-) shares ;;
delta-cost-) costs ;;
esac
