# SPDX-License-Identifier: MIT
#
# The program in README (tests/example) draws on emulated Cortex-M, pixel for pixel, what it draws on
# the host: on M0+ and M4 with the memory that the scene asks for, on an M0 with what its 16 KB leave; in C and in C++.
. tests/tap.sh
. sim/targets/targets.sh
. tests/example/example.sh

compile_scene() {
    "$BUILD/limner" compile sim/scenes/teapot.obj -o "$work/teapot" --report >"$work/report"
}

run_on_host() {
    example_link host all && target_run host "$work/host" >"$work/host.txt" && [ "$(wc -l <"$work/host.txt")" -eq 3 ]
}

run_on_arm() { # CORE BYTES [STANDARD]
    example_link "$@" || return 1
    target_run "$1" "$work/$1" >"$work/$1.txt" || {
        tail -n 3 "$work/$1.txt"
        return 1
    }
    diff "$work/host.txt" "$work/$1.txt"
}

# The report's bytes are those of the image's block, beside struct lim, struct lim_sender and the line.
report_is_right() {
    reported=$(awk '/working memory, bytes/ { print $NF }' "$work/report")
    printf '#include "teapot.h"\nchar others[sizeof(struct lim) + sizeof(struct lim_sender) + 480];\n' >"$work/others.c"
    target_compile m4 "$work/others.o" "$work/others.c" -I"$work" -DLIM_MAX_SIDE_PX=240 || return 1
    block=$(bytes_of "$work/m4" teapot_memory_block) others=$(bytes_of "$work/others.o" others)
    echo "reported $reported bytes, linked $block of which $others are not meant"
    [ "$reported" -eq $((block - others)) ]
}

bytes_of() { # FILE SYMBOL
    echo $((0x$(arm-none-eabi-nm -S "$1" | awk -v symbol="$2" '$4 == symbol { print $2 }')))
}

# Degrees and metres are the compiler's affair.
computes_in_integers() {
    arm-none-eabi-nm "$work/m0plus" | awk '{ print $NF }' >"$work/symbols"
    grep -qx lim_orbit "$work/symbols" && ! grep -E '^__aeabi_(d|f|i2d|i2f|ui2|l2|ul2)|^__[a-z]*[sd]f[0-9]' "$work/symbols"
}

tap_check "the teapot compiles to C" compile_scene
tap_check "the example runs on the host" run_on_host
tap_check "Cortex-M4 draws what the host draws" run_on_arm m4 all
tap_check "so does Cortex-M0+" run_on_arm m0plus all
tap_check "in integers" computes_in_integers
tap_check "so does Cortex-M0+ with the same file in C++" run_on_arm m0plus all c++11
tap_check "Cortex-M0 draws it with 8 KB of memory" run_on_arm microbit 8192
tap_check "the compiler's report tells the memory that the image has" report_is_right
tap_done
