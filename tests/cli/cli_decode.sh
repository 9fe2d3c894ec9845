# SPDX-License-Identifier: MIT
#
# `limner decode` and `limner hashes` from the outside. The firmware of boards/common for a display of each family runs
# on a board that is this computer and writes down what goes over its wires (tests/wire_board); decoded, these are the
# frames that `limner render` has of that panel, and no wait was too short. Bad input ends with one line that names it.
. tests/tap.sh
. tests/wire_board/firmware.sh

decode() { # OPTION...: of what the firmware does
    "$work/firmware" | timeout 20 "$limner" decode - "$@"
}

shows() { # SIZE RENDERED-PANEL PANEL OPTION...
    make_firmware "$@" || return 1
    shift 2
    decode --panel "$@" --frames 4 --check "$work/golden"
}

tap_check "a scene compiles for this computer" compile_scene
tap_check "a colour panel's wires give the frames that render has" shows 160x128 st7789:rgb444 \
    st7735:rgb444 --rotate 90
tap_check "in mirrors too, and off the corner of the chip's memory" shows 96x80 st7789 st7789 --size 96x80 \
    --mirror --rotate 180
tap_check "so do those of round glass" shows 240x240 gc9a01 gc9a01
tap_check "those of pages" shows 128x64 sh1106 sh1106 --invert
tap_check "those of greys" shows 128x64 ssd0323 ssd0323
# The voltage on it must not keep its sign for a second.
memory_lcd_is_kept() {
    DEFINES='-DBOARD_CARD=1 -DBOARD_CARD_MS=2600' make_firmware 128x128 ls013b7dh03 ls013b7dh03 &&
        "$limner" card --panel ls013b7dh03 --write-hashes "$work/card" &&
        cat "$work/card" "$work/golden" "$work/card" | awk '{ print NR - 1, $2 }' >"$work/all" &&
        decode --panel ls013b7dh03 --frames 6 --check "$work/all"
}
tap_check "the self-test keeps a memory LCD while it shows the card" memory_lcd_is_kept
tap_check "those of a memory LCD, whose select is the driver's" shows 128x128 \
    ls013b7dh03 ls013b7dh03

# -- What is made of them: the last firmware's frames ------------------------------------------------------------------

log=$work/wires
wires_of_four >"$log"

lcd() { # OPTION...
    "$limner" decode "$log" --panel ls013b7dh03 "$@"
}

writes_files() {
    lcd --write-hashes "$work/hashes" -o "$work/%d.png" >"$work/said" && cmp "$work/golden" "$work/hashes" &&
        [ "$(wc -l <"$work/said")" -eq 4 ] && "$limner" hashes "$work/0.png" "$work/1.png" "$work/2.png" "$work/3.png" \
        --check "$work/golden"
}
tap_check "hashes and pictures are those of render" writes_files

cut_bytes() { # all lines, one of them without its last byte
    awk 'NF > 16 && !cut++ { sub(/ [0-9A-F][0-9A-F]$/, "") } { print }' "$log" >"$work/cut"
}

cut_waits() {
    grep -v '^t' "$log" | awk '{ print } NR == 1 { print "t 0" }' >"$work/hasty"
}

sed 's/^0 .*/0 0123456789abcdef/' "$work/golden" >"$work/other"
cut_bytes
cut_waits
tap_check "a frame that differs is an error" fails 'other: frame 0 differs: hash .*, expected 0123456789abcdef' lcd \
    --check "$work/other"
tap_check "a byte that is missing is one of the chip's complaints, with its line" fails \
    'cut:[0-9]+: emulated ls013b7dh03: 1 complaints' "$limner" decode "$work/cut" --panel ls013b7dh03 \
    -o "$work/bad/%d.png"
tap_check "so is a wait that is too short, if time is told" fails 'hasty:[0-9]+: .*too soon' \
    "$limner" decode "$work/hasty" --panel ls013b7dh03
tap_check "frames that do not come are an error" fails 'wires: ends after 4 of 5 frames' lcd --frames 5 \
    --write-hashes "$work/bad/hashes"

bad_line() { # LINE TEXT
    printf '# first\n%s\n' "$1" >"$work/line"
    fails "^limner: $work/line:2: $2" "$limner" decode "$work/line" --panel st7789
}

tap_check "a byte that is none is refused" bad_line 'b 12 3' "' 3' is no byte of two hexadecimal digits$"
tap_check "a wire that is none is refused" bad_line 'p data 1' "'data' is no wire: dc, "
tap_check "a level that is none is refused" bad_line 'p dc 2' "a level is 0 or 1, not ' 2'$"
tap_check "a time that is none is refused" bad_line 't -5' "' -5' is no number of nanoseconds$"
tap_check "any other line is refused" bad_line 'x' "'x' is no line of a wire log$"
tap_check "a log that is not there is refused" fails '^limner: nosuch: No such file' "$limner" decode nosuch \
    --panel st7789
