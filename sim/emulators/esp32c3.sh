# SPDX-License-Identifier: MIT
#
# Runs the image of an ESP32-C3 on the project's chip with Unicorn's processor, and gives what went over its display's
# wires to a command, as a wire log on its standard input:
#   sh sim/emulators/esp32c3.sh BUILD IMAGE FRAMES MAP 'OPTION VALUE ...' 'DRIVER.o ...' COMMAND...
# IMAGE is without ending, .elf and .esp. Options are those of esp32c3.c; drivers are the objects whose instructions are
# not the picture's. Prints what the command does, then what each frame took; every rule that was broken is a line on
# standard error. Fails where one was, as the command does, or when the frames do not come in $EMULATE_S seconds (120).
set -eu

build=$1 image=$2 frames=$3 map=$4 options=$5 drivers=$6
shift 6

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
status=0
# shellcheck disable=SC2086 # drivers and options are words
{
    sh sim/emulators/ranges.sh "$image.elf" $drivers >"$work/ranges"
    timeout -k 5 "${EMULATE_S:-120}" "$build/esp32c3" "$image.esp" "$frames" "$map" "$work/ranges" "$work/wires" $options \
        >"$work/said" || status=$?
}
"$@" <"$work/wires" || status=$?
cat "$work/said"
exit "$status"
