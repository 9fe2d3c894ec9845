# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# The program of boards/linux on the tapped wires: so many frames as a wire log, and the record of all until SIGTERM has
# ended it, in the middle of a frame. Its lamp is on the line SELECT.
export LIMNER_DC=DC LIMNER_RESET=RESET LIMNER_BACKLIGHT=BACKLIGHT LIMNER_LED=SELECT

# Time does not move while anything runs: the limit is for a program that has ended.
flies() {
    forget
    image.elf &
    image=$!
    timeout 600 tee began </dev/wire_tap | wires "$FRAMES" >flight
    kill -s TERM $image
    wait $image
    status=$?
    keep rest
    cat began rest.wires >flight.wires
    echo "status $status"
    [ $status = $((128 + 15)) ]
}

tap_check "the Linux board's program flies until SIGTERM" flies
