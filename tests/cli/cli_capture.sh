# SPDX-License-Identifier: MIT
#
# `limner decode` of what a logic analyser captured: the wires of the firmware of boards/common, of which
# tests/wire_board/vcd.awk makes dumps with a timing of their own. sigrok-cli reads and writes the same captures, and its
# own SPI decoder has the same bytes. What a capture lacks is one line of error that names the time, the line or the
# channel.
. tests/tap.sh
. tests/wire_board/firmware.sh

dump() { # AWK-OPTION...: of $work/wires
    awk -f tests/wire_board/vcd.awk -v unit_ns=100 -v half=2 "$@" "$work/wires"
}

oled() { # FILE OPTION...
    file=$1
    shift
    "$limner" decode "$file" --panel ssd1306 "$@"
}

shows() { # AWK-OPTION... -- OPTION...
    count=0
    for word; do
        [ "$word" != -- ] || break
        count=$((count + 1))
    done
    # shellcheck disable=SC2046 # options are words
    dump $(echo "$@" | cut -d ' ' -f "1-$count") >"$work/dump.vcd"
    shift $((count + 1))
    oled "$work/dump.vcd" --check "$work/golden" "$@"
}

# The last frames, in their order, and not one that began before the capture.
shows_rest() { # COUNT AWK-OPTION... -- OPTION...
    rest=$1
    shift
    shows "$@" --running --write-hashes "$work/rest" >"$work/out" 2>"$work/said"
    cat "$work/out" "$work/said"
    oled "$work/dump.vcd" --running --check-loop "$work/golden" && grep -q 'is taken for one that is set up' "$work/said" &&
        [ "$(grep -c '^frame' "$work/out")" -eq "$rest" ]
}

refused() { # PATTERN [OPTION...]: what standard input has
    pattern=$1
    shift
    cat >"$work/bad.vcd"
    fails "$pattern" oled "$work/bad.vcd" "$@"
}

small_memory_lcd() {
    make_firmware 128x128 ls013b7dh03 ls013b7dh03 && wires_of_four >"$work/wires" &&
        dump -v cs=select -v half=5 >"$work/lcd.vcd" &&
        "$limner" decode "$work/lcd.vcd" --panel ls013b7dh03 --check "$work/golden"
}

round_glass() { # frames of which the corners are never sent
    make_firmware 240x240 gc9a01 gc9a01 && "$work/firmware" | awk '{ print } $1 == "p" && $2 == "led" && frames++ == 2 { exit }' \
        >"$work/wires" && head -n 2 "$work/golden" >"$work/two" &&
        awk -f tests/wire_board/vcd.awk -v unit_ns=100 -v half=2 -v led=0 "$work/wires" |
        "$limner" decode - --panel gc9a01 --check "$work/two"
}

pixels_in_bits() { # windows that end within a byte, and a clock that rests high
    make_firmware 96x80 st7735:rgb444 st7735:rgb444 --size 96x80 && "$work/firmware" |
        awk '{ print } $1 == "p" && $2 == "led" && frames++ == 2 { exit }' >"$work/wires" &&
        head -n 2 "$work/golden" >"$work/two" && dump -v mode=3 -v cs=none -v led=0 |
        "$limner" decode - --panel st7735:rgb444 --size 96x80 --mode 3 --check "$work/two"
}

tap_check "a scene compiles for this computer" compile_scene
tap_check "a memory LCD's select, high while it listens, is found by the name CS" small_memory_lcd
tap_check "round glass's frames end though nobody captured a light" round_glass
tap_check "colours of 12 bits do, without CS" pixels_in_bits
tap_check "an OLED's firmware" make_firmware 128x64 ssd1306 ssd1306
wires_of_four >"$work/wires"
tap_check "frames end where the board's light changes" shows --
tap_check "they end where the picture is whole" shows -v led=0 --
tap_check "or at a pause" shows -v led=0 -v rest=400 -- --pause 30
tap_check "without CS the clock's bits are counted from the beginning" shows -v cs=none --
tap_check "CS may be low all the time" shows -v cs=always --
tap_check "or low for each byte" shows -v cs=byte --
tap_check "mode 1" shows -v mode=1 -- --mode 1
tap_check "mode 2" shows -v mode=2 -v cs=none -- --mode 2
tap_check "mode 3" shows -v mode=3 -- --mode 3
tap_check "edges of one instant are as many as they are" shows -v half=0 --
tap_check "channels have the names that options say" shows -v dc=D0 -v sck=D1 -v mosi=D2 -- \
    --wires dc=D0,sck=d1,mosi=wires.D2

