# SPDX-License-Identifier: MIT
#
# limner export --for pico and --for idf, by CMake and stand-ins for the two SDKs (tests/export/stubs), on fakes that say what
# goes over a display's wires: the example's own main file, with the cameras of `limner render` in the place of its orbit, shows
# the frames of `limner render`. The component's code runs as RV32IMC as well. Sketches compile on fakes of their libraries.
. tests/tap.sh
. tests/export/exported.sh
. sim/targets/targets.sh

command -v cmake >/dev/null || { tap_skip "exported folders build with their SDKs" "cmake is missing" && tap_done && exit; }

scenes=sim/scenes here=$(pwd)
mkdir -p "$work/names"
exported_names "$work/names"

# The example's pins become the fakes' (fake_wires.h), its orbit the cameras, and its end the last of them.
with_cameras() { # FILE EXPRESSION
    {
        printf '#include "cameras.h"\n#include "fake_wires.h"\n#include <stdio.h>\n#include <stdlib.h>\n'
        sed -e "$2" -e 's/^\( *\)lim_orbit(.*/\1static uint16_t frame;\n\1if (frame == CAMERAS_COUNT) exit(wires_complaints() != 0);\n\1camera = cameras[frame++];/' \
            -e 's/^\( *\)err = model_display_frame(.*/\1err = model_display_frame(\&camera, ((frame - 1u) * 1000u + 7u) \/ 15u);\n\1printf("p led %d\\n", frame % 2);/' "$1"
    } >"$1.new" && mv "$1.new" "$1" && grep -q 'frame == CAMERAS_COUNT' "$1" && grep -q 'p led' "$1"
}

builds() { # SOURCE BUILT
    cmake -S "$1" -B "$2" -DCMAKE_C_FLAGS="-I$work/names -I$3 $WARNINGS -Wno-missing-prototypes -Wno-error=unused-function -Wno-unused-variable -Wno-unused-const-variable" >"$work/log" 2>&1 &&
        cmake --build "$2" >>"$work/log" 2>&1 || { cat "$work/log" && return 1; }
}

frames_are_right() { # PROGRAM EXPECTED PANEL
    { echo 'p led 0' && timeout -k 5 60 "$1"; } >"$work/wires" || { tail -n 3 "$work/wires" && return 1; }
    "$BUILD/limner" decode "$work/wires" --panel "$3" --frames 8 --check "$2"
}

pico_draws() { # MODEL CAMERAS|- PANEL OPTION...
    model=$1 cameras=$2 panel=$3 folder=$work/pico-$3
    shift 3
    exported_expected "$folder" "$model" "$cameras" --panel "$panel" "$@" >/dev/null &&
        "$BUILD/limner" export "$model" --for pico --panel "$panel" -o "$folder/model" "$@" >/dev/null &&
        with_cameras "$folder/model/example/main.c" 's/\.sck = 18/.sck = WIRE_CLOCK/; s/\.tx = 19/.tx = WIRE_DATA/; s/\.cs = 17/.cs = WIRE_CS/
            s/\.dc = 16/.dc = WIRE_DC/; s/\.reset = 22/.reset = WIRE_RESET/; s/\.backlight = 20/.backlight = WIRE_BACKLIGHT/; s/select = 17/select = WIRE_SELECT/' &&
        PICO_SDK_PATH=$here/tests/export/stubs/pico builds "$folder/model/example" "$folder/built" "$folder" &&
        frames_are_right "$folder/built/model_example" "$folder/expected" "$panel"
}

idf_draws() { # MODEL CAMERAS|- PANEL OPTION...
    model=$1 cameras=$2 panel=$3 folder=$work/idf-$3
    shift 3
    exported_expected "$folder" "$model" "$cameras" --panel "$panel" "$@" >/dev/null &&
        "$BUILD/limner" export "$model" --for idf --panel "$panel" -o "$folder/model" "$@" >/dev/null &&
        with_cameras "$folder/model/examples/model/main/main.c" 's/PIN_CLOCK = 6/PIN_CLOCK = WIRE_CLOCK/; s/PIN_DATA = 7/PIN_DATA = WIRE_DATA/; s/PIN_CS = 10/PIN_CS = WIRE_CS/
            s/PIN_DC = 4/PIN_DC = WIRE_DC/; s/PIN_RESET = 5/PIN_RESET = WIRE_RESET/; s/select = PIN_CS/select = WIRE_SELECT/' &&
        IDF_PATH=$here/tests/export/stubs/idf builds "$folder/model/examples/model" "$folder/built" "$folder" &&
        frames_are_right "$folder/built/model.elf" "$folder/expected" "$panel"
}

