# SPDX-License-Identifier: MIT
#
# Every kind of tree draws the same scenes right, with as few wrong pixels as the BSP tree is allowed;
# both orders of drawing agree on it.
. tests/tap.sh
. tests/scene_program.sh

# scene method most-wrong-%: compared with the reference in double precision
right() {
    "$BUILD/limner" render "sim/scenes/$1.obj" --camera "sim/scenes/$1.cam" --method "$2" --compare >"$work/table" &&
        awk -v most="$3" '/^compared/ { wrong = $8; holes = $NF }
            END { exit !(wrong != "" && wrong + 0 <= most && holes == 0) }' "$work/table"
}

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

orders_agree() {
    "$BUILD/limner" render sim/scenes/teapot.obj --size 97x61 --tree "$1" --write-hashes "$work/near" &&
        "$BUILD/limner" render sim/scenes/teapot.obj --size 97x61 --tree "$1" --method painter --check "$work/near"
}
for tree in clusters axis octree; do
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
# The last lines are what the process took of memory and time: that is the machine's, not the choice's.
choice() { sed '/^[a-z ]* for compiling/d' "$work/report"; }
chooses_again() {
    choice >"$work/first"
    chooses teapot clusters && choice >"$work/second" && cmp "$work/second" "$work/first"
}
tap_check "auto: the same again" chooses_again
by_default() { # SCENE TREE WHY
    "$BUILD/limner" compile "$1" --report >"$work/report" || return 1
    grep -A 1 '^  tree ' "$work/report"
    [ "$(awk '$1 == "tree" { print $2 }' "$work/report")" = "$2" ] && grep -q "chosen: .*$3" "$work/report"
}
tap_check "by default: rooms, the BSP tree, which splits nothing" by_default sim/scenes/rooms.obj bsp 'less than a quarter'
tap_check "by default: the demo, the BSP tree, though it splits a quarter" \
    by_default "$BUILD/scenes/demo.obj" bsp 'no other tree spares a tenth'
tap_check "by default: teapot, clusters, for the BSP tree splits much" by_default sim/scenes/teapot.obj clusters '% of its bytes'
says_nothing() {
    for asked in '--tree bsp' '--method bsp' '--method painter'; do
        # shellcheck disable=SC2086 # an option and its value
        "$BUILD/limner" compile sim/scenes/teapot.obj $asked --report >"$work/report" &&
            ! grep chosen: "$work/report" && grep -q '^  tree  *bsp$' "$work/report" || return 1
    done
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --method convex --report >"$work/report" && ! grep chosen: "$work/report"
}
tap_check "no choice where a tree is asked for, nothing is predicted, or by a convex solid's own method" says_nothing
solid_scans() {
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --report >"$work/report" &&
        grep -q 'by scan lines$' "$work/report" && grep -q 'less code and memory.*--method convex$' "$work/report" &&
        "$BUILD/limner" compile sim/scenes/icosahedron.obj --panel ssd1306 --report >"$work/report" &&
        grep -q 'as one convex solid$' "$work/report"
}
tap_check "a convex solid is drawn by scan lines, but on black and white displays, without a line" solid_scans

