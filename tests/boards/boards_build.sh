# SPDX-License-Identifier: MIT
#
# Every board's image builds, for its own scene and panel and for others; what a board cannot hold is refused with the
# reason; a board is one folder. Of the images that are not a board's own, half in each run (tests/part_of.sh).
. tests/tap.sh
. tests/part_of.sh

built=$(cd "$BUILD" && pwd) # seen from a copy of the project as well

# From the project's folder, or another one that is like it.
board() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$built" BOARDS="$kept/boards" "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

refused() { # PATTERN MAKE-ARGUMENT...
    pattern=$1
    shift
    if board "$@" >/dev/null; then
        echo "it was built"
        return 1
    fi
    cat "$work/said" && grep -q "$pattern" "$work/said" && ! find "$kept/boards" -name 'image.[ebh]*' -newer "$work/began" | grep .
}

builds() { # MAKE-ARGUMENT...
    board "$@" && grep -q '^  flash  *[0-9]' "$work/said" && grep -q '^  RAM  *[0-9]' "$work/said"
}

# All of the image that is left of what its scene asks for.
builds_in_less() { # MAKE-ARGUMENT...
    builds "$@" && cat "$work/said" && grep -q 'asks for [0-9]* bytes and gets' "$work/said"
}

# The project with one more folder in it, which is a copy of another board's.
copy_board() { # FROM TO
    mkdir -p "$work/project/boards" && ln -s "$PWD"/boards/* "$work/project/boards" &&
        ln -s "$PWD/Makefile" "$PWD/firmware" "$PWD/hal" "$PWD/sim" "$work/project" &&
        cp -rL "boards/$1" "$work/project/boards/$2"
}

copied_board_builds() {
    copy_board bluepill mine && (cd "$work/project" && builds BOARD=mine) && grep -q '^mine: ' "$work/said" &&
        ls "$kept"/boards/mine/*/image.bin
}

# Of the image before: SSD1306s turn nothing by 90 degrees.
turned_cameras() { # W_PX H_PX
    header=$kept/boards/bluepill/icosahedron-ssd1306-fast/cameras.h
    grep '^#define' "$header" && grep -qx "#define CAMERAS_W_PX $1" "$header" && grep -qx "#define CAMERAS_H_PX $2" "$header"
}

flash_tool_is_named() {
    ! board flash BOARD=bluepill FLASH_TOOL=no-such-tool >/dev/null && cat "$work/said" &&
        grep -q 'no-such-tool is missing' "$work/said"
}

# Without hardware, in one line.
says_what_is_wrong() {
    LIMNER_SPI=/dev/null "$kept"/boards/linux/*/image.elf 2>"$work/said"
    [ $? -eq 1 ] && cat "$work/said" && [ "$(cat "$work/said")" = "limner: LIMNER_SPI=/dev/null: not an SPI device" ]
}

for folder in boards/*/board.mk; do
    name=${folder%/board.mk} name=${name#boards/}
    tap_check "$name: its image builds" builds BOARD="$name"
done
touch "$work/began"
tap_check "a program says what it cannot draw on" says_what_is_wrong
turned_builds() {
    builds BOARD=bluepill PANEL=ssd1306 MODULE='--rotate 90' SCENE=icosahedron && turned_cameras 64 128
}

echo "# SEED=$SEED"
for image in $(part_of 2 panel moving pathless turned changes bands); do
    case $image in
    panel) tap_check "another panel does" builds BOARD=bluepill PANEL=ssd1306 SCENE=icosahedron ;;
    moving) tap_check "a scene that moves does" builds BOARD=stm32f405 PANEL=ili9341 SCENE=movers PRECISION=fine ;;
    pathless) tap_check "one without a path of its own does" builds BOARD=bluepill SCENE=icosahedron PANEL=st7735:rgb444 ;;
    turned) tap_check "a turned picture does, and its cameras see what the viewer does" turned_builds ;;
    changes) tap_check "what changes alone does" builds BOARD=stm32f405 COMPILE=--delta ;;
    bands) tap_check "with less RAM than the scene asks for it draws in bands" builds_in_less BOARD=bluepill RAM_B=7168 ;;
    esac
done
sleep 0.01
touch "$work/began"
tap_check "too little RAM is refused" refused 'RAM is short by [0-9]* of 3000 bytes' BOARD=bluepill RAM_B=3000
tap_check "too little flash is refused" refused 'flash is short by [0-9]* of 40000 bytes' BOARD=bluepill FLASH_B=40000
tap_check "more than the linker's region is refused" refused 'flash is short by' BOARD=bluepill SCENE=demo
tap_check "a path that leads to a board is refused" refused 'there is no board' BOARD=../boards/bluepill
tap_check "a board that is not there is refused" refused 'there is no board nix; there are: ' BOARD=nix
tap_check "a scene that is not there is refused" refused 'there is no scene nix' BOARD=bluepill SCENE=nix
tap_check "a camera path that is not there is refused" refused 'there is no camera path nix.cam' BOARD=bluepill CAMERA=nix.cam
tap_check "a time that is none is refused" refused 'CARD_MS=soon: must be a whole number of milliseconds' BOARD=bluepill \
    SCENE=test-card CARD_MS=soon
tap_check "a path with spaces is refused" refused 'no paths with spaces' BOARD=bluepill SCENE='a b'
tap_check "a panel that is not there is refused" refused 'no such panel; there are' BOARD=bluepill PANEL=nix
tap_check "a precision that is not there is refused" refused 'precision' BOARD=bluepill PRECISION=nix
tap_check "a tool for flashing that is missing is named" flash_tool_is_named
tap_check "a copied folder is a board" copied_board_builds
tap_done
