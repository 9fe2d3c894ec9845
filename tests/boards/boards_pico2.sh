# SPDX-License-Identifier: MIT
#
# The Pico 2's image. Its file is read as the RP2350's boot ROM would (rp2350_image.awk), which finds each byte that is
# wrong; its code draws on QEMU's Cortex-M33 what the simulator draws. Nobody has run the image itself.
. tests/tap.sh

board() { # MAKE-ARGUMENT...
    make DEPS=skip BUILD="$BUILD" BOARD=pico2 BOARDS="$kept/boards" PICTURES="$work/pictures" "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
}

folder=$kept/boards/pico2/rooms-st7789-fast image=$folder/image

frames_are_golden() { # MAKE-ARGUMENT...
    board emulate N=4 "$@" && cat "$work/said" && [ "$(grep -c '^frame [0-9]*:' "$work/said")" -eq 4 ] &&
        grep -q '^emulate: no emulator has this chip' "$work/said"
}

# All but the board and its drivers: what the image has of code and constants, it has there.
same_objects_are_linked() {
    for elf in "$image.elf" "$image.an505.elf"; do
        arm-none-eabi-nm -S "$elf" | awk 'NF == 4 && $3 ~ /[tTrR]/ { print $4, $2 }' |
            grep -v 'rp20\|rp2350\|pl022\|systick\|wire_set\|board_init\|^[A-Z]* ' | sort >"$work/$(basename "$elf")"
    done
    grep -c '^lim_' "$work/image.elf" && grep -c '^screen_' "$work/image.elf" && grep '^\(lim_\|screen_\|scene_\|dcs_\|main\)' "$work/image.elf" >"$work/of_the_image" &&
        grep '^\(lim_\|screen_\|scene_\|dcs_\|main\)' "$work/image.an505.elf" | diff "$work/of_the_image" -
}

# What an earlier run has linked stays unused where the compiler fails.
needs_its_own_elf() {
    cp "$image.an505.elf" "$work/old.an505.elf" &&
        ! sh sim/emulators/an505.sh "$work/old" 1 false '' cat >"$work/said" 2>&1 && cat "$work/said" &&
        [ ! -s "$work/said" ] && [ ! -e "$work/old.an505.elf" ]
}

read_by_rules() { # UF2
    od -An -v -tu1 "$1" | awk -f tests/boards/rp2350_image.awk
}

holds_the_rules() {
    read_by_rules "$image.uf2" >"$work/found" && cat "$work/found" &&
        grep -q 'defined at 0x40, .* stack at 0x20082000$' "$work/found"
}

# The whole of the image, no more: the file's pages are those of image.bin, which the linker wrote.
has_all_bytes() {
    size_b=$(wc -c <"$image.bin") && pages=$(((size_b + 255) / 256)) &&
        [ "$(wc -c <"$image.uf2")" -eq $((512 * (pages + 1))) ] &&
        tail -c +513 "$image.uf2" | od -An -v -tx1 -w512 | cut -c 97-864 | tr -d ' \n' | head -c $((2 * size_b)) >"$work/pages" &&
        od -An -v -tx1 "$image.bin" | tr -d ' \n' | cmp - "$work/pages"
}

# A byte of the file, and what the rules say of it. The image's page begins at 512 + 32.
is_found() { # AT BYTE PATTERN
    cp "$image.uf2" "$work/damaged.uf2" &&
        printf '%b' "\\0$(printf %o "$2")" | dd of="$work/damaged.uf2" bs=1 seek="$1" conv=notrunc 2>/dev/null || return 1
    ! read_by_rules "$work/damaged.uf2" >"$work/found" && cat "$work/found" && grep -q "^wrong: .*$3" "$work/found"
}

each_damage_is_found() {
    page=$((512 + 32)) def=$((512 + 32 + 64))
    is_found 0 0 'magic' && is_found 28 86 'absolute' && is_found 40 0 'absolute' && is_found 288 0 'ignored' && is_found 12 1 'absolute' &&
        is_found $((512 + 28)) 86 'family' && is_found $((1024 + 12)) 3 'another address' &&
        is_found $((1024 + 20)) 7 'comes as' && is_found $((page + 3)) 16 'stack' && is_found $((page + 4)) 0 'Thumb' &&
        is_found $((page + 7)) 32 'not in the image' && is_found $((page + 12)) 0 'vector 3' && is_found $def 0 'no block' &&
        is_found $((def + 4)) 65 'kind' && is_found $((def + 6)) 34 'executable' && is_found $((def + 6)) 17 'secure' &&
        is_found $((def + 7)) 17 'Arm' && is_found $((def + 7)) 0 'RP2350' && is_found $((def + 7)) 144 'trial' &&
        is_found $((def + 9)) 2 'last item' && is_found $((def + 12)) 4 'next block' && is_found $((def + 16)) 0 'end'
}

loses_a_block() {
    head -c -512 "$image.uf2" >"$work/short.uf2" && ! read_by_rules "$work/short.uf2" >"$work/found" && cat "$work/found" &&
        grep -q '^wrong: [0-9]* blocks of' "$work/found"
}

# With stand-ins for findmnt, which finds the folder that $DRIVE names if it is asked for the right drive.
flash() {
    mkdir -p "$work/bin" "$work/drive" &&
        printf '#!/bin/sh\ncase $* in *LABEL=RP2350) echo "$DRIVE" ;; esac\n' >"$work/bin/findmnt" && chmod +x "$work/bin/findmnt" &&
        PATH="$work/bin:$PATH" board flash
}

flashes_by_drive() {
    DRIVE=$work/drive flash && cmp "$image.uf2" "$work/drive/image.uf2"
}

says_how_to_mount() {
    ! DRIVE='' flash >/dev/null && cat "$work/said" && grep -q 'hold BOOTSEL' "$work/said"
}

tap_check "its code draws four frames of rooms, each pixel as the simulator does" frames_are_golden
tap_check "what ran are the image's own objects" same_objects_are_linked
tap_check "what an earlier run has linked does not run when the compiler fails" needs_its_own_elf
tap_check "so it does on a display in black and white" frames_are_golden PANEL=ssd1306 SCENE=icosahedron
board image >/dev/null
tap_check "the boot ROM finds an image, its stack and where it begins" holds_the_rules
tap_check "it is the whole of it" has_all_bytes
tap_check "a byte that is wrong is found, wherever it is" each_damage_is_found
tap_check "a file that is not whole is found" loses_a_block
tap_check "make flash copies to the boot drive" flashes_by_drive
tap_check "and says how to have one" says_how_to_mount
tap_done
