# SPDX-License-Identifier: MIT
#
# What a ray and a move of a walker cost on emulated processors, on walks of `limner walk`: eight directions from every
# fourth camera. Both processors find the same, or there is no figure.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
. sim/targets/targets.sh
: "${WARNINGS:=-Wall}"

# Cameras and scene; of a map without textures, which stop nobody.
prepare() { # MODEL
    mkdir -p "$work/scene" && rm -f "$work"/scene/*
    "$BUILD/limner" walk "$1" -o "$work/walk.cam" >/dev/null
    awk '!/^#/ && n++ % 4 == 0' "$work/walk.cam" >"$work/few.cam"
    "$BUILD/limner" compile "$1" --no-textures --tree bsp -o "$work/scene/model" >/dev/null
    "$BUILD/limner" render "$work/scene/model.lim" --camera "$work/few.cam" --write-cameras "$work/scene/cameras.h" >/dev/null
}

# Lines `KIND ... INSTRUCTIONS` in $work/CORE.counts.
count() { # CORE FLAG...
    core=$1
    shift
    target_link "$core" "$work/image" '-DLIM_CONFIG="model.h"' "-I$work/scene" "$@" sim/targets/walks.c \
        boards/common/app_scene.c "$work"/scene/model*.c firmware/*.c firmware/*/*.c
    "$(target_tools "$core")nm" "$work/image" |
        awk '$3 == "frame_begin" { print "begin " $1 } $3 == "frame_end" { print "end " $1 }' >"$work/marks"
    target_run "$core" "$work/image" -icount shift=0 \
        -plugin "$BUILD/count_plugin.so,ranges=$work/marks,out=$work/counts" >"$work/$core.found"
    awk '/^frame/ { print $2 + $3 }' "$work/counts" | paste -d ' ' "$work/$core.found" - >"$work/$core.counts"
}

figures() { # KIND CORE: mean and worst
    awk -v kind="$1" '$1 == kind { n++; sum += $NF; if ($NF > most) most = $NF }
        END { if (n) printf " %.1f / %.1f |", sum / n / 1000, most / 1000 }' "$work/$2.counts"
}

row() { # NAME MODEL FLAG...
    row_name=$1 row_model=$2
    shift 2
    prepare "$row_model"
    count m0plus "$@"
    count m4 "$@"
    cmp "$work/m0plus.found" "$work/m4.found" >&2
    polygons=$(awk '/polygon_count|\.polygon_count/ { gsub(/[^0-9]/, ""); print; exit }' "$work/scene/model.c")
    echo "| $row_name | ${polygons:-?} |$(figures ray m0plus)$(figures ray m4)$(figures move m0plus)$(figures move m4)"
}

player='-DWALKS_EYE_M=1.28 -DWALKS_RADIUS_M=0.5 -DWALKS_STEP_M=0.75'
echo '| thousand instructions, mean / worst | polygons | a ray, Cortex-M0+ | a ray, Cortex-M4F | a move, Cortex-M0+ | a move, Cortex-M4F |'
echo '|---|---|---|---|---|---|'
row rooms sim/scenes/rooms.obj
row demo "$BUILD/scenes/demo.obj"
# shellcheck disable=SC2086 # flags are words
row 'freedoom1.wad:E1M1' /usr/share/games/doom/freedoom1.wad:E1M1 $player
