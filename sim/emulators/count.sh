# SPDX-License-Identifier: MIT
#
# Counts the instructions of a board's image on the machine that QEMU has of it, between the marks of a frame in
# boards/common/main.c: sh sim/emulators/count.sh FRAMES PLUGIN ELF SYSTEM MACHINE OBJECT...
# The objects are those of drivers, built with gcc's call graph beside them. Prints the means of all frames: the
# instructions of a frame, and how many of them are the drivers', which wait for the bus (in QEMU it is always ready).
set -eu

frames=$1 plugin=$2 elf=$3 system=$4 machine=$5
shift 5
[ $# -gt 0 ] || { echo "count: no drivers were named" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for object; do
    sed -n 's/^node: { title: "\([^"]*:\)\{0,1\}\([A-Za-z0-9_.]*\)".*bytes (.*/\2/p' "${object%.o}.ci"
done | sort -u >"$work/drivers"

# Functions on Arm have an odd address by name only.
"${TOOLS}nm" -S "$elf" | sort | awk '
    NR == FNR { driver[$1]; next }
    $NF == "frame_begin" { print "begin " $1 }
    $NF == "frame_end" { print "end " $1 }
    NF == 4 && $3 ~ /[tT]/ && $4 in driver { print "range", $1, $2 }' "$work/drivers" - |
    while read -r kind start length; do
        [ "$kind" != range ] || printf 'range %x %x\n' "0x$start" $((0x$start + 0x$length))
        [ "$kind" = range ] || printf '%s %x\n' "$kind" "0x$start"
    done >"$work/ranges"

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
