# SPDX-License-Identifier: MIT
#
# Scenes whose grid is too coarse for what is in them, where it must be one of 16 bits (cli_coordinates.sh has those that
# may have 32): every command that compiles a model refuses, names faces, sizes and what helps, and writes nothing; with --drop-small it says how much is left out. What is predicted of a scene is what its
# cameras find, also near what is small.
. tests/tap.sh

limner=$BUILD/limner
"$BUILD/generate_scale" ground 240000 "$work" # 126 faces: +-120,000 m, boxes of 0.6 m
for side in 100 1000 10000 50000; do "$BUILD/generate_scale" floor $side "$work"; done
ground=$work/ground240000.obj

. tests/refused.sh

small='ground240000.obj: face [0-9]* \(0\.6 m\), [0-9]* \(0\.6 m\), [0-9]* \(0\.6 m\) \.\.\.: 12[05] of 126 faces would vanish or move too far on a grid with units of 3\.66 m; take --coordinates 32, or leave it out by --drop-small$'
for profile in draft fast fine exact; do
    tap_check "compile refuses what vanishes, $profile" refused "$small" compile "$ground" --coordinates 16 -o "$work/out/x" --precision $profile
    tap_check "render, too, $profile" refused "$small" render "$ground" --coordinates 16 -o "$work/out/%d.png" --gif "$work/out/x.gif" --precision $profile
    tap_check "and measure, $profile" refused "$small" measure "$ground" --coordinates 16 --no-cost -o "$work/out" --precision $profile
done
tap_check "view refuses" refused "$small" view "$ground" --coordinates 16
tap_check "compare refuses" refused "$small" compare "$ground" --coordinates 16 --no-cost -o "$work/out"
tap_check "splitters refuses" refused "$small" splitters "$ground" --coordinates 16
tap_check "play refuses" refused "$small" play "$ground" --coordinates 16 --panel st7789 --spi /dev/spidev99.0 --dc GPIO25
tap_check "compile refuses one such model of two" refused "$small" compile sim/scenes/knot.obj "$ground" --coordinates 16 -o "$work/out/x"
tap_check "also where it only reports" refused "$small" compile "$ground" --coordinates 16 --report

helps='1000.obj: face [2-6] .*; take --coordinates 32, take --precision exact, or leave it out by --drop-small$'
tap_check "1 km: boxes of 0.1 m move too far, and exact helps" refused "$helps" compile "$work/floor1000.obj" --coordinates 16 -o "$work/out/x"
tap_check "it does" "$limner" compile "$work/floor1000.obj" --coordinates 16 -o "$work/x" --precision exact
tap_check "10 km are refused" refused '10000.obj: face [2-6] \(0\.1 m\)' compile "$work/floor10000.obj" --coordinates 16 -o "$work/out/x"
tap_check "in exact, too" refused '10000.obj: face [2-6] \(0\.1 m\)' render "$work/floor10000.obj" --coordinates 16 --precision exact -o "$work/out/%d.png"
tap_check "50 km are refused" refused '50000.obj: (all precisions are refused, exact: )?face' measure "$work/floor50000.obj" --coordinates 16 --no-cost
tap_check "100 m are not" "$limner" compile "$work/floor100.obj" -o "$work/y"

