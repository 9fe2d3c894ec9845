# SPDX-License-Identifier: MIT
#
# The LM3S6965 board's image in QEMU: its buttons walk the camera, and an SSI that stops, in the middle of a command
# too, is told by the LED, and then all is set up anew; a processor's exception ends with the LED lit.
. tests/tap.sh

folder=$kept/boards/lm3s6965evb/rooms-ssd0323-fast
scene='sim/scenes/rooms.obj --camera sim/scenes/rooms.cam --size 128x64 --panel ssd0323'

builds() {
    make DEPS=skip BUILD="$BUILD" BOARD=lm3s6965evb BOARDS="$kept/boards" N=8 image "$folder/golden.8"
}

# -- Buttons -------------------------------------------------------------------------------------------------------------

# Which keys are down, step by step, and what the firmware reads then (enum board_button). The frames of the last step may
# not be whole when the machine stops.
steps='up=1 =0 left+up=5 right=8 =0 down=2 ctrl=16 =0 left=4 =0'

send_key() { # KEY true|false
    printf '{"execute":"input-send-event","arguments":{"events":[{"type":"key","data":{"down":%s,"key":{"type":"qcode","data":"%s"}}}]}}\n' \
        "$2" "$1"
}

# Until the firmware has read it twice running.
until_read() { # BUTTONS
    for _ in $(seq 300); do
        [ "$(tail -c 2000000 "$work/trace" | buttons | tail -n 2 | tr '\n' ' ')" != "$1 $1 " ] || return 0
        sleep 0.02
    done
}

# QEMU takes keys while the machine runs only, and until each was pressed once all are down.
press_keys() {
    echo '{"execute":"qmp_capabilities"}'
    echo '{"execute":"cont"}'
    until_read 31
    for key in up down left right ctrl; do send_key $key true && send_key $key false; done
    until_read 0
    held=
    for step in $steps; do
        for key in $held; do send_key "$key" false; done
        held=$(echo "${step%=*}" | tr + ' ')
        for key in $held; do send_key "$key" true; done
        until_read "${step#*=}"
    done
    echo '{"execute":"quit"}'
}

# An instruction takes 256 ns of the machine's time, so that its waits are short.
run_with_keys() {
    : >"$work/trace"
    press_keys | timeout -k 5 60 qemu-system-arm -M lm3s6965evb -kernel "$folder/image.elf" -nodefaults \
        -nic user,restrict=on -display none -serial none -monitor none -qmp stdio -icount shift=8 -S -D "$work/trace" \
        -trace memory_region_ops_write -trace memory_region_ops_read >"$work/monitor" 2>"$work/said"
    cat "$work/said"
    key_frames=$(($(grep -c 'ops_write.*addr 0x40025004 ' "$work/trace") - 2))
    ! grep -i 'ssd0323\|error' "$work/said" && grep ops_write "$work/trace" |
        "$BUILD/limner" decode - --panel ssd0323 --qemu boards/lm3s6965evb/trace.map --frames $key_frames \
            --write-hashes "$work/drawn" && buttons <"$work/trace" | head -n $key_frames >"$work/buttons"
}

# What the firmware read of its pins in each frame, as enum board_button: of port E, then of port F, low is down.
buttons() {
    awk '/ops_read.* addr 0x4002403c / { e = $9 }
        /ops_read.* addr 0x40025008 / && e != "" { print e, $9 }' |
        while read -r e f; do echo $((e ^ 15 | ((f == 0) << 4))); done
}

# Not one that was down from the beginning, but each that was pressed then.
all_buttons_are_seen() {
    uniq -c "$work/buttons" && [ "$(head -n 1 "$work/buttons")" -eq 31 ] || return 1
    for button in 0 1 5 4 8 2 16; do
        grep -qx $button "$work/buttons" || return 1
    done
}

walks() {
    # shellcheck disable=SC2086 # arguments are words
    "$BUILD/tests/boards/walked" $scene <"$work/buttons" >"$work/walked" && diff "$work/walked" "$work/drawn"
}

# Up to the first press of one button after none was down, and where select is pressed after it, frames are the path's; in
# between none is. (A frame may read one button where two are let go of.)
# Select counts not when it is only the last to be let go of those down at first.
leaves_the_path() {
    first=$(awk '$0 == 0 { none = 1 } none && $0 == 1 { print NR; exit }' "$work/buttons")
    select=$(awk -v first="$first" 'NR > first && $0 == 16 { print NR; exit }' "$work/buttons")
    diff "$folder/golden" "$work/drawn" | sed -n 's/^> //p' >"$work/others"
    echo "up from frame $first on, select in frame $select" && cat "$work/others"
    awk -v first="$first" -v select="$select" '$1 + 1 < first { early = 1 } $1 + 1 < select { n++ } $1 + 1 == select { late = 1 }
        END { exit early || late || n != select - first }' "$work/others"
}

# -- Faults --------------------------------------------------------------------------------------------------------------

# Stops the SSI in the second frame, by SSE of SSICR1, at a write of so many bytes, and so many instructions into it.
# What gdb writes does not reach devices, so the firmware does: it sets a pin low that is that register.
stop_ssi() { # BYTES STEPS
    sed 's/^/1 /' <<END
tbreak *pl022_write if \$r2 == $1
continue
stepi $2
set *(int *)0x2000c000 = 0x40008004
call ((int (*)(void *, int))output_set)((void *)0x2000c000, 0)
END
}

# Three blinks tell the port's trouble; the frames that follow are the path's from its beginning, on QEMU's display too.
recovers() { # BYTES STEPS
    stop_ssi "$1" "$2" >"$work/commands"
    OLED_COMMANDS=$work/commands sh sim/emulators/qemu_oled.sh "$folder/image.elf" 10 "$work/oled" || return 1
    rm "$work/oled/000.png" "$work/oled/001.png"
    "$BUILD/limner" hashes "$work"/oled/*.png --shrink 4 --check "$folder/golden.8" && blinks
}

# The LED is set up dark, changes with the first frame, goes out and blinks three times, and so from the start again.
blinks() {
    awk '/ops_write.* addr 0x40025004 / { printf "%s", $9 == "0x0" ? "." : "!" }
        /ops_write.* addr 0x400fe104 / { printf " " }' "$work/oled/trace" | tee "$work/led"
    grep -q '^ \.!\.!\.!\.!\. \.!\.!\.!\.!\.$' "$work/led"
}

stops_with_the_led_lit() {
    printf '2 %s\n' 'set $pc = 0xe0000000' 'tbreak image_fault' continue 'stepi 300' 'info symbol $pc' quit >"$work/commands"
    OLED_COMMANDS=$work/commands sh sim/emulators/qemu_oled.sh "$folder/image.elf" 9 "$work/oled" || return 1
    cat "$work/oled/log" && grep -q '^image_fault' "$work/oled/log" &&
        [ "$(sed -n 's/.*ops_write.* addr 0x40025004 value \([^ ]*\) .*/\1/p' "$work/oled/trace" | tail -n 1)" = 0xff ]
}

tap_check "the image is built" builds
tap_check "QEMU runs it while keys are pressed" run_with_keys
tap_check "each button is read, down at first" all_buttons_are_seen
tap_check "the frames are those that the buttons walk to" walks
tap_check "buttons leave the path, select goes back to it" leaves_the_path
tap_check "an SSI that stops among pixels is told and started anew" recovers 4096 2000
tap_check "so is one that stops in the middle of a command" recovers 2 1
tap_check "an exception stops it with the LED lit" stops_with_the_led_lit
tap_done
