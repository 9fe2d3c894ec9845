# SPDX-License-Identifier: MIT
#
# What a frame costs on walks through levels of Freedoom, with textures and without, and what it gets wrong: 240x240 pixels,
# profile fast. The walk through E1M1 is the project's; the others are made here, and nothing was tuned on them.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

figures() { # NAME MODEL WALK OPTION...
    figures_name=$1 figures_model=$2 figures_walk=$3
    shift 3
    "$BUILD/limner" measure "$figures_model" --path "$figures_walk" --camera "$figures_walk" --precision fast --core m4,m0plus \
        -o "$work/measured" "$@" >/dev/null 2>"$work/said" || { cat "$work/said" >&2; return 1; }
    awk -F , -v name="$figures_name" 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { cost[$c["core"]] = sprintf("%.0f / %.0f", $c["instructions"] / 1000, $c["worst_instructions"] / 1000)
            bytes = $c["state_b"] + $c["pools_b"] + $c["static_b"]; wrong = $c["wrong_percent"]; holes = $c["holes"]; order = $c["order_errors"]
            flash = $c["scene_b"] }
        END { printf "| %s | %s | %s | %.1f | %.0f | %.4f | %d | %d |\n", name, cost["m4"], cost["m0plus"], bytes / 1000, flash / 1000,
            wrong, holes, order }' "$work/measured/measure.csv"
}

walk() { # NAME MODEL WALK
    figures "$1" "$2" "$3"
    figures "$1, flat" "$2" "$3" --no-textures
}

levels=/usr/share/games/doom
echo '| walk of 256 frames | thousand instructions, Cortex-M4F, mean / worst | Cortex-M0+ | RAM, KB | scene in flash, KB | wrong, % | holes | errors of order |'
echo '|---|---|---|---|---|---|---|---|'
walk E1M1 "$levels/freedoom1.wad:E1M1" sim/scenes/freedoom1-E1M1.cam
for level in freedoom1.wad:E2M1 freedoom1.wad:E3M4 freedoom2.wad:MAP01 freedoom2.wad:MAP11; do
    "$BUILD/limner" walk "$levels/$level" -o "$work/walk.cam" >/dev/null
    walk "${level#*:}" "$levels/$level" "$work/walk.cam"
done
