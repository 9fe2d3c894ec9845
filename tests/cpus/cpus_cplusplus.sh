# SPDX-License-Identifier: MIT
#
# A firmware with a main file in C++ (tests/cplusplus/main.cpp) links with the renderer in C, and paints the pixels of
# `limner render`. Its own file is compiled without LIM_CONFIG. README's program is C++ as well as C.
. tests/tap.sh
. sim/targets/targets.sh
. tests/example/example.sh

render_expected() {
    awk '!/^#/ && NF && n++ % 20 == 0' sim/scenes/teapot.cam | head -n 3 >"$work/few.cam"
    "$BUILD/limner" compile sim/scenes/teapot.obj --size 80x60 -o "$work/model" >/dev/null &&
        "$BUILD/limner" render "$work/model.lim" --camera "$work/few.cam" --size 80x60 --write-hashes "$work/expected" \
            --write-cameras "$work/cameras.h" && [ "$(cut -d ' ' -f 2 "$work/expected" | sort -u | wc -l)" -eq 3 ]
}

links_and_paints() { # CORE STANDARD [FLAG...]
    core=$1 standard=$2
    shift 2
    # shellcheck disable=SC2046 # flags are words
    "$(example_cplusplus "$(target_compiler "$core")")" $(target_flags "$core" | sed 's/-std=[^ ]*//') "-std=$standard" -O2 -Wall -Wextra -pedantic -Werror \
        -ffreestanding -fno-exceptions -fno-rtti -ffunction-sections -fdata-sections -Ifirmware -Isim/targets -I"$work" "$@" \
        -c -o "$work/main.o" tests/cplusplus/main.cpp &&
        target_link "$core" "$work/image" -I"$work" -DLIM_CONFIG='"model.h"' "$work/main.o" "$work/model.c" firmware/*.c firmware/*/*.c &&
        target_run "$core" "$work/image" >"$work/frames" && diff "$work/expected" "$work/frames"
}

example_in_c() {
    "$BUILD/limner" compile sim/scenes/teapot.obj -o "$work/teapot" >/dev/null && example_link host all &&
        target_run host "$work/host" >"$work/host.txt" && [ "$(wc -l <"$work/host.txt")" -eq 3 ]
}

example_in_cplusplus() { # STANDARD
    example_link host all "$1" && target_run host "$work/host" >"$work/frames" && diff "$work/host.txt" "$work/frames"
}

tap_check "the host renders three frames of the teapot" render_expected
for standard in c++11 c++20; do
    tap_check "host: a main file of $standard draws them, too" links_and_paints host "$standard"
done
tap_check "host: README's program draws three frames" example_in_c
for standard in c++11 c++20; do
    tap_check "host: the same file in $standard draws them, too" example_in_cplusplus "$standard"
done
tap_check "m0plus: so does one of c++17" links_and_paints m0plus c++17
tap_check "m33: so does one of c++20" links_and_paints m33 c++20
tap_check "rv32: so does one of c++14" links_and_paints rv32 c++14
tap_check "avr: so does one of c++11, with 8 KB of memory" links_and_paints avr c++11 -DMEM_B=8192
tap_done
