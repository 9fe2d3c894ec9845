# SPDX-License-Identifier: MIT
#
# The examples of sim/export/examples, filled in for a scene, compile for the fakes of their libraries, and a sketch has 25
# lines at most.
. tests/tap.sh
. tests/adapters/adapters.sh

fill_in() { # EXAMPLE FILE
    sed -e 's/@name@/model/g; s/@NAME@/MODEL/g; s/@name_c@/model/g; s/@W@/160/g; s/@H@/128/g; s/@LENS@/50/g' \
        -e 's/@ORBIT_M@/4.5/g; s/@TARGET_M@/0, 0.5, 0/g' "sim/export/examples/$1" >"$2"
    ! grep -n '@' "$2"
}

is_short() { # EXAMPLE
    [ "$(wc -l <"sim/export/examples/$1")" -le 25 ]
}

sketch_compiles() { # EXAMPLE
    fill_in "$1" "$work/sketch.ino" && is_short "$1" && in_cplusplus "$work/sketch.ino" "$work/sketch.o" -include Arduino.h -Wno-conversion -Wno-missing-field-initializers
}

program_compiles() { # EXAMPLE FLAG...
    example=$1
    shift
    fill_in "$example" "$work/example.c" && in_c "$work/example.c" "$work/example.o" -Wno-missing-prototypes "$@"
}

if ! has_cplusplus; then
    tap_skip "examples" "there is no $CXX"
    tap_done
    exit 0
fi

scene_and_module() {
    "$limner" compile sim/scenes/teapot.obj --size 160x128 -o "$work/model" >"$work/said" &&
        "$limner" module --panel st7735 --size 128x160 --rotate 90 -o "$work/module" >"$work/said"
}

tap_check "a scene and a module are written" scene_and_module
for sketch in tft_espi lovyangfx arduino_spi; do
    tap_check "the sketch $sketch compiles" sketch_compiles "$sketch.ino.in"
done
for program in pico_main idf_spi_main idf_esp_lcd_main lvgl_view; do
    tap_check "the program $program compiles" program_compiles "$program.c.in"
done
tap_done
