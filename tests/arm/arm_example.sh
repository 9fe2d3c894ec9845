# SPDX-License-Identifier: MIT
#
# The program in README (tests/example) draws on emulated Cortex-M, pixel for pixel, what it draws on
# the host: on an M4 with the memory that the scene asks for, on an M0 with what its 16 KB leave.
. tests/tap.sh
. sim/targets/targets.sh
. tests/example/example.sh

compile_scene() {
    "$BUILD/limner" compile sim/scenes/teapot.obj -o "$work/teapot" >"$work/report"
}

link_example() { # CORE BYTES; BYTES of memory, or what the scene asks for
    example_with_memory "$1" "$2" || return 1
    target_link "$1" "$work/$1" -DLIM_CONFIG='"teapot.h"' -DLIM_MAX_SIDE_PX=240 -Itests/example -I"$work" \
        "$work/$1.c" tests/example/display_hash.c "$work/teapot.c" \
        firmware/*.c firmware/*/*.c
}

run_on_host() {
    link_example host all && target_run host "$work/host" >"$work/host.txt" && [ "$(wc -l <"$work/host.txt")" -eq 3 ]
}

run_on_arm() { # CORE BYTES
    link_example "$@" || return 1
    target_run "$1" "$work/$1" >"$work/$1.txt" || {
        tail -n 3 "$work/$1.txt"
        return 1
    }
    diff "$work/host.txt" "$work/$1.txt"
}

# The report's bytes are those of the image's array.
report_is_right() {
    reported=$(awk '/working memory, bytes/ { print $NF }' "$work/report")
    linked=$((0x$(arm-none-eabi-nm -S "$work/m4" | awk '$4 == "mem" { print $2 }')))
    echo "reported $reported bytes, linked $linked"
    [ "$reported" -eq "$linked" ]
}

tap_check "the teapot compiles to C" compile_scene
tap_check "the example runs on the host" run_on_host
tap_check "Cortex-M4 draws what the host draws" run_on_arm m4 all
tap_check "Cortex-M0 draws it with 8 KB of memory" run_on_arm microbit 8192
tap_check "the compiler's report tells the memory that the image has" report_is_right
tap_done
