# SPDX-License-Identifier: MIT
#
# Views along faces: what is predicted of them is what paths find which sim/tools/tables/field_scenes.awk draws, and
# nothing of the simulator.
. tests/tap.sh

limner=$BUILD/limner

draw() { # KIND SEED
    awk -v kind="$1" -v seed="$2" -v count=48 -v cameras="$work/$1.cam" -f sim/tools/tables/field_scenes.awk >"$work/$1.obj"
}

predicted_right() { # KIND
    tree='--tree bsp --splitter fewest'
    # shellcheck disable=SC2086 # words
    "$limner" compile "$work/$1.obj" --report $tree >"$work/report" &&
        "$limner" measure "$work/$1.obj" --no-cost --precision fast $tree --camera "$work/$1.cam" >"$work/found" || return 1
    awk -F ' *[|] *' '/wrong pixels, grazing views/ { split($0, word, " "); predicted = word[5] }
        $2 == "fast" { measured = $4 }
        END {
            print predicted, measured
            exit !(measured > 0.001 && predicted <= 2 * measured && measured <= 2 * predicted)
        }' "$work/report" "$work/found"
}

for scene in 'floor 1' 'sheets 2' 'corridor 3' 'bars 1'; do
    # shellcheck disable=SC2086 # a kind and a seed
    draw $scene
    tap_check "what is predicted along ${scene% *} is found there" predicted_right "${scene% *}"
done

of_a_file() {
    "$limner" compile "$work/bars.obj" -o "$work/bars" >/dev/null &&
        ! "$limner" render "$work/bars.lim" --camera grazing:1:2 2>"$work/err" &&
        grep -q 'grazing:1:2: a .lim file does not hold' "$work/err"
}
seeds_are_whole() {
    ! "$limner" render "$work/bars.obj" --camera grazing:x 2>"$work/err" && grep -q '^limner: --camera grazing:SEED' "$work/err"
}
tap_check "such cameras need the model" of_a_file
tap_check "and a seed" seeds_are_whole

tap_done
