# SPDX-License-Identifier: MIT
#
# The fixed-point vectors on emulated Cortex-M0 and Cortex-M4 give what they give on the host, to the
# letter. (The Cortex-M0+ runs the M0's instructions; QEMU's M0 refuses any other.)
. tests/tap.sh
. tests/arm/arm.sh

run_on_host() { # PROFILE
    # shellcheck disable=SC2086 # flags are words
    $CC -std=c11 -O2 $WARNINGS -Ifirmware -Ihal -DLIM_PROFILE="LIM_PROFILE_$1" -o "$work/host" \
        tests/arm/host.c tests/arm/fixed_main.c tests/fixed_vectors.c firmware/*.c &&
        "$work/host" >"$work/host-$1.txt" && [ -s "$work/host-$1.txt" ]
}

run_on_arm() { # PROFILE MACHINE
    arm_link "$2" "$work/$2.elf" -DLIM_PROFILE="LIM_PROFILE_$1" tests/arm/fixed_main.c tests/fixed_vectors.c \
        firmware/*.c || return 1
    if ! arm_run "$2" "$work/$2.elf" >"$work/$2.txt"; then
        tail -n 3 "$work/$2.txt"
        return 1
    fi
    diff "$work/host-$1.txt" "$work/$2.txt"
}

for profile in FAST FINE; do
    tap_check "$profile: the fixed-point vectors hold on the host" run_on_host $profile
    tap_check "$profile: Cortex-M0 gives what the host gives" run_on_arm $profile m0
    tap_check "$profile: Cortex-M4 gives what the host gives" run_on_arm $profile m4
done
tap_done
