# SPDX-License-Identifier: MIT
#
# --rotate of `limner render` and `view`: --size is that of the upright glass, as play and module have it, and the picture
# is turned on it. Refusals of a size name it where it helps.
. tests/tap.sh

limner=$PWD/$BUILD/limner
scene=$PWD/sim/scenes/teapot.obj
cd "$work" || exit 1

# The sides of a PNG file, as its header has them: big-endian words from byte 16 on.
sides() { od -A n -t u1 -j 16 -N 8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'; }

draws() { # SIDES ARGUMENT...: so large a picture, as memory of that size shows it
    wanted=$1
    shift
    "$limner" render "$scene" "$@" -o turned.png --write-hashes turned && [ "$(sides turned.png)" = "$wanted" ] || return 1
    "$limner" render "$scene" --panel memory --size "$wanted" -o plain.png --check turned
}

refuses() { # PATTERN ARGUMENT...
    pattern=$1
    shift
    ! "$limner" "$@" >out 2>err && [ ! -s out ] && [ "$(wc -l <err)" -eq 1 ] && grep -qE -- "$pattern" err || { cat err && return 1; }
}

for panel in ili9341 st7796 ssd1351; do
    tap_check "$panel: a picture by 90 degrees lies on glass that stands" draws 96x64 --panel $panel --size 64x96 --rotate 90
    tap_check "$panel: by 270 as well" draws 96x64 --panel $panel --size 64x96 --rotate 270
    tap_check "$panel: by 180 it keeps its sides" draws 64x96 --panel $panel --size 64x96 --rotate 180
done
tap_check "a panel's usual glass is turned, too" draws 320x240 --panel ili9341 --rotate 90
tap_check "without a panel the picture's sides are exchanged" draws 96x64 --size 64x96 --rotate 90
tap_check "so they are where no chip is so large" draws 900x500 --size 500x900 --rotate 90
tap_check "memory takes it" draws 96x64 --panel memory --size 64x96 --rotate 90
tap_check "the order of options is nobody's concern" draws 96x64 --rotate 90 --size 64x96 --panel ili9341
tap_check "a picture that lies needs no --rotate to be drawn" draws 320x240 --panel ili9341 --size 320x240
tap_check "glass must stand to be turned" refuses '320x240 pixels do not fit into its memory of 240x320; --size 240x320 --rotate 90 draws' \
    render "$scene" --panel ili9341 --size 320x240 --rotate 180
tap_check "a module's refusal names --rotate" refuses '^limner: --panel ili9341: 320x240 pixels do not fit into its memory of 240x320; --size 240x320 --rotate 90 draws a lying picture$' \
    module --panel ili9341 --size 320x240 -o display
tap_check "where that does not fit either it does not" refuses 'do not fit into its memory of 240x320$' module --panel ili9341 --size 400x240 -o display
tap_check "nor where the chip turns nothing" refuses 'do not fit into its memory of 128x64$' module --panel ssd1306 --size 64x128 -o display
tap_check "a chip that turns nothing says what does" refuses '^limner: --rotate: ssd1306 turns no pictures so, .*--panel memory' \
    render "$scene" --panel ssd1306 --rotate 90 -o x.png
tap_check "other angles are refused" refuses '^limner: --rotate 45: must be 0, 90, 180 or 270 degrees' render "$scene" --rotate 45 -o x.png
tap_check "view takes it" refuses '^limner: --rotate 45: must be' view "$scene" --rotate 45
tap_done
