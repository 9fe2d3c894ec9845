# SPDX-License-Identifier: MIT
#
# The program in README (tests/example) builds as README says, and its frames do not depend on how wide the build's screen
# arithmetic is, nor on how much memory it is given.
. tests/tap.sh
. tests/example/example.sh

# README shows what is compiled here, in at most 20 lines of C, which are C++ as well.
readme_shows_it() {
    sed -n '/^```c$/,/^```$/p' README.md | sed '1d; $d' >"$work/shown.c"
    sed '/SPDX-License-Identifier/d' tests/example/main.c | diff "$work/shown.c" - && [ "$(grep -c . "$work/shown.c")" -le 20 ]
}

compile_scene() {
    "$BUILD/limner" compile sim/scenes/teapot.obj -o "$work/teapot"
}

# It reads eleven headers at most: the scene's, limner.h, and those in that.
reads_few_headers() {
    "$CC" -std=c11 -H -fsyntax-only -Ifirmware -Itests/example -I"$work" tests/example/main.c 2>&1 | awk '$1 ~ /^\.+$/ && $2 !~ /^\/usr/' >"$work/read"
    grep -v ' tests/example/' "$work/read" | sed 's/^\.* //' | sort -u >"$work/headers"
    cat "$work/headers"
    grep -qx firmware/stages.h "$work/headers" && [ "$(wc -l <"$work/headers")" -le 11 ] &&
        awk 'length($1) > 6 { exit 1 }' "$work/read"
}

build() { # NAME BYTES FLAG...; BYTES of memory, or what the scene asks for
    name=$1
    mem_b=$2
    shift 2
    example_with_memory "$name" "$mem_b" && example_main "$CC" "$name" c11 "$@" || return 1
    # shellcheck disable=SC2086 # flags are words
    $CC -std=c11 -O2 $WARNINGS "$@" -DLIM_CONFIG='"teapot.h"' -Ifirmware -Itests/example -Isim/targets -I"$work" -o "$work/$name" \
        "$work/$name.o" tests/example/display_hash.c sim/targets/start_host.c "$work/teapot.c" firmware/*.c firmware/*/*.c
}

# Three frames; neither nothing nor everything is painted.
shows_a_teapot() { # NAME BYTES FLAG...
    build "$@" && "$work/$1" >"$work/$1.txt" || return 1
    cat "$work/$1.txt"
    awk '{ painted = $4 } END { exit !(NR == 3 && painted > 5000 && painted < 240 * 240 * 3 / 2) }' "$work/$1.txt"
}

same_frames() { # NAME BYTES FLAG...
    shows_a_teapot "$@" && diff "$work/narrow.txt" "$work/$1.txt"
}

refuses() { # NAME BYTES FLAG...
    build "$@" || return 1
    "$work/$1" >"$work/$1.txt"
    [ $? -eq 1 ] && [ ! -s "$work/$1.txt" ]
}

tap_check "the program in README is the one that is tested, of 20 lines at most" readme_shows_it
tap_check "the teapot compiles to C" compile_scene
tap_check "the program reads eleven headers" reads_few_headers
tap_check "the example shows it on a display of 240 pixels" shows_a_teapot narrow all -DLIM_MAX_SIDE_PX=240
tap_check "a build for 1024 pixels draws the same frames" same_frames wide all -DLIM_MAX_SIDE_PX=1024
tap_check "so does one without counters and painter" same_frames bare all -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_STATS=0 \
    -DLIM_HAS_PAINTER=0
tap_check "so does one with 8 KB of memory" same_frames small 8192 -DLIM_MAX_SIDE_PX=240
tap_check "2 KB of memory are refused" refuses smaller 2048 -DLIM_MAX_SIDE_PX=240
tap_done
