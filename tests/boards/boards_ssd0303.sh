# SPDX-License-Identifier: MIT
#
# QEMU's own SSD0303, on the I2C of the LM3S811 Evaluation Board, shows what the firmware of boards/common draws. The chip
# speaks SH1106's commands: pages, and columns by halves, of 132. Its glass, 96x16, begins at the column addressed 36.
. tests/tap.sh

limner=$BUILD/limner
model=sim/scenes/hexecontahedron.obj

compile() { # SOURCE...: for the board
    # shellcheck disable=SC2086 # warnings are words
    printf '%s\n' "$@" | (cd "$work/objects" && xargs -P 2 -n 16 arm-none-eabi-gcc -std=c11 -ffreestanding -mthumb \
        -mcpu=cortex-m3 -Os $WARNINGS -ffunction-sections -fdata-sections -I"$work" -DLIM_CONFIG='"model.h"' \
        -I"$OLDPWD/firmware" -I"$OLDPWD/hal" -I"$OLDPWD/hal/mcu" -I"$OLDPWD/boards/common" -c)
}

# The scene, from one camera for ever.
compile_scene() { # CAMERA
    mkdir -p "$work/objects"
    echo "$1" >"$work/path.cam"
    "$limner" compile $model --size 96x16 -o "$work/model" &&
        "$limner" render "$work/model.lim" --camera "$work/path.cam" --size 96x16 --panel ssd1306 --write-hashes "$work/golden" \
            --write-cameras "$work/cameras.h" -o "$work/golden-%d.png" &&
        compile "$work/model.c" "$PWD"/firmware/*.c "$PWD"/firmware/*/*.c "$PWD"/hal/*.c "$PWD/tests/i2c_board/board.c" \
            "$PWD"/boards/common/screen.c "$PWD"/boards/common/walker.c "$PWD"/boards/common/bare_image.c \
            "$PWD"/boards/common/start_cortex_m.c
}

# The module is that of an SH1106 whose glass begins so many columns from its edge.
builds() { # COLUMN
    "$limner" module --panel sh1106 --size 96x16 --offset "$1,0" -o "$work/module" &&
        compile "$work/module.c" "$PWD/boards/common/main.c" "$PWD/boards/common/app_scene.c" &&
        arm-none-eabi-gcc -mthumb -mcpu=cortex-m3 -nostdlib -Wl,--gc-sections -Lboards/common -T tests/i2c_board/memory.ld \
            -Wl,--defsym=image_stack_b=2K -o "$work/image.elf" "$work"/objects/*.o -lgcc
}

is_golden() { "$limner" hashes "$work/shown.png" --shrink 4 --check "$work/golden"; }

# The same frame is drawn again and again: pictures of the display are taken until one is right, so many times at most.
take_pictures() { # TIMES
    for _ in $(seq "$1"); do
        sleep 0.3
        echo "screendump $work/shown.png -f png"
        sleep 0.1
        ! is_golden >/dev/null 2>&1 || break
    done
    echo quit
}

run() { # TIMES
    rm -f "$work/shown.png"
    take_pictures "$1" | timeout -k 5 60 qemu-system-arm -M lm3s811evb -kernel "$work/image.elf" -display none -serial none \
        -monitor stdio -nodefaults >"$work/monitor" 2>"$work/said"
    cat "$work/said"
}

shows_frame() { builds 36 && run 50 && is_golden; }

# Of SH1106's commands that of the converter's voltage is none of SSD0303's.
knows_commands() {
    grep 'ssd0303' "$work/said"
    ! grep 'ssd0303' "$work/said" | grep -v 'Unknown command: 0x33$'
}

is_not_another_place() { builds 32 && run 3 && [ -s "$work/shown.png" ] && ! is_golden; }

tap_check "a scene compiles for the board" compile_scene '0.2 0.1 1.08 0.1 0.05 0.2'
tap_check "QEMU's SSD0303 shows the frame, each of its pixels" shows_frame
tap_check "it knows the driver's commands, but for one" knows_commands
tap_check "a picture that begins four columns beside is another" is_not_another_place
tap_done
