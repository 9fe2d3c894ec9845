# SPDX-License-Identifier: MIT
#
# Runs an RP2040's image in rp2040js until it has shown some frames, and gives what went over its display's wires to a
# command, as a wire log on its standard input:
#   sh sim/emulators/rp2040.sh IMAGE FRAMES 'OPTION...' COMMAND...
#   sh sim/emulators/rp2040.sh build/.../image 8 '--pin dc=16 --pin led=25' build/limner decode - ...
# IMAGE is without ending, .elf and .uf2. Options are those of rp2040.mjs. Prints what the command does, then what each
# frame took, and their mean. Fails as the command does, or when the frames do not come in $EMULATE_S seconds (120).
set -eu

image=$1 frames=$2 options=$3
shift 3

here=$(dirname "$0")
modules=$(sh "$here/npm.sh")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

"${TOOLS:-arm-none-eabi-}nm" "$image.elf" >"$work/symbols"
# shellcheck disable=SC2086 # options are words
timeout -k 5 "${EMULATE_S:-120}" node "$here/rp2040.mjs" "$modules" "$image.uf2" "$work/symbols" "$frames" $options \
    >"$work/wires"
"$@" <"$work/wires"
grep '^# ' "$work/wires"
