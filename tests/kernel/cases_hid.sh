# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# `limner play --hid` to an emulated MCP2210 that is a device of this kernel: by uhid, where hidraw is all there is, or
# as a USB gadget behind an emulated host controller, where libusb reaches it too. $BRIDGE says which: /dev/uhid or
# /dev/hidg0.

plug_in() {
    case $BRIDGE in /dev/hidg0) echo dummy_udc.0 >$gadget/UDC ;; esac
}

# Of uhid the device goes with its program; of USB the kernel needs a while to see it gone.
pull_out() {
    case $BRIDGE in /dev/hidg0) echo >$gadget/UDC ;; esac
    while [ -c /dev/hidraw0 ]; do sleep 0.1; done
}

gadget=/sys/kernel/config/usb_gadget/mcp2210
make_gadget() {
    mkdir $gadget $gadget/strings/0x409 $gadget/configs/c.1 $gadget/functions/hid.0 || return 1
    echo 0x04d8 >$gadget/idVendor
    echo 0x00de >$gadget/idProduct
    echo full-speed >$gadget/max_speed
    echo 'MCP2210 USB-to-SPI Master' >$gadget/strings/0x409/product
    echo 0000000001 >$gadget/strings/0x409/serialnumber
    echo 64 >$gadget/functions/hid.0/report_length
    bridge descriptor >$gadget/functions/hid.0/report_desc
    ln -s $gadget/functions/hid.0 $gadget/configs/c.1
}

# start RECORD REPORTS: the bridge, plugged in, as the kernel knows by now.
start() {
    if [ "$BRIDGE" = /dev/hidg0 ]; then
        plug_in
        until [ -c /dev/hidg0 ]; do sleep 0.01; done
    fi
    bridge "$BRIDGE" "$1" "$2" >bridge.said 2>&1 &
    bridge=$!
    until [ -c /dev/hidraw0 ]; do sleep 0.1; done
}

stop() {
    kill "$bridge"
    wait "$bridge"
    status=$?
    pull_out
    cat bridge.said
    return $status
}

play() { # PANEL SIZE OFFSET ARGUMENT...
    panel=$1 size=$2 offset=$3
    shift 3
    limner play --hid --dc GP0 --reset GP1 --backlight GP2 --cs GP3 --panel "$panel" --size "$size" \
        --offset "$offset" --invert --rgb "$@"
}

scene="$STAGE/demo.lim --camera $STAGE/demo.cam"

draws() { # NAME PANEL SIZE OFFSET ARGUMENT...
    name=$1
    shift
    start "$name.wires" 1000000
    play "$@"
    status=$?
    stop && return $status
}

# Pulled out in the middle of a frame, plugged in again when that has been told.
unplugged() {
    start unplugged.wires 300
    # shellcheck disable=SC2086 # a list
    play st7735 80x160 26,1 $scene --frames 1 2>said &
    player=$!
    wait "$bridge"
    pull_out
    until [ -s said ]; do sleep 0.05; done
    start replugged.wires 1000000
    wait $player
    status=$?
    stop
    cat said
    [ $status = 0 ] && [ "$(wc -l <said)" = 1 ] && grep -q 'unplugged; plug it in again; trying again' said
}

listed() {
    start listed.wires 1000000
    limner devices >listed
    setpriv --reuid=nobody --regid=nogroup --clear-groups "$(command -v limner)" devices >forbidden
    stop
    cat listed forbidden
    grep -q 'MCP2210 0000000001 .*: usable' listed && grep -q 'MCP2210.*permission; .*udev' forbidden
}

[ "$BRIDGE" = /dev/uhid ] || tap_check "there is a USB gadget" make_gadget
tap_check "is listed, and to whom it is forbidden as such" listed
tap_check "draws the card" draws card st7735 80x160 26,1 --test-card --frames 1
# shellcheck disable=SC2086 # a list
tap_check "draws a scene" draws scene ssd1306 128x64 0,0 $scene --frames 2
tap_check "unplugged in the middle of a frame, and plugged in again" unplugged
