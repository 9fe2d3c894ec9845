# SPDX-License-Identifier: MIT
#
# Builds with any two features, and without any two, paint what the full renderer paints: an eighth of the pairs, which
# one SEED says. (Suite `features` has all pairs.) A renderer that is fitted to a scene links without an optimizer.
. tests/tap.sh
. tests/features_on.sh

convex_refuses() { # SCENE
    "$BUILD/limner" render "$1" --method convex --size 32x32 -o "$work/none%d.png" >/dev/null 2>"$work/said" && return 1
    cat "$work/said"
    grep -q '^limner: .*rooms.obj: --method convex: the scene is not one convex solid$' "$work/said" && ! ls "$work"/none* 2>/dev/null
}

convex_is_nearest() { # SCENE
    for method in nearest convex; do
        "$BUILD/limner" render "$1" --method $method --size 97x61 --write-hashes "$work/$method" || return 1
    done
    diff "$work/nearest" "$work/convex"
}


# One object for each file, as users build: what the scene does without is called by nobody.
links_unoptimized() { # COMPILER NAME
    rm -rf "$work/objects"
    mkdir "$work/objects"
    # shellcheck disable=SC2086 # flags are words
    for source in tests/features/main.c "$kept/$2"/model*.c firmware/*.c firmware/*/*.c; do
        ${CCACHE:-} "$1" -std=c11 -O0 $WARNINGS -DLIM_CONFIG='"model.h"' -Ifirmware -I"$kept/$2" -c \
            -o "$work/objects/$(basename "$source" .c).o" "$source" || return 1
    done
    "$1" -o "$kept/$2/program" "$work"/objects/*.o && "$kept/$2/program" >"$kept/$2/frames" &&
        features_compare "$2" "$(features_all "$2")"
}

tap_check "--method convex refuses the rooms" convex_refuses sim/scenes/rooms.obj
tap_check "--method convex paints an icosahedron as nearest first does" convex_is_nearest sim/scenes/icosahedron.obj
# Without an optimizer clang takes a third of the time, and with all but two flags there is most to compile.
features_pairs "$CC" "$(command -v clang >/dev/null && echo clang || echo "$CC")"
for compiler in gcc clang; do
    if command -v $compiler >/dev/null; then
        tap_check "$compiler: a renderer fitted to the rooms links without an optimizer" links_unoptimized $compiler rooms
    else
        tap_skip "$compiler: a renderer fitted to the rooms links without an optimizer" "$compiler is not installed"
    fi
done
tap_done
