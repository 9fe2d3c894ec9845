# SPDX-License-Identifier: MIT
#
# `limner module`: every panel, in each of its formats and turned, becomes C that compiles for a board without warnings;
# the header says what the driver makes of the module; what makes no sense is refused, and nothing is written.
. tests/tap.sh

limner=$BUILD/limner

module() { # NAME ARGUMENT...
    name=$1
    shift
    "$limner" module -o "$work/$name" "$@"
}

compiles() { # COMPILER...: every NAME.c in $work, a unit each
    # shellcheck disable=SC2086 # warnings are words
    "$@" -std=c11 -O1 $WARNINGS -Ifirmware -Ihal -Iboards/common -fsyntax-only "$work"/*.c
}

panels=$("$limner" play --panel none 2>&1 | sed 's/.*there are //; s/,//g')

formats() { # PANEL
    "$limner" play --panel "$1:none" 2>&1 | sed 's/.*there are //; s/,//g'
}

writes_all() {
    for panel in $panels; do
        for format in $(formats "$panel"); do
            module "$panel-$format" --panel "$panel:$format" || return 1
            module "$panel-$format-turned" --panel "$panel:$format" --rotate 90 --no-invert || return 1
        done
    done
    [ "$(ls "$work"/*-*.c | wc -l)" -ge 30 ]
}

tap_check "every panel becomes C, in each of its formats and turned" writes_all
tap_check "which compiles without a warning" compiles "${CC:-gcc}"
if command -v arm-none-eabi-gcc >/dev/null; then
    tap_check "for Cortex-M too" compiles arm-none-eabi-gcc -mthumb -mcpu=cortex-m3
else
    tap_skip "for Cortex-M too" "no arm-none-eabi-gcc: apt-get install gcc-arm-none-eabi"
fi

says() { # NAME DEFINITION...
    header=$work/$1.h
    shift
    for definition; do
        grep -qxF "#define $definition" "$header" || { echo "no $definition in" && cat "$header" && return 1; }
    done
}

module gc9a01 --panel gc9a01
module fast --panel st7789 --hz 62500000
module ili9488 --panel ili9488 --rotate 270
module ssd1306 --panel ssd1306 --rotate 90
module ssd0323 --panel ssd0323
tap_check "a round panel says so" says gc9a01 'MODULE_NAME "gc9a01"' 'MODULE_ROUND 1' 'MODULE_MONO 0' \
    'MODULE_W_PX 240' 'MODULE_SPEED_HZ 40000000u' 'MODULE_FORMAT PANEL_RGB565' \
    'MODULE_LINES_MEM_B(n_lines) SCREEN_MEM_B(MODULE_W_PX, n_lines)'
tap_check "the bus's clock can be another than the usual" says fast 'MODULE_SPEED_HZ 62500000u'
tap_check "a chip that turns the picture has it turned" says ili9488 'MODULE_W_PX 480' 'MODULE_H_PX 320' \
    'MODULE_CAMERA_TURN PANEL_UPRIGHT' 'MODULE_LINES_MEM_B(n_lines) SCREEN_WIDE_MEM_B(MODULE_W_PX, n_lines)'
tap_check "a chip that cannot leaves it to the camera" says ssd1306 'MODULE_W_PX 128' 'MODULE_H_PX 64' 'MODULE_MONO 1' \
    'MODULE_CAMERA_TURN PANEL_TURNED_90' 'MODULE_LINES_MEM_B(n_lines) SCREEN_PAGES_MEM_B(MODULE_W_PX, n_lines)'
module st7789 --panel st7789
module ls027b7dh01 --panel ls027b7dh01
module told --panel st7735 --mode 3
tap_check "a controller that is often without chip select has a clock that idles high" says st7789 'MODULE_SPI_MODES 8u'
tap_check "a memory LCD has one that idles low" says ls027b7dh01 'MODULE_SPI_MODES 1u'
tap_check "others take both" says ssd0323 'MODULE_SPI_MODES 9u'
tap_check "the mode of SPI can be told" says told 'MODULE_SPI_MODES 8u'
tap_check "greys are no black and white" says ssd0323 'MODULE_MONO 0' 'MODULE_FORMAT PANEL_GREY4'

is_refused() { # TEXT ARGUMENT...
    text=$1
    shift
    ! "$limner" module "$@" >"$work/out" 2>"$work/said" && [ "$(cat "$work/said")" = "limner: $text" ] &&
        [ ! -s "$work/out" ] && ! ls "$work"/bad* 2>/dev/null
}

tap_check "a panel is required" is_refused \
    "--panel NAME is missing: the display's controller; \`limner help\` lists them" -o "$work/bad"
tap_check "a name is required" is_refused "module: needs -o NAME, for NAME.c and NAME.h" --panel st7789
tap_check "a size beyond the chip's is refused" is_refused \
    "--panel st7789: 320x240 pixels do not fit into its memory of 240x320" --panel st7789 --size 320x240 -o "$work/bad"
tap_check "a mirror that the driver refuses is refused" is_refused \
    "--panel ls013b7dh03: its driver refuses these pins, or a mirrored picture (-2001)" \
    --panel ls013b7dh03 --mirror -o "$work/bad"
tap_check "a clock is a number" is_refused "--hz 0: must be a whole number from 1 to 1000000000" --panel st7789 \
    --hz 0 -o "$work/bad"
tap_check "there are four modes of SPI" is_refused "--mode 4: must be a whole number from 0 to 3" --panel st7789 \
    --mode 4 -o "$work/bad"
tap_check "what is left over is refused" is_refused "module: what is '--delta'?" --panel st7789 -o "$work/bad" --delta
tap_done
