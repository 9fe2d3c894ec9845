# SPDX-License-Identifier: MIT
#
# The wrong pixels that `limner compile` predicts, against those that `limner measure` finds with cameras of other random
# numbers, half of them anywhere and half near faces, and for OBJ files with cameras that no code of the simulator drew
# (other_cameras.awk); in every profile. Models are those of Debian's assimp-testmodels that are not drawn from animations,
# and scenes of the project and its generators. $BUILD/predictions keeps a file a model, so that a run which was interrupted
# goes on.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
limner=$(cd "$BUILD" && pwd)/limner
assimp=/usr/share/assimp/models
seed=77
frames=24 # of each kind
# One tree a scene: which one decides little about errors.
tree='--tree bsp --splitter fewest'

generated='floor 100
floor 300
floor 1000
floor 10000
floor 50000
ground 1000
ground 240000
rooms 6
mesh 2000'

# The same shape in another file: once is enough. The engine of 110,000 faces takes hours.
again='box_longline|box_mat_|box_without|cube_mtllib|cube_usemtl|vertexcolors_uni|PLY/Wuson|STL/Wuson|Spider_|cube_binary
|Embedded|MaterialsCommon|glTF2/BoxTextured|with_two_solids|with_empty_solid|Asset-Generator|2CylinderEngine'

list() { # FOLDER for what is generated
    cut -f 1 tests/models/models.expected | grep -vE "$(echo "$again" | tr -d '\n')" | while IFS= read -r model; do
        grep -q "^$model	rendered" tests/models/models.expected && echo "$assimp/$model"
    done
    ls sim/scenes/*.obj sim/scenes/movers.gltf "$BUILD/scenes/demo.obj"
    echo "$generated" | while read -r kind size; do
        "$BUILD/generate_scale" "$kind" "$size" "$1"
        echo "$1/$kind$size.obj"
    done
}

# A line for each profile: its name, predicted, and - or why it is refused.
predict() { # MODEL FOLDER NAME
    for profile in draft fast fine exact; do
        # shellcheck disable=SC2086 # words
        if "$limner" compile "$1" --report --precision "$profile" $tree >"$2/$3.said" 2>"$2/$3.error"; then
            echo "predicted $profile $(awk '/wrong pixels, predicted/ { print $4 }' "$2/$3.said")"
        else
            echo "refused $profile $(sed "s,^limner: ,,; s,^[^:]*: ,,; s,|,/,g" "$2/$3.error")"
        fi
    done
    rm -f "$2/$3.said" "$2/$3.error"
}

measured() { # MODEL PROFILE,... CAMERAS KIND
    # shellcheck disable=SC2086
    "$limner" measure "$1" --no-cost --precision "$2" $tree --camera "$3" 2>/dev/null |
        awk -F ' *[|] *' -v kind="$4" '$2 ~ /^(draft|fast|fine|exact)$/ && !seen[$2]++ { print kind, $2, $4 }'
}

measured_all() { # MODEL PROFILE,... FILE for cameras
    for kind in random near; do measured "$1" "$2" $kind:$seed:$frames measured; done
    case $1 in *.obj) ;; *) return ;; esac
    for other_seed in 1 2; do
        awk -v seed=$other_seed -v count=$frames -f sim/tools/tables/other_cameras.awk "$1" >"$3"
        [ ! -s "$3" ] || measured "$1" "$2" "$3" other
    done
    rm -f "$3"
}

# Names in the table and on disk.
name_of() { # MODEL
    case $1 in "$assimp"*) echo "${1#"$assimp/"}" ;; *) echo "${1##*/}" ;; esac
}
row_file() { name_of "$1" | tr '/ ' '__'; }

# | model | profile | predicted | measured | verdict | by other cameras | verdict |
one() { # MODEL FOLDER
    name=$(name_of "$1")
    file=$(row_file "$1")
    # shellcheck disable=SC3013 # Debian's sh has it
    [ ! -s "$2/$file.rows" ] || [ ! "$2/$file.rows" -nt "$limner" ] || exit 0
    predict "$1" "$2" "$file" >"$2/$file.part"
    profiles=$(awk '$1 == "predicted" { printf "%s%s", n++ ? "," : "", $2 }' "$2/$file.part")
    [ -z "$profiles" ] || measured_all "$1" "$profiles" "$2/$file.cameras" >>"$2/$file.part"
    awk -v name="$name" '
        $1 == "measured" || $1 == "other" { sum[$1, $2] += $3; count[$1, $2]++ }
        $1 == "predicted" { order[++n] = $2; predicted[$2] = $3 }
        $1 == "refused" { order[++n] = $2; profile = $2; sub(/^refused [a-z]* /, ""); reason[profile] = $0 }
        function verdict(a, b) { return a < 0.001 && b < 0.001 || a <= 2 * b && b <= 2 * a ? "within" : "beyond" }
        function cells(kind, p,    mean) {
            if (!count[kind, p])
                return kind == "other" ? "| - | - |" : "| - | not measured |"
            mean = sum[kind, p] / count[kind, p]
            return sprintf("| %.4f | %s |", mean, verdict(predicted[p] + 0, mean))
        }
        END {
            for (i = 1; i <= n; i++) {
                p = order[i]
                if (p in reason)
                    printf "| %s | %s | - | - | refused: %s | - | - |\n", name, p, reason[p]
                else
                    printf "| %s | %s | %.4f %s%s\n", name, p, predicted[p], cells("measured", p),
                           substr(cells("other", p), 2)
            }
        }' "$2/$file.part" >"$2/$file.rows"
    rm -f "$2/$file.part"
}

table() { # FOLDER
    mkdir -p "$1"
    list "$1" >"$1/list"
    # The smallest first.
    tr '\n' '\0' <"$1/list" | xargs -0 ls -Sr >"$1/sorted"
    xargs -d '\n' -P "${JOBS:-$(nproc)}" -I '{}' sh -eu "$0" one '{}' "$1" <"$1/sorted"
    while IFS= read -r model; do
        cat "$1/$(row_file "$model").rows"
    done <"$1/list"
}

# How many pairs lie within a factor of two.
summary() { # FILE
    awk -F ' *[|] *' '{ refused += $6 ~ /^refused/; count[$6]++; other[$8]++ }
        !($2 in seen) { seen[$2]; models++ }
        END {
            printf "%d models in four profiles: %d pairs within, %d beyond (%.1f %% within); %d refused. ",
                   models, count["within"], count["beyond"],
                   100 * count["within"] / (count["within"] + count["beyond"]), refused
            printf "By other cameras: %d within, %d beyond (%.1f %%).\n\n", other["within"], other["beyond"],
                   100 * other["within"] / (other["within"] + other["beyond"])
        }' "$1"
}

case $1 in
one) one "$2" "$3" ;;
*)
    folder=$BUILD/predictions
    table "$folder" >"$work/rows"
    summary "$work/rows"
    echo '| scene | profile | predicted, % | measured, % | | by other cameras, % | |'
    echo '|---|---|---|---|---|---|---|'
    cat "$work/rows"
    ;;
esac
