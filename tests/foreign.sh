# SPDX-License-Identifier: MIT
#
# Drivers that this project did not write draw its test card, and the emulated modules show it: luma's, from Debian's
# packages of them, and those of Linux, in the kernel of tests/kernel. Which ones is tests/foreign/streams, what came out
# tests/foreign/README.md. --table FILE: that is the table of it, which `make tables TABLES=foreign` writes there.
. tests/tap.sh

here=tests/kernel # for guests
foreign=tests/foreign
table=$([ "${1:-}" != --table ] || echo "$2")
python=/usr/bin/python3 # the one that Debian's packages are for
: >"$work/table"

# rows BY: those of luma or linux, without what is round the fields.
rows() {
    sed '/^#/d; s/ *| */|/g' $foreign/streams | awk -F'|' -v by="$1" '$2 == by'
}

draw_cards() {
    sed '/^#/d' $foreign/streams | cut -d'|' -f4 | sort -u | tr -d ' ' | while IFS=x read -r w_px h_px; do
        "$BUILD/tests/foreign/card" "$w_px" "$h_px" >"$work/card-${w_px}x$h_px.ppm" || return 1
    done
}

# -- Streams -----------------------------------------------------------------------------------------------------------

luma_draws() { # NAME SIZE DRIVER [ARGUMENT...]
    log=$work/$1.log card=$work/card-$2.ppm driver=$3
    shift 3
    "$python" $foreign/luma_stream.py "$driver" "$card" "$@" >"$log"
}

# What the guest recorded, with its times.
linux_draws() { # NAME
    "$BUILD/tests/kernel/wires" 1 <"$stage/on-drivers/$1.wires" >"$work/$1.log"
}

# -- Glass -------------------------------------------------------------------------------------------------------------

# shellcheck disable=SC2086 # options are words
decode() { # LOG MODULE PICTURE
    "$BUILD/limner" decode "$1" --foreign --panel $2 --frames 1 -o "$3-%d.png"
}

judge() { "$python" $foreign/judge.py "$@"; }

# Whether the module shows the card, all of it.
shows_card() { # NAME SIZE KIND MODULE
    decode "$work/$1.log" "$4" "$work/$1" 2>"$work/$1.notices" || { cat "$work/$1.notices"; return 1; }
    judge "$work/card-$2.ppm" "$3" "$work/$1-0.png" >"$work/$1.judged"
    cat "$work/$1.judged"
    grep -q '^0 of ' "$work/$1.judged"
}

tabulate() { # NAME BY DRIVER SIZE KIND MODULE PRODUCT
    sed "s,^limner: .*/,# ," "$work/$1.notices"
    echo "| ${6%% *} | $7 | $2: \`$3\` | $4 $5 | $(cat "$work/$1.judged") |" >>"$work/table"
}

judge_row() { # NAME BY DRIVER SIZE KIND MODULE PRODUCT
    # shellcheck disable=SC2086 # what it is told are words
    case $2 in
    luma) tap_check "$1: luma draws" luma_draws "$1" "$4" $3 ;;
    linux) tap_check "$1: Linux draws" linux_draws "$1" ;;
    esac
    tap_check "$1: ${6%% *} shows the card" shows_card "$1" "$4" "$5" "$6"
    [ ! -s "$work/$1.judged" ] || tabulate "$@"
}

judge_rows() { # BY
    while IFS='|' read -r name by driver size kind module product; do
        judge_row "$name" "$by" "$driver" "$size" "$kind" "$module" "$product"
    done <<END
$(rows "$1")
END
}

# -- What must be noticed ----------------------------------------------------------------------------------------------

# The byte after a command, exchanged for another.
told_otherwise() { # NAME COMMAND BYTE
    awk -v command="b $2" -v byte="$3" '
        is_next && /^b/ { $2 = byte; is_next = 0 }
        $0 == command { is_next = 1 }
        { print }' "$work/$1.log" >"$work/otherwise.log"
    ! cmp -s "$work/$1.log" "$work/otherwise.log"
}

# The last byte of the last line that has pixels.
with_other_pixels() { # NAME
    awk '{ line[NR] = $0 } /^b/ && NF > 64 { last = NR }
        END {
            sub(/[0-9A-F][0-9A-F]$/, line[last] ~ /FF$/ ? "00" : "FF", line[last])
            for (i = 1; i <= NR; i++) print line[i]
        }' "$work/$1.log" >"$work/otherwise.log"
}

