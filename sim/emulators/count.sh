# SPDX-License-Identifier: MIT
#
# Counts the instructions of a board's image on the machine that QEMU has of it, between the marks of a frame in
# boards/common/main.c: sh sim/emulators/count.sh FRAMES PLUGIN ELF SYSTEM MACHINE OBJECT...
# The objects are those of drivers, built with gcc's call graph beside them. Prints the means of all frames: the
# instructions of a frame, and how many of them are the drivers', which wait for the bus (in QEMU it is always ready).
set -eu

frames=$1 plugin=$2 elf=$3 system=$4 machine=$5
shift 5
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sh sim/emulators/ranges.sh "$elf" "$@" >"$work/ranges"

status=0
timeout -k 5 120 "qemu-system-$system" -M "$machine" -kernel "$elf" -nodefaults -display none -serial none \
    -monitor none -semihosting-config enable=on,target=native -icount shift=0 -plugin "$plugin,ranges=$work/ranges,out=$work/counts,frames=$frames" \
    </dev/null 2>"$work/said" || status=$?
if [ "$(tail -n 1 "$work/counts" 2>/dev/null)" != done ]; then
    echo "count: $elf: $machine did not draw $frames frames (exit status $status)" >&2
    head -n 3 "$work/said" >&2
    exit 1
fi
awk '/^frame/ {
        frames++
        for (i = 2; i <= NF; i++) all += $i
        for (i = 2; i <= NF - 2; i++) drivers += $i
    }
    END { printf "%d %d\n", all / frames, drivers / frames }' "$work/counts"
