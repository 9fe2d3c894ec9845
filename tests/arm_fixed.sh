# SPDX-License-Identifier: MIT
#
# The fixed-point vectors on emulated Cortex-M0 and Cortex-M4 give what they give on the host, to the
# letter. (The Cortex-M0+ runs the M0's instructions; QEMU's M0 refuses any other.)
. tests/tap.sh
. tests/arm/arm.sh

run_on_host() {
    # shellcheck disable=SC2086 # flags are words
    $CC -std=c11 -O2 $WARNINGS -Ifirmware -Ihal -o "$work/host" \
        tests/arm/host.c tests/arm/fixed_main.c tests/fixed_vectors.c firmware/*.c &&
        "$work/host" >"$work/host.txt" && [ -s "$work/host.txt" ]
}

run_on_arm() { # MACHINE
    arm_link "$1" "$work/$1.elf" tests/arm/fixed_main.c tests/fixed_vectors.c firmware/*.c || return 1
    if ! arm_run "$1" "$work/$1.elf" >"$work/$1.txt"; then
        tail -n 3 "$work/$1.txt"
        return 1
    fi
    diff "$work/host.txt" "$work/$1.txt"
}

tap_check "the fixed-point vectors hold on the host" run_on_host
tap_check "Cortex-M0 gives what the host gives" run_on_arm m0
tap_check "Cortex-M4 gives what the host gives" run_on_arm m4
tap_done
