# SPDX-License-Identifier: MIT
#
# USB-HID bridges from the outside: sim/MEASURED.md's prediction is what the port sends to an emulated bridge, and options that
# make no sense, or a bridge that is not there, end with one line that says so and status 1.
. tests/tap.sh

tap_check "sim/MEASURED.md's table of displays over USB-HID is what is predicted now" sh sim/tools/tables.sh --check bridge

one_row() { # PANEL SIZE
    [ "$("$BUILD/limner" bridge --panel "$1" --size "$2" | grep -c "^| $1 | $2 | ")" = 1 ]
}
tap_check "one display of the user's choice" one_row pcd8544 84x48
tap_check "so is a memory LCD, which is selected by a pin" one_row ls027b7dh01 400x240

# TEXT OPTION...
refused() {
    text=$1
    shift
    ! "$BUILD/limner" "$@" >"$work/out" 2>"$work/err" && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" = 1 ] &&
        grep -qF -- "$text" "$work/err" || { cat "$work/err"; return 1; }
}

card="play --test-card --panel st7735"
# shellcheck disable=SC2086 # words
{
    tap_check "a bridge and spidev" refused "--hid, --spi: only one of them" $card --hid --spi /dev/spidev0.0 --dc GP0
    tap_check "a line to wait for" refused "--te: a USB-HID bridge cannot" $card --hid --dc GP0 --te GP1
    tap_check "chip select of spidev's" refused "--no-cs, --cs-high: of --spi" $card --hid --dc GP0 --no-cs
    tap_check "chip select without a bridge" refused "--cs GP3: of --hid" $card --spi /dev/spidev0.0 --dc GPIO25 --cs GP3
    tap_check "a pin that bridges do not have" refused "GPIO25: no such pin; bridges have GP0 to GP8" \
        $card --hid 0123456789 --dc GPIO25
    tap_check "a pin for two signals" refused "both cannot be GP0" $card --hid --dc GP0 --reset GP0
    tap_check "chip select on another signal's pin" refused "GP0: named twice" $card --hid --dc GP0 --cs GP0
    tap_check "a bridge that is not there" refused "USB-HID bridge 0123456789: none" $card --hid 0123456789 --dc GP0
    tap_check "a serial number that is no number" refused "USB-HID bridge x1: none" $card --hid=x1 --dc GP0
    tap_check "a glass without its size" refused "come together" bridge --panel st7789
    tap_check "no such panel" refused "no such panel" bridge --panel x --size 8x8
    tap_check "a scene without cameras" refused "x: a scene and its camera file come together" bridge x
    tap_check "cameras that are not there" refused "none.cam: No such file" bridge sim/scenes/icosahedron.obj none.cam
}

lists_bridges() {
    "$BUILD/limner" devices | grep -q '^hid   '
}
tap_check "devices has a section of bridges" lists_bridges
tap_done
