# SPDX-License-Identifier: MIT
#
# Ports over Arduino's SPI library, the Pico SDK and ESP-IDF send what Limner's own panels want: on fakes of these
# libraries (tests/adapters/fakes) the firmware of a module writes a wire log, with chip select, D/C and time, and decoded
# it has the frames that `limner render` has of that panel. Broken on purpose, each port is found out.
. tests/tap.sh
. tests/adapters/adapters.sh

model=sim/scenes/teapot.obj

build_boards() { # FLAG...
    in_cplusplus tests/adapters/arduino_board.c "$work/arduino_board.o" "$@" &&
        in_c tests/adapters/pico_board.c "$work/pico_board.o" "$@" &&
        in_c tests/adapters/idf_board.c "$work/idf_board.o" "$@"
}

headers_are_cplusplus() {
    in_cplusplus tests/adapters/pico_board.c "$work/as_cplusplus" && in_cplusplus tests/adapters/idf_board.c "$work/as_cplusplus"
}

link_ports() { link_frames "$work/port_frames" "$work"/*.o; }

module() { # LINES SIZE RENDERED-PANEL PANEL OPTION...
    lines=$1 size=$2 rendered=$3
    shift 3
    "$limner" render "$work/model.lim" --size "$size" --frames 3 --panel "$rendered" --write-hashes "$work/golden" \
        --write-cameras "$work/cameras.h" >"$work/rendered" &&
        "$limner" module --panel "$@" -o "$work/module" >"$work/written" && in_c "$work/module.c" "$work/module.o" &&
        in_c tests/adapters/port_frames.c "$work/port_frames.o" "-DLINES=$lines" && link_ports
}

sends() { # PORT WAY PANEL OPTION...
    port=$1 way=$2
    shift 2
    # shellcheck disable=SC2086 # ways are words
    timeout 20 "$work/port_frames" "$port" $way >"$work/wires" 2>"$work/told" || { cat "$work/told"; return 1; }
    "$limner" decode "$work/wires" --panel "$@" --frames 3 --check "$work/golden"
}

# The memory of a line, and of a block that DMA sends while the next one is painted.
panel_shows() { # LINES SIZE RENDERED-PANEL PANEL OPTION...
    module "$@" || return 1
    shift 3
    for port in arduino pico idf; do
        sends "$port" '' "$@" || { echo "$port" && return 1; }
    done
}

starts_again() {
    for port in arduino pico idf; do
        sends "$port" again st7735 || { echo "$port" && return 1; }
    done
}

# What goes wrong in the set-up or in a frame comes back, negative, and the board can be begun again.
recovers() {
    for call in 0 1 2 3 20 200; do
        for failure in -1 259; do
            if ! sends idf "fail=$call,$failure" st7735 || ! grep -qx '# refused: -[0-9]*' "$work/told"; then
                echo "call $call: $failure"
                return 1
            fi
        done
    done
}

# Broken, it compiles, and something is complained about or shown otherwise.
found_out() { # PORT HEADER EXPRESSION
    break_header "$2" "$3" || { mend_headers && echo "nothing to break" && return 1; }
    build_boards -w && link_ports
    built=$?
    mend_headers
    [ $built -eq 0 ] && ! { sends "$1" again st7735 && { [ "$1" != idf ] || recovers; }; }
}

found_out_if() { # HEADER WHAT EXPRESSION
    tap_check "$1 is found out if $2" found_out "${1%_bus}" "limner_$1.h" "$3"
}

if ! has_cplusplus; then
    tap_skip "ports" "there is no $CXX"
    tap_done
    exit 0
fi

tap_check "the fakes compile" fakes_compile fake_wires fake_pico fake_idf_spi
tap_check "the ports do, in C and for Arduino in C++" build_boards
tap_check "those in C are C++ as well" headers_are_cplusplus
tap_check "a scene compiles" compile_scene "$model" 240x320
tap_check "a colour panel shows the frames that render has" panel_shows 2 240x240 st7789 st7789
tap_check "in memory for a single line" panel_shows 1 240x240 gc9a01 gc9a01
tap_check "turned, in another format" panel_shows 2 160x128 st7789:rgb444 st7735:rgb444 --rotate 90
tap_check "and one of three bytes a pixel, of which a line is longer than its memory" panel_shows 2 320x480 ili9488 ili9488
tap_check "so does one of pages" panel_shows 2 128x64 ssd1306 ssd1306
tap_check "whose chip needs an address for each page" panel_shows 2 84x48 pcd8544 pcd8544
tap_check "one of greys" panel_shows 2 128x128 ssd1327 ssd1327
tap_check "and a memory LCD, whose select is its driver's" panel_shows 2 128x128 ls013b7dh03 ls013b7dh03
tap_check "and one that is sent many lines at once" panel_shows 64 128x160 st7735 st7735
tap_check "a board can be begun again" starts_again
tap_check "whatever the ESP32's drivers refuse" recovers

found_out_if arduino "it keeps the display unselected" 's/digitalWrite(port->cs, LOW)/digitalWrite(port->cs, HIGH)/'
found_out_if arduino "it sends outside of transactions" '/beginTransaction/d; /endTransaction/d'
found_out_if arduino "it lets SPI read over what is sent" 's/memcpy(piece, data, piece_b);//; s/transfer(piece, /transfer((void *)data, /'
found_out_if arduino "it sends in mode 1" 's/modes\[spi_mode_of(spi_modes, 0)\]/SPI_MODE1/'
found_out_if arduino "it knows two modes" 's/modes\[spi_mode_of(spi_modes, 0)\]/spi_modes \& SPI_IDLES_LOW ? SPI_MODE0 : SPI_MODE3/'
found_out_if arduino "it takes the lowest bit first" 's/MSBFIRST/LSBFIRST/'
found_out_if arduino "it waits by a function that does not count so far" 's/delay_us > 10000 ? .* : //'
found_out_if arduino "it waits a millisecond too short" 's/delay_us \/ 1000 + 2/delay_us \/ 1000/'
found_out_if arduino "it sends the same piece again" 's/data += piece_b, //'
found_out_if pico_bus "D/C does not wait for the SPI" 's/while (spi_is_busy(wires->spi))/while (false)/'
found_out_if pico_bus "it does not wait for DMA" 's/^    dma_channel_wait_for_finish_blocking(wires->dma);//'
found_out_if pico_bus "DMA goes at its own pace" '/channel_config_set_dreq/d'
found_out_if pico_bus "DMA goes by words" '/channel_config_set_transfer_data_size/d'
found_out_if pico_bus "it keeps the display unselected" 's/gpio_put(wires->cs, false)/gpio_put(wires->cs, true)/'
found_out_if pico_bus "it says that nothing is to be flushed" 's/limner_pico_flush, limner_pico_left_b/NULL, limner_pico_left_b/'
found_out_if pico "it leaves D/C an input" 's/gpio_set_dir(number, GPIO_OUT)/gpio_set_dir(number, GPIO_IN)/'
found_out_if idf "it does not fetch results" 's/(err = limner_idf_flush(port))/0/'
found_out_if idf "it says that nothing is to be flushed" 's/limner_idf_flush, NULL/NULL, NULL/'
found_out_if idf "it sends longer parts than the bus takes" 's/n_b < 4092 ? n_b : 4092/n_b/'
found_out_if idf "it keeps the length that the driver has set" 's/port->part.rxlength = 0, //'
found_out_if idf "it counts bytes for bits" 's/length = 8 \* part_b/length = part_b/'
found_out_if idf "it keeps a bus without a device" 's/))) spi_bus_free(port->host);/))) (void)0;/'
found_out_if idf "it turns the sign of ESP_FAIL" 's/return err > 0 ? -err : err;/return -err;/'
found_out_if idf "it tells errors as they are" 's/return err > 0 ? -err : err;/return err;/'
found_out_if idf "it does not wait" 's/esp_rom_delay_us(delay_us), 0/0/'
tap_done