# Somebody switches the analyser on in the middle of a frame, and then presses the board's reset.
shows_from_reset() {
    cp "$work/wires" "$work/once" && head -c 7000 "$work/once" >"$work/wires" && echo >>"$work/wires" && cat "$work/once" >>"$work/wires"
    shows -v from=30000 --
    status=$?
    mv "$work/once" "$work/wires"
    return $status
}
tap_check "what was shown before the display was reset is left out" shows_from_reset
tap_check "a capture that begins in the middle has the frames that follow" shows_rest 2 -v from=60000 --
tap_check "or that picture's, where nobody captured the light" shows_rest 2 -v from=60000 -v led=0 --
tap_check "or those behind a pause" shows_rest 2 -v from=60000 -v led=0 -v rest=400 -- --pause 30
frames_of_others() {
    sed '3s/ .*/ 0123456789abcdef/' "$work/golden" >"$work/wrong" && sed '1s/ .*/ 0123456789abcdef/' "$work/golden" >"$work/other" &&
        fails 'wrong: frame 2 differs: hash .*, expected 0123456789abcdef' oled "$work/dump.vcd" --check-loop "$work/wrong" &&
        fails 'other: the first frame is none of its 4' oled "$work/dump.vcd" --check-loop "$work/other"
}

# -- sigrok ------------------------------------------------------------------------------------------------------------

dump >"$work/dump.vcd"
sigrok_session() {
    sigrok-cli -I vcd -i "$work/dump.vcd" -O srzip -o "$work/session.sr" && oled "$work/session.sr" --check "$work/golden"
}

sigrok_dump() {
    sigrok-cli -i "$work/session.sr" -O vcd -o "$work/sigrok.vcd" && oled "$work/sigrok.vcd" --check "$work/golden"
}

sigrok_bytes() { # those that the firmware sent
    sigrok-cli -i "$work/session.sr" -P spi:clk=SCLK:mosi=sda:cs=CS# -A spi=mosi-data | sed 's/.*: //' >"$work/theirs" &&
        awk '$1 == "b" { for (i = 2; i <= NF; i++) print $i }' "$work/wires" | cmp - "$work/theirs" &&
        [ "$(wc -l <"$work/theirs")" -gt 4000 ]
}

tap_check "a session that sigrok wrote" sigrok_session
tap_check "a dump that sigrok wrote" sigrok_dump
tap_check "sigrok's SPI decoder finds the same bytes" sigrok_bytes

sampled_slowly() { # three samples take longer than half a period of the clock, and less than a whole one
    sigrok-cli -I vcd:downsample=3 -i "$work/dump.vcd" -O srzip -o "$work/slow.sr" &&
        fails 'slow.sr: at [0-9.]* us: .*level is a single sample: take more samples' oled "$work/slow.sr"
}
tap_check "too few samples are told, with the time" sampled_slowly
head -c 1500 "$work/session.sr" >"$work/cut.sr"
tap_check "a session that was cut off is refused" fails '^limner: .*cut.sr: ' oled "$work/cut.sr"
printf 'PK\003\004 and no more' >"$work/none.sr"
tap_check "so is what only begins as one" fails '^limner: .*none.sr: ' oled "$work/none.sr"
tap_check "a session is read by its name" fails 'standard input: .*by its name' oled - <"$work/session.sr"

# -- What captures lack ------------------------------------------------------------------------------------------------

tap_check "a frame that differs is an error" frames_of_others
dump -v dc=D0 >"$work/unnamed.vcd"
tap_check "a channel that is missing is named" fails 'unnamed.vcd: no channel is dc: .*--wires dc=CHANNEL; there are: wires.D0, wires.SCLK, ' \
    oled "$work/unnamed.vcd"
tap_check "so is one that was asked for" fails "dump.vcd: there is no channel 'D9' for mosi; there are: " \
    oled "$work/dump.vcd" --wires mosi=D9
tap_check "a wire that has two channels is refused" fails '^limner: --wires: dc is given twice: D0, D1$' \
    oled "$work/dump.vcd" --wires dc=D0,dc=D1
tap_check "so are two wires of one channel" fails 'unnamed.vcd: dc and cs are the same channel, wires.D0$' \
    oled "$work/unnamed.vcd" --wires dc=D0,cs=D0
tap_check "a wire that is none is refused" fails "^limner: --wires: 'data' is no wire: dc, " oled "$work/dump.vcd" --wires data=D1
tap_check "a mode that is none is refused" fails '^limner: --mode 4' oled "$work/dump.vcd" --mode 4
tap_check "options of captures mean nothing to wire logs" fails 'wires: neither a VCD nor a session' oled "$work/wires" --running
dump -v from=60000 >"$work/late.vcd"
tap_check "a capture that begins in the middle says what to do" fails 'at [0-9.]* us: .*started before the capture: --running' \
    oled "$work/late.vcd" --wires reset=-
tap_check "or that nobody reset the display" fails 'ends after 0 frames; reset never fell: --running if ' oled "$work/late.vcd"
dump -v half=4 -v glitch=30000 >"$work/glitch.vcd"
tap_check "a spike on the clock is told, with its length" fails \
    'glitch.vcd: at 3[0-9.]* us: [a-z]* changes after [1-7] bits* of a byte: .* was 100 ns' oled "$work/glitch.vcd"
