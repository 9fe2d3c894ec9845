# SPDX-License-Identifier: MIT
#
# Puts an image on a Pico 2: sh boards/pico2/flash.sh IMAGE (without ending). By its boot drive. (Debian's
# openocd knows no RP2350.)
set -eu

image=$1
drive=$(findmnt -n -o TARGET -S LABEL=RP2350 | head -n 1)
if [ -n "$drive" ]; then
    cp "$image.uf2" "$drive/" && sync
    echo "flash: $image.uf2 copied to $drive; the board starts it"
    exit 0
fi
echo "flash: no drive RP2350 is mounted: hold BOOTSEL while plugging in" >&2
exit 1
