# SPDX-License-Identifier: MIT
#
# How firmware/config.h finds the scene's header: a limner_config.h in the compiler's folders takes the place of
# -DLIM_CONFIG, for the renderer, the scene and the program, in C and in C++; what it sets holds in all of them.
. tests/tap.sh
. sim/targets/targets.sh
. tests/example/example.sh

prepare() {
    awk '!/^#/ && NF && n++ % 11 == 0' sim/scenes/rooms.cam | head -n 4 >"$work/few.cam"
    "$BUILD/limner" compile sim/scenes/rooms.obj --size 80x60 -o "$work/model" >/dev/null &&
        "$BUILD/limner" render sim/scenes/rooms.obj --camera "$work/few.cam" --size 80x60 --write-hashes "$work/expected" \
            --write-cameras "$work/cameras.h" && cp tests/targets/begin.c "$work/begin.c" || return 1
    mkdir -p "$work/found"
    printf '#define LIM_HAS_STATS 1\n#include "model.h"\n' >"$work/found/limner_config.h"
}

program() { # CORE STANDARD FLAG...: its main file
    core=$1 standard=$2
    shift 2
    example_main_for "$core" begin "$standard" -Isim/targets "$@"
}

link() { # CORE FLAG...: that with the renderer and the scene
    core=$1
    shift
    target_link "$core" "$work/image" -I"$work" "$@" "$work/begin.o" "$work/model.c" firmware/*.c firmware/*/*.c
}

draws() { # CORE
    target_run "$1" "$work/image" >"$work/frames" && diff "$work/expected" "$work/frames"
}

found() { # CORE STANDARD FLAG...
    core=$1 standard=$2
    shift 2
    program "$core" "$standard" -I"$work/found" "$@" && link "$core" -I"$work/found" && draws "$core"
}

# In whatever order headers are included.
settings_hold() {
    for order in 'model.h limner.h' 'limner.h model.h' 'target.h model.h' 'model.h'; do
        {
            for header in $order; do echo "#include \"$header\""; done
            echo 'LIM_STATIC_ASSERT(LIM_HAS_STATS == 1 && LIM_HAS_PAINTER == 0 && LIM_MAX_SIDE_PX == 80, "");'
            echo 'int main(void) { return !model_scene.polygon_count; }'
        } >"$work/order.c"
        for settling in "$CC -std=c11" "$(example_cplusplus "$CC") -x c++ -std=c++11"; do
            # shellcheck disable=SC2086 # words
            $settling -Wall -Wextra -pedantic -Werror -fsyntax-only -Ifirmware -I"$work" -I"$work/found" "$work/order.c" || return 1
        done
    done
}

# What -D says comes before what is found.
named_is_stronger() {
    program host c11 '-DLIM_CONFIG="model.h"' -I"$work/found" && link host '-DLIM_CONFIG="model.h"' -I"$work/found" && draws host || return 1
    nm "$work/begin.o" >"$work/symbols"
    grep 'lim_begin' "$work/symbols" && ! grep 'lim_begin.*\.stats' "$work/symbols"
}

does_not_link() { # PATTERN FLAG...: the renderer; what the linker says
    pattern=$1
    shift
    link host "$@" 2>"$work/said" && return 1
    cat "$work/said"
    grep -q "undefined reference to .lim_begin\.needs_same_LIM_CONFIG$pattern" "$work/said"
}

# Whoever includes the scene's header has its needs; a renderer that nobody told of them has all features.
nothing_is_found() {
    program host c11 && does_not_link '.*\.80px'
}

one_part_finds_it() {
    program host c11 -I"$work/found" && does_not_link '.*\.80px.*\.stats' '-DLIM_CONFIG="model.h"'
}

# As if GCC knew no __has_include.
without_has_include() {
    printf '#include "limner.h"\nLIM_STATIC_ASSERT(LIM_MAX_SIDE_PX == SIDE_PX, "");\n' >"$work/side.c"
    set -- gcc -std=c11 -fsyntax-only -Ifirmware -I"$work" -I"$work/found" "$work/side.c"
    "$@" -DSIDE_PX=80 && "$@" -DSIDE_PX=1024 -U__has_include && "$@" -DSIDE_PX=80 -U__has_include '-DLIM_CONFIG="model.h"'
}

tap_check "rooms compile" prepare
tap_check "limner_config.h is found by all files, in C" found host c11
tap_check "and in C++" found host c++11
tap_check "m0plus: so it is in C++17" found m0plus c++17
tap_check "avr: so it is in C" found avr gnu11 -DMEM_B=8192
tap_check "avr: and in C++" found avr c++11 -DMEM_B=8192
tap_check "what it sets holds in whatever order headers come" settings_hold
tap_check "-DLIM_CONFIG is stronger" named_is_stronger
tap_check "with neither the renderer does not link, and it is said what it lacks" nothing_is_found
tap_check "nor does it if one part alone finds it" one_part_finds_it
tap_check "a compiler without __has_include takes -DLIM_CONFIG alone" without_has_include
tap_done
