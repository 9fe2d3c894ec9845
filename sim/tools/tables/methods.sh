# SPDX-License-Identifier: MIT
#
# What the compiler's choice of a method costs beside every other one, on levels, meshes, and things in rooms that nothing
# was tuned on: instructions counted on an emulated Cortex-M0+, 8 random cameras. A mesh counts where it has no more
# wrong pixels than the profile promises or no more than 1.25 times those of the tree. SCENES="MAP02 duck" prints these alone.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work, pictures

if [ -n "$pictures" ] && [ -n "${SCENES:-}" ]; then
    echo "methods: SCENES is for printing; the page has all" >&2
    exit 1
fi
: "${SCENES:=MAP02 MAP05 MAP07 E1M1 duck COLLADA Cinema4D WusonBlitz faerie sphereWithHole rooms+teapot rooms+knot}"
models=/usr/share/assimp/models
levels=/usr/share/games/doom
cameras=random:77:8
methods='nearest scanline mesh mesh-depth'

level() { # WAD MAP
    "$BUILD/generate_bench" level "$work/$2" "$levels/$1" "$2" && echo "$work/$2.obj"
}

in_rooms() { # SCENE SCALE X Y Z: rooms, and that scene where it says
    awk -v s="$2" -v x="$3" -v y="$4" -v z="$5" '
        FNR == 1 { before = count; files++ }
        $1 == "v" { count++; if (files == 1) print; else print "v", $2 * s + x, $3 * s + y, $4 * s + z }
        $1 == "f" { printf "f"; for (i = 2; i <= NF; i++) { split($i, corner, "/"); printf " %d", corner[1] + before } print "" }
    ' sim/scenes/rooms.obj "sim/scenes/$1.obj" >"$work/rooms+$1.obj" && echo "$work/rooms+$1.obj"
}

model() { # SCENE: its file
    case $1 in
    MAP*) level freedoom2.wad "$1" ;;
    E?M?) level freedoom1.wad "$1" ;;
    duck | COLLADA | Cinema4D) echo "$models/Collada/$1.dae" ;;
    WusonBlitz) echo "$models/B3D/$1.b3d" ;;
    faerie) echo "$models/MD2/$1.md2" ;;
    sphereWithHole) echo "$models/STL/$1.stl" ;;
    rooms+teapot) in_rooms teapot 0.3 2 1 2 ;;
    rooms+knot) in_rooms knot 0.35 8 1.2 8 ;;
    *) echo "methods: no such scene: $1" >&2; return 1 ;;
    esac
}

# "METHOD INSTRUCTIONS WRONG" of a method, or nothing if it does not draw the scene.
figures() { # FILE METHOD|chosen
    [ "$2" = chosen ] && method= || method="--method $2"
    # shellcheck disable=SC2086 # words
    "$BUILD/limner" measure "$1" --no-textures $method --core m0plus --precision fast --camera $cameras -o "$work/o" \
        >/dev/null 2>"$work/said" || { grep -q -- "--method $2" "$work/said" || cat "$work/said" >&2; return 0; }
    awk -F, -v method="$2" 'FNR == 2 { print method, $19, $7 }' "$work/o/measure.csv"
}

# The method that the compiler takes.
chosen() { # FILE
    "$BUILD/limner" compile "$1" --no-textures --precision fast -o "$work/chosen" >/dev/null 2>&1 &&
        sed -n 's/^#define LIM_HAS_\(NEAREST\|SCANLINE\|MESH\|MESH_DEPTH\) 1$/\1/p' "$work/chosen.h" | tr 'A-Z_' 'a-z-'
}

predicted() { # METHOD: for the same frames of the compiled scene
    "$BUILD/limner" render "$work/chosen.lim" --method "$1" --camera $cameras --stats 2>/dev/null |
        sed -n 's/^predicted for .*: \([0-9]*\) instructions.*/predicted \1/p'
}

row() { # SCENE
    file=$(model "$1")
    for method in $methods chosen; do
        figures "$file" "$method"
    done >"$work/figures"
    name=$(chosen "$file")
    predicted "$name" >>"$work/figures"
    awk -v scene="$1" -v name="$name" '
        $1 == "predicted" { predicted = $2; next }
        { counted[$1] = $2; wrong[$1] = $3 }
        END {
            tree = wrong["nearest"]; bound = tree * 1.25 > 0.05 ? tree * 1.25 : 0.05
            for (method in counted) {
                if (method == "chosen" || (method ~ /^mesh/ && wrong[method] > bound)) continue
                if (!best || counted[method] < counted[best]) best = method
            }
            if (!name || !predicted) exit 1
            off = (predicted / counted["chosen"] - 1) * 100
            printf "| %s | %s | %.0f | %s | %.0f | %.2f | %+.1f |", scene, name, counted["chosen"] / 1000, best, counted[best] / 1000,
                counted["chosen"] / counted[best], off
            n = split("nearest scanline mesh mesh-depth", names, " ")
            for (i = 1; i <= n; i++)
                printf names[i] in counted ? " %.0f, %.3f |" : " - |", counted[names[i]] / 1000, wrong[names[i]]
            print ""
        }' "$work/figures"
}

echo '| scene | chosen | it costs | cheapest that is right enough | it costs | ratio | predicted, off by % | nearest, wrong % | scanline | mesh | mesh-depth |'
echo '|---|---|---|---|---|---|---|---|---|---|---|'
for scene in $SCENES; do
    row "$scene"
done