tap_check "a level that is unknown is told" eval "sed 's/^1#\$/x#/' '$work/dump.vcd' | refused 'at [0-9.]* us: mosi is unknown'"
tap_check "so is a clock's" eval "awk '/^#2015/ { print \"#2014\nx\\\"\" } { print }' '$work/dump.vcd' | refused 'at 201.400 us: sck is unknown'"
tap_check "too few frames are told" fails 'dump.vcd: ends after 4 of 5 frames; ' oled "$work/dump.vcd" --frames 5
head -n 20000 "$work/dump.vcd" >"$work/part.vcd"
tap_check "frames that are not whole are told" fails 'part.vcd: ends after 0 of 2 frames; .* of 8192 pixels' oled "$work/part.vcd" \
    --wires led=- --frames 2 --write-hashes "$work/bad"
tap_check "a display that is never selected is told" eval "sed 's/^0%&/1%\&/' '$work/dump.vcd' | refused 'sck changed only while the display was not selected'"

header='$timescale 1 us $end $var wire 1 a dc $end $var wire 1 b sck $end $var wire 1 c mosi $end $enddefinitions $end'
bad_dump() { # TEXT PATTERN [HEADER]: behind the header, its second line
    printf '%s\n%s\n' "${3-$header}" "$1" | refused "$2"
}
tap_check "time that goes back is refused" bad_dump '#5 1a #4' 'vcd:2: time goes back from #5 to #4$'
tap_check "a time that is none is refused" bad_dump '#5x' "vcd:2: '#5x' is no time$"
tap_check "a time beyond all is refused" bad_dump '#99999999999999999999' "is no time$"
tap_check "a change that is none is refused" bad_dump 'p1 0 1 a' "vcd:2: 'p1' is no change"
tap_check "a change that is cut off is refused" bad_dump 'b101' 'vcd:3: the file ends within a change'
tap_check "a change of nothing is refused" bad_dump '1 a' 'vcd:2: a change of a signal without a name'
tap_check "bits that are none are refused" bad_dump 'b12 a' "vcd:2: '12' are no values"
tap_check "bytes that are no text are refused" bad_dump "$(printf '\001')" 'vcd:2: a byte 01h'
tap_check "a header that is cut off is refused" bad_dump '' 'vcd:3: the file ends within .var: was it cut off' '$timescale 1 us $end $var wire'
tap_check "a header without a time scale is refused" bad_dump '' 'no .timescale' '$enddefinitions $end'
tap_check "a time scale that is none is refused" bad_dump '' "vcd:1: .timescale '3us' is not" '$timescale 3 us $end'
tap_check "a signal that is none is refused" bad_dump '' 'vcd:1: .var is not followed by' '$var wire one a dc $end'
tap_check "two signals of one name are refused" bad_dump '' "'DC' is wire.dc as well as bus.dc: say which" \
    '$timescale 1 us $end $scope module wire $end $var wire 1 a dc $end $upscope $end $scope module bus $end $var wire 1 b dc $end
    $upscope $end $enddefinitions $end'
tap_check "a clock that stands still is told" bad_dump '#1 0b' 'bad.vcd: ends after 0 frames; sck never changed'

# -- Other writers' ways -----------------------------------------------------------------------------------------------

# Bits of a vector, names with blanks and scopes, changes of several signals a line, comments, no line ends at the end, the
# same instant twice, x before anybody drives a wire.
other_ways() {
    awk 'BEGIN { bus = "xxxxx" }
        /^\$timescale/ { print "\n$timescale\n\t100ns\n$end"; next }
        /^\$scope/ { print "$comment $var wire 1 ! no $end\n$scope module top $end $scope begin spi $end"; next }
        /^\$upscope/ { print "$var real 64 * volts $end $var wire 4 bus pins [4:1] $end $var wire 1 ~ Channel 0 $end"
            print "$upscope $end $upscope $end"; next }
        /^\$var/ { next }
        /^#/ { printf "%s r3.3 * $comment # 1! $end ", $0; next }
        /^[01]!/ { print substr($0, 1, 1) "~"; next }
        /^[01]["#$%]/ || /^[01]{}/ {
            at = index("\"#$%", substr($0, 2, 1))
            if (!at) at = 5
            level[at] = substr($0, 1, 1)
            printf "b%s%s%s%s bus ", level[1] == "" ? "x" : level[1], level[2] == "" ? "x" : level[2], level[4] == "" ? "x" : level[4],
                level[5] == "" ? "x" : level[5]
            next
        }
        { printf "%s ", $0 }' "$work/dump.vcd" >"$work/other.vcd"
    oled "$work/other.vcd" --wires 'dc=Channel 0,sck=top.spi.pins[4],mosi=pins[3],cs=pins[2],led=pins[1]' --check "$work/golden"
}
tap_check "vectors, scopes, comments, names with blanks" other_ways

# A reader that kept what it has read would need more than that.
in_little_memory() {
    awk '1; END { for (now = 200000; now < 2200000; now++) print "#" now "\n" now % 2 "{}" }' "$work/dump.vcd" >"$work/long.vcd"
    size_b=$(wc -c <"$work/long.vcd")
    [ "$size_b" -gt 20000000 ] && (ulimit -d 20000 && oled "$work/long.vcd" --check "$work/golden")
}
tap_check "20 MB are read in less memory" in_little_memory
tap_done
