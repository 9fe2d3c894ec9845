# SPDX-License-Identifier: MIT
#
# What the compiler and the simulator measure on the demo and the benchmark scenes; the pictures are the demo's.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work, pictures

reported() { # LABEL: a number of the compiler's report
    sed -n "s/^ *$1  *\([0-9]*\).*/\1/p" "$work/report" | head -n 1
}

mean() { # COLUMN: of the statistics' line of means
    awk -v column="$1" '$1 == "frame" && !at { for (i = 1; i <= NF; i++) if ($i == column) at = i }
        $1 == "mean" && !shown { print $at; shown = 1 }' "$work/fast"
}

closing() { # FILE PHRASE: the number after it in the comparison's closing line
    sed -n "\$s/.*$2 \([0-9.]*\).*/\1/p" "$work/$1"
}

measure() { # PRECISION SCENE [TREE]: into $work/PRECISION
    "$BUILD/limner" render "$2.obj" ${3:+--tree "$3"} --camera "$2.cam" --size 240x240 --precision "$1" --stats \
        --compare --sheet "$work/sheet.png" >"$work/$1"
}

row() { # NAME FOLDER [TREE]
    "$BUILD/limner" compile "$2/$1.obj" ${3:+--tree "$3"} -o "$work/scene" --report >"$work/report"
    measure fast "$2/$1" "${3-}"
    measure fine "$2/$1" "${3-}"
    echo "| $1 | $(reported 'faces in the model') | $(reported splits) | $(reported 'in all')" \
        "| $(reported 'working memory, bytes') | $(mean polygons) | $(mean seen) | $(mean overdraw)" \
        "| $(closing fast wrong) | $(closing fine wrong) | $(closing fast shift) | $(closing fine shift)" \
        "| $(($(closing fast holes) + $(closing fine holes))) |"
}

table() {
    echo "| scene | polygons | splits | flash, bytes | RAM, bytes | reached | seen | overdraw | wrong, % fast | fine | beyond 1 px, ppm fast | fine | holes |"
    echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|"
    row demo "$BUILD/scenes"
    for scene in rooms rooms-tilted; do row "$scene" sim/scenes; done
    row teapot sim/scenes clusters # else a mesh
}

# The demo's walk, moving, and twelve frames of it.
draw() {
    "$BUILD/limner" render "$BUILD/scenes/demo.obj" --camera "$BUILD/scenes/demo.cam" --gif "$pictures/demo.gif"
    awk 'NR % 8 == 5' "$BUILD/scenes/demo.cam" >"$work/few.cam"
    "$BUILD/limner" render "$BUILD/scenes/demo.obj" --camera "$work/few.cam" --sheet "$pictures/demo.png"
}

table
[ -z "$pictures" ] || draw
