# SPDX-License-Identifier: MIT
#
# For tests of the example to source: its program with another amount of memory.
# shellcheck shell=sh

# Writes $work/NAME.c: the example with BYTES of memory; `all`: as it is.
example_with_memory() { # NAME BYTES
    case $2 in
    all) cp tests/example/main.c "$work/$1.c" ;;
    *)
        sed "s/^TEAPOT_MEMORY(240, 240);/LIM_MEMORY(teapot_memory, 240, 240, $2, 0, 1);/" tests/example/main.c >"$work/$1.c"
        ! cmp -s tests/example/main.c "$work/$1.c"
        ;;
    esac
}

# example_main COMPILER NAME STANDARD FLAG...: $work/NAME.o of $work/NAME.c, in C or, as STANDARD says, in C++.
example_main() {
    main_compiler=$1 main_name=$2 main_standard=$3
    shift 3
    case $main_standard in
    c++*)
        "$main_compiler" -x c++ "-std=$main_standard" -O2 -Wall -Wextra -pedantic -Werror -fno-exceptions -Ifirmware -Itests/example -I"$work" "$@" \
            -c -o "$work/$main_name.o" "$work/$main_name.c"
        ;;
    *)
        # shellcheck disable=SC2086 # flags are words
        "$main_compiler" "-std=$main_standard" -O2 $WARNINGS -Ifirmware -Itests/example -I"$work" "$@" \
            -c -o "$work/$main_name.o" "$work/$main_name.c"
        ;;
    esac
}

# The C++ compiler that belongs to one of C.
example_cplusplus() { # COMPILER
    case $1 in
    *clang*) echo "$1" | sed 's/clang/clang++/' ;;
    *) echo "$1" | sed 's/gcc/g++/' ;;
    esac
}

# example_main_for CORE NAME STANDARD FLAG...: the same by a core's compiler, with that core's flags.
example_main_for() {
    main_core=$1 main_file=$2 main_language=$3
    shift 3
    case $main_language in
    c++*) core_compiler=$(example_cplusplus "$(target_compiler "$main_core")") ;;
    *) core_compiler=$(target_compiler "$main_core") ;;
    esac
    [ "$main_core" = host ] || set -- -ffreestanding "$@"
    # shellcheck disable=SC2046 # flags are words
    example_main "$core_compiler" "$main_file" "$main_language" $(target_flags "$main_core" | sed 's/-std=[^ ]*//') "$@"
}

# example_link CORE BYTES [STANDARD]: $work/CORE, an image with so much memory, or what the scene asks for; for scripts that
# have sourced sim/targets/targets.sh.
example_link() {
    example_with_memory "$1" "$2" && example_main_for "$1" "$1" "${3:-c11}" -DLIM_MAX_SIDE_PX=240 || return 1
    target_link "$1" "$work/$1" -DLIM_CONFIG='"teapot.h"' -DLIM_MAX_SIDE_PX=240 -Itests/example -I"$work" \
        "$work/$1.o" tests/example/display_hash.c "$work/teapot.c" \
        firmware/*.c firmware/*/*.c
}
