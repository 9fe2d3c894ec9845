# SPDX-License-Identifier: MIT
#
# What a frame is predicted to cost on a Cortex-M0+ is what the emulated one counts, give or take a few percent.
. tests/tap.sh

agrees() { # SCENE TREE SPLITTER METHOD
    awk 'n++ % 8 == 0' "sim/scenes/$1.cam" >"$work/cam"
    "$BUILD/limner" measure "sim/scenes/$1.obj" --camera "$work/cam" --tree "$2" --splitter "$3" --method "$4" --precision fast \
        --core m0plus -o "$work/$1-$2-$3-$4" >/dev/null &&
        "$BUILD/limner" render "sim/scenes/$1.obj" --camera "$work/cam" --tree "$2" --splitter "$3" --method "$4" --stats >"$work/said" &&
        counted=$(awk -F , 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "instructions") column = i } NR == 2 { print $column }' \
            "$work/$1-$2-$3-$4/measure.csv") &&
        awk -v counted="$counted" '/^predicted/ {
            off = ($(NF - 3) / counted - 1) * 100
            printf "counted %.0f, predicted %.0f: off by %.1f %%\n", counted, $(NF - 3), off
            said = 1
        }
        END { exit !(said && counted > 100000 && off < 4 && off > -4) }' "$work/said"
}

tap_check "rooms, BSP tree" agrees rooms bsp auto nearest
tap_check "rooms, clusters" agrees rooms clusters auto nearest
tap_check "rooms-tilted, octree" agrees rooms-tilted octree auto nearest
tap_check "teapot, BSP tree" agrees teapot bsp auto nearest
tap_check "teapot, first polygon: twice as many nodes" agrees teapot bsp first nearest
tap_check "teapot, axis tree" agrees teapot axis auto nearest
tap_check "by scan lines: teapot, clusters" agrees teapot clusters auto scanline
tap_check "by scan lines: knot, BSP tree" agrees knot bsp auto scanline
tap_check "by scan lines: rooms, BSP tree" agrees rooms bsp auto scanline
tap_done
