# SPDX-License-Identifier: MIT
#
# Puts an image on a Pico: sh boards/pico/flash.sh IMAGE (without ending). By its boot drive where that is mounted, else
# with openocd and a debug probe.
set -eu

image=$1
drive=$(findmnt -n -o TARGET -S LABEL=RPI-RP2 | head -n 1)
if [ -n "$drive" ]; then
    cp "$image.uf2" "$drive/" && sync
    echo "flash: $image.uf2 copied to $drive; the board starts it"
    exit 0
fi
if ! command -v openocd >/dev/null; then
    echo "flash: no drive RPI-RP2 is mounted (hold BOOTSEL while plugging in); for a debug probe, openocd is missing," \
        "Debian's package: openocd" >&2
    exit 1
fi
exec openocd -f interface/cmsis-dap.cfg -f target/rp2040.cfg -c 'adapter speed 5000' \
    -c "program $image.elf verify reset exit"
