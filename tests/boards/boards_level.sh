# SPDX-License-Identifier: MIT
#
# Maps of Freedoom on boards. E1M1, textured, in rp2040js: from a UF2 file that fits a Pico, and its buttons walk until walls stop
# them; without textures on an LM3S6965, and the smallest map in the 64 KB of flash that a Blue Pill has for certain. Every pixel is
# the simulator's.
. tests/tap.sh

board() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$BUILD" BOARDS="$kept/boards" PICTURES="$work/pictures" "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

draws() { # FRAMES MAKE-ARGUMENT...
    frames=$1
    shift
    board emulate N="$frames" "$@" && cat "$work/said" && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq "$frames" ]
}

level=freedoom1.wad:E1M1
image=$kept/boards/pico/freedoom1-E1M1-st7789-fast/image

# -- The demo ------------------------------------------------------------------------------------------------------------

fits_a_pico() {
    board BOARD=pico SCENE=$level image && cat "$work/said" && grep '^  flash .* of 2097152 bytes, [0-9]* left' "$work/said" &&
        grep '^  frames  two renderers' "$work/said" && [ -s "$image.uf2" ]
}

# What is said of a path, when there is none in sim/scenes.
walks_where_no_path_is_kept() {
    board BOARD=pico SCENE=freedoom1.wad:E2M8 "$kept/boards/pico/freedoom1-E2M8-st7789-fast/cameras.h" &&
        grep 'CAMERAS_COUNT 256' "$kept/boards/pico/freedoom1-E2M8-st7789-fast/cameras.h"
}

# The path that is kept is the walk.
path_is_the_walk() {
    "$BUILD/limner" walk /usr/share/games/doom/$level -o "$work/walk.cam" && cmp "$work/walk.cam" sim/scenes/freedoom1-E1M1.cam
}

# -- Buttons -------------------------------------------------------------------------------------------------------------

# Left three times, back into the wall behind, forward again while turning right. A camera is announced a frame ahead, so that what is
# pressed when n frames were shown counts for frame n + 1.
presses='--press 12=1-4 --press 15=4-12 --press 14=12-20 --press 13=12-14'
buttons='0 0 4 4 4 2 2 2 2 2 2 2 2 9 9 1 1 1 1 1'

frames_of() { # FILE: of walked
    # shellcheck disable=SC2086 # numbers are words
    printf '%s\n' $buttons | "$BUILD/tests/boards/walked_level" /usr/share/games/doom/$level \
        --camera sim/scenes/freedoom1-E1M1.cam --size 240x240 --panel st7789 >"$1"
}

walks() {
    frames_of "$work/walked" && board BOARD=pico SCENE=$level image &&
        sh sim/emulators/rp2040.sh "$image" 20 "--pin dc=16 --pin cs=17 --pin reset=22 --pin led=25 --pin backlight=20 $presses" \
            "$BUILD/limner" decode - --panel st7789 --size 240x240 --frames 20 --write-hashes "$work/drawn" &&
        [ "$(wc -l <"$work/drawn")" -eq 20 ] && diff "$work/walked" "$work/drawn"
}

# Two frames of the path, then others; and from the wall on others than who passes through it sees.
walls_stop_it() {
    head -n 2 "${image%/*}/golden" >"$work/path" && head -n 2 "$work/drawn" | cmp - "$work/path" &&
        WALLS=no frames_of "$work/through" &&
        diff "$work/drawn" "$work/through" | sed -n 's/^< //p' >"$work/stopped" && cat "$work/stopped" &&
        awk '$1 < 7 { early = 1 } { last = $1; n++ } END { exit early || n < 10 || last != 19 }' "$work/stopped"
}

# -- What is asked for ---------------------------------------------------------------------------------------------------

# Where the package is missing it is named, and nothing else happens.
asks_for_freedoom() {
    mkdir -p "$work/bin" && printf '#!/bin/sh\nexit 0\n' >"$work/bin/dpkg-query" && chmod +x "$work/bin/dpkg-query" &&
        ! PATH="$work/bin:$PATH" make DEPS=no BUILD="$work/build" CCACHE= BOARD=pico SCENE=$level >"$work/said" 2>&1 &&
        cat "$work/said" && grep 'missing packages: .*freedoom' "$work/said" &&
        grep 'DEPS=no, so nothing is installed; to install them.*: apt-get install .*freedoom' "$work/said"
}

refuses() { # SCENE PATTERN
    ! board BOARD=pico SCENE="$1" image && grep "$2" "$work/said"
}

needs_no_package_for_a_file_of_yours() {
    cp /usr/share/games/doom/freedoom1.wad "$work/mine.wad" &&
        make -n BOARD=pico SCENE="$work/mine.wad:E1M1" BUILD="$BUILD" 2>&1 | grep setup.sh >"$work/said" && cat "$work/said" &&
        ! grep freedoom "$work/said"
}

if sh sim/emulators/npm.sh >/dev/null 2>"$work/npm"; then
    tap_check "E1M1, textured and lit, fits a Pico, with two renderers" fits_a_pico
    tap_check "its frames are the simulator's" draws 4 BOARD=pico SCENE=$level
    tap_check "buttons walk through it as in the simulator" walks
    tap_check "walls stop who walks" walls_stop_it
else
    tap_skip "E1M1 on a Pico" "$(tail -n 1 "$work/npm")"
fi
tap_check "its path is what limner walk finds" path_is_the_walk
tap_check "a map without a path is walked through" walks_where_no_path_is_kept
tap_check "E1M1 in flat colours on an LM3S6965" draws 8 BOARD=lm3s6965evb SCENE=$level COMPILE='--fill --no-textures'
tap_check "a map in flat colours in 64 KB of flash" draws 8 BOARD=bluepill FLASH_B=65536 SCENE=freedoom1.wad:E2M8 COMPILE=--no-textures
tap_check "Freedoom is a package that is asked for" asks_for_freedoom
tap_check "but not for a WAD of yours" needs_no_package_for_a_file_of_yours
tap_check "a WAD that is nowhere is refused" refuses nix.wad:E1M1 'there is no /usr/share/games/doom/nix.wad'
tap_check "a map that is not there is refused" refuses freedoom1.wad:E9M9 'E9M9'
tap_done
