# SPDX-License-Identifier: MIT
#
# limner export --for arduino, by Arduino's own builder and core for AVR: the folder is a library, its example is compiled and
# linked for a Leonardo, and runs in simavr with simavr's own SSD1306 on its pins. What the display shows are the frames of
# `limner render`.
. tests/tap.sh
. tests/export/exported.sh

core=/usr/share/arduino/hardware
for tool in arduino-builder avr-gcc; do
    command -v $tool >/dev/null || { tap_skip "the example draws on a Leonardo" "$tool is missing" && tap_done && exit; }
done

mkdir -p "$work/libraries" "$work/built" "$work/sketch/sketch" "$work/pictures"

export_it() {
    "$BUILD/limner" export sim/scenes/icosahedron.obj --for arduino --panel ssd1306 -o "$work/libraries/solid"
}

# Debian's avr-gcc has DECIMAL_DIG for C alone, which the core's String wants.
build() { # SKETCH
    arduino-builder -compile -hardware /usr/share/arduino-builder -hardware $core -tools /usr/bin -libraries "$work/libraries" \
        -fqbn arduino:avr:leonardo -build-path "$work/built" -prefs=compiler.cpp.extra_flags=-DDECIMAL_DIG=9 "$1" >"$work/log" 2>&1 ||
        { cat "$work/log" && return 1; }
    ! grep "$work/libraries.*warning" "$work/log"
}

build_example() { build "$work/libraries/solid/examples/solid/solid.ino" && cp "$work/built/solid.ino.elf" "$work/example.elf"; }

# The same by the paths of render's cameras, with the display on an Arduboy's pins and a frame's end told by its green light.
build_path() {
    exported_expected "$work/sketch/sketch" sim/scenes/icosahedron.obj - --panel ssd1306 >/dev/null || return 1
    exported_names "$work/sketch/sketch"
    sed 's/wires = {10, 9, 8,/wires = {12, 4, 6,/
        s/^  lim_orbit(.*/  static uint8_t frame;\n  const struct lim_camera lens = cameras[frame++ % CAMERAS_COUNT];\n  camera = lens;/
        s/limner_arduino_led(err != 0)/digitalWrite(11, err ? LOW : frame % 2)/; s/^  limner_arduino_board/  pinMode(11, OUTPUT);\n&/
        s/^static struct board board;/#include "cameras.h"\n&/' "$work/libraries/solid/examples/solid/solid.ino" >"$work/sketch/sketch/sketch.ino"
    grep -c 'cameras\[\|, 4, 6,\|(11,' "$work/sketch/sketch/sketch.ino" | grep -qx 4 && build "$work/sketch/sketch/sketch.ino"
}

shows_frames() {
    ran=$work/ran
    sh sim/emulators/simavr.sh "$BUILD" "$work/built/sketch.ino.elf" 8 "$work/pictures" "$work/sketch/sketch/expected" \
        "$BUILD/limner" decode - --panel ssd1306 --frames 8 --check "$work/sketch/sketch/expected" >"$ran" || { cat "$ran" && return 1; }
    cat "$ran"
}

is_short() { # a sketch that a newcomer reads at once
    [ "$(wc -l <"$work/libraries/solid/examples/solid/solid.ino")" -le 25 ]
}

# What a Leonardo has for programs, and for variables and the stack together, as deep as it was in simavr. Interrupts of the
# core are in it: its clock ticks.
fits() {
    avr-size "$work/example.elf" | awk 'NR == 2 { print $1 + $2, $2 + $3 }' >"$work/size"
    read -r flash_b static_b <"$work/size"
    stack_b=$(awk '$2 == "stack" { print $3 }' "$work/ran")
    echo "# flash $flash_b of 28672 bytes, RAM $static_b bytes with the core and $stack_b of stack, of 2560"
    [ "$flash_b" -le 28672 ] && [ "$stack_b" -gt 300 ] && [ $((static_b + stack_b)) -le 2560 ]
}

tap_check "an icosahedron on an SSD1306 becomes an Arduino library" export_it
tap_check "its example has 25 lines at most" is_short
tap_check "Arduino's builder makes the example without a warning of ours" build_example
tap_check "its builder makes a sketch along a path" build_path
tap_check "simavr shows the frames of render" shows_frames
fits >"$work/fits" && tap_ok "it fits a Leonardo" || tap_fail "it fits a Leonardo"
cat "$work/fits"
tap_done
