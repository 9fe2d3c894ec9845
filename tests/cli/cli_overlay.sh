# SPDX-License-Identifier: MIT
#
# Text over frames on the command line: the pictures that were looked at; where only changes are sent the same ones, of
# every kind of scene; what a compiled scene's header says; and what is refused. How pictures with text come about from
# those without is in tests/unit/sim/test_caption.c.
. tests/tap.sh
. tests/scene_program.sh

golden=tests/golden/golden_overlay.expected

few() { # FILE EVERY: some cameras of a file, each twice
    awk -v every="$2" '!/^#/ && NF && n++ % every == 0 { print; print }' "$1" | head -n 10 >"$work/few.cam"
}

render() { # OPTION...
    "$BUILD/limner" render "$@" --camera "$work/few.cam"
}

is_golden() {
    few sim/scenes/rooms.cam 20
    render sim/scenes/rooms.obj --size 128x64 --overlay 'frame #: 24.3 [%]' --check $golden
}

# Each frame has another number, so another hash than without, and than the same view before it.
all_differ() {
    render sim/scenes/rooms.obj --size 96x72 --write-hashes "$work/plain" &&
        render sim/scenes/rooms.obj --size 96x72 --overlay '#' --write-hashes "$work/numbered" &&
        [ "$(cut -d ' ' -f 2 "$work/plain" "$work/numbered" | sort -u | wc -l)" -eq \
            $(($(cut -d ' ' -f 2 "$work/plain" | sort -u | wc -l) + $(wc -l <"$work/numbered"))) ]
}

same() { # MODEL OPTION...
    render "$@" --overlay 'frame #' --write-hashes "$work/whole" >/dev/null &&
        render "$@" --overlay 'frame #' --delta --check "$work/whole" &&
        render "$@" --overlay 'frame #' --delta=150 --check "$work/whole"
}

# A number of two characters that changes takes less than its box has.
changes_are_small() {
    yes '0.42 1.6 0 1.416802 1.520085 0' | head -n 4 >"$work/few.cam"
    render sim/scenes/rooms.obj --overlay 'number #' --delta --stats >"$work/said" || return 1
    awk '/sent_px/ { on = 1; next } on && $1 ~ /^[1-3]$/ { print; rows++; if ($2 < 1 || $2 > 6 * 8 || $3 > 2) wrong = 1 }
        END { exit rows != 3 || wrong }' "$work/said"
}

and_nothing_is_sent_if_it_stays() {
    render sim/scenes/rooms.obj --overlay 'no number' --delta --stats >"$work/said" &&
        awk '/sent_px/ { on = 1; next } on && $1 ~ /^[1-3]$/ { rows++; if ($2 || $3) wrong = 1 } END { exit rows != 3 || wrong }' \
            "$work/said"
}

is_in_films() {
    "$BUILD/limner" render sim/scenes/icosahedron.obj --size 64x48 --frames 3 --overlay '#' --gif "$work/a.gif" --sheet "$work/a.png" &&
        "$BUILD/limner" render sim/scenes/icosahedron.obj --size 64x48 --frames 3 --gif "$work/b.gif" --sheet "$work/b.png" &&
        ! cmp -s "$work/a.gif" "$work/b.gif" && ! cmp -s "$work/a.png" "$work/b.png"
}

header_says() { # 0|1 OPTION...
    flag=$1
    shift
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --size 64x64 "$@" -o "$work/solid" >/dev/null &&
        grep -qx "#define LIM_HAS_OVERLAY $flag" "$work/solid.h"
}

# Without the flag no file of it makes any code, whatever the linker drops.
takes_no_bytes() {
    header_says 0 || return 1
    for source in firmware/overlay.c firmware/text.c firmware/pixels/font.c firmware/lines/overlaid.c; do
        "$CC" -std=c11 -Os -DLIM_CONFIG='"solid.h"' -Ifirmware -I"$work" -c -o "$work/part.o" "$source" || return 1
        [ -z "$(nm --defined-only "$work/part.o")" ] || return 1
    done
}

# The program in README with the lines of firmware/README.md in it: its frames are others than without.
readme_draws() {
    "$BUILD/limner" compile sim/scenes/teapot.obj --overlay -o "$work/teapot" >/dev/null || return 1
    sed -n '/^## Text over/,/^## /p' firmware/README.md | sed -n '/^```c$/,/^```$/p' | sed '1d; $d' >"$work/lines.c"
    awk -v lines="$work/lines.c" '
        { print }
        /^static struct lim_camera/ { while ((getline line <lines) > 0) print line; print "static const int32_t frames_per_s_q8 = 6234;" }
        /teapot_begin\(/ { print "lim_set_overlay(teapot_memory.lim, &overlay);" }
        /^ *lim_orbit\(/ { print "lim_text_fixed(fps, frames_per_s_q8, 8, 1);" }' tests/example/main.c >"$work/main.c"
    grep -q 'lim_set_overlay(teapot_memory.lim, &overlay);' firmware/README.md &&
        grep -q 'lim_text_fixed(fps, frames_per_s_q8, 8, 1);' firmware/README.md || return 1
    for source in "$work/main.c" tests/example/main.c; do
        scene_program "$work/program" -DLIM_CONFIG='"teapot.h"' -Itests/example -Isim/targets "$source" tests/example/display_hash.c \
            sim/targets/start_host.c "$work/teapot.c" && "$work/program" || return 1
    done >"$work/frames"
    cat "$work/frames"
    [ "$(wc -l <"$work/frames")" -eq 6 ] && [ "$(sort -u "$work/frames" | wc -l)" -eq 6 ]
}

refused() { # WHAT TEXT
    ! "$BUILD/limner" render sim/scenes/icosahedron.obj --overlay "$2" -o "$work/none%d.png" >"$work/out" 2>"$work/said" &&
        cat "$work/said" && [ "$(wc -l <"$work/said")" -eq 1 ] && grep -q "^limner: --overlay: .*$1" "$work/said" &&
        ! ls "$work"/none* 2>/dev/null
}

tap_check "the picture is the one that was looked at" is_golden
tap_check "a # becomes the frame's number" all_differ
few sim/scenes/rooms-walk.cam 9
for panel in st7789 gc9a01 ssd1351; do
    tap_check "changes make the same pictures on $panel" same sim/scenes/rooms.obj --size 101x77 --panel $panel
done
tap_check "and on ssd1306" same sim/scenes/rooms.obj --size 96x64 --panel ssd1306
tap_check "and on ssd1327, smooth" same sim/scenes/rooms.obj --size 96x64 --panel ssd1327 --antialias
few "$BUILD/scenes/textured/textured.cam" 8
tap_check "and of textures" same "$BUILD/scenes/textured/textured.obj" --size 96x72
few sim/scenes/glass.cam 8
tap_check "and through glass" same sim/scenes/glass.obj --size 96x72
few sim/scenes/movers.cam 1
tap_check "and where things move" same sim/scenes/movers.gltf --size 96x72
tap_check "a number that changes is sent, and nothing else" changes_are_small
tap_check "a text that stays is not sent again" and_nothing_is_sent_if_it_stays
tap_check "films and sheets have it" is_in_films
tap_check "compile --overlay links it" header_says 1 --overlay
tap_check "else no file of it takes a byte" takes_no_bytes
tap_check "the lines in firmware/README.md draw over the example's frames" readme_draws
tap_check "a text that is empty is refused" refused '1 to 170 characters, not 0' ''
tap_check "so is one of 171 characters" refused 'not 171' "$(printf '%171s' '')"
tap_check "so is what the font has not" refused 'byte 195' "$(printf 'gr\303\274n')"
tap_done