tap_check "a log is required" fails '^limner: decode: needs a wire log' "$limner" decode --panel st7789
tap_check "a panel is required" fails '^limner: --panel NAME is missing' "$limner" decode "$log"
tap_check "a number of frames is a number" fails '^limner: --frames 0: ' lcd --frames 0

# -- QEMU's trace ------------------------------------------------------------------------------------------------------

# The same wires, as an STM32, a PL061 and an FE310 would write them to their registers.
awk -v out="$work" '
    function trace(file, address, value) {
        printf "memory_region_ops_write cpu 0 mr 0x55e0 addr 0x%x value 0x%x size 4\n", address, value >file
    }
    BEGIN {
        bit["dc"] = 1; bit["reset"] = 2; bit["select"] = 4; bit["backlight"] = 8; bit["led"] = 16
        for (hex = 0; hex < 256; hex++) value[sprintf("%02X", hex)] = hex
    }
    $1 == "b" {
        for (i = 2; i <= NF; i++) {
            trace(out "/bsrr", 1073819660, value[$i])
            trace(out "/masked", 1073774600, value[$i])
            trace(out "/output", 268582984, value[$i])
        }
    }
    $1 == "p" {
        level[$2] = $3
        trace(out "/bsrr", 1073872920, bit[$2] * ($3 ? 1 : 65536))
        trace(out "/masked", 1073766400 + 4 * bit[$2], $3 ? 255 : 0)
        levels = 0
        for (name in bit) levels += bit[name] * level[name]
        trace(out "/output", 268509196, levels)
    }' "$log"

map() { # IDIOM SPI-ADDRESS PIN-ADDRESS
    printf 'spi %s\n' "$2" >"$work/$1.map"
    bit=0
    for pin in dc reset select backlight led; do
        echo "pin $pin $1 $3 $bit # a wire"
        bit=$((bit + 1))
    done >>"$work/$1.map"
}

map bsrr 4001300c 40020018
map masked 0x40008008 0x40006000
map output 10024048 1001200c
for idiom in bsrr masked output; do
    tap_check "register idiom $idiom: the same frames" "$limner" decode "$work/$idiom" --qemu "$work/$idiom.map" \
        --panel ls013b7dh03 --frames 4 --check "$work/golden"
done

talks() { # QEMU's and the firmware's own lines are not lost, and time stamps do no harm
    awk 'NR == 5 { print "HSE timeout" } { print "123@1700000000.250000:" $0 }' "$work/bsrr" >"$work/talk"
    "$limner" decode - --qemu "$work/bsrr.map" --panel ls013b7dh03 --check "$work/golden" <"$work/talk" \
        2>"$work/said" &&
        [ "$(cat "$work/said")" = "limner: standard input:5: no trace: HSE timeout" ]
}
tap_check "what is said between the lines of a trace is passed on" talks
echo 'memory_region_ops_write cpu 0 mr 0x55e0' >"$work/torn"
tap_check "a line that is torn is refused" fails '^limner: .*torn:1: a trace without addr or value' "$limner" decode \
    "$work/torn" --qemu "$work/bsrr.map" --panel st7789

bad_map() { # LINE TEXT
    printf 'spi 4001300c\npin led bsrr 40020018 4\n%s\n' "$1" >"$work/map"
    fails "^limner: $work/map:3: $2" lcd --qemu "$work/map"
}
tap_check "a map's line that is none is refused" bad_map 'pin dc bsrr 40020018' 'neither .spi ADDRESS. nor .pin NAME'
tap_check "a map's wire that is none is refused" bad_map 'pin data bsrr 40020018 1' "'data' is no wire: dc, "
tap_check "a map's idiom that is none is refused" bad_map 'pin dc odr 40020018 1' "'odr' is no idiom: bsrr, "
tap_check "a map's address that is none is refused" bad_map 'spi SPI1' "'SPI1' is no hexadecimal address"
tap_check "a map's bit that is none is refused" bad_map 'pin dc masked 40006000 8' "'8' is no bit: masked has 0..7"
echo 'spi 4001300c' >"$work/map"
tap_check "a map without what ends frames is refused" fails 'map: no line .pin led' lcd --qemu "$work/map"
echo 'pin led bsrr 40020018 4' >"$work/map"
tap_check "a map without an SPI is refused" fails 'map: no line .spi ADDRESS' lcd --qemu "$work/map"

# -- Pictures ----------------------------------------------------------------------------------------------------------

tap_check "a picture whose pixels are no whole squares is refused" fails '0.png: pixel 12,10 has several colours' \
    "$limner" hashes --shrink 4 "$work/0.png" --write-hashes "$work/bad/hashes"
tap_check "a picture that is none is refused" fails 'golden: not a readable PNG file$' "$limner" hashes "$work/golden"
tap_check "a picture is required" fails '^limner: hashes: needs pictures' "$limner" hashes --check "$work/golden"
tap_done
