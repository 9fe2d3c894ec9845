# SPDX-License-Identifier: MIT
#
# The Linux port on a stock Debian kernel for another processor, which has nothing of ours in it: QEMU's arm64 board with
# a display on its GPIO lines, SPI by the kernel's spi-gpio. The witness is QEMU, which traces every pin: from the pins
# come bytes, from these the picture on the emulated panel, which must be the test card. See tests/kernel/README.md.
. tests/tap.sh

here=tests/kernel
cross=aarch64-linux-gnu-gcc

skip_all() {
    echo "1..0 # SKIP $*"
    exit 0
}

# The port, the panels and the card, for arm64; the rest of the host program needs libraries that are not at hand.
compile() {
    # shellcheck disable=SC2086 # a list
    $cross -std=c11 -O2 $WARNINGS -D_POSIX_C_SOURCE=200809L -DLIM_GPIOD=1 -Ifirmware -Ihal -Isim -Iboards/common \
        -I"$debian/usr/include" -static -o "$work/root/bin/draw_card" $here/draw_card.c $here/card.c \
        hal/*.c hal/linux/*.c boards/common/screen.c sim/display.c sim/error.c sim/test_card.c "$debian/usr/lib/aarch64-linux-gnu/libgpiod.a"
}

pack() {
    cp "$debian/bin/busybox" "$work/root/bin" &&
        ln -s busybox "$work/root/bin/sh" &&
        find "$debian/lib/modules" \( -name spi-bitbang.ko -o -name spi-gpio.ko \) -exec cp {} "$work/root" \; &&
        cp $here/arm64_init.sh "$work/root/init" &&
        chmod 755 "$work/root/init" &&
        (cd "$work/root" && find . | cpio -o -H newc >"$work/initramfs")
}

device_tree() {
    qemu-system-aarch64 -M virt,dumpdtb="$work/virt.dtb" -cpu cortex-a53 -m 512 -nodefaults -display none &&
        handle=$(fdtget "$work/virt.dtb" /pl061@9030000 phandle) &&
        sed "s/PL061/$handle/" $here/arm64.dts | dtc -I dts -O dtb -o "$work/display.dtbo" &&
        fdtoverlay -i "$work/virt.dtb" -o "$work/board.dtb" "$work/display.dtbo"
}

# A panel of its own for each start, so that a record of the pins begins with its power.
boot() { # PANEL GLASS
    timeout 120 qemu-system-aarch64 -M virt -cpu cortex-a53 -m 512 -nographic -no-reboot -nodefaults -serial stdio \
        -kernel "$(echo "$debian"/boot/vmlinuz-*)" -initrd "$work/initramfs" -dtb "$work/board.dtb" \
        -append "console=ttyAMA0 quiet panic=-1 PANEL=$1 GLASS=$2" \
        -msg timestamp=on -trace pl061_set_output -D "$work/$1.pins" </dev/null >"$work/$1.console" 2>&1
    "$BUILD/tests/kernel/pins" <"$work/$1.pins" >"$work/$1.wires"
}

drawn() { # PANEL
    cat "$work/$1.console"
    tr -d '\r' <"$work/$1.console" | grep -q '^1\.\.1$' && grep -q '^ok 1 - drawn' "$work/$1.console"
}

# Small glass: every bit is three lines of trace.
mono='ssd1306 128x64+0+0'
colour='st7735 64x40+32+60'

debian=$(sh $here/debian.sh bookworm arm64 'linux-image-arm64=./boot/vmlinuz-*,*/drivers/spi/*' busybox-static \
    libgpiod-dev 2>&1) || skip_all "$debian"
mkdir -p "$work/root/bin" "$work/root/sys" "$work/root/dev"
tap_check "the port is compiled for arm64" compile
tap_check "the initial file system is packed" pack
tap_check "a display is added to the device tree" device_tree
# shellcheck disable=SC2086 # lists
{
    boot $mono &
    boot $colour
    wait
    for picture in "$mono" "$colour"; do
        panel=${picture% *}
        tap_check "the stock kernel draws on $panel" drawn "$panel"
        tap_check "the pins carried the picture to $panel" \
            "$BUILD/tests/kernel/replay" "$work/$panel.wires" $picture card
    done
}
tap_done