# What has no order is drawn by methods that make one, and by no other.
sets() {
    "$BUILD/limner" compile sim/scenes/knot.obj --tree none -o "$work/set" --report >"$work/report" &&
        grep -q "^RAM .*, by Newell's depth sort" "$work/report" && grep -q 'SCENE_METHOD LIM_NEWELL' "$work/set.h" &&
        "$BUILD/limner" render sim/scenes/knot.obj --tree none --size 80x60 --write-hashes "$work/hashes" &&
        "$BUILD/limner" render "$work/set.lim" --method newell --size 80x60 --check "$work/hashes" &&
        "$BUILD/limner" render "$work/set.lim" --size 80x60 --check "$work/hashes"
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
    render "$work/set.lim" --method nearest --size 80x60
tap_check "nor is one to be made for that" refuses '--method painter --tree none: a set has no order; depth and newell draw it' \
    compile sim/scenes/knot.obj --tree none --method painter --report
tap_check "two trees are one too many" refuses '--method bsp --tree clusters: that method has a tree of its own' \
    measure sim/scenes/knot.obj --tree clusters --method bsp
tap_check "newell's options go with newell" refuses '--newell: goes with --method newell' render sim/scenes/knot.obj --newell one
# A solid shows most of what the walk reaches: there scan lines cost less. Rooms hide most of it.
scans() { # WORDS OPTION...
    words=$1
    shift
    "$BUILD/limner" compile sim/scenes/teapot.obj "$@" --report >"$work/report" && grep "^RAM .*$words\$" "$work/report"
}
scans_teapot() {
    scans 'by scan lines' -o "$work/pot" && [ "$(awk '$1 == "tree" { print $2 }' "$work/report")" = clusters ] &&
        grep -q 'SCENE_METHOD LIM_SCANLINE$' "$work/pot.h" && grep -q 'LIM_HAS_SCANLINE 1$' "$work/pot.h" &&
        grep -q 'LIM_HAS_NEAREST 0$' "$work/pot.h" || return 1
    grep -A 1 '^  drawn by scan lines: ' "$work/report"
    awk '/drawn by scan lines:/ { less = $5; more = $8 }
        /bytes of working memory/ { ram = $1; other = $4 }
        /instructions a frame/ { said = $4 }
        $1 == "working" { needs = $NF }
        END { exit !(less > 0 && less <= 0.95 * more && said == less && ram == needs && other > 0 && ram + 960 < 17500) }' \
        "$work/report"
}
tap_check "teapot is compiled for scan lines, with clusters, in less than 18 KB, and the report says why" scans_teapot
shows_the_same() { # SIZE METHOD...: as compiled for scan lines, and never out of memory
    size=$1
    shift
    for method; do
        "$BUILD/limner" render "$work/pot.lim" --size "$size" --camera sim/scenes/teapot.cam --method "$method" --stats \
            --write-hashes "$work/$method" >"$work/stats" && [ "$(awk '
                $1 == "frame" { for (i = 1; i <= NF; i++) if ($i == "bands") column = i }
                $1 == "worst" { print $column }' "$work/stats")" = 0 ] || return 1
    done
    cmp "$work/nearest" "$work/scanline"
}
tap_check "compiled for scan lines, its limits do for both orders, which show the same" \
    shows_the_same 240x240 nearest scanline
small_too() { scans 'by scan lines' --size 128x64 -o "$work/pot" && shows_the_same 128x64 nearest scanline; }
tap_check "so on a small screen, where most of the polygons have no pixel" small_too

# A firmware of the scene's own looks at no columns, so polygons without any wait for their lines as well.
cat >"$work/bands.c" <<'END'
#include "cameras.h"
#include "limner.h"
#include "model.h"

static uint32_t line[CAMERAS_W_PX], mem[MODEL_SCENE_MEM_B(CAMERAS_H_PX) / 4 + 1];
static struct lim lim;

static void *lend(void *ctx, uint16_t y_px) { (void)ctx, (void)y_px; return line; }

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

int main(void)
{
    const struct lim_target target = {
        .w_px = CAMERAS_W_PX, .h_px = CAMERAS_H_PX, .method = MODEL_SCENE_METHOD, .lend = lend, .done = done};
    int err = lim_init(&lim, &model_scene, &target, mem, MODEL_SCENE_MEM_B(CAMERAS_H_PX));

    for (int i = 0; i < CAMERAS_COUNT && !err; i++) {
        err = lim_frame(&lim, &cameras[i]);
        if (lim_bands(&lim)) return 2;
    }
    return err != 0;
}
END
needs_no_band() { # WxH
    scans 'by scan lines' --method scanline --size "$1" -o "$work/model" &&
        "$BUILD/limner" render "$work/model.lim" --camera sim/scenes/teapot.cam --size "$1" \
            --write-cameras "$work/cameras.h" &&
        scene_program "$work/bands" -DLIM_CONFIG='"model.h"' "$work/bands.c" "$work"/model*.c && "$work/bands"
}
for size in 32x32 64x32 128x64; do
    tap_check "at $size its own firmware needs no band for the same path" needs_no_band $size
done
stays_nearest() {
    for asked in '--method nearest' --wireframe --delta --fill; do
        # shellcheck disable=SC2086 # an option and its value
        scans 'nearest first' $asked && ! grep 'scan lines' "$work/report" || return 1
    done
    "$BUILD/limner" compile sim/scenes/rooms.obj --report >"$work/report" &&
        awk '/instructions a frame/ { said = $4 }
            /drawn nearest first: by scan lines more than/ { more = $9 }
            END { exit !(more > 0.94 * said && more < said) }' "$work/report" && ! grep 'drawn by scan lines' "$work/report"
}
tap_check "antialiased, too" scans 'by scan lines' --antialias
tap_check "not so for what they cannot paint, nor rooms, nor where a method is asked for" stays_nearest
obeys() { scans 'by scan lines' --method scanline --tree bsp && ! grep 'drawn by scan lines' "$work/report"; }
tap_check "--method scanline is obeyed, with any tree" obeys
for option in --wireframe --delta; do
    tap_check "--method scanline $option is refused" \
        refuses ".*--method scanline: $option is drawn nearest first; take --method nearest" \
        compile sim/scenes/teapot.obj --method scanline $option --report
    tap_check "render --method scanline $option is refused" \
        refuses ".*--method scanline: $option is drawn nearest first; take --method nearest" \
        render sim/scenes/teapot.obj --method scanline $option
done
tap_check "--method scanline --fill is refused" \
    refuses '.*--method scanline: --fill is drawn nearest first; take --method nearest' \
    compile sim/scenes/teapot.obj --method scanline --fill --report
for command in 'compile sim/scenes/glass.obj --report' 'render sim/scenes/glass.obj'; do
    # shellcheck disable=SC2086 # a command and its arguments
    tap_check "${command%% *}: --method scanline is refused for glass" \
        refuses '.*--method scanline: glass is drawn nearest first; take --method nearest' $command --method scanline
done

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
    grep -q '^limner: --tree z: no such tree; there are auto, bsp, clusters, axis, octree, none and mesh$' "$work/out"
}
tap_check "an unknown tree is refused" refused
tap_done
