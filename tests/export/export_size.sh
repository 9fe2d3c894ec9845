# SPDX-License-Identifier: MIT
#
# An exported renderer takes no more code than the same sources one by one: text at -Os, linked with the sections that are
# used alone, 1 % at most above.
. tests/tap.sh
. sim/targets/targets.sh

mkdir -p "$kept"

# What the linker starts from, and what a bare image has to have.
cat >"$kept/start.c" <<'END'
#include <stddef.h>
#include <stdint.h>
int main(void);
void start(void);
int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px);
void *memcpy(void *to, const void *from, size_t n);
void *memset(void *at, int value, size_t n);
static volatile unsigned sink;
void start(void)
{
    sink = (unsigned)main();
}
int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    sink = pixels[0] + y_px + x_px + n_px;
    return 0;
}
void *memcpy(void *to, const void *from, size_t n)
{
    for (size_t i = 0; i < n; i++)
        ((char *)to)[i] = ((const char *)from)[i];
    return to;
}
void *memset(void *at, int value, size_t n)
{
    for (size_t i = 0; i < n; i++)
        ((char *)at)[i] = (char)value;
    return at;
}
END

# text_b CORE NAME FLAG|SOURCE...: bytes of the image's code and constants.
text_b() {
    core=$1 name=$2 flags='' objects='' number=0
    shift 2
    for word; do
        case $word in
        *.c) ;;
        *) flags="$flags $word" ;;
        esac
    done
    mkdir -p "$kept/$name.$core"
    for word; do
        [ "${word%.c}" != "$word" ] || continue
        number=$((number + 1))
        objects="$objects $kept/$name.$core/$number.o"
        # shellcheck disable=SC2046,SC2086 # flags are words
        $CCACHE $(target_compiler "$core") $(target_flags "$core") -Os -ffreestanding -fno-builtin -ffunction-sections -fdata-sections $flags \
            -c -o "$kept/$name.$core/$number.o" "$word" || return 1
    done
    # shellcheck disable=SC2046,SC2086
    $(target_compiler "$core") $(target_flags "$core") -nostdlib -Wl,--gc-sections -Wl,-e,start -Wl,--no-warn-rwx-segments -o "$kept/$name.$core/image" $objects -lgcc &&
        "$(target_tools "$core")size" "$kept/$name.$core/image" | awk 'NR > 1 { print $1 }'
}

is_no_larger() { # CORE NAME MODEL OPTION...
    core=$1 name=$2 model=$3
    shift 3
    rm -rf "$kept/$name"
    mkdir -p "$kept/$name"
    "$BUILD/limner" compile "$model" -o "$kept/$name/model" "$@" >/dev/null &&
        "$BUILD/limner" export "$model" --for plain -o "$kept/$name/export/model" "$@" >/dev/null || return 1
    folder=$kept/$name/export/model
    one=$(text_b "$core" "$name-one" -I"$folder" "$folder"/*.c "$kept/start.c") &&
        many=$(text_b "$core" "$name-many" -DLIM_CONFIG='"model.h"' -I"$kept/$name" -Ifirmware "$folder/main.c" "$kept/$name"/*.c firmware/*.c firmware/*/*.c \
            "$kept/start.c") || return 1
    echo "exported: $one bytes, from separate files: $many"
    [ "$one" -gt 5000 ] && [ $((one * 100)) -le $((many * 101)) ]
}

scenes=sim/scenes
tap_check "a convex solid on Cortex-M0+" is_no_larger m0plus icosahedron $scenes/icosahedron.obj --method convex
tap_check "rooms, nearest first, on Cortex-M4" is_no_larger m4 rooms $scenes/rooms.obj
tap_check "the teapot, by scan lines, in profile exact on Cortex-M0+" is_no_larger m0plus teapot $scenes/teapot.obj --precision exact
tap_check "glass with smooth edges as RV32IMC" is_no_larger rv32 glass $scenes/glass.obj --antialias
tap_check "what moves on Cortex-M33" is_no_larger m33 movers $scenes/movers.gltf
tap_check "knots that are sorted and split, by changes alone, on Cortex-M0+" is_no_larger m0plus knot $scenes/knot.obj --method newell --delta
tap_done
