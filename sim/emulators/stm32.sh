# SPDX-License-Identifier: MIT
#
# Runs the image of an STM32 on the project's chip with Unicorn's processor, and gives what went over its display's wires
# to a command, as a wire log on its standard input:
#   sh sim/emulators/stm32.sh BUILD f405|f103 IMAGE FRAMES MAP 'OPTION VALUE ...' COMMAND...
# Options are those of stm32.c. Prints what the command does, then the clocks and frames; every rule of the maker's
# manuals that was broken is a line on standard error. Fails where one was, as the command does, or when the frames do not
# come in $EMULATE_S seconds (120).
set -eu

build=$1 part=$2 image=$3 frames=$4 map=$5 options=$6
shift 6

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
status=0
# shellcheck disable=SC2086 # options are words
timeout -k 5 "${EMULATE_S:-120}" "$build/stm32" "$part" "$image" "$frames" "$map" "$work/wires" $options \
    >"$work/said" || status=$?
"$@" <"$work/wires" || status=$?
cat "$work/said"
exit "$status"
