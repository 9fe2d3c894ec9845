# SPDX-License-Identifier: MIT
#
# What a text over each frame costs on emulated processors, 240x240 pixels: `frame N`, on a box. The images draw what the
# simulator draws, or there is no figure.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

figures() { # OPTION...: instructions a frame and bytes of code, on both processors
    "$BUILD/limner" measure sim/scenes/rooms.obj --camera "$work/walk.cam" --precision fast --core m0plus,m4 -o "$work/measured" \
        "$@" >/dev/null &&
        awk -F '|' '/instructions a frame/ { on = 1 } on && $2 ~ /fast/ { printf " %d | %d |", $4, $10; on = 0 }' \
            "$work/measured/measure.md"
}

grep -v '^#' sim/scenes/rooms-walk.cam | head -n 60 >"$work/walk.cam"
echo '| rooms, walk | Cortex-M0+, instructions a frame | code at -O2, bytes | Cortex-M4F, instructions a frame | code at -O2, bytes |'
echo '|---|---|---|---|---|'
echo "| plain |$(figures)"
echo "| with \`frame N\` over it |$(figures --overlay)"
