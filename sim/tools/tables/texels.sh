# SPDX-License-Identifier: MIT
#
# How far texels are from those of the model, and what a frame costs, for each profile: textured rooms, a level of Freedoom, the
# textured teapot as a mesh and in a tree. 240x240 pixels.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

row() { # NAME MODEL CAMERAS OPTION...
    row_name=$1 row_model=$2 row_cameras=$3
    shift 3
    "$BUILD/limner" measure "$row_model" --camera "$row_cameras" --core m0plus,m4 -o "$work/measured" "$@" >/dev/null 2>"$work/said" ||
        { cat "$work/said" >&2; return 1; }
    awk -F , -v name="$row_name" 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { profile = $c["precision"] }
        !(profile in line) { order[++n] = profile; straight = $c["texel_straight_percent"]
            line[profile] = sprintf("| %s | `%s` | %.3f | %.3f | %.1f | %s |", name, profile, $c["texel_rms"], $c["texel_far_percent"],
                $c["texel_level_percent"], straight == "" ? "-" : sprintf("%.0f", straight)) }
        { cost[profile, $c["core"]] = $c["instructions"] / 1000 }
        END { for (i = 1; i <= n; i++) printf "%s %.0f | %.0f |\n", line[order[i]], cost[order[i], "m0plus"], cost[order[i], "m4"] }' \
        "$work/measured/measure.csv"
}

level=/usr/share/games/doom/freedoom1.wad:E1M1
"$BUILD/limner" walk "$level" -o "$work/walk.cam" >/dev/null
awk '!/^#/ && n++ % 16 == 0' "$work/walk.cam" >"$work/few.cam"
echo '| scene | precision | texels, rms | off by more than one, % | at another level, % | straight pieces, % of the squares | thousand instructions, Cortex-M0+ | Cortex-M4F |'
echo '|---|---|---|---|---|---|---|---|'
row 'rooms' sim/scenes/mapped/roomstex.obj sim/scenes/rooms.cam
row 'Freedoom, E1M1' "$level" "$work/few.cam"
row 'teapot, in a tree' sim/scenes/mapped/teapottex.obj sim/scenes/teapot.cam --tree bsp
row 'teapot, by default' sim/scenes/mapped/teapottex.obj sim/scenes/teapot.cam
