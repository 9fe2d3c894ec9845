# SPDX-License-Identifier: MIT
#
# Prints README's table of what scenes cost in a firmware. With --write puts it into README.md between its
# markers; with --check says how README differs. Needs $BUILD/limner, $BUILD/scenes and $WARNINGS.
set -eu
. sim/targets/targets.sh
. sim/footprint.sh
. sim/readme_table.sh

: "${BUILD:=build}"
h_px=240
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

method_of() { # FOLDER
    grep -q 'LIM_HAS_CONVEX 1' "$1/model.h" && echo convex || echo nearest
}

# On one core: code, RAM, stack.
costs_on() { # CORE FOLDER
    footprint_objects "$1" "$2" model.h
    footprint_link "$1" "$2"
    footprint_stack "$1" "$2" >"$2/stack"
    echo "$(footprint_size "$1" "$2/$1/renderer.elf" 1) $(footprint_ram "$1" "$2" model.h MODEL $h_px)" \
        "$(sed 's/:.*//' "$2/stack")"
}

scene_data() { # FOLDER
    # shellcheck disable=SC2046,SC2086 # flags are words
    $(target_compiler m4) $(target_flags m4) $footprint_flags -I"$1" -DLIM_CONFIG='"model.h"' \
        -c -o "$1/model.image" "$1/model.c"
    footprint_size m4 "$1/model.image" 1
}

row() { # NAME MODEL
    mkdir "$work/$1"
    "$BUILD/limner" compile "$2" --size ${h_px}x$h_px -o "$work/$1/model" >/dev/null
    costs_on m0plus "$work/$1" >"$work/m0plus"
    costs_on m4 "$work/$1" >"$work/m4"
    read -r code_m0 ram_m0 stack_m0 <"$work/m0plus"
    read -r code_m4 ram_m4 stack_m4 <"$work/m4"
    [ "$ram_m0" = "$ram_m4" ] # the same structs on both
    echo "| $1 | $(method_of "$work/$1") | $code_m0 | $code_m4 | $(scene_data "$work/$1") | $ram_m4 | $stack_m0 | $stack_m4 |"
}

table() {
    echo "| scene | method | code, M0+ | code, M4 | scene data | RAM | stack, M0+ | stack, M4 |"
    echo "|---|---|---|---|---|---|---|---|"
    row demo "$BUILD/scenes/demo.obj"
    for scene in rooms teapot icosahedron; do row $scene sim/scenes/$scene.obj; done
}

table >"$work/table"
case ${1:-} in
--write) readme_write footprint "$work/table" ;;
--check) readme_has footprint "$work/table" ;;
*) cat "$work/table" ;;
esac
