# SPDX-License-Identifier: MIT
#
# Accuracy against cost: what `limner measure` says of the demo and two benchmark scenes, and its picture of the rooms. The
# full tables go to out/tradeoff. A part is a scene's columns of accuracy, which need no emulator.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work, pictures

out=out/tradeoff
profiles=draft,fast,fine,exact

folder_of() { # SCENE
    [ "$1" = demo ] && echo "$BUILD/scenes" || echo sim/scenes
}

measure() { # SCENE [OPTION...]
    scene=$1 folder=$(folder_of "$1")
    shift
    "$BUILD/limner" measure "$folder/$scene.obj" --camera "$folder/$scene.cam" --size 240x240 "$@" >"$work/said"
}

# Rows of the table from a CSV of `limner measure`: the four profiles on two processors. No field that is
# used has a comma in it.
rows() { # CSV
    awk -F , '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        function field(name) { return $column[name] }
        function place() {
            return field("on_front") == "" ? "" : field("on_front") ? "front" : "dominated by " field("dominated_by")
        }
        {
            profile = field("precision")
            if (!(profile in accuracy)) order[++count] = profile
            scene = field("scene")
            gsub("\"", "", scene)
            accuracy[profile] = sprintf("| %s | %s | %.4f | %.2f | %.3f |", scene, profile, field("wrong_percent"),
                field("beyond_ppm"), field("vertex_rms_px"))
            cost[profile, field("core")] = sprintf(" %.0f | %s |", field("instructions") / 1000, place())
            ram[profile] = field("state_b") + field("pools_b") + field("static_b")
        }
        END {
            for (i = 1; i <= count; i++) {
                profile = order[i]
                if (profile ~ /_/) continue # other sub-pixel bits: in the full tables
                print accuracy[profile] cost[profile, "m0plus"] cost[profile, "m4"] " " ram[profile] " |"
            }
        }' "$1"
}

table() {
    echo "| scene | precision | wrong, % | beyond 1 px, ppm | vertex error rms, px | M0+: thousand instructions | | M4F | | RAM, bytes |"
    echo "|---|---|---|---|---|---|---|---|---|---|"
    for scene in demo rooms teapot; do
        echo "tradeoff: $scene" >&2
        measure "$scene" --sub-bits -o "$out/$scene"
        rows "$out/$scene/measure.csv"
    done
}

# The columns of accuracy alone.
accuracies() { # SCENE < TABLE
    awk -F '|' -v scene=" $1 " '$2 == scene && NF > 6 { print $2 "|" $3 "|" $4 "|" $5 "|" $6 }'
}

case ${2:-} in
part)
    measure "$3" --no-cost --precision "$profiles" -o "$work"
    rows "$work/measure.csv" | accuracies "$3"
    ;;
of) accuracies "$3" ;;
*)
    table
    [ -z "$pictures" ] || cp "$out/rooms/measure.png" "$pictures/tradeoff.png"
    ;;
esac