# The component by its own CMakeLists.txt, without the driver's fakes.
idf_as_rv32() {
    folder=$work/rv32
    exported_expected "$folder" $scenes/movers.gltf $scenes/movers.cam --size 96x64 >/dev/null &&
        "$BUILD/limner" export $scenes/movers.gltf --for idf --size 96x64 -o "$folder/model" >/dev/null &&
        printf 'function(idf_component_register)\n    cmake_parse_arguments(c "" "" "SRCS;INCLUDE_DIRS;REQUIRES" ${ARGN})\n    set(sources "${c_SRCS}" PARENT_SCOPE)\n    message("SRCS ${c_SRCS}")\nendfunction()\ninclude(%s/CMakeLists.txt)\n' "$folder/model" >"$folder/read.cmake" &&
        sources=$(cmake -P "$folder/read.cmake" 2>&1 | sed -n 's/^SRCS //p' | tr ';' '\n' | sed "s#^#$folder/model/#") || return 1
    # shellcheck disable=SC2046,SC2086 # flags and sources are words
    $(target_compiler rv32) $(target_flags rv32) -O2 -ffunction-sections -fdata-sections -Wl,--gc-sections $WARNINGS -I"$folder/model/include" -I"$folder" -I"$work/names" -Isim/targets -Iboards/common \
        -o "$folder/draws" tests/export/draw.c $sources $(target_image rv32) -lgcc || return 1
    target_run rv32 "$folder/draws" >"$folder/drawn" && diff "$folder/expected" "$folder/drawn"
}

# Those which draw on displays of other libraries; what they send is tests/adapters' to test.
sketches_compile() { # MOST-LINES MODEL OPTION...
    lines=$1
    shift
    rm -rf "$work/sketches"
    "$BUILD/limner" export "$@" --for arduino --size 160x128 -o "$work/sketches" >/dev/null 2>&1 || return 1
    for sketch in TFT_eSPI LovyanGFX; do
        g++ -x c++ -std=c++11 -Wall -Wextra -Werror -Wno-missing-field-initializers -include Arduino.h -Itests/adapters/fakes -I"$work/sketches/src" \
            -c -o "$work/sketch.o" "$work/sketches/examples/sketches_$sketch/sketches_$sketch.ino" &&
            [ "$(wc -l <"$work/sketches/examples/sketches_$sketch/sketches_$sketch.ino")" -le "$lines" ] || return 1
    done
    # shellcheck disable=SC2086
    "$CC" -std=c11 $WARNINGS -Itests/adapters/fakes -I"$work/sketches/src" -c -o "$work/view.o" \
        "$work/sketches/examples/sketches_LVGL/sketches_view.c"
}

esp_lcd_compiles() { # MODEL OPTION...
    rm -rf "$work/lcd"
    "$BUILD/limner" export "$@" --for idf --size 240x240 -o "$work/lcd" >/dev/null || return 1
    # shellcheck disable=SC2086
    "$CC" -std=c11 $WARNINGS -Itests/adapters/fakes -Itests/export/stubs/idf/include -I"$work/lcd/include" -c -o "$work/lcd.o" "$work/lcd/examples/lcd_esp_lcd/main/main.c"
}

tap_check "the Pico's example shows rooms on an ILI9341" pico_draws $scenes/rooms.obj $scenes/rooms.cam ili9341
tap_check "and what moves on a memory LCD" pico_draws $scenes/movers.gltf $scenes/movers.cam ls027b7dh01
tap_check "ESP-IDF's example shows the teapot on an ST7789" idf_draws $scenes/teapot.obj $scenes/teapot.cam st7789
tap_check "and rooms on an SH1106" idf_draws $scenes/rooms.obj $scenes/rooms.cam sh1106
tap_check "its component draws as RV32IMC" idf_as_rv32
teapot() { "$@" $scenes/teapot.obj --tree clusters; } # CHECK...: of it by one tree, as all are tried otherwise
all_kinds() { # CHECK...: of what moves, in outlines, smooth
    "$@" $scenes/movers.gltf && "$@" $scenes/teapot.obj --tree clusters --wireframe &&
        "$@" $scenes/teapot.obj --tree clusters --antialias && "$@" $scenes/rooms.obj --round
}

tap_check "the program for esp_lcd compiles" teapot esp_lcd_compiles
tap_check "so it does for what moves, outlines and smooth edges" all_kinds esp_lcd_compiles
tap_check "sketches for TFT_eSPI and LovyanGFX compile, of 25 lines at most, and a widget of LVGL" teapot sketches_compile 25
tap_check "and so do those for what moves, outlines and smooth edges" all_kinds sketches_compile 30
tap_done