# A precision that is refused leaves the others to choose from; each reason is told once.
reason='^draft, fast.*: refused: face 4 \(0\.1 m\), 6 .* of 126 faces would vanish'
chooses_exact() {
    "$limner" compile "$work/floor1000.obj" --coordinates 16 -o "$work/chosen" --report --max-error 1% >"$work/said" || return 1
    head -4 "$work/said"
    [ "$(awk '$NF == "chosen" { print $1 }' "$work/said")" = exact ] && [ -s "$work/chosen.lim" ] &&
        [ "$(grep -cE "$reason" "$work/said")" -eq 1 ] && ! grep -q '^exact.*refused' "$work/said"
}
measures_exact() {
    "$limner" measure "$work/floor1000.obj" --coordinates 16 --no-cost --size 32x32 -o "$work/measured" >"$work/said" 2>"$work/err" &&
        [ "$(awk '/^[|] (draft|fast|fine|exact)/ { print $2 }' "$work/said")" = exact ] &&
        grep -qE "$reason" "$work/measured/measure.md" && grep -q '^limner: note: draft, .*: refused: face 4' "$work/err"
}
misses() {
    rm -f "$work"/none*
    ! "$limner" compile "$work/floor1000.obj" --coordinates 16 -o "$work/none" --max-vertex-error 1e-9px >"$work/said" 2>"$work/err" &&
        cat "$work/err" && grep -q 'no precision meets the bound; exact comes nearest' "$work/err" &&
        [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qE "$reason" "$work/said" && ! ls "$work"/none* 2>/dev/null
}
tap_check "a bound is met by the precision that is not refused" chooses_exact
tap_check "it is measured, and the others named with the reason" measures_exact
tap_check "if it misses the bound, nothing is written" misses
tap_check "if all are refused, one line says why" refused '10000.obj: all precisions are refused, exact: face 4 ' compile "$work/floor10000.obj" --coordinates 16 -o "$work/out/x" --max-error 1

# What is left out is said, and counted as wrong.
drops_some() {
    "$limner" compile "$work/floor1000.obj" -o "$work/dropped" --report --drop-small >"$work/report" || return 1
    cat "$work/report"
    awk '/left out, too small/ { out = $5 } /near faces, small/ { near = $6 }
        END { exit !(out >= 5 && out < 125 && out % 5 == 0 && near > 1) }' "$work/report"
}
drops_all_boxes() {
    "$limner" render "$ground" --drop-small --size 32x32 -o "$work/ground%d.png" 2>&1 |
        grep -q '^limner: note: --drop-small left out 125 of 126 faces, too small for the grid$' && [ -s "$work/ground15.png" ]
}
drops_in() { # COMMAND...
    timeout 120 "$limner" "$@" --drop-small 2>"$work/err" >"$work/said" && grep -q 'left out 125 of 126 faces' "$work/err"
}
tap_check "--drop-small leaves out whole boxes, and their pixels are predicted to be wrong" drops_some
tap_check "render says how much it leaves out" drops_all_boxes
tap_check "measure does" drops_in measure "$ground" --no-cost --size 32x32 --precision fast
tap_check "compare does" drops_in compare "$ground" --no-cost --size 32x32 --frames 1
tap_check "splitters does" drops_in splitters "$ground"
tap_check "help names --drop-small" sh -c "'$limner' help | grep -q -- '--drop-small'"

# MODEL PROFILE [OPTION...]: predicted by the compiler, measured with other random numbers.
predicted_right() {
    model=$1 profile=$2
    shift 2
    "$limner" compile "$model" --report --precision "$profile" "$@" >"$work/report" || return 1
    for kind in random near; do
        "$limner" measure "$model" --no-cost --precision "$profile" --camera $kind:5:24 "$@" >"$work/$kind" || return 1
    done
    awk -F ' *[|] *' -v profile="$profile" '/wrong pixels, predicted/ { split($0, word, " "); predicted = word[4] }
        $2 == profile { measured += $4 / 2 }
        END {
            print predicted, measured
            small = predicted < 0.001 && measured < 0.001
            exit !(predicted > 0 && measured > 0 && (small || (predicted <= 2 * measured && measured <= 2 * predicted)))
        }' "$work/report" "$work/random" "$work/near"
}
tap_check "what is predicted of the teapot is measured" predicted_right sim/scenes/teapot.obj fast
tap_check "of a floor of 100 m with boxes, too" predicted_right "$work/floor100.obj" fast
tap_check "and of what is left out of one of 10 km" predicted_right "$work/floor10000.obj" fast --drop-small

# The boxes as the generator's own cameras see them, which know nothing of samplers.
walk_sees() {
    "$limner" render "$work/floor100.obj" --camera "$work/floor100.cam" --compare >"$work/table" || return 1
    wrong=$(awk '/^compared/ { print $8 }' "$work/table")
    near=$("$limner" compile "$work/floor100.obj" --report | awk '/near faces/ { print $6 }')
    echo "a walk sees $wrong %, near faces $near % are predicted"
    awk -v wrong="$wrong" -v near="$near" 'BEGIN { exit !(near > wrong / 3 && near < wrong * 3) }'
}
tap_check "a walk among the boxes sees about what is predicted near faces" walk_sees

no_original() { ! "$limner" render "$work/y.lim" --camera near:1:2 2>"$work/err" && grep -q 'near:1:2: a .lim file does not hold' "$work/err"; }
tap_check "cameras near faces need the model" no_original
tap_done
