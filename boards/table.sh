# SPDX-License-Identifier: MIT
#
# Prints the table of boards: what their images take, and what a frame costs, drawn and checked in an emulator.
# With --write puts it into boards/README.md between its markers. With --rows says of which images, a line of arguments of
# `make cost` for each.
set -eu
. sim/tools/page_table.sh

: "${BUILD:=build}"

rows() {
    cat <<'END'
BOARD=lm3s6965evb
BOARD=pico
BOARD=pico SCENE=teapot
BOARD=stm32f405
BOARD=stm32f405 SCENE=teapot
BOARD=stm32f405 PANEL=ssd1351 MODULE=--size=128x128 COMPILE=--framebuffer
BOARD=bluepill
BOARD=bluepill PART=f100 PANEL=st7789
BOARD=bluepill PART=f100
BOARD=hifive1
BOARD=arduboy
BOARD=arduboy SCENE=icosahedron OUTLINES=yes
END
}

table() {
    table_head
    rows | while read -r row; do
        # shellcheck disable=SC2086 # arguments are words
        make -s cost DEPS=skip BUILD="$BUILD" $row </dev/null >"$work/said" || { cat "$work/said" >&2; exit 1; }
        tail -n 1 "$work/said"
    done
}

table_head() {
    echo "| board | scene | panel | flash, bytes | RAM, bytes | stack, bytes | processor, a frame | bus, bytes a frame | frames/s: processor | bus |"
    echo "|---|---|---|---|---|---|---|---|---|---|"
}

case ${1:-} in
--rows) rows ;;
*)
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    table >"$work/table"
    if [ "${1:-}" = --write ]; then page_write boards "$work/table"; else cat "$work/table"; fi
    ;;
esac
