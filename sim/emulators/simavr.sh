# SPDX-License-Identifier: MIT
#
# Runs an Arduboy's image in simavr, with simavr's own display:
#   sh sim/emulators/simavr.sh BUILD IMAGE FRAMES PICTURES CHECK COMMAND...
# What that display showed goes to PICTURES/000.png and so on, and must be the frames whose hashes the file CHECK has;
# what went over its wires is the command's standard input (limner decode - ...), whose exit status this has. Beside it
# prints the frames' cycles, and how deep the stack was.
set -eu

build=$1 image=$2 frames=$3 pictures=$4 check=$5
shift 5

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
timeout -k 5 "${EMULATE_S:-120}" "$build/simavr_oled" "$image" "$frames" "$pictures/%03d.png" "$work/wires" \
    >"$work/said" 2>"$work/complaints" || {
    cat "$work/complaints" >&2
    exit 1
}
grep '^# ' "$work/said"
i=0
while [ "$i" -lt "$frames" ]; do
    printf '%s/%03d.png\n' "$pictures" "$i"
    i=$((i + 1))
done >"$work/list"
# shellcheck disable=SC2046 # a list of files
"$build/limner" hashes $(cat "$work/list") --check "$check" >"$work/hashes" || {
    cat "$work/hashes"
    exit 1
}
"$@" <"$work/wires"
