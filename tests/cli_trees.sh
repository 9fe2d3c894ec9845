# SPDX-License-Identifier: MIT
#
# Every kind of tree draws the same scenes right, with as few wrong pixels as the BSP tree is allowed;
# both orders of drawing agree on it. Trees that only approximate are found out.
. tests/tap.sh

# scene method most-wrong-%: compared with the reference in double precision
right() {
    "$BUILD/limner" render "sim/scenes/$1.obj" --camera "sim/scenes/$1.cam" --method "$2" --compare >"$work/table" &&
        awk -v most="$3" '/^compared/ { wrong = $8; holes = $NF }
            END { exit !(wrong != "" && wrong + 0 <= most && holes == 0) }' "$work/table"
}
wrong() { ! right "$@" && grep -q '^compared' "$work/table"; }

for tree in bsp clusters axis octree; do
    tap_check "rooms, $tree" right rooms $tree 0.05
done
for tree in bsp clusters axis octree; do
    tap_check "teapot, $tree" right teapot $tree 0.08
done

# The rooms' camera walks in planes of symmetry. A cut there that splits walls lets a pixel of what is behind through.
splits_nothing() {
    "$BUILD/limner" compile "sim/scenes/$1.obj" --keep-faces --tree axis --report | grep -q '^  splits  *0$'
}
for scene in rooms rooms-tilted; do
    tap_check "$scene, axis: no cut where polygons' own planes split less" splits_nothing $scene
done

# Planes of polygons alone split the teapot 460 times.
splits_at_most() {
    splits=$("$BUILD/limner" compile "sim/scenes/$1.obj" --tree "$2" --report | awk '$1 == "splits" { print $2 }')
    echo "splits: $splits" && [ "$splits" -le "$3" ]
}
tap_check "teapot, clusters: cut where rings end" splits_at_most teapot clusters 150
tap_check "teapot, axis: few splits" splits_at_most teapot axis 150
tap_check "rooms, by the cubes of centres: not exact, and it shows" wrong rooms octree-centre 0.05
tap_check "rooms, by what sampled eyes see: not exact, and it shows" wrong rooms clusters-sampled 0.05
tap_check "teapot, by what sampled eyes see: not exact, and it shows" wrong teapot clusters-sampled 0.05
tap_check "teapot, clusters by sampled eyes split less than proved ones" splits_at_most teapot clusters-sampled 80

orders_agree() {
    "$BUILD/limner" render sim/scenes/teapot.obj --size 97x61 --tree "$1" --write-hashes "$work/near" &&
        "$BUILD/limner" render sim/scenes/teapot.obj --size 97x61 --tree "$1" --method painter --check "$work/near"
}
for tree in clusters axis octree clusters-sampled; do
    tap_check "$tree: nearest first and back to front are the same pictures" orders_agree $tree
done

# The report says why. On rooms the three are alike, so it stays the BSP tree.
chooses() { # SCENE TREE...
    "$BUILD/limner" compile "sim/scenes/$1.obj" --tree auto --report >"$work/report" || return 1
    grep -A 1 '^  tree ' "$work/report"
    awk -v wanted="$2" '$1 == "tree" { tree = $2 }
        $1 == "chosen:" { why = $0; share = $2 }
        END { exit !(tree == wanted && (tree == "bsp" ? why ~ /no other tree spares a tenth/ : share > 0 && share <= 90)) }' \
        "$work/report"
}
tap_check "auto: rooms, the BSP tree" chooses rooms bsp
tap_check "auto: teapot, clusters spare more than a tenth" chooses teapot clusters
chooses_again() {
    cp "$work/report" "$work/first"
    chooses teapot clusters && cmp "$work/report" "$work/first"
}
tap_check "auto: the same again" chooses_again
by_default() { # SCENE TREE WHY
    "$BUILD/limner" compile "$1" --report >"$work/report" || return 1
    grep -A 1 '^  tree ' "$work/report"
    [ "$(awk '$1 == "tree" { print $2 }' "$work/report")" = "$2" ] && grep -q "chosen: .*$3" "$work/report"
}
tap_check "by default: rooms, the BSP tree, which splits nothing" by_default sim/scenes/rooms.obj bsp 'less than a quarter'
tap_check "by default: the demo, the BSP tree, which splits little" \
    by_default "$BUILD/scenes/demo.obj" bsp 'less than a quarter'
tap_check "by default: teapot, clusters, for the BSP tree splits much" by_default sim/scenes/teapot.obj clusters '% of its bytes'
says_nothing() {
    for asked in '--tree bsp' '--method bsp' '--method painter'; do
        # shellcheck disable=SC2086 # an option and its value
        "$BUILD/limner" compile sim/scenes/teapot.obj $asked --report >"$work/report" &&
            ! grep chosen: "$work/report" && grep -q '^  tree  *bsp$' "$work/report" || return 1
    done
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --tree auto --report >"$work/report" && ! grep chosen: "$work/report"
}
tap_check "no choice where a tree is asked for, nothing is predicted, or the solid is convex" says_nothing

# What has no order is drawn by methods that make one, and by no other.
sets() {
    "$BUILD/limner" compile sim/scenes/knot.obj --tree none -o "$work/set" >"$work/report" &&
        grep -q "^RAM .*, by Newell's depth sort" "$work/report" && grep -q 'SCENE_METHOD LIM_NEWELL' "$work/set.h" &&
        "$BUILD/limner" render sim/scenes/knot.obj --tree none --size 80x60 --write-hashes "$work/hashes" &&
        "$BUILD/limner" render "$work/set.lim" --method newell --size 80x60 --check "$work/hashes"
}
tap_check "a set is sorted, if nothing else is asked for" sets
refuses() { # MESSAGE OPTION...
    message=$1
    shift
    "$BUILD/limner" "$@" >"$work/out" 2>&1 && return 1
    cat "$work/out"
    grep -q "^limner: $message\$" "$work/out"
}
tap_check "a compiled set is not walked" refuses '.*set.lim: a set has no order; draw it with --method newell or depth' \
    render "$work/set.lim" --size 80x60
tap_check "nor is one to be made for that" refuses '--method painter --tree none: a set has no order; depth and newell draw it' \
    compile sim/scenes/knot.obj --tree none --method painter --report
tap_check "two trees are one too many" refuses '--method bsp --tree clusters: that method has a tree of its own' \
    measure sim/scenes/knot.obj --tree clusters --method bsp
tap_check "newell's options go with newell" refuses '--newell: goes with --method newell' render sim/scenes/knot.obj --newell one
unpredicted() {
    "$BUILD/limner" compile sim/scenes/glass.obj --report >"$work/report" &&
        grep -q 'chosen:  *no cost is predicted' "$work/report" || return 1
    for asked in --antialias --wireframe '--precision exact'; do
        # shellcheck disable=SC2086 # an option and its value
        "$BUILD/limner" compile sim/scenes/rooms.obj $asked --report >"$work/report" &&
            ! grep 'instructions a frame' "$work/report" || return 1
        "$BUILD/limner" render sim/scenes/rooms.obj $asked --stats --size 40x40 -o "$work/%03d.png" >"$work/report" &&
            ! grep '^predicted for' "$work/report" || return 1
    done
}
tap_check "no cost is predicted of what the prediction does not know" unpredicted

refused() {
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --tree z --report >"$work/out" 2>&1 && return 1
    grep -q '^limner: --tree z: no such tree; there are auto, bsp, clusters, axis, octree, octree-centre, clusters-sampled, none$' "$work/out"
}
tap_check "an unknown tree is refused" refused
tap_done
