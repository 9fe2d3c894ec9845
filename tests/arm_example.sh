# SPDX-License-Identifier: MIT
#
# The example of a firmware (tests/example) draws on emulated Cortex-M, pixel for pixel, what it draws on
# the host: on an M4 with the memory that the scene asks for, on an M0 with what its 16 KB leave.
. tests/tap.sh
. tests/arm/arm.sh

compile_scene() {
    "$BUILD/limner" compile sim/scenes/teapot.obj -o "$work/teapot" >"$work/report"
}

run_on_host() {
    # shellcheck disable=SC2086 # flags are words
    $CC -std=c11 -O2 $WARNINGS -DLIM_CONFIG='"teapot.h"' -Ifirmware -I"$work" -o "$work/host" \
        tests/example/*.c tests/arm/host.c "$work/teapot.c" firmware/*.c &&
        "$work/host" >"$work/host.txt" && [ "$(wc -l <"$work/host.txt")" -eq 3 ]
}

run_on_arm() { # MACHINE FLAG...
    machine=$1
    shift
    arm_link "$machine" "$work/$machine.elf" "$@" -DLIM_CONFIG='"teapot.h"' -DLIM_MAX_SIDE_PX=240 -I"$work" \
        tests/example/*.c "$work/teapot.c" firmware/*.c || return 1
    arm_run "$machine" "$work/$machine.elf" >"$work/$machine.txt" || {
        tail -n 3 "$work/$machine.txt"
        return 1
    }
    diff "$work/host.txt" "$work/$machine.txt"
}

# The report's bytes are those of the image's array.
report_is_right() {
    reported=$(awk '/working memory, bytes/ { print $NF }' "$work/report")
    linked=$((0x$(arm-none-eabi-nm -S "$work/m4.elf" | awk '$4 == "mem" { print $2 }')))
    echo "reported $reported bytes, linked $linked"
    [ "$reported" -eq "$linked" ]
}

tap_check "the teapot compiles to C" compile_scene
tap_check "the example runs on the host" run_on_host
tap_check "Cortex-M4 draws what the host draws" run_on_arm m4
tap_check "Cortex-M0 draws it with 8 KB of memory" run_on_arm m0 -DMEM_B=8192
tap_check "the compiler's report tells the memory that the image has" report_is_right
tap_done
