# SPDX-License-Identifier: MIT
#
# For test scripts to source: builds the renderer with some of its features and renders with it. A choice of
# features is a number, a bit each; what a scene needs is there in any case. Every build, with all warnings as errors,
# must paint what the full renderer of `limner render` paints.
# shellcheck shell=sh

features='LIM_HAS_NEAREST LIM_HAS_CONVEX LIM_HAS_PAINTER LIM_HAS_STATS LIM_HAS_CULL LIM_HAS_SLANTED LIM_HAS_LARGE
    LIM_HAS_SCANLINE LIM_HAS_STREAM'
features_count=9

features_prepare() { # NAME [NAME-OF-CAMERAS]: the scene as C, ten cameras, and the hashes that the full renderer gives
    rm -rf "$kept/$1"
    mkdir -p "$kept/$1"
    awk '!/^#/ && NF && n++ % 7 == 0' "sim/scenes/${2:-$1}.cam" | head -n 10 >"$work/few.cam"
    "$BUILD/limner" compile "sim/scenes/$1.obj" --size 96x64 -o "$kept/$1/model" >/dev/null &&
        "$BUILD/limner" render "$kept/$1/model.lim" --camera "$work/few.cam" --size 96x64 \
            --write-hashes "$kept/$1/expected" --write-cameras "$kept/$1/cameras.h" || return 1
    [ "$(cut -d ' ' -f 2 "$kept/$1/expected" | sort -u | wc -l)" -eq 10 ]
}

# The flags of a choice. A flag is 1 if its bit is or the scene's header says so; large planes are slanted.
features_flags() { # NAME CHOICE
    awk -v choice="$2" -v names="$features" '
        /#define LIM_HAS_/ { needed[$2] = $3 }
        END {
            count = split(names, name, " ")
            for (i = 1; i <= count; i++) on[name[i]] = needed[name[i]] || int(choice / 2 ^ (i - 1)) % 2
            if (on["LIM_HAS_LARGE"]) on["LIM_HAS_SLANTED"] = 1
            for (i = 1; i <= count; i++) printf "-D%s=%d ", name[i], on[name[i]]
        }' "$kept/$1/model.h"
}

features_build() { # COMPILER NAME FLAGS: $kept/NAME/program
    rm -rf "$kept/$2/objects"
    mkdir "$kept/$2/objects"
    for source in tests/features/main.c "$kept/$2/model.c" firmware/*.c firmware/*/*.c; do
        # shellcheck disable=SC2086 # flags are words
        ${CCACHE:-} $1 -std=c11 -O1 $WARNINGS $3 -DLIM_CONFIG='"model.h"' -Ifirmware -I"$kept/$2" -c \
            -o "$kept/$2/objects/$(basename "$source" .c).o" "$source" || return 1
    done
    $1 -o "$kept/$2/program" "$kept/$2"/objects/*.o
}

# features_draw COMPILER NAME CHOICE: every method that is linked gives the expected hashes.
features_draw() {
    flags=$(features_flags "$2" "$3")
    echo "$1 $flags"
    features_build "$1" "$2" "$flags" && "$kept/$2/program" >"$kept/$2/frames" || return 1
    split -l 10 "$kept/$2/frames" "$kept/$2/method."
    for method in "$kept/$2"/method.*; do
        diff "$kept/$2/expected" "$method" || return 1
    done
    [ "$(wc -l <"$kept/$2/frames")" -eq $((10 * $(features_methods "$2" "$flags"))) ] && rm "$kept/$2"/method.*
}

# How many methods draw this scene: a scene that is not convex is not drawn by the convex one. Those that walk draw every
# frame in parts too, where that is a feature.
features_methods() { # NAME FLAGS
    convex=$(grep -c 'SCENE_METHOD LIM_CONVEX' "$kept/$1/model.h")
    echo "$2" | awk -v convex="$convex" '{ print (/NEAREST=1/ + /SCANLINE=1/) * (1 + /STREAM=1/) + /PAINTER=1/ + (convex && /CONVEX=1/) }'
}
