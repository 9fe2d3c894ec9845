# SPDX-License-Identifier: MIT
#
# The Pico's image in rp2040js: from the UF2 file through its own second stage to frames, painting while DMA sends, and
# back to frames after the SPI stopped.
. tests/tap.sh

board() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$BUILD" BOARD=pico BOARDS="$kept/boards" PICTURES="$work/pictures" "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

image=$kept/boards/pico/rooms-st7789-fast/image

frames_are_golden() {
    board emulate N=8 && cat "$work/said" && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq 8 ]
}

# A quarter of each frame's bytes, or more, left while the processor did not wait for them; with one line it is hardly any.
paints_while_dma_sends() {
    cat "$work/said" && awk '/^# bus frame/ { n++; if (4 * $11 < $6) few = 1 } END { exit !n || few }' "$work/said"
}

# The parts of a frame are its whole, and the bus is never busy longer.
cycles_add_up() {
    awk '/^# cycles frame/ { n++; if ($6 != $8 + $10 + $12 || !$8 || !$10 || !$12) wrong = 1; total = $6 }
        /^# bus frame/ && ($8 > total || $8 != 16 * $6) { wrong = 1 }
        END { exit !n || wrong }' "$work/said"
}

# But for the first frame, which nothing went before, a frame takes hardly longer than its bytes.
is_bound_by_the_bus() {
    awk '/^# cycles frame [1-9]/ { total += $6 }
        /^# bus frame [1-9]/ { bus += $8 }
        END { printf "%.3f of the bus\n", total / bus; exit !(total > bus && total < 1.05 * bus) }' "$work/said"
}

# What is said of all frames but the first is their mean.
means_are_told() {
    awk '/^# cycles frame [1-9]/ { n++; total += $6; cpu += $6 - $12 }
        /^# flash frame [1-9]/ { misses += $6; waits += $12; if ($6 != $8 + $10) wrong = 1 }
        /^# mean of/ {
            gsub(/[;,]/, ""); said++
            near($4, n); near($6, 125e6 * n / total); near($13, 125e6 * n / cpu)
            near($14, cpu / n); near($18, waits / n); near($23, misses / n)
        }
        function near(said, is) { if (said < is - 0.51 || said > is + 0.51) { print said " is not " is; wrong = 1 } }
        END { exit wrong || n != 7 || said != 1 || !waits }' "$work/said"
}

# At 62.5 MHz with four lines a word takes 40 cycles, and 256 at 31.25 MHz with one: the figures are those of the first.
is_read_fast() {
    awk '/^# flash frame/ { n++; if ($12 != 40 * $6) slow = 1 } END { exit !n || slow }' "$work/said"
}

# From flash that is read by four lines, by one since it is not known, and by one since two of four are not connected.
starts_from() { # CYCLES CHIP
    board image && head -n 2 "${image%/*}/golden" >"$work/golden" &&
        sh sim/emulators/rp2040.sh "$image" 2 "--pin dc=16 --pin cs=17 --pin reset=22 --pin led=25 --flash $2" \
            "$BUILD/limner" decode - --panel st7789 --size 240x240 --frames 2 --check "$work/golden" >"$work/started" &&
        cat "$work/started" && awk -v cycles="$1" '/^# flash frame/ { n++; if ($12 != cycles * $6) wrong = 1 }
            END { exit n != 2 || wrong }' "$work/started"
}

starts_from_each() {
    starts_from 40 w25q080 && starts_from 256 unknown && starts_from 256 two-lines
}

no_such_flash() {
    ! sh sim/emulators/rp2040.sh "$image" 1 '--flash nix' cat >"$work/told" 2>&1 && cat "$work/told" &&
        grep -q 'no flash chip nix; there are: w25q080' "$work/told"
}

# A Pico W's radio: GP23 is its supply, GP24 and GP29 its bus, GP25 its select. Nothing drives what is not the LED.
leaves_the_radio_alone() {
    board LED=none image && sh sim/emulators/rp2040.sh "$image" 2 '--pin reset=22 --pin radio=23 --pin radio=24
        --pin radio=25 --pin radio=29' cat >"$work/wires" && grep -c '^p reset' "$work/wires" &&
        ! grep '^p radio' "$work/wires" && grep -q '^# cycles frame 1' "$work/wires" &&
        board image && sh sim/emulators/rp2040.sh "$image" 1 '--pin led=25 --pin radio=23 --pin radio=24 --pin radio=29' \
        cat >"$work/wires" && grep -q '^p led 1' "$work/wires" && ! grep '^p radio' "$work/wires"
}

another_led() {
    board LED=GP6 emulate N=2 && cat "$work/said" && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq 2 ]
}

refuses_led() { # LED PATTERN GOAL
    ! board LED="$1" "$3" >/dev/null && cat "$work/said" && grep -q "$2" "$work/said"
}

