# SPDX-License-Identifier: MIT
#
# What the images of boards draw in emulators that others wrote: eight frames of a path, whole, each pixel as the
# simulator draws it. The images are those of boards/images.txt, half of them in each run (tests/part_of.sh), of which the table in boards/README.md must say what is measured
# here.
. tests/tap.sh
. tests/part_of.sh

board() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$BUILD" BOARDS="$kept/boards" PICTURES="$work/pictures" "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

# No two pictures of a path are the same file.
pictures_differ() { # COUNT
    find "$work/pictures" -name '*.png' -exec cksum {} + | cut -d ' ' -f 1,2 | sort -u >"$work/sums"
    [ "$(wc -l <"$work/sums")" -eq "$1" ]
}

draws() { # MAKE-ARGUMENT...
    rm -rf "$work/pictures"
    board emulate N=8 "$@" || return 1
    cat "$work/said"
    [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq 8 ] && pictures_differ 8
}

draws_row() { # MAKE-ARGUMENT...
    rm -rf "$work/pictures"
    board -s cost N=8 "$@" && cat "$work/said" && pictures_differ 8 && tail -n 1 "$work/said" >"$work/row" &&
        grep -qxF -f "$work/row" "$work/page"
}

# Packages of npm are fetched, which may not be possible: that says why.
npm_fails() { # MAKE-ARGUMENT...
    case $1 in
    BOARD=pico) ! sh sim/emulators/npm.sh >/dev/null 2>"$work/npm" ;;
    *) false ;;
    esac
}

# With golden frames of which the first differs in one digit.
tells_wrong_pixels() { # GOLDEN MAKE-ARGUMENT...
    sed '1s/.$/x/; 1s/[0-7]x$/8/; 1s/[89a-f]x$/0/; 1s/x$/0/' "$1" >"$work/wrong"
    shift
    ! board emulate CHECK="$work/wrong" "$@" >/dev/null && cat "$work/said" && grep -q 'frame 0 differs' "$work/said"
}

# The mode in which an image's first byte goes out: the two bits of SPI's register that say so, as QEMU sees it written.
starts_in_mode() { # MODE SYSTEM MACHINE CONTROL DATA IMAGE
    said=$(sh sim/emulators/qemu.sh "$2" "$3" "$6" awk -v control="0x$4" -v data="0x$5" '
        $7 == control { value = $9 }
        $7 == data { print value; exit }') && echo "control register: $said" && [ -n "$said" ] &&
        [ $((said & 3)) -eq "$1" ]
}

draws_in_mode() { # MODE SYSTEM MACHINE CONTROL DATA BOARD PANEL
    board BOARD="$6" BOARDS="$kept/boards/f100" PART=f100 PANEL="$7" SCENE=icosahedron image &&
        starts_in_mode "$1" "$2" "$3" "$4" "$5" "$kept/boards/f100/$6/icosahedron-$7-fast/image.elf"
}

sh sim/tools/tables.sh --show boards >"$work/page"
part_of 2 "$(cat boards/images.txt)" >"$work/rows"
echo "# SEED=$SEED"
while read -r row; do
    # shellcheck disable=SC2086 # arguments are words
    if npm_fails $row; then
        tap_skip "$row: eight frames" "$(grep -m 1 'code\|missing' "$work/npm" || tail -n 1 "$work/npm")"
    else
        tap_check "$row: eight frames, at the cost that boards/README.md says" draws_row $row
    fi
done <"$work/rows"
page_has_no_other_row() {
    [ "$(grep -c '^| [a-z]' "$work/page")" -eq $(($(wc -l <boards/images.txt) + 1)) ]
}
tap_check "boards/README.md has a row for each, and no other" page_has_no_other_row
tap_check "a scene that moves, 18 bits a pixel" draws BOARD=stm32f405 SCENE=movers PANEL=st7735:rgb666
tap_check "what changes alone" draws BOARD=stm32f405 COMPILE=--delta
tap_check "changes of text over frames" draws BOARD=stm32f405 COMPILE='--delta --overlay'
tap_check "text over a solid whose runs go into pages" draws BOARD=arduboy SCENE=icosahedron COMPILE=--overlay
tap_check "a memory LCD" draws BOARD=hifive1 PANEL=ls013b7dh03 SCENE=icosahedron
for row in 'arm netduinoplus2 40013000 4001300c stm32f405' 'riscv32 sifive_e 10024004 10024048 hifive1' \
    'arm stm32vldiscovery 40013000 4001300c bluepill'; do
    # shellcheck disable=SC2086 # arguments are words
    {
        tap_check "${row##* }: mode 0, where the clock must be low between messages" draws_in_mode 0 $row ls013b7dh03
        tap_check "${row##* }: mode 3 elsewhere" draws_in_mode 3 $row st7735
    }
done
tap_check "a wrong pixel is told" tells_wrong_pixels "$kept/boards/stm32f405/rooms-st7789-fast/golden.8" BOARD=stm32f405
tap_done
