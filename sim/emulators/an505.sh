# SPDX-License-Identifier: MIT
#
# Runs the code of an image for a Cortex-M33, whose chip no emulator has, in QEMU's mps2-an505, and gives what its display
# would get to a command, as a wire log on its standard input:
#   sh sim/emulators/an505.sh IMAGE FRAMES 'COMPILER FLAG...' 'OBJECT...' COMMAND...
# The objects are the image's, but for those that know the chip, in whose place comes an505_board.c (IMAGE.an505.o). They are
# linked for another memory, into IMAGE.an505.elf. Fails as the command does, or when the frames do not come.
set -eu
: "${WARNINGS:=-Wall}"
. sim/targets/targets.sh

image=$1 frames=$2 compiler=$3 objects=$4
shift 4

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

rm -f "$image.an505.elf" # of an earlier run
# shellcheck disable=SC2086 # flags are words
$compiler -Isim -DFRAMES="$frames" -c -o "$image.an505.o" sim/emulators/an505_board.c
# shellcheck disable=SC2086 # and objects, or patterns
$compiler -nostdlib -Lboards/common -T sim/targets/an505.ld -Wl,--gc-sections -Wl,--fatal-warnings \
    -Wl,--no-warn-rwx-segments -o "$image.an505.elf" "$image.an505.o" $objects -lgcc
echo "emulate: no emulator has this chip: the image's code runs on the same core, without drivers of pins, SPI and clocks"
target_run m33 "$image.an505.elf" >"$work/wires" || { echo "emulate: it did not come to $frames frames" >&2; exit 1; }
"$@" <"$work/wires"