# Without the next frame's walk to do it waits, and draws the same.
waits_with_one_renderer() {
    board emulate N=4 STREAM=no && grep -q 'one renderer; 960 bytes' "$work/said" &&
        awk '/^# cycles frame [1-9]/ { total += $6 } /^# bus frame [1-9]/ { bus += $8 }
            END { exit !(total > 1.1 * bus) }' "$work/said"
}

# The SPI stops in the second frame, and for one more start: the LED tells the port's trouble by three blinks each time,
# and the frames that follow are those of the path from its beginning.
recovers() {
    board image && head -n 3 "${image%/*}/golden" >"$work/golden" &&
        sh sim/emulators/rp2040.sh "$image" 4 '--pin dc=16 --pin cs=17 --pin backlight=20 --pin reset=22 --pin led=25
            --stop-after 200000 --for 2' cat >"$work/wires" || return 1
    "$BUILD/limner" decode "$work/wires" --panel st7789 --size 240x240 --write-hashes "$work/hashes" &&
        sed -n '3,$p' "$work/hashes" | awk '{ print NR - 1, $2 }' | cmp - "$work/golden" &&
        sed -n '/the SPI stops/,/cycles frame 1/p' "$work/wires" >"$work/trouble" &&
        blinks "$work/trouble" && [ "$(grep -c '^p reset 0' "$work/trouble")" -eq 2 ]
}

# WIRES: before each start anew the LED has been lit three times, and dark at first.
blinks() {
    [ "$(awk '/^p led 1/ { lit++ } /^p reset 0/ { print lit; lit = 0 }' "$1" | tr '\n' ' ')" = '3 3 ' ]
}

# A bit of the second stage: the boot ROM would try USB instead.
damaged_stage_is_not_entered() {
    cp "$image.elf" "$work/damaged.elf" && cp "$image.uf2" "$work/damaged.uf2" &&
        printf '\377' | dd of="$work/damaged.uf2" bs=1 seek=40 conv=notrunc 2>/dev/null || return 1
    ! sh sim/emulators/rp2040.sh "$work/damaged" 1 '' cat >"$work/said" 2>&1 && cat "$work/said" &&
        grep -q 'wrong checksum' "$work/said"
}

# With stand-ins for findmnt, which finds the folder that $DRIVE names, and openocd.
flash() {
    mkdir -p "$work/bin" "$work/drive" && rm -f "$work/probed" &&
        printf '#!/bin/sh\necho "$DRIVE"\n' >"$work/bin/findmnt" &&
        printf '#!/bin/sh\necho "$@" >"%s"\n' "$work/probed" >"$work/bin/openocd" &&
        chmod +x "$work/bin/findmnt" "$work/bin/openocd" && PATH="$work/bin:$PATH" board flash
}

flashes_by_drive() {
    DRIVE=$work/drive flash && cmp "$image.uf2" "$work/drive/image.uf2" && [ ! -e "$work/probed" ]
}

flashes_by_probe() {
    DRIVE='' flash && grep "program $image.elf verify reset exit" "$work/probed"
}

refuses() { # PATTERN COMMAND...
    pattern=$1
    shift
    ! "$BUILD/limner" "$@" >"$work/said" 2>&1 && cat "$work/said" && grep -q "$pattern" "$work/said" &&
        [ ! -e "$work/none" ]
}

tap_check "eight frames of rooms, each pixel as the simulator draws it" frames_are_golden
tap_check "the next line is painted while DMA sends the last" paints_while_dma_sends
tap_check "walking, painting and waiting are all that a frame takes" cycles_add_up
tap_check "the bus, at 62.5 MHz, is what limits rooms" is_bound_by_the_bus
tap_check "flash is read by four lines, at 62.5 MHz" is_read_fast
tap_check "misses, waits and frames a second are told" means_are_told
tap_check "with one renderer the frames are the same, and later" waits_with_one_renderer
tap_check "when the SPI stops the LED tells it, and the path begins anew when it works again" recovers
tap_check "it starts from flash of several kinds, and draws the same" starts_from_each
tap_check "a flash chip that is not there is refused" no_such_flash
tap_check "a Pico W's radio is not driven" leaves_the_radio_alone
tap_check "an LED may be on another pin" another_led
tap_check "not on one that is taken" refuses_led 16 'a pin that is free' image
tap_check "without one the emulator cannot tell frames, and says so" refuses_led none 'told by the LED' emulate
board image >/dev/null
tap_check "a damaged second stage is not entered" damaged_stage_is_not_entered
tap_check "make flash copies to the boot drive, where that is mounted" flashes_by_drive
tap_check "and takes a debug probe otherwise" flashes_by_probe
head -c 253 /dev/zero >"$work/long.bin"
: >"$work/empty.bin"
tap_check "a second stage that is too long is refused" refuses 'long.bin: more than 252 bytes' \
    boot2 "$work/long.bin" -o "$work/none"
tap_check "an empty image is refused" refuses 'empty.bin: the file is empty' uf2 "$work/empty.bin" -o "$work/none"
tap_check "an unknown family is refused" refuses "no 'nix'; there are rp2040 and rp2350-arm-s" \
    uf2 "$image.bin" --family nix -o "$work/none"
tap_done
