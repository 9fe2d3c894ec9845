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

panels=$("$limner" play --panel none 2>&1 | sed 's/.*there are //; s/,//g; s/ and / /')

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
module st7796 --panel st7796
module narrow --panel st7796 --size 222x480
module ssd1306 --panel ssd1306 --rotate 90
module ssd0323 --panel ssd0323
tap_check "a round panel says so" says gc9a01 'MODULE_NAME "gc9a01"' 'MODULE_ROUND 1' 'MODULE_MONO 0' \
    'MODULE_W_PX 240' 'MODULE_SPEED_HZ 40000000u' 'MODULE_FORMAT PANEL_RGB565' \
    'MODULE_LINES_MEM_B(n_lines) SCREEN_MEM_B(MODULE_W_PX, n_lines)'
tap_check "the bus's clock can be another than the usual" says fast 'MODULE_SPEED_HZ 62500000u'
tap_check "a chip that turns the picture has it turned" says ili9488 'MODULE_W_PX 480' 'MODULE_H_PX 320' \
    'MODULE_CAMERA_TURN PANEL_UPRIGHT' 'MODULE_LINES_MEM_B(n_lines) SCREEN_WIDE_MEM_B(MODULE_W_PX, n_lines)'
tap_check "TN glass is not inverted" says st7796 'MODULE_NAME "st7796"' 'MODULE_W_PX 320' 'MODULE_H_PX 480' \
    'MODULE_FORMAT PANEL_RGB565' 'MODULE_SPEED_HZ 40000000u'
tap_check "narrow IPS glass lies in the middle of memory" says narrow 'MODULE_W_PX 222' 'MODULE_H_PX 480'
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

has() { # NAME FIELD...: in its configuration
    source=$work/$1.c
    shift
    for field; do
        grep -qxF "        .$field," "$source" || { echo "no $field in" && cat "$source" && return 1; }
    done
}

has_not() { # NAME WORD
    ! grep -n "$2" "$work/$1.c"
}

module st7735 --panel st7735 --size 128x128
module red --panel st7735 --memory 128x160 --offset 0,0
module small --panel ssd1306 --size 72x40
module tall --panel ssd1306 --size 128x32 --wiring alternative --contrast 255 --start-line 63
module seen --panel ili9341 --mirror-rows
module dogs --panel uc1701 --size 102x64
module undone --panel uc1701 --size 102x64 --mirror-columns --mirror-rows
module osram --panel ssd0323 --start-line 79 --contrast 1
module other --panel ssd0323 --size 128x80
tap_check "glass of 128x128 has the memory that its mode pins leave" has st7735 'mem_w_px = 132' 'mem_h_px = 132' \
    'ox_px = 2' 'oy_px = 3'
tap_check "and any other what --memory says" has red 'mem_w_px = 128' 'mem_h_px = 160' 'w_px = 128' 'h_px = 160'
tap_check "which has no margin" has_not red 'o[xy]_px'
tap_check "the smallest OLED has the chip's reference" has small 'internal_reference = true' 'ox_px = 28'
tap_check "an OLED is told wiring, contrast and first line" has tall 'wiring = PAGES_WIRING_ALTERNATIVE' \
    'contrast = 255' 'start_line = 63'
tap_check "rows are mirrored without columns" has seen 'flip_rows = true'
tap_check "and columns are not" has_not seen 'flip_columns\|mirror'
tap_check "glass that is mounted the other way round says so" has dogs 'flip_columns = true' 'flip_rows = true'
tap_check "unless it is not" has_not undone flip
tap_check "the LM3S6965EVB's glass has its maker's shift" has osram 'shift = 76' 'shift_turned = 68' 'start_line = 79' \
    'contrast = 1'
tap_check "which another size has not" has_not other shift

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
    "--panel st7789: 320x240 pixels do not fit into its memory of 240x320; --size 240x320 --rotate 90 draws a lying picture" --panel st7789 --size 320x240 -o "$work/bad"
tap_check "a mirror that the driver refuses is refused" is_refused \
    "--mirror: ls013b7dh03 cannot" \
    --panel ls013b7dh03 --mirror -o "$work/bad"
tap_check "so is one of a chip that flips nothing" is_refused "--mirror: pcd8544 cannot" --panel pcd8544 --mirror \
    -o "$work/bad"
