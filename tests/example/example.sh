# SPDX-License-Identifier: MIT
#
# For tests of the example to source: its program with another amount of memory.
# shellcheck shell=sh

# Writes $work/NAME.c: the example with BYTES of memory; `all`: as it is.
example_with_memory() { # NAME BYTES
    case $2 in
    all) cp tests/example/main.c "$work/$1.c" ;;
    *)
        sed "s/TEAPOT_SCENE_MEM_B(240)/$2/" tests/example/main.c >"$work/$1.c"
        ! cmp -s tests/example/main.c "$work/$1.c"
        ;;
    esac
}
