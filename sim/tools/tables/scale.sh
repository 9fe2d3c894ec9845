# SPDX-License-Identifier: MIT
#
# How costs grow with a scene: buildings of more and more rooms through which the same walk leads, and one mesh in finer and
# finer triangles; and a picture of that. SCENES="rooms6 mesh1000" prints these alone. Instructions are those of scenes
# that fit QEMU's Cortex-M4 (4 MB).
# shellcheck shell=sh disable=SC2154 # of tables.sh: work, pictures

if [ -n "$pictures" ] && [ -n "${SCENES:-}" ]; then
    echo "scale: SCENES is for printing; the page has all" >&2
    exit 1
fi
: "${SCENES:=rooms6 rooms12 rooms24 rooms48 mesh1000 mesh5000 mesh20000 mesh100000 mesh200000}"
flash_most_kb=3500

counted() { # SCENE: thousand instructions a frame on the emulated processor
    "$BUILD/limner" measure "$work/$1.obj" --camera "$work/$1.cam" --precision fast --core m4 -o "$work/measured" >/dev/null &&
        awk -F '|' '/instructions a frame/ { on = 1 } on && $2 ~ /fast/ { printf "%.0f", $4 / 1000; on = 0 }' \
            "$work/measured/measure.md"
}

# A line of numbers: scene, kind, polygons, pieces, splits, nodes, flash KB, MB for compiling, nodes and pieces reached,
# predicted for Cortex-M0+ and counted on Cortex-M4F, thousand a frame; NaN: too large.
row() { # SCENE
    kind=${1%%[0-9]*}
    "$BUILD/generate_scale" "$kind" "${1#"$kind"}" "$work"
    "$BUILD/limner" compile "$work/$1.obj" -o "$work/$1" --report >"$work/report"
    "$BUILD/limner" render "$work/$1.lim" --camera "$work/$1.cam" --size 240x240 --stats >"$work/stats"
    awk -v scene="$1" -v kind="$kind" '
        FNR == NR && /polygons before splitting/ { polygons = $4 }
        FNR == NR && /polygons in the scene/ { pieces = $5 }
        FNR == NR && /^  splits / { splits = $2 }
        FNR == NR && /^  nodes / && !nodes { nodes = $2 }
        FNR == NR && /^  in all/ { flash_kb = $3 / 1000 }
        FNR == NR && /^memory for compiling/ { memory_mb = $(NF - 1) }
        FNR < NR && $1 == "mean" { reached_nodes = $2; reached = $5 }
        FNR < NR && /^predicted for/ { predicted = $(NF - 3) / 1000 }
        END { printf "%s %s %d %d %d %d %.0f %d %.0f %.0f %.0f", scene, kind, polygons, pieces, splits, nodes, flash_kb,
            memory_mb, reached_nodes, reached, predicted }' "$work/report" "$work/stats" >"$work/row"
    # shellcheck disable=SC2046 # numbers are words
    set -- "$1" $(cat "$work/row")
    m4=NaN
    [ "$8" -gt "$flash_most_kb" ] || m4=$(counted "$1")
    echo "$(cat "$work/row") $m4"
}

table() {
    echo '| scene | polygons | pieces | nodes | flash, KB | memory for compiling, MB | nodes reached | pieces reached | M0+, predicted | M4F, counted |'
    echo '|---|---|---|---|---|---|---|---|---|---|'
    awk '{ printf "| %s | %d | %d | %d | %d | %d | %d | %d | %d | %s |\n", $1, $3, $4, $6, $7, $8, $9, $10, $11,
        $12 == "NaN" ? "too large" : $12 }' "$work/rows"
}

for scene in $SCENES; do
    row "$scene"
done >"$work/rows"
table
[ -z "$pictures" ] || gnuplot -c sim/tools/tables/scale.gp "$work/rows" >"$pictures/scale.png"
