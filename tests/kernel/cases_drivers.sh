# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# The kernel's own drivers of displays draw the test card: of each row of tests/foreign/streams that names one, the
# record of its wires. The line SELECT is the lamp's, which ends the frame.

# A display's number is free again once it is gone, so there is one frame buffer at a time.
until_frame_buffer() {
    for _ in $(seq 100); do
        [ ! -e /dev/fb0 ] || return 0
        sleep 0.01
    done
    echo "no frame buffer"
    return 1
}

lamp() { gpioset wire-tap 3="$1"; }

# What is written is on its way at the next of the driver's refreshes, of which there are 20 a second.
draws_card() { # NAME DRIVER SIZE KIND
    forget
    lamp 0
    echo "$2" >/dev/wire_display && until_frame_buffer || return 1
    case $4 in
    bits) paint /dev/fb0 "$STAGE/card-$3.ppm" bits ;;
    *) paint /dev/fb0 "$STAGE/card-$3.ppm" ;;
    esac || return 1
    sleep 1
    lamp 1
    keep "$1"
}

while IFS='|' read -r name by driver size kind _; do
    [ "$by" != linux ] || tap_check "$name draws" draws_card "$name" "$driver" "$size" "$kind"
done <<END
$(sed '/^#/d; s/ *| */|/g' "$STAGE/streams")
END