# judged PATTERN SIZE KIND MODULE: what the exchanged log shows is not the card, which is said so.
judged() {
    decode "$work/otherwise.log" "$4" "$work/otherwise" &&
        ! judge "$work/card-$2.ppm" "$3" "$work/otherwise-0.png" >"$work/said" && cat "$work/said" && grep -q "$1" "$work/said"
}

mirror_is_noticed() { told_otherwise luma-ili9341 36 68 && judged mirrored 320x240 colours 'ili9341 --rotate 90'; }
shift_is_noticed() { told_otherwise luma-ssd1351 A1 05 && judged rolled 128x128 colours ssd1351; }
pixels_are_noticed() { with_other_pixels luma-ssd1327 && judged '^2 of ' 128x128 greys ssd1327; }

# -- The table ---------------------------------------------------------------------------------------------------------

chips_shown() { # BY, a pattern
    sed -n "s/^| \([a-z0-9]*\) .*| $1: .*| 0 of .*/\1/p" "$work/table" | sort -u
}

enough_chips() { # COUNT BY
    chips_shown "$2"
    [ "$(chips_shown "$2" | wc -l)" -ge "$1" ]
}

# All that was measured stands there, and nothing else of the same drivers.
page_says_so() { # BY
    sh sim/tools/tables.sh --show foreign | grep "| $1: " >"$work/said"
    grep "| $1: " "$work/table" | LC_ALL=C sort | diff "$work/said" -
}

# A page has both drivers' rows.
write_table() {
    for by in luma linux; do
        [ -n "$(chips_shown $by)" ] || { echo "the drivers of $by drew nothing"; return 1; }
    done
    echo '| chip | module | driven by | picture | outcome |'
    echo '| --- | --- | --- | --- | --- |'
    LC_ALL=C sort "$work/table"
    printf '\n%s of the 16 chips: %s by luma, %s by Linux.\n' "$(chips_shown '.*' | wc -l)" \
        "$(chips_shown luma | wc -l)" "$(chips_shown linux | wc -l)"
}

written() { # FILE
    write_table >"$work/written" && cp "$work/written" "$1" || { cat "$work/written"; return 1; }
}

# -- All of it ---------------------------------------------------------------------------------------------------------

tap_check "the card is drawn" draw_cards

if "$python" -c 'import luma.lcd.device, luma.oled.device' 2>"$work/said"; then
    judge_rows luma
    tap_check "11 of the 16 chips show what luma draws" enough_chips 11 luma
    tap_check "a mirrored picture is noticed, and named" mirror_is_noticed
    tap_check "so is a shifted one" shift_is_noticed
    tap_check "so is one byte of two pixels" pixels_are_noticed
    [ -n "$table" ] || tap_check "the page says what luma's streams showed" page_says_so luma
else
    tap_skip "luma's drivers" "Debian's packages python3-luma.lcd and python3-luma.oled are not installed"
fi

# -- Linux -------------------------------------------------------------------------------------------------------------

. tests/kernel/guests.sh

judge_linux() {
    # shellcheck disable=SC2154 # of guests.sh
    prepare_guests &&
        cp "$BUILD/tests/kernel/power_off" "$BUILD/tests/kernel/paint" $foreign/streams "$work"/card-*.ppm "$stage" &&
        chmod -R a+rX "$stage"
    guest drivers usual drivers
    if cannot_start drivers; then
        tap_skip "Linux' drivers" "User Mode Linux does not start here: $(tail -n 1 "$work/drivers.console")"
        return
    fi
    tap_check "the guest draws" is_good drivers
    judge_rows linux
    [ -n "$table" ] || tap_check "the page says what Linux' streams showed" page_says_so linux
}

kernel=$(sh tests/kernel/build.sh --path 2>&1) || status=$?
case ${status:-0} in
0) judge_linux ;;
2) tap_skip "Linux' drivers" "$kernel" ;;
*)
    echo "$kernel" >"$work/why"
    tap_fail "the tests' kernel builds" "$work/why"
    ;;
esac
[ -z "$table" ] || tap_check "the table has both drivers' rows" written "$table"
tap_done
