#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Process 1 of tests/arm64.sh: a stock kernel, busybox, and the program that draws on $PANEL of $GLASS, which stand in
# the kernel's command line. The console takes its TAP. Without a glass the program of boards/linux flies, for ever.
/bin/busybox --install -s /bin
mount -t sysfs sysfs /sys
mount -t devtmpfs devtmpfs /dev
for module in spi-bitbang spi-gpio; do insmod /$module.ko; done
[ -n "${GLASS:-}" ] || LIMNER_DC=DC LIMNER_RESET=RESET LIMNER_BACKLIGHT=BACKLIGHT LIMNER_LED=SELECT image.elf 2>&1
if draw_card /dev/spidev0.0 "$PANEL" "$GLASS" 2>&1; then echo "ok 1 - drawn"; else echo "not ok 1 - drawn"; fi
echo 1..1
poweroff -f
