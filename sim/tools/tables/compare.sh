# SPDX-License-Identifier: MIT
#
# Every visibility method on five kinds of scenes, and a picture of what they get wrong: what `limner compare` says. Full
# tables and pictures go to out/compare. A part is a scene's columns of pixels, which need no emulator.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work, pictures

out=out/compare

# One convex solid, rooms, a dense mesh, polygons that pass through each other and hide each other in a ring, objects
# that move through rooms and through each other.
scenes='icosahedron rooms teapot knot movers'
picture=knot

model() { # SCENE: the file of that name
    for suffix in obj gltf; do
        [ ! -e "sim/scenes/$1.$suffix" ] || echo "sim/scenes/$1.$suffix"
    done
}

compare() { # SCENE FOLDER [OPTION...]
    scene=$1 folder=$2
    shift 2
    [ ! -e "sim/scenes/$scene.cam" ] || set -- --camera "sim/scenes/$scene.cam" "$@"
    "$BUILD/limner" compare "$(model "$scene")" --size 240x240 -o "$folder" "$@" >/dev/null
}

# Rows of the table from a CSV of `limner compare`. Methods that come to the same are one row; those that do
# not draw the scene have none. No field that is used has a comma in it.
rows() { # CSV
    awk -F , '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        function field(name) { return $column[name] }
        function thousands(name, format) { return field(name) == "" ? "-" : sprintf(format, field(name) / 1000) }
        field("frames") == "" { next }
        {
            scene = field("scene")
            gsub("\"", "", scene)
            splits = field("splits_a_frame") > 0 ? sprintf("%.0f a frame", field("splits_a_frame")) : field("splits")
            figures = sprintf(" | %s | %.4f | %d | %d | %s | %s | %s | %s | %s |", field("exact") ? "exact" : "approximate",
                field("wrong_percent"), field("order_errors"), field("holes"), splits, thousands("m0plus_instructions", "%.0f"),
                thousands("m4_instructions", "%.0f"), thousands("m0plus_ram_b", "%.1f"),
                thousands("m0plus_flash_b", "%.1f"))
            if (figures in names) names[figures] = names[figures] ", " field("method")
            else {
                names[figures] = "| " scene " | " field("method")
                order[++count] = figures
            }
        }
        END { for (i = 1; i <= count; i++) print names[order[i]] order[i] }' "$1"
}

table() {
    echo "| scene | method | kind | wrong, % | order errors, px | holes, px | splits | M0+: thousand instructions | M4F | RAM, KB | flash, KB |"
    echo "|---|---|---|---|---|---|---|---|---|---|---|"
    for scene in $scenes; do
        echo "compare: $scene" >&2
        compare "$scene" "$out/$scene"
        rows "$out/$scene/compare.csv"
    done
}

# The columns of pixels alone, a line a method.
pixels() { # SCENE < TABLE
    awk -F ' *[|] *' -v scene="$1" '$2 == scene {
        count = split($3, names, ", ")
        for (i = 1; i <= count; i++) print names[i], $4, $5, $6, $7
    }' | sort
}

case ${2:-} in
part)
    compare "$3" "$work/now" --no-cost
    rows "$work/now/compare.csv" | pixels "$3"
    ;;
of) pixels "$3" ;;
*)
    table
    [ -z "$pictures" ] || cp "$out/$picture/sheet.png" "$pictures/compare.png"
    ;;
esac
