# SPDX-License-Identifier: MIT
#
# What `limner compile` predicts of views along faces, against what `limner measure` finds on scenes and paths that
# field_scenes.awk draws: by seeds on which the sampler was not tuned (that was done on 1 to 4).
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
limner=$(cd "$BUILD" && pwd)/limner
seeds='11 12 13 14'
frames=48
tree='--tree bsp --splitter fewest' # one tree, as in predictions.sh

one() { # KIND SEED FOLDER
    scene=$3/$1$2
    awk -v kind="$1" -v seed="$2" -v count=$frames -v cameras="$scene.cam" -f sim/tools/tables/field_scenes.awk >"$scene.obj"
    for profile in fast fine exact; do
        # shellcheck disable=SC2086 # words
        "$limner" compile "$scene.obj" --report --precision $profile $tree 2>/dev/null |
            awk '/wrong pixels, predicted/ { all = $4 } /wrong pixels, grazing/ { print all, $5 }' >"$scene.said"
        # shellcheck disable=SC2086
        "$limner" measure "$scene.obj" --no-cost --precision $profile $tree --camera "$scene.cam" 2>/dev/null |
            awk -F ' *[|] *' -v profile=$profile '$2 == profile { print $4; exit }' >"$scene.found"
        awk -v name="$1 $2" -v profile=$profile '
            function verdict(a, b) { return a < 0.001 && b < 0.001 || a <= 2 * b && b <= 2 * a ? "within" : "beyond" }
            FNR == NR { all = $1; grazing = $2; next }
            { printf "| %s | %s | %.4f | %.4f | %s | %.4f | %s |\n", name, profile, $1, grazing, verdict(grazing, $1), all,
                     verdict(all, $1) }' "$scene.said" "$scene.found"
    done >"$scene.rows"
}

# Where next to nothing is wrong it is easy to be within: those pairs are counted apart.
summary() { # FILE
    awk -F ' *[|] *' '{ by_row += $6 == "within"; by_all += $8 == "within" }
        $4 >= 0.001 || $5 >= 0.001 { more++; more_row += $6 == "within"; more_all += $8 == "within" }
        END {
            printf "%d pairs: %d within by the row of grazing views, %d by that of all cameras. ", NR, by_row, by_all
            printf "Of the %d where 0.001 %% or more are measured or predicted along faces: %d and %d.\n\n", more, more_row, more_all
        }' "$1"
}

case $1 in
one) one "$2" "$3" "$4" ;;
*)
    for kind in floor bars sheets fins corridor; do
        for seed in $seeds; do echo "$kind $seed"; done
    done >"$work/list"
    xargs -L 1 -P "${JOBS:-$(nproc)}" sh -eu -c 'sh -eu "$0" one "$2" "$3" "$1"' "$0" "$work" <"$work/list"
    while read -r kind seed; do cat "$work/$kind$seed.rows"; done <"$work/list" >"$work/rows"
    summary "$work/rows"
    echo '| scene | profile | measured, % | grazing views, % | | all cameras, % | |'
    echo '|---|---|---|---|---|---|---|'
    cat "$work/rows"
    ;;
esac
