# SPDX-License-Identifier: MIT
#
# Builds and runs bare test images for Cortex-M, for scripts to source: arm_link, arm_run.
# Of two machines: m0 (Cortex-M0 of a micro:bit, 16 KB of RAM) and m4 (Cortex-M4, 4 MB).
# shellcheck shell=sh

arm_cpu() {
    case $1 in
    m0) echo cortex-m0 ;;
    m4) echo cortex-m4 ;;
    esac
}

# arm_link MACHINE IMAGE SOURCE...: compiles the sources with the start-up code into an ELF image.
arm_link() {
    arm_machine=$1 arm_image=$2
    shift 2
    # shellcheck disable=SC2086 # flags are words
    arm-none-eabi-gcc -std=c11 -O2 $WARNINGS -mcpu="$(arm_cpu "$arm_machine")" -mthumb -mfloat-abi=soft \
        -ffreestanding -fno-tree-loop-distribute-patterns -ffunction-sections -fdata-sections \
        -Ifirmware -Ihal -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings -Wl,--no-warn-rwx-segments \
        -Ltests/arm -T "tests/arm/$arm_machine.ld" -o "$arm_image" tests/arm/start.c "$@" -lgcc
}

# arm_run MACHINE IMAGE: runs it; its output and exit status become ours. Ends after two minutes.
arm_run() {
    case $1 in
    m0) set -- microbit "$2" ;;
    m4) set -- mps2-an386 "$2" ;;
    esac
    timeout -k 5 120 qemu-system-arm -M "$1" -kernel "$2" -nodefaults -nic none -display none -serial none \
        -monitor none -chardev stdio,id=host -semihosting-config enable=on,target=native,chardev=host </dev/null
}