tap_check "two greys of a byte begin together" is_refused \
    "--panel ssd1327: glass begins at columns that are multiples of 2, not at 1" --panel ssd1327 --size 126x96 \
    --offset 1,0 -o "$work/bad"
tap_check "and end so" is_refused "--panel ssd1327: 127x96: its width must be a multiple of 2 pixels" \
    --panel ssd1327 --size 127x96 -o "$work/bad"
tap_check "a memory LCD has its size" is_refused "--panel ls013b7dh03: 64x64: it has 128x128 pixels, and no others" \
    --panel ls013b7dh03 --size 64x64 -o "$work/bad"
takes() { # FILE ARGUMENT...
    name=$1
    shift
    "$limner" module "$@" -o "$work/$name" 2>"$work/said"
}
in_the_middle() {
    takes even --panel ssd1327 --size 122x96 && grep -q 'ox_px = 2,' "$work/even.c"
}
tap_check "glass in the middle of memory begins where a byte does" in_the_middle
same_memory() {
    takes plain --panel st7735 --size 128x128 && takes said --panel st7735 --size 128x128 --memory 132x132 &&
        grep -q 'oy_px = 3' "$work/said.c" && [ "$(tail -n +3 "$work/plain.c")" = "$(tail -n +3 "$work/said.c")" ]
}
tap_check "the usual module's memory, said again, moves nothing" same_memory
hardly_meant() { # TEXT ARGUMENT...
    text=$1
    shift
    takes mode "$@" && [ "$(cat "$work/said")" = "limner: note: $text" ]
}
tap_check "a mode that reads the wrong edge is told" hardly_meant \
    "--mode 2: st7789 reads as the clock rises, in modes 0 and 3" --panel st7789 --mode 2
tap_check "so is one that a memory LCD does not bear" hardly_meant \
    "--mode 3: ls013b7dh03 wants a clock that is low between messages, mode 0" --panel ls013b7dh03 --mode 3
tap_check "rows that no chip can mirror are refused" is_refused "--mirror-rows: pcd8544 cannot" --panel pcd8544 \
    --mirror-rows -o "$work/bad"
tap_check "so are columns" is_refused "--mirror-columns: ls027b7dh01 cannot" --panel ls027b7dh01 --mirror-columns \
    -o "$work/bad"
tap_check "a contrast that no chip has is refused" is_refused "--contrast 3: st7789 has none" --panel st7789 \
    --contrast 3 -o "$work/bad"
tap_check "so is one that is too large" is_refused "--contrast 64: must be a whole number from 1 to 63" --panel st7567 \
    --contrast 64 -o "$work/bad"
tap_check "a first line beyond memory is refused" is_refused "--start-line 64: must be a whole number from 0 to 63" \
    --panel ssd1306 --start-line 64 -o "$work/bad"
tap_check "and one where there is none" is_refused "--start-line 0: pcd8544 has none" --panel pcd8544 --start-line 0 \
    -o "$work/bad"
tap_check "a wiring has a name" is_refused "--wiring odd: must be sequential or alternative" --panel sh1106 \
    --wiring odd -o "$work/bad"
tap_check "and belongs to OLEDs" is_refused "--wiring sequential: st7567 is not told any" --panel st7567 \
    --wiring sequential -o "$work/bad"
tap_check "memory that the chip has not is refused" is_refused "--memory 133x162: st7735 has 132x162" --panel st7735 \
    --memory 133x162 -o "$work/bad"
tap_check "memory without mode pins is refused" is_refused "--memory 64x64: ssd1351 has no mode pins" --panel ssd1351 \
    --memory 64x64 -o "$work/bad"
tap_check "memory smaller than the glass is refused" is_refused \
    "--panel st7735: 128x160 pixels do not fit into its memory of 120x160" --panel st7735 --memory 120x160 -o "$work/bad"
tap_check "a clock is a number" is_refused "--hz 0: must be a whole number from 1 to 1000000000" --panel st7789 \
    --hz 0 -o "$work/bad"
tap_check "there are four modes of SPI" is_refused "--mode 4: must be a whole number from 0 to 3" --panel st7789 \
    --mode 4 -o "$work/bad"
tap_check "what is left over is refused" is_refused "module: what is '--delta'?" --panel st7789 -o "$work/bad" --delta
tap_done
