# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# For tests/kernel.sh: the programs once more, with other libraries than this system's usual ones, and as an image.
# Wants tests/kernel/guests.sh.

# relink FOLDER FROM TO [OBJECT]...: the programs in $stage/FOLDER, with the library TO in the place of FROM. Objects
# come before the project's own library, which has others of the same functions.
relink() {
    folder=$stage/$1 from=$2 to=$3
    shift 3
    mkdir "$folder"
    libraries=$(readelf -d "$BUILD/limner" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/-l:\1/p' | grep -v "$from")
    for program in limner:sim/cli/main.o port_calls:tests/kernel/port_calls.o; do
        # shellcheck disable=SC2086 # a list
        ${CC:-gcc} -o "$folder/${program%%:*}" "$BUILD/host/${program#*:}" "$@" "$BUILD/host/liblimner.a" \
            -Wl,-rpath,"$folder" "$to" -lcmocka $libraries || return 1
    done
    chmod -R a+rX "$folder"
}

# Of the two generations of libgpiod one file each makes use.
build_with_libgpiod2() { # FOLDER of Debian's packages
    library=$1/usr/lib/$(${CC:-gcc} -print-multiarch)/libgpiod.so.3
    ${CC:-gcc} @"$BUILD/host/flags" -ULIM_GPIOD -DLIM_GPIOD=2 -I"$1/usr/include" -c -o "$work/gpio_v2.o" \
        hal/linux/gpio_v2.c &&
        relink libgpiod2 libgpiod "$library" "$work/gpio_v2.o" &&
        cp "$library" "$stage/libgpiod2"
}

build_with_libusb() {
    relink libusb libhidapi "$(pkg-config --variable=libdir hidapi-libusb)/libhidapi-libusb.so"
}

build_board() {
    make BOARD=linux DEPS=skip BUILD="$BUILD" BOARDS="$work/boards" &&
        cp "$work/boards/linux/rooms-st7789-fast/image.elf" "$BUILD/tests/kernel/wires" "$stage/usual" &&
        chmod -R a+rX "$stage/usual"
}
