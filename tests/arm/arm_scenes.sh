# SPDX-License-Identifier: MIT
#
# Two scenes in one firmware: named in one call they share one header, whose configuration is the union of
# what they need; one program shows both, on the host and on Cortex-M, as `limner render` does.
. tests/tap.sh
. sim/targets/targets.sh

scenes='teapot glass'

compile_both() {
    "$BUILD/limner" compile sim/scenes/teapot.obj sim/scenes/glass.obj --size 96x64 -o "$work/level" \
        >"$work/report" || return 1
    (cd "$work" && echo level*) >"$work/files"
    grep -qx 'level.h level_glass.c level_glass.lim level_teapot.c level_teapot.lim' "$work/files" &&
        grep -q '^.*/level_teapot$' "$work/report" && grep -q '^.*/level_glass$' "$work/report"
}

defined() { # MACRO VALUE: in the shared header
    grep -qx "#define $1 $2" "$work/level.h"
}

# The teapot needs scan lines, the glass nearest first; its polygons are the larger ones.
union_of_needs() {
    "$BUILD/limner" compile sim/scenes/teapot.obj --size 96x64 -o "$work/alone" >/dev/null &&
        defined LIM_HAS_SCANLINE 1 && defined LIM_HAS_NEAREST 1 && defined LIM_HAS_PAINTER 0 &&
        grep -qx '#define LIM_HAS_NEAREST 0' "$work/alone.h" &&
        "$BUILD/limner" compile sim/scenes/glass.obj --size 96x64 -o "$work/other" >/dev/null &&
        grep 'LIM_MAX_VERTICES [0-9]' "$work/other.h" >"$work/most" && ! grep -qxF -f "$work/most" "$work/alone.h" &&
        grep -qxF -f "$work/most" "$work/level.h"
}

same_arrays_as_alone() {
    cmp "$work/alone.lim" "$work/level_teapot.lim"
}

expect() { # NAME: frames of the scene alone
    awk '!/^#/ && NF && n++ % 13 == 0' sim/scenes/teapot.cam | head -n 4 >"$work/few.cam"
    "$BUILD/limner" render "$work/level_$1.lim" --camera "$work/few.cam" --size 96x64 --write-hashes "$work/$1.hashes" \
        --write-cameras "$work/$1_cameras.h" && [ "$(cut -d ' ' -f 2 "$work/$1.hashes" | sort -u | wc -l)" -eq 4 ]
}

shows_both() { # CORE
    target_link "$1" "$work/$1" -I"$work" -DLIM_CONFIG='"level.h"' tests/scenes/main.c "$work/level_teapot.c" \
        "$work/level_glass.c" firmware/*.c firmware/*/*.c && target_run "$1" "$work/$1" >"$work/$1.hashes" || return 1
    cat "$work/teapot.hashes" "$work/glass.hashes" "$work/teapot.hashes" | diff - "$work/$1.hashes"
}

refused() { # PATTERN MODEL...: one line, no file
    pattern=$1
    shift
    "$BUILD/limner" compile "$@" -o "$work/none" >/dev/null 2>"$work/said" && return 1
    cat "$work/said"
    [ "$(wc -l <"$work/said")" -eq 1 ] && grep -q "$pattern" "$work/said" && ! ls "$work"/none* 2>/dev/null
}

tap_check "two models become two scenes with one header" compile_both
tap_check "its configuration is the union of their needs" union_of_needs
tap_check "each scene is what it is alone" same_arrays_as_alone
for name in $scenes; do tap_check "the host renders $name" expect $name; done
for core in host m0plus m4; do tap_check "$core: one program shows both, and the first again" shows_both $core; done
mkdir "$work/other"
cp sim/scenes/icosahedron.obj "$work/other"
tap_check "two scenes of one name are refused" refused 'a scene of that name is there already' \
    sim/scenes/icosahedron.obj "$work/other/icosahedron.obj"
tap_check "one model that cannot be read leaves nothing of the others" refused 'none.obj' sim/scenes/icosahedron.obj none.obj
tap_done
