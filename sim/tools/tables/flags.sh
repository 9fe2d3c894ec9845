# SPDX-License-Identifier: MIT
#
# What a firmware saves by a flag of config.h that is off, on the scene of the project that saves most: at -Os, on
# Cortex-M0+ if no other core is named, the renderer with and without it as sim/tools/footprint.sh links it. Overlays are
# with text.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
. sim/targets/targets.sh
. sim/tools/footprint.sh

: "${WARNINGS:=-Wall}"
h_px=240

# A flag, the scene or SCENE@CORE, and what else a build with the flag on needs, or one without it that could have it.
flags() {
    cat <<'END'
LIM_HAS_NEAREST icosahedron
LIM_HAS_SCANLINE icosahedron
LIM_HAS_PAINTER rooms
LIM_HAS_CONVEX rooms
LIM_HAS_DEPTH rooms
LIM_HAS_NEWELL rooms
LIM_HAS_MESH rooms
LIM_HAS_MESH_DEPTH distance
LIM_HAS_MOVERS rooms
LIM_HAS_DEFORM movers
LIM_HAS_LIGHT movers
LIM_HAS_CULL quarters
LIM_HAS_SLANTED opacity
LIM_HAS_LARGE icosahedron@avr
LIM_HAS_WIDE rooms
LIM_HAS_LONG rooms
LIM_HAS_LEAVES movers
LIM_HAS_MESH_LEAVES movers -DLIM_HAS_LEAVES=1
LIM_HAS_TRANSPARENT rooms
LIM_HAS_TEXTURE rooms
LIM_HAS_MASKED quarters -DLIM_HAS_TRANSPARENT=1
LIM_HAS_SKY quarters
LIM_HAS_TELE rooms
LIM_HAS_WIREFRAME rooms
LIM_HAS_ANTIALIAS rooms
LIM_HAS_DELTA rooms
LIM_HAS_OVERLAY rooms
LIM_HAS_ROUND changing
LIM_HAS_FILL rooms
LIM_HAS_FRAMEBUFFER rooms
LIM_HAS_LINES icosahedron -DLIM_HAS_FILL=1
LIM_HAS_STATS rooms
LIM_HAS_PORTALS rooms
LIM_RECIP_TABLE rooms
END
}

scene() { # NAME: its model, and options
    case $1 in
    movers) echo sim/scenes/movers.gltf ;;
    quarters) echo tests/models/quarters.obj --method nearest ;;
    opacity) echo tests/models/opacity.obj ;;
    changing) echo sim/scenes/rooms.obj --delta ;;
    distance) echo sim/scenes/knot.obj --method mesh ;;
    icosahedron) echo sim/scenes/icosahedron.obj --method convex ;;
    *) echo "sim/scenes/$1.obj" ;;
    esac
}

shown() { # NAME: in the table
    case $1 in
    opacity | quarters) scene "$1" ;;
    changing) echo 'rooms, `--delta`' ;;
    distance) echo 'knot, `--method mesh`' ;;
    *) echo "$1" ;;
    esac
}

shown_core() { # CORE
    case $1 in
    m0plus) ;;
    avr) echo ', ATmega1284P' ;;
    *) echo ", $1" ;;
    esac
}

compile() { # NAME
    [ -d "$work/$1" ] && return
    mkdir "$work/$1"
    # shellcheck disable=SC2046 # words
    "$BUILD/limner" compile $(scene "$1") --size ${h_px}x$h_px -o "$work/$1/model" >/dev/null
}

# Without call graphs, which are for stacks: all files at once.
cost() { # NAME CORE FLAG...: code and tables, RAM
    cost_dir=$work/$1 cost_core=$2 project=$PWD
    shift 2
    rm -rf "${cost_dir:?}/$cost_core"
    mkdir "$cost_dir/$cost_core"
    # shellcheck disable=SC2046,SC2086 # words
    (cd "$cost_dir/$cost_core" && $(target_compiler "$cost_core") $(target_flags "$cost_core") -Os -ffreestanding \
        -ffunction-sections -fdata-sections $WARNINGS "-I$project/firmware" -I.. -DLIM_CONFIG='"model.h"' "$@" \
        -c "$project"/firmware/*.c "$project"/firmware/*/*.c)
    footprint_link "$cost_core" "$cost_dir"
    echo "$(footprint_size "$cost_core" "$cost_dir/$cost_core/renderer.elf" 1)" \
        "$(footprint_ram "$cost_core" "$cost_dir" model.h MODEL $h_px "$@")"
}

row() { # FLAG SCENE[@CORE] [OTHER-FLAG...]
    flag=$1 name=${2%@*} core=m0plus
    [ "$name" = "$2" ] || core=${2#*@}
    shift 2
    compile "$name"
    # shellcheck disable=SC2034 # of footprint.sh
    case $flag in LIM_HAS_OVERLAY) footprint_entries="$footprint_entries lim_set_overlay lim_text" ;; esac
    off=$(cost "$name" $core "-D$flag=0" "$@")
    on=$(cost "$name" $core "-D$flag=1" "$@")
    echo "$flag:$(shown "$name")$(shown_core $core):$off $on" | awk -F : '{
        split($3, b, " ")
        printf "| `%s` | %s | %d | %.1f | %d | %.1f |\n", $1, $2, b[3] - b[1], 100 * (b[3] - b[1]) / b[3], b[4] - b[2], 100 * (b[4] - b[2]) / b[4]
    }'
}

# Each flag that can be set has a row.
flags | cut -d ' ' -f 1 | sort >"$work/listed"
{ sed -n 's/^#ifndef \(LIM_HAS_[A-Z_]*\)$/\1/p' firmware/config.h && echo LIM_RECIP_TABLE; } | sort | diff - "$work/listed" >&2

echo '| flag | scene that is without it | code and tables saved, bytes | % | RAM saved, bytes | % |'
echo '|---|---|---|---|---|---|'
flags | while read -r row_flag row_scene row_flags; do
    # shellcheck disable=SC2086 # words
    row "$row_flag" "$row_scene" $row_flags
done
