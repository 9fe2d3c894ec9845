# SPDX-License-Identifier: MIT
#
# Where in an image a frame begins and ends (the marks of boards/common/app_scene.c), and where its drivers are, a line
# each: sh sim/emulators/ranges.sh ELF OBJECT... The objects are those of drivers, built with gcc's call graph beside
# them. Of the environment: TOOLS.
set -eu

elf=$1
shift
[ $# -gt 0 ] || { echo "ranges: no drivers were named" >&2; exit 1; }
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
    done
