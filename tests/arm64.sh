# SPDX-License-Identifier: MIT
#
# The Linux port on a stock Debian kernel for another processor, which has nothing of ours in it: QEMU's arm64 board with
# a display on its GPIO lines, SPI by the kernel's spi-gpio. The witness is QEMU, which traces every pin: from the pins
# come bytes, from these the picture on the emulated panel, which must be the test card or the simulator's frames. See
# tests/kernel/README.md.
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
    $cross -std=c11 -O2 $WARNINGS -D_POSIX_C_SOURCE=200809L -DLIM_GPIOD=1 -Ifirmware -Ihal -Isim -Iboards/common -Itests \
        -I"$debian/usr/include" -static -o "$work/root/bin/draw_card" $here/draw_card.c boards/common/card.c \
        hal/*.c hal/linux/*.c boards/common/screen.c sim/displays/display.c sim/base/c_field.c sim/base/error.c boards/common/test_card.c "$debian/usr/lib/aarch64-linux-gnu/libgpiod.a"
}

# As boards/linux/README.md says, against Debian's libgpiod of that architecture.
compile_image() {
    make BOARD=linux DEPS=skip BUILD="$BUILD" BOARDS="$work/boards" TOOLS="${cross%gcc}" PANEL=ssd1306 MODULE='--hz 1000000' \
        ARCH="-I$debian/usr/include" STANDARD='-std=c11 -D_POSIX_C_SOURCE=200809L -DLIM_GPIOD=1' \
        LAST="-static $debian/usr/lib/aarch64-linux-gnu/libgpiod.a"
}

pack() {
    cp "$debian/bin/busybox" "$work"/boards/linux/*/image.elf "$work/root/bin" &&
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
# run NAME VARIABLE=VALUE...: the trace of the pins becomes $work/NAME.pins. In the place of the shell that it is run by.
run() {
    name=$1
    shift
    exec timeout 120 qemu-system-aarch64 -M virt -cpu cortex-a53 -m 512 -nographic -no-reboot -nodefaults -serial stdio \
        -kernel "$(echo "$debian"/boot/vmlinuz-*)" -initrd "$work/initramfs" -dtb "$work/board.dtb" \
        -append "console=ttyAMA0 quiet panic=-1 $*" \
        -msg timestamp=on -trace pl061_set_output -D "$work/$name.pins" </dev/null >"$work/$name.console" 2>&1
}

boot() { # PANEL GLASS
    (run "$1" PANEL="$1" GLASS="$2")
    "$BUILD/tests/kernel/pins" <"$work/$1.pins" >"$work/$1.wires"
}

# The image never ends: the machine does, when eight frames have come.
flies() {
    mkfifo "$work/flight.pins"
    run flight &
    machine=$!
    "$BUILD/tests/kernel/pins" <"$work/flight.pins" | "$BUILD/tests/kernel/wires" 8 >"$work/flight"
    kill $machine
    wait $machine
    cat "$work/flight.console"
    "$BUILD/limner" render sim/scenes/rooms.obj --camera sim/scenes/rooms.cam --size 128x64 --precision fast \
        --panel ssd1306 --write-hashes "$work/hashes" && head -n 8 "$work/hashes" >"$work/golden" &&
        "$BUILD/limner" decode "$work/flight" --panel ssd1306 --frames 8 --check "$work/golden"
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
tap_check "the image of boards/linux is" compile_image
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
tap_check "that image flies on the stock kernel, frame by frame as simulated" flies
tap_done
