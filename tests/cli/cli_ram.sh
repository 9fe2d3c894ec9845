# SPDX-License-Identifier: MIT
#
# Less memory: the same pictures, and costs that grow gently.
. tests/tap.sh

limner="$BUILD/limner"

# SCENE METHOD PERCENT MEAN WORST: pictures as with all memory; at most so many times the instructions.
grows_gently() {
    model=sim/scenes/$1
    [ -f "$model.obj" ] || model=$BUILD/scenes/$1
    set -- "$1" "$2" "$3" "$4" "$5" "$model.obj --camera $model.cam --method $2 --size 240x240 --stats"
    # shellcheck disable=SC2086 # options
    "$limner" render $6 --write-hashes "$work/hashes" >"$work/all" && "$limner" render $6 --ram "$3%" --check "$work/hashes" >"$work/less" &&
        awk -v mean="$4" -v worst="$5" '
            /^predicted/ { n = $(NF - 3); if (FNR < NR) printf "%.2f", n / all; if (FNR < NR && n > mean * all) bad = 1; if (FNR == NR) all = n }
            /in the worst:/ { n = $NF; if (FNR < NR) print " " n / most; if (FNR < NR && n > worst * most) bad = 1; if (FNR == NR) most = n; seen++ }
            END { exit bad || seen != 2 }' "$work/all" "$work/less"
}
# The teapot's compiler takes scan lines.
for scene in rooms teapot rooms-tilted hexecontahedron knot; do
    tap_check "$scene with 70 % of the pools" grows_gently $scene nearest 70 1.3 3
    tap_check "$scene with 50 % of the pools" grows_gently $scene nearest 50 2 5
done
# By scan lines all that is in view waits, so that a shortage is a second walk at once.
tap_check "teapot by scan lines with 70 % of the pools" grows_gently teapot scanline 70 1.35 2.5
tap_check "teapot by scan lines with 50 % of the pools" grows_gently teapot scanline 50 1.8 3
tap_check "knot by scan lines with 70 % of the pools" grows_gently knot scanline 70 1.3 3
tap_check "knot by scan lines with 50 % of the pools" grows_gently knot scanline 50 1.5 3

# Newell's pieces are polygons: with room for fewer of them others would be nearest.
the_same_by_newell() {
    set -- sim/scenes/knot.obj --method newell --camera random:3:12 --size 120x120
    "$limner" render "$@" --write-hashes "$work/hashes" >"$work/all" && "$limner" render "$@" --ram 1% --check "$work/hashes" &&
        ! "$limner" render "$@" --ram 5000 2>"$work/error" && grep -q 'too little memory; [0-9]* are the least' "$work/error"
}
tap_check "by Newell, less memory shows the same, or is refused" the_same_by_newell

refuses() { ! "$limner" render sim/scenes/teapot.obj --frames 1 --stats --ram "$1" 2>"$work/error" && grep -q "$2" "$work/error"; }
tap_check "too little is refused, with the least" refuses 1000 'too little memory; [0-9]* are the least'
tap_check "no number is refused" refuses some '^limner: --ram'

tap_done
