# SPDX-License-Identifier: MIT
#
# Runs an image in QEMU and gives every write to a device's register to a command, as lines on its standard input:
#   sh sim/emulators/qemu.sh SYSTEM MACHINE IMAGE COMMAND...       arm netduinoplus2 image.elf limner decode - ...
# Ends with the command, whose exit status it has, or after $EMULATE_S seconds (120), when the lines end. An
# instruction takes a nanosecond of the machine's time, so that every run is the same.
set -eu

system=$1 machine=$2 image=$3
shift 3

command -v "qemu-system-$system" >/dev/null || {
    echo "qemu.sh: qemu-system-$system is missing; Debian's packages: qemu-system-arm, qemu-system-misc" >&2
    exit 1
}
work=$(mktemp -d)
qemu=
finish() {
    [ -z "$qemu" ] || kill "$qemu" 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT
trap 'exit 1' INT TERM
mkfifo "$work/trace"

timeout -k 5 "${EMULATE_S:-120}" "qemu-system-$system" -M "$machine" -kernel "$image" -nodefaults -display none \
    -serial none -monitor none -icount shift=0 -trace memory_region_ops_write -D /proc/self/fd/1 \
    </dev/null >"$work/trace" 2>"$work/said" &
qemu=$!
status=0
"$@" <"$work/trace" || status=$?
[ "$status" -eq 0 ] || cat "$work/said" >&2
exit "$status"
